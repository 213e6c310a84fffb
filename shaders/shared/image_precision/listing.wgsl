// A list of faces or polygons, made in any order. Twin: crates/image_precision/src/face_list.rs
//
// Stages that do much for few elements run over a list: in lockstep, elements with nothing to do take as long as the others.

// The number of entries, and the entries.
@group(2) @binding(0) var<storage, read_write> faces: array<atomic<u32>>;

fn element(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.x + id.y * groups.x * 64u;
}

fn list_face(entry: u32) {
    atomicStore(&faces[atomicAdd(&faces[0], 1u) + 1u], entry);
}
