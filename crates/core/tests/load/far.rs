//! Meshes far from zero: what a file says beyond 32 bits is kept.

#![expect(clippy::float_cmp, reason = "the digits of a file are to come back")]

use crate::expectations::{accepted, labelled};
use crate::gltf::Document;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::DVec3;
use silhouette_core::load::{Format, Note};

/// A small prism in the coordinates of a survey, to the millimetre.
const CORNERS: [[f64; 3]; 4] = [
    [500_000.125, 5_400_000.001, 312.4],
    [500_000.725, 5_400_000.001, 312.4],
    [500_000.125, 5_400_000.602, 312.4],
    [500_000.125, 5_400_000.001, 313.003],
];
const FACES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

fn rows(prefix: &str, corners: &[[f64; 3]]) -> String {
    corners.iter().map(|[x, y, z]| format!("{prefix}{x} {y} {z}\n")).collect()
}

fn obj(corners: &[[f64; 3]]) -> String {
    rows("v ", corners) + &FACES.map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1)).concat()
}

fn files(corners: &[[f64; 3]]) -> [(Format, Vec<u8>); 5] {
    let faces = FACES.map(|[a, b, c]| format!("3 {a} {b} {c}\n")).concat();
    let (vertices, faces_count) = (corners.len(), FACES.len());
    let header = |encoding: &str| {
        format!(
            "ply\nformat {encoding} 1.0\nelement vertex {vertices}\nproperty double x\nproperty double y\n\
             property double z\nelement face {faces_count}\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let mut binary = header("binary_big_endian").into_bytes();
    corners.iter().flatten().for_each(|x| binary.extend(x.to_be_bytes()));
    for face in FACES {
        binary.push(3);
        face.iter().for_each(|vertex| binary.extend(vertex.to_be_bytes()));
    }
    let facet = |face: [u32; 3]| {
        let loops = rows("vertex ", &face.map(|vertex| corners[vertex as usize]));
        format!("facet normal 0 0 1\nouter loop\n{loops}endloop\nendfacet\n")
    };
    [
        (Format::Obj, obj(corners).into_bytes()),
        (Format::Off, format!("OFF\n{vertices} {faces_count} 0\n{}{faces}", rows("", corners)).into_bytes()),
        (Format::Ply, format!("{}{}{faces}", header("ascii"), rows("", corners)).into_bytes()),
        (Format::Ply, binary),
        (Format::Stl, format!("solid\n{}endsolid\n", FACES.map(facet).concat()).into_bytes()),
    ]
}

/// The positions of faces in the coordinates of the file.
fn in_file(mesh: &TriangleMesh) -> Vec<[f64; 3]> {
    mesh.triangles().iter().flatten().map(|&at| mesh.in_file(mesh.positions()[at as usize]).to_array()).collect()
}

#[test]
fn coordinates_of_a_survey_come_back_to_the_last_digit() {
    let expected: Vec<[f64; 3]> = FACES.iter().flatten().map(|&at| CORNERS[at as usize]).collect();
    for (format, bytes) in files(&CORNERS) {
        let mesh = accepted(format, bytes);
        assert_eq!(in_file(&mesh), expected, "{format}");
        assert_eq!(mesh.origin(), DVec3::new(500_000.0, 5_400_000.0, 313.0), "{format}");
    }
}

#[test]
fn what_is_close_to_zero_stays_what_it_is() {
    let close = CORNERS.map(|[x, y, z]| [x - 500_000.0, y - 5_400_000.0, z - 312.0]);
    for (format, bytes) in files(&close) {
        let mesh = accepted(format, bytes);
        assert_eq!(mesh.origin(), DVec3::ZERO);
        let rounded = mesh.triangles().iter().flatten().zip(FACES.iter().flatten());
        for (ours, theirs) in rounded {
            assert_eq!(mesh.positions()[*ours as usize].to_array(), close[*theirs as usize].map(|x| x as f32));
        }
    }
}

/// A thing of a tenth of a millimetre, which 32 bits take for a point.
#[test]
fn what_looks_like_a_point_may_be_none() {
    let tiny = CORNERS.map(|[x, y, z]| [x * 1e-4 + 5_400_000.0, y * 1e-4, z]).map(|[x, _, z]| [x, x, z * 1e-4]);
    let corners = [0, 1, 2, 3].map(|at| [tiny[at][0], 5_400_000.0 + CORNERS[at][1].fract() * 1e-4, tiny[at][2]]);
    let mesh = accepted(Format::Obj, obj(&corners));
    for (ours, theirs) in mesh.positions().iter().zip(corners) {
        assert!(mesh.in_file(*ours).distance(DVec3::from_array(theirs)) < 1e-9, "{ours} for {theirs:?}");
    }
    let one_place = accepted(Format::Obj, obj(&[[5.25, 7.5, 1e6]; 4]));
    assert_eq!(in_file(&one_place)[3], [5.25, 7.5, 1e6]);
}

#[test]
fn unused_vertices_do_not_count() {
    let with_zero = obj(&CORNERS) + "v 0 0 0\n";
    assert_eq!(in_file(&accepted(Format::Obj, with_zero))[0], CORNERS[0]);
}

#[test]
fn nodes_place_their_meshes_in_64_bits() {
    let mut document = Document::default();
    let corners = CORNERS.map(|corner| [0, 1, 2].map(|axis| (corner[axis] - CORNERS[0][axis]) as f32));
    let (positions, indices) = (document.positions(&corners), document.indices(5125, FACES.as_flattened()));
    document.mesh(positions, &format!(r#","indices":{indices}"#));
    let [x, y, z] = CORNERS[0];
    document.nodes.push(format!(r#"{{"mesh":0,"translation":[{x},{y},{z}]}}"#));
    let mesh = accepted(Format::Gltf, document.glb());
    for (ours, theirs) in mesh.positions().iter().zip(CORNERS) {
        assert!(mesh.in_file(*ours).distance(DVec3::from_array(theirs)) < 1e-6, "{ours} for {theirs:?}");
    }
}

/// A strip of triangles a centimetre wide over 1000 km.
#[test]
fn what_32_bits_cannot_hold_is_noted() {
    let notes = |width: f64| {
        let mut text = String::new();
        for step in 0..200 {
            let x = f64::from(step) * 5000.003;
            text += &format!("v {x} 0 0\nv {x} {width} 0\nv {} 0 0.001\n", x + width);
        }
        for step in 0..200 {
            text += &format!("f {} {} {}\n", 3 * step + 1, 3 * step + 2, 3 * step + 3);
        }
        labelled(Format::Obj, text).notes
    };
    let noted = notes(0.01);
    let [Note::Rounded { distance, sides, of: 600 }] = noted[..] else { panic!("{noted:?}") };
    assert!((0.01..0.04).contains(&distance) && sides > 100, "{noted:?}");
    assert!(noted[0].to_string().contains("positions are rounded by up to"), "{}", noted[0]);
    assert_eq!(notes(100.0), []);
}
