// Moves vertices along a wave: stands for skinning.

struct Time {
    seconds: f32,
    sway: f32,
}

@group(0) @binding(0) var<uniform> time: Time;
@group(0) @binding(1) var<storage, read> rest: array<f32>;
@group(0) @binding(2) var<storage, read_write> positions: array<f32>;

@compute @workgroup_size(64)
fn sway(@builtin(global_invocation_id) id: vec3<u32>) {
    let first = 3u * id.x;
    if first + 2u >= arrayLength(&rest) {
        return;
    }
    let y = rest[first + 1u];
    positions[first] = rest[first] + time.sway * sin(4.0 * y + 6.0 * time.seconds);
    positions[first + 1u] = y;
    positions[first + 2u] = rest[first + 2u] + time.sway * cos(4.0 * y + 6.0 * time.seconds);
}
