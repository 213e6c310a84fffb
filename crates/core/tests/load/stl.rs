use crate::expectations::{SQUARE, SQUARE_FAN, accepted, assert_refused, assert_square, labelled, positions};
use silhouette_core::load::{Format::Stl, Note, Place};

/// A binary file of these triangles, with wrong normals and non-zero attributes.
pub fn binary(header: &[u8], triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([[7.0_f32; 3]].iter().chain(triangle).flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0xab, 0xcd]);
    }
    bytes
}

/// The triangles of the square.
pub fn square() -> [[[f32; 3]; 3]; 2] {
    SQUARE_FAN.map(|triangle| triangle.map(|vertex| SQUARE[vertex as usize]))
}

/// A solid of these triangles as text.
pub fn text(triangles: &[[[f32; 3]; 3]]) -> String {
    let facet = |triangle: &[[f32; 3]; 3]| {
        let rows: String = triangle.iter().map(|[x, y, z]| format!("      vertex {x:e} {y} {z}\n")).collect();
        format!("  facet normal 0 0 1\n    outer loop\n{rows}    endloop\n  endfacet\n")
    };
    format!(
        "solid a name with spaces\n{}endsolid a name with spaces\n",
        triangles.iter().map(facet).collect::<String>()
    )
}

#[test]
fn binary_and_text_join_equal_positions_in_order_of_appearance() {
    assert_square(&accepted(Stl, binary(b"made by hand", &square())));
    assert_square(&accepted(Stl, text(&square())));
}

#[test]
fn binary_files_may_begin_like_text() {
    assert_square(&accepted(Stl, binary(b"solid but binary", &square())));
}

#[test]
fn bytes_behind_the_last_triangle_are_passed_over() {
    let mut bytes = binary(b"made by hand", &square());
    bytes.extend(b"trailer");
    assert_square(&accepted(Stl, bytes));
}

#[test]
fn negative_zero_equals_zero() {
    let triangles =
        [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[-0.0, 0.0, -0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]];
    for bytes in [binary(b"", &triangles), text(&triangles).into_bytes()] {
        let mesh = accepted(Stl, bytes);
        assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(positions(&mesh)[0].map(f32::to_bits), [0; 3]);
    }
}

#[test]
fn several_solids_are_one_mesh_in_any_case_and_line_end() {
    let [one, two] = square();
    let both = (text(&[one]) + &text(&[two])).to_uppercase().replace('\n', "\r\n");
    assert_square(&accepted(Stl, both));
    assert_square(&accepted(Stl, text(&square()).replace("solid a name with spaces", "solid")));
}

#[test]
fn cut_binary_files_are_refused() {
    for header in [b"made by hand".as_slice(), b"solid but binary"] {
        let bytes = binary(header, &square());
        assert_refused(Stl, &bytes[..bytes.len() - 1], ", byte 84", &["100 bytes", "99 are left"]);
        assert_refused(Stl, &bytes[..84], ", byte 84", &["0 are left"]);
    }
    assert_refused(Stl, [0; 83], ", byte 0", &["84 bytes", "83 are left"]);
    let mut promise = binary(b"", &square());
    promise[80..84].fill(0xff);
    assert_refused(Stl, promise, ", byte 84", &["214748364750 bytes are needed"]);
    assert_refused(Stl, binary(b"", &[]), "", &["no faces"]);
}

#[test]
fn positions_must_be_finite() {
    let mut triangles = square();
    triangles[1][2][1] = f32::NAN;
    assert_refused(Stl, binary(b"", &triangles), ", byte 170", &["vertex 3", "NaN"]);
    assert_refused(Stl, text(&triangles), ", line 13", &["vertex 3", "NaN"]);
    assert_refused(Stl, text(&square()).replace("vertex 0e0 1", "vertex 1e39 1"), ", line 13", &["1e39"]);
}

#[test]
fn text_out_of_order_is_refused_at_its_line() {
    let whole = text(&square());
    assert_refused(Stl, whole.replacen("endloop", "end", 1), ", line 7", &["endloop", "end"]);
    assert_refused(Stl, whole.replacen("outer loop", "inner", 1), ", line 3", &["outer loop", "inner"]);
    let facet = whole.find("endfacet").unwrap();
    assert_refused(Stl, &whole[..facet], ", line 7", &["endfacet", "nothing"]);
    assert_refused(Stl, "solid x\nfacet normal 0 0 1\n", ", line 2", &["endfacet", "nothing"]);
    assert_refused(Stl, "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", ", line 4", &["endloop", "nothing"]);
    assert_refused(Stl, whole.replacen("vertex", "vertices", 1), ", line 4", &["a vertex or endloop", "vertices"]);
    assert_refused(Stl, "solid x\nendsolid x\n", "", &["no faces"]);
}

/// The facets of the square on lines of their own, or all on one, with words of two parts and names of all kinds.
#[test]
fn lines_mean_nothing_to_facets() {
    let whole = text(&square());
    let one_line = whole.replace('\n', " ");
    let facet_per_line = whole.replace('\n', " ").replace("  facet", "\nfacet").replace("endsolid", "\nendsolid");
    let broken = whole.replace("a name with spaces", "").replace(' ', "\n");
    let two_parts =
        whole.replace("endloop", "end loop").replace("endfacet", "End\nFacet").replace("endsolid", "end solid");
    for text in [
        one_line,
        facet_per_line,
        broken,
        two_parts,
        whole.replace('\n', "\r"),
        whole.replace("outer loop", "outerloop"),
    ] {
        let loaded = labelled(Stl, &text);
        assert_square(&loaded.mesh);
        assert_eq!(loaded.notes, [], "{text}");
    }
}

#[test]
fn names_are_passed_over() {
    let whole = text(&square());
    for (solid, endsolid) in [
        ("solid", "endsolid"),
        ("solidAssimpScene", "endsolidAssimpScene"),
        ("solid my facet endloop", "endsolid my solid facet"),
        ("SOLID vertex", "EndSolid outer loop\n\n"),
    ] {
        let text = whole.replace("endsolid a name with spaces", endsolid).replace("solid a name with spaces", solid);
        assert_square(&accepted(Stl, &text));
        let both = text.repeat(2);
        assert_eq!(accepted(Stl, &both).face_count(), 4, "{both}");
        assert_eq!(accepted(Stl, both.replace('\n', "  ")).face_count(), 4, "{both}");
    }
}

#[test]
fn a_missing_end_is_noted() {
    let whole = text(&square());
    let cut = &whole[..whole.find("endsolid").unwrap()];
    let loaded = labelled(Stl, cut);
    assert_square(&loaded.mesh);
    assert_eq!(loaded.notes, [Note::NoEnd]);
    let loaded = labelled(Stl, whole.clone() + cut);
    assert_eq!((loaded.mesh.face_count(), loaded.notes), (4, vec![Note::NoEnd]));
    assert_eq!(labelled(Stl, cut.to_owned() + &whole).notes, [], "several solids may share an end");
}

#[test]
fn facets_without_three_vertices_are_left_out_and_counted() {
    let few =
        "facet normal 0 0 1\nendfacet\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 1 1 endloop endfacet\n";
    let text = text(&square()).replacen("facet", &format!("{few}facet"), 1);
    let loaded = labelled(Stl, &text);
    assert_eq!(loaded.mesh.face_count(), 2);
    assert_eq!(loaded.notes, [Note::FewCorners { count: 2, first: Place::Line(3) }]);
}
