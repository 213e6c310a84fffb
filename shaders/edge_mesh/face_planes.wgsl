// Step 2: facing and normal of every face, from this frame's positions. Twin: crates/edge_mesh/src/face_planes.rs

#import "shared/invocation.wgsl"
#import "shared/front_volume.wgsl"
#import "edge_mesh/style.wgsl"
#import "edge_mesh/oct_normal.wgsl"

@group(2) @binding(0) var<storage, read_write> facing: array<u32>;
@group(2) @binding(1) var<storage, read_write> normals: array<u32>;

// An invocation per word of 32 faces, so that no two write the same word.
@compute @workgroup_size(WORKGROUP)
fn face_planes(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let word = element(id, groups);
    let first = word * 32u;
    if first >= style.faces {
        return;
    }
    var bits = 0u;
    for (var face = first; face < min(first + 32u, style.faces); face++) {
        bits |= u32(front_volume_seen_from(face, style.viewer) > 0.0) << (face & 31u);
        if style.bends_now != 0u {
            normals[face] = oct_encode(face_normal(face));
        }
    }
    facing[word] = bits;
}
