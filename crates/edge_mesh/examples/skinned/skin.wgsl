// Linear blend skinning by two joints.

@group(0) @binding(0) var<uniform> joints: array<mat4x4<f32>, 2>;
@group(0) @binding(1) var<storage, read> rest: array<f32>;
@group(0) @binding(2) var<storage, read> weights: array<f32>;
@group(0) @binding(3) var<storage, read_write> positions: array<f32>;

@compute @workgroup_size(64)
fn skin(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&weights) {
        return;
    }
    let at = 3u * id.x;
    let position = vec4<f32>(rest[at], rest[at + 1u], rest[at + 2u], 1.0);
    let blended = mix((joints[0] * position).xyz, (joints[1] * position).xyz, weights[id.x]);
    positions[at] = blended.x;
    positions[at + 1u] = blended.y;
    positions[at + 2u] = blended.z;
}
