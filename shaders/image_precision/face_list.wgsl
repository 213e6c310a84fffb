// Lists the faces whose edges are drawn. Twin: crates/image_precision/src/back_edges.rs

// For unoriented polygons: 1 for faces of the first layer.
@group(2) @binding(1) var<storage, read> first_layer: array<u32>;

@compute @workgroup_size(64)
fn list_back_faces(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && front_volume(face) < 0.0 {
        list_face(face);
    }
}

@compute @workgroup_size(64)
fn list_later_layers(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && first_layer[face] == 0u {
        list_face(select(face, face | FRONT, front_volume(face) > 0.0));
    }
}
