use crate::expectations::{accepted, assert_refused, assert_square, labelled, labels, positions, refused, square_rows};
use silhouette_core::load::{Format::Obj, Note, Place, Problem};

fn square(faces: &str) -> String {
    square_rows("v ") + faces
}

#[test]
fn polygons_are_fanned_from_their_first_corner() {
    assert_square(&accepted(Obj, square("f 1 2 3 4\n")));
    assert_eq!(accepted(Obj, square("f 3 4 1 2")).triangles(), [[2, 3, 0], [2, 0, 1]]);
}

#[test]
fn texture_and_normal_numbers_do_not_split_vertices() {
    let rows = "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\nf 1/1/1 2/2/1 3/1/2\nf 1//2 3//1 4//2\n";
    assert_square(&accepted(Obj, square(rows)));
    assert_square(&accepted(Obj, square("f 1/7 2/8 3/9 4/9\n")));
}

#[test]
fn groups_objects_and_materials_do_not_renumber() {
    let rows = "o one\nusemtl red\nf 1 2 3\ng two\ns 1\no three\nf 1 3 4\n";
    assert_square(&accepted(Obj, square(rows)));
}

#[test]
fn materials_and_groups_label_faces() {
    let label = |rows: &str| labels(Obj, square(rows));
    assert_eq!(label("f 1 2 3\nusemtl red\nf 1 3 4\n"), Some(vec![0, 1]));
    assert_eq!(
        label("usemtl red # bright\nf 1 2 3 4\ng left\nf 1 2 3\nusemtl red\ng\nf 1 3 4\n"),
        Some(vec![1, 1, 2, 1])
    );
    assert_eq!(label("g a b\nf 1 2 3\ng b  a\nf 1 3 4\n"), None, "groups are a set of words");
    assert_eq!(label("f 1 2 3\ng default\nf 1 3 4\n"), None, "the format's own name of no group");
    assert_eq!(label("f 1 2 3\nusemtl red\ng far\nusemtl\ng\nf 1 3 4\n"), None, "names that no face had");
    assert_eq!(label("o one\nf 1 2 3\no two\nf 1 3 4\n"), None, "objects are no groups");
}

#[test]
fn unreferenced_and_coincident_vertices_are_kept_in_order() {
    let mesh = accepted(Obj, "v 9 9 9\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 8 8 8\nf 2 4 5\n");
    let expected = [[9.0; 3], [0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [8.0; 3]];
    assert_eq!(positions(&mesh), expected);
    assert_eq!(mesh.triangles(), [[1, 3, 4]]);
}

#[test]
fn relative_numbers_count_back_from_the_row() {
    let mesh = accepted(Obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4/-1 -1 -2\n");
    assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 3, 2]]);
}

#[test]
fn faces_may_stand_before_their_vertices() {
    assert_square(&accepted(Obj, String::from("f 1 2 3 4\n") + &square_rows("v ")));
}

#[test]
fn rows_may_be_indented_continued_commented_and_end_like_windows_rows() {
    let text = "\u{feff}# caf\u{e9} \\\r\n\tv 0 0 0\r\nv  1\t0 0 1.0 \r\n  v 1 1 \\\r\n0 # corner\r\nv 0 1 0 0.5 0.5 0.5\r\n\r\n\
                f 1 2 \\\r\n 3 \\\r\n 4 # face\r\n";
    assert_square(&accepted(Obj, text));
}

#[test]
fn comments_need_not_be_utf8() {
    let bytes = [b"# caf\xe9\n".as_slice(), square("g \u{1F43A}\nf 1 2 3 4").as_bytes()].concat();
    assert_square(&accepted(Obj, bytes));
}

#[test]
fn coordinates_are_rounded_once() {
    // Halfway between two 32-bit floats and a little more: by way of 64 bits it would be rounded down, to even.
    let mesh = accepted(Obj, "v 1.00000005960464477539062500001 .5 5.\nv -1e-3 +2E2 1e-50\nv 0 0 1\nf 1 2 3");
    assert_eq!(positions(&mesh)[..2], [[1.0 + f32::EPSILON, 0.5, 5.0], [-0.001, 200.0, 0.0]]);
}

#[test]
fn vertex_zero_is_refused_at_its_line() {
    let error = refused(Obj, square("f 1 2 3\nf 0 1 2\n"));
    assert_eq!(error.place, Some(Place::Line(6)));
    assert!(matches!(error.problem, Problem::VertexZero));
}

#[test]
fn numbers_out_of_range_are_refused_with_the_range() {
    assert_refused(Obj, square("f 1 2 3\nf 1 2 5\n"), ", line 6", &["face 1", "vertex 5", "1 to 4", "-4 to -1"]);
    assert_refused(Obj, "v 0 0 0\nf -1 -2 -1\n", ", line 2", &["face 0", "vertex -2", "-1 to -1"]);
    assert_refused(Obj, "f 1 2 3\n", ", line 1", &["there are no vertices"]);
    let highest = "f 1 2 9223372036854775807\n";
    assert_refused(Obj, square(highest), ", line 5", &["vertex 9223372036854775807"]);
    let lowest = "f 1 2 -9223372036854775808\n";
    assert_refused(Obj, square(lowest), ", line 5", &["vertex -9223372036854775808"]);
    assert_refused(Obj, square("f 1 2 99999999999999999999\n"), ", line 5", &["a vertex number"]);
}

#[test]
fn coordinates_must_be_finite_numbers() {
    for word in ["nan", "inf", "-infinity", "1e39", "-1e999"] {
        assert_refused(Obj, format!("v 0 0 0\n\nv 1 {word} 0\n"), ", line 3", &["vertex 1", word]);
    }
    assert_refused(Obj, "v 0 zero 0\n", ", line 1", &["a coordinate", "\"zero\""]);
    assert_refused(Obj, "v 0 0\n", ", line 1", &["a coordinate", "nothing"]);
}

#[test]
fn faces_of_one_or_two_corners_are_left_out_and_counted() {
    let loaded = labelled(Obj, square("s 1\nf 1\nf 1 2 3\nf 2\nf 4 2\ns 2\nf 1 3 4\nf # none\n"));
    assert_square(&loaded.mesh);
    assert_eq!(loaded.notes, [Note::FewCorners { count: 4, first: Place::Line(6) }]);
    assert_eq!(loaded.feature_edges, [[0, 2]], "groups are those of the faces that are left");
    assert_eq!(loaded.notes[0].to_string(), "4 faces of fewer than three corners were left out (the first: line 6)");
    assert_refused(Obj, square("f 1 2 3\nf 1 9\n"), ", line 6", &["face 1", "vertex 9"]);
    assert_refused(Obj, square("f 1 2\n"), "", &["no faces"]);
}

#[test]
fn a_continuation_may_end_in_spaces() {
    assert_square(&accepted(Obj, square("f 1 2 \\  \t\n3 \\ \r\n 4\n")));
    assert_square(&accepted(Obj, square("# no continuation \\ \nf 1 2 3 4\n")));
}

#[test]
fn lines_may_end_as_on_old_macs() {
    assert_square(&accepted(Obj, ("# made by hand\n".to_owned() + &square("f 1 2 3 \\\n 4\n")).replace('\n', "\r")));
    let bad = square("f 1 2 3\n\nf 0 1 2\n");
    for end in ["\r", "\r\n", "\n"] {
        assert_refused(Obj, bad.replace('\n', end), ", line 7", &["vertex 0"]);
    }
    assert_square(&accepted(Obj, square("f 1 2 3 4").replacen('\n', "\r", 2)));
}

#[test]
fn files_without_faces_or_text_are_refused() {
    assert_refused(Obj, square_rows("v "), "", &["no faces"]);
    assert_refused(Obj, "l 1 2\np 1\n", "", &["no faces"]);
    assert_refused(Obj, b"v 0 \xff 0\n", ", line 1", &["UTF-8"]);
    let utf16: Vec<u8> = "\u{feff}v 0 0 0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_refused(Obj, utf16, ", line 1", &["UTF-8"]);
}

#[test]
fn line_numbers_survive_continued_rows() {
    let text = square_rows("v ") + "f 1 \\\n2 \\\n3\nf 1 2 x\n";
    assert_refused(Obj, text, ", line 8", &["\"x\""]);
}

/// A backslash at the end of a comment is a part of the comment, on rows that continue others as well.
#[test]
fn a_comment_on_a_continued_row_ends_with_it() {
    assert_square(&accepted(Obj, square("f 1 2 3 \\\n# note \\\nf 1 3 4\n")));
    let loaded = labelled(Obj, square("f 1 2 3 4\nl 1 2 # 2 3\n"));
    assert_eq!(loaded.feature_edges, [[0, 1]]);
}
