// Lists the faces whose edges are drawn, in any order. Twin: crates/image_precision/src/face_list.rs
//
// Stages that do much for few faces run over a list: in lockstep, faces with nothing to do take as long as the others.

#import "shared/invocation.wgsl"
#import "image_precision/facing.wgsl"
#import "image_precision/front_mark.wgsl"

// The number of entries, and the entries.
@group(2) @binding(0) var<storage, read_write> faces: array<atomic<u32>>;
// For unoriented polygons: 1 for faces of the first layer.
@group(2) @binding(1) var<storage, read> first_layer: array<u32>;

fn list_face(entry: u32) {
    atomicStore(&faces[atomicAdd(&faces[0], 1u) + 1u], entry);
}

@compute @workgroup_size(WORKGROUP)
fn list_back_faces(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && front_volume(face) < 0.0 {
        list_face(face);
    }
}

@compute @workgroup_size(WORKGROUP)
fn list_later_layers(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && first_layer[face] == 0u {
        list_face(select(face, face | FRONT, front_volume(face) > 0.0));
    }
}
