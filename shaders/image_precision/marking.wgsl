// Marks the faces of the first layer and lists the others. The stage that imports this declares the texture of face
// numbers, `seen`, with `samples` and `sample_at` to read it.

#import "shared/invocation.wgsl"
#import "image_precision/style.wgsl"

@group(2) @binding(0) var<storage, read_write> first_layer: array<u32>;
@group(2) @binding(2) var<storage, read_write> listed: array<u32>;
@group(2) @binding(3) var<storage, read_write> arguments: array<atomic<u32>>;

@compute @workgroup_size(8, 8)
fn mark_seen(@builtin(global_invocation_id) id: vec3<u32>) {
    let size = textureDimensions(seen);
    if id.x < size.x && id.y < size.y {
        for (var sample = 0u; sample < samples(); sample++) {
            let number = pack4x8unorm(sample_at(vec2<i32>(id.xy), sample));
            if number != 0u {
                first_layer[number - 1u] = 1u;
            }
        }
    }
}

@compute @workgroup_size(WORKGROUP)
fn list_later_faces(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && first_layer[face] == 0u {
        listed[atomicAdd(&arguments[0], 3u) / 3u] = face;
    }
}
