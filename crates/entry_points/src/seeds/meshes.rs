//! Small files of every format and encoding, behind the letters that [`mesh_files`](crate::mesh_files) reads first.

use super::{Seed, gltf, seed};

const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.25], [0.0, 1.0, 0.0]];

pub fn seeds() -> Vec<Seed> {
    let mut seeds = vec![
        seed("obj-groups", format!("o0{}", obj())),
        seed("obj-concave", "o1v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\nf -1 -2 -3\n"),
        seed("obj-far", "o2v 500000.25 5400000.125 0\nv 500001 5400001 1\nv 500002 5400001 0\nf 1 2 3\n"),
        seed("obj-lines", "o6v 0 0 0\nv 1 0 0\nv 0 1 \\\n0\nl 1 2\ns 1\nf 1//1 2//2 3//3\ns off\nf 3 2 1\n"),
        seed("off", format!("f0OFF\n# four\n4 2 0\n{}4 0 1 2 3 0.5 0.5 0.5\n3 0 1 2\n", rows(""))),
        seed("off-colours", format!("f3COFF 4 1 0\n{}3 0 1 2\n", rows("").replace('\n', " 1 0 0 1\n"))),
        seed("ply-text", format!("p0{}{}4 0 1 2 3\n3 0 1 2\n", ply("ascii", "face 2", "uchar int"), rows(""))),
        seed("ply-strips", format!("p4{}{}8 0 1 2 3 -1 0 2 3\n", ply("ascii", "tristrips 1", "int int"), rows(""))),
        seed("stl-text", stl_text()),
        seed("stl-binary", stl_binary()),
        seed("gltf-embedded", [b"g0", gltf::text().as_bytes()].concat()),
        seed("gltf-skinned", [b"g2", gltf::skinned().as_bytes()].concat()),
        seed("glb", [b"g5", &gltf::binary()[..]].concat()),
    ];
    for (name, encoding) in [("ply-little", "binary_little_endian"), ("ply-big", "binary_big_endian")] {
        seeds.push(seed(name, ply_binary(encoding)));
    }
    seeds
}

fn rows(before: &str) -> String {
    SQUARE.iter().map(|[x, y, z]| format!("{before}{x} {y} {z}\n")).collect()
}

fn obj() -> String {
    format!(
        "mtllib none.mtl\no plate\n{}vt 0 0\nvn 0 0 1\nusemtl red\ng left upper\ns 1\nf 1/1/1 2/1/1 3/1/1\nusemtl blue\n\
         g right\ns 2\nf 1 3 4\n",
        rows("v ")
    )
}

fn ply(encoding: &str, faces: &str, list: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\ncomment small\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         element {faces}\nproperty list {list} vertex_indices\nend_header\n"
    )
}

fn ply_binary(encoding: &str) -> Vec<u8> {
    let is_big = encoding == "binary_big_endian";
    let mut bytes = format!("p1{}", ply(encoding, "face 1", "uchar uint")).into_bytes();
    let put_float = |x: f32| if is_big { x.to_be_bytes() } else { x.to_le_bytes() };
    let put_index = |x: u32| if is_big { x.to_be_bytes() } else { x.to_le_bytes() };
    bytes.extend(SQUARE.into_iter().flatten().flat_map(put_float));
    bytes.push(4);
    bytes.extend((0..4).flat_map(put_index));
    bytes
}

const FACETS: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

fn stl_text() -> String {
    let vertex = |corner: &usize| {
        let [x, y, z] = SQUARE[*corner];
        format!("vertex {x} {y} {z}\n")
    };
    let facet = |corners: &[usize; 3]| {
        let corners: String = corners.iter().map(vertex).collect();
        format!("facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let facets: String = FACETS.iter().map(facet).collect();
    format!("s0solid plate\n{facets}endsolid plate\n")
}

fn stl_binary() -> Vec<u8> {
    let mut bytes = b"s2".to_vec();
    bytes.extend([b' '; 80]);
    bytes.extend((FACETS.len() as u32).to_le_bytes());
    for corners in FACETS {
        let numbers = [0.0, 0.0, 1.0].into_iter().chain(corners.into_iter().flat_map(|corner| SQUARE[corner]));
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}
