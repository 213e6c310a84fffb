//! `tobj`, a reader with which this one shares no code, must agree face for face and position for position.
//!
//! `tobj` numbers the vertices of each model, which is a run of faces of one object, group and material, in the order in
//! which they are first used. So the triangles of both are renumbered in order of use, run by run, before ids are compared;
//! then all ids and all bits of all positions have to be equal.

use crate::expectations::accepted;
use proptest::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::load::Format::Obj;
use silhouette_core::{NoProgress, TriangleMesh, load};
use std::collections::HashMap;
use std::io::Write as _;

fn by_tobj(text: &[u8]) -> Result<Vec<tobj::Model>, tobj::LoadError> {
    let no_materials = |_: &std::path::Path| tobj::load_mtl_buf(&mut std::io::empty());
    let options = tobj::LoadOptions { ignore_points: true, ignore_lines: true, ..tobj::LoadOptions::default() };
    tobj::load_obj_buf(&mut &text[..], &options, no_materials).map(|(models, _)| models)
}

/// Triangles that a model becomes.
fn triangle_count(mesh: &tobj::Mesh) -> usize {
    match mesh.face_arities.as_slice() {
        [] => mesh.indices.len() / 3,
        arities => arities.iter().map(|&arity| arity.saturating_sub(2) as usize).sum(),
    }
}

/// A mesh with the vertices of each run of this many triangles in order of first use.
fn renumbered(mesh: &TriangleMesh, runs: impl IntoIterator<Item = usize>) -> TriangleMesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut rest = mesh.triangles();
    for run in runs {
        let (of_run, after) = rest.split_at(run);
        rest = after;
        let mut ids = HashMap::new();
        triangles.extend(of_run.iter().map(|corners| {
            corners.map(|vertex| {
                *ids.entry(vertex).or_insert_with(|| {
                    positions.push(mesh.positions()[vertex as usize]);
                    positions.len() as u32 - 1
                })
            })
        }));
    }
    assert!(rest.is_empty(), "{} triangles of ours are left over", rest.len());
    TriangleMesh::new(positions, triangles).unwrap().with_origin(mesh.origin())
}

/// Says where two meshes differ, bits of positions included; within rounding where ours count from an origin.
fn difference(ours: &TriangleMesh, theirs: &TriangleMesh) -> Option<String> {
    let bits = |position: &Vec3| position.to_array().map(f32::to_bits);
    let are_same = |(_, (here, there)): &(usize, (&Vec3, &Vec3))| {
        let roundings = (here.abs() + there.abs()).as_dvec3() * f64::from(f32::EPSILON);
        let apart = (ours.in_file(**here) - there.as_dvec3()).abs();
        if ours.origin() == DVec3::ZERO { bits(here) == bits(there) } else { apart.cmple(roundings).all() }
    };
    let counts = [ours, theirs].map(|mesh| (mesh.vertex_count(), mesh.face_count()));
    if counts[0] != counts[1] {
        return Some(format!("{:?} vertices and faces, but {:?}", counts[0], counts[1]));
    }
    let mut faces = ours.triangles().iter().zip(theirs.triangles()).enumerate();
    if let Some((face, (ours, theirs))) = faces.find(|(_, (ours, theirs))| ours != theirs) {
        return Some(format!("face {face}: {ours:?}, but {theirs:?}"));
    }
    let mut vertices = ours.positions().iter().zip(theirs.positions()).enumerate();
    let differing = vertices.find(|pair| !are_same(pair));
    differing.map(|(vertex, (ours, theirs))| format!("vertex {vertex}: {ours:?}, but {theirs:?}"))
}

/// Compares our mesh of a text with that of `tobj`. Yields the number of models.
fn compare(ours: &TriangleMesh, text: &[u8]) -> Result<usize, String> {
    let models = by_tobj(text).map_err(|error| format!("tobj: {error}"))?;
    let theirs = TriangleMesh::from_tobj(&models).map_err(|error| error.to_string())?;
    let runs = || models.iter().map(|model| triangle_count(&model.mesh));
    difference(&renumbered(ours, runs()), &renumbered(&theirs, runs())).map_or(Ok(models.len()), Err)
}

#[test]
fn every_real_model_agrees() {
    let Some(folder) = std::env::var_os("SILHOUETTES_MODELS") else {
        writeln!(std::io::stderr(), "skipped every_real_model_agrees: SILHOUETTES_MODELS names no folder").unwrap();
        return;
    };
    let mut compared = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        if load::Format::of(&path) != Some(Obj) {
            continue;
        }
        let text = std::fs::read(&path).unwrap();
        let ours = load::read(Obj, "ours", &text, &NoProgress).unwrap();
        let models = compare(&ours, &text).unwrap_or_else(|what| panic!("{}: {what}", path.display()));
        writeln!(std::io::stderr(), "{}: {} faces, {models} models", path.display(), ours.face_count()).unwrap();
        compared += 1;
    }
    assert!(compared > 0, "no OBJ file in {}", folder.display());
}

/// The negative control: a swapped corner, a moved vertex and a missing face are seen.
#[test]
fn differences_are_found() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 4 3\n";
    let ours = accepted(Obj, text);
    assert_eq!(compare(&ours, text.as_bytes()), Ok(1));
    for (from, to) in [("f 2 4 3", "f 2 3 4"), ("v 1 0 0", "v 1.0000001 0 0"), ("v 0 0 0", "v -0 0 0")] {
        let other = accepted(Obj, text.replace(from, to));
        assert!(compare(&other, text.as_bytes()).is_err(), "{to}");
    }
    let shorter = by_tobj(text.replace("f 2 4 3\n", "").as_bytes()).unwrap();
    assert!(difference(&ours, &TriangleMesh::from_tobj(&shorter).unwrap()).is_some());
}

/// Where every vertex is used in the order of the file, `tobj` keeps that order: the meshes are equal as they are.
#[test]
fn ids_are_those_of_the_file() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 0 0\nf 1 2 3\nf 3 2 4\nf 4 2 5\n";
    assert_eq!(TriangleMesh::from_tobj(&by_tobj(text.as_bytes()).unwrap()).unwrap(), accepted(Obj, text));
}

/// Rows on which the two differ. The format is on our side: `w` is the weight of rational curves, and no weight of
/// polygons; `l` is a line, however many vertices it has; a backslash joins rows; a comment may follow a face.
#[test]
fn known_differences_are_those_of_tobj() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let ours = accepted(Obj, square);
    let weighted = square.replace("v 1 1 0", "v 1 1 0 2");
    assert_eq!(accepted(Obj, &weighted), ours);
    assert!(compare(&ours, weighted.as_bytes()).unwrap_err().starts_with("vertex 2"), "tobj divides by w");
    let lines = format!("{square}l 1 2 3 4\n");
    assert_eq!(accepted(Obj, &lines), ours);
    let faces = TriangleMesh::from_tobj(&by_tobj(lines.as_bytes()).unwrap()).unwrap().face_count();
    assert_eq!(faces, 4, "tobj takes a line of four vertices for a face");
    for row in ["f 1 2 \\\n3 4", "f 1 2 3 4 # square"] {
        let text = square.replace("f 1 2 3 4", row);
        assert_eq!(accepted(Obj, &text), ours, "{row}");
        assert!(by_tobj(text.as_bytes()).is_err(), "{row}");
    }
}

/// A number as files spell it.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<f32>().prop_filter("finite", |x| x.is_finite()).prop_map(|x| x.to_string()),
        (-1e6..1e6_f64).prop_map(|x| format!("{x:.4}")),
        (-1e3..1e3_f64, -30..30_i32).prop_map(|(x, power)| format!("{x:.17}e{power}")),
        (-99..99_i32).prop_map(|x| x.to_string()),
        Just(".5".to_owned()),
        Just("-0".to_owned()),
    ]
}

/// A corner by its rank from the first vertex, spelt absolutely or relatively, alone or with its companions.
fn corner(vertices: usize) -> impl Strategy<Value = String> {
    (0..vertices, any::<bool>(), 0..4_usize).prop_map(move |(vertex, is_relative, companions)| {
        let number = if is_relative { vertex as i64 - vertices as i64 } else { vertex as i64 + 1 };
        match companions {
            0 => number.to_string(),
            1 => format!("{number}/1"),
            2 => format!("{number}//1"),
            _ => format!("{number}/1/1"),
        }
    })
}

/// A row that does not change which faces there are, or a face.
fn row(vertices: usize) -> impl Strategy<Value = String> {
    let face = prop::collection::vec(corner(vertices), 3..7).prop_map(|corners| format!("f {}", corners.join("  ")));
    let other = prop::sample::select(vec![
        "",
        "# f 1 2 3",
        "o object",
        "o",
        "g one two",
        "g",
        "s off",
        "s 2",
        "usemtl steel",
        "p 1",
        "vp 0.5",
        "l 1 2",
    ]);
    prop_oneof![4 => face, 1 => other.prop_map(str::to_owned)]
}

fn text() -> impl Strategy<Value = String> {
    let vertices = prop::collection::vec([number(), number(), number()], 1..12);
    let texts = vertices.prop_flat_map(|vertices| {
        let rows = prop::collection::vec(row(vertices.len()), 1..20);
        (Just(vertices), rows, prop::sample::select(vec!["\n", "\r\n", " \n\n"]), 0..3_usize)
    });
    texts.prop_map(|(vertices, rows, end, indent)| {
        let indent = " ".repeat(indent);
        let vertices = vertices.iter().map(|position| format!("v {}", position.join(" ")));
        let all = vertices.chain(["vt 0 0".to_owned(), "vn 0 0 1".to_owned()]).chain(rows);
        all.map(|row| format!("{indent}{row}{end}")).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn generated_files_agree(text in text()) {
        match load::read(Obj, "ours", text.as_bytes(), &NoProgress) {
            Ok(ours) => prop_assert_eq!(compare(&ours, text.as_bytes()).err(), None),
            Err(error) => {
                let line = error.to_string();
                let faces = by_tobj(text.as_bytes()).ok().and_then(|models| TriangleMesh::from_tobj(&models).ok());
                let faces = faces.map_or(0, |mesh| mesh.face_count());
                prop_assert!(line.contains("no faces") && faces == 0 || line.contains("finite"), "{line}");
            }
        }
    }
}
