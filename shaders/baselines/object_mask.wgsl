// The objects of a group, each in its number. Twin: crates/baselines/src/jump_flood/object_mask.rs

#import "shared/camera.wgsl"

struct ObjectUniform {
    // From 1 on; 0 is the ground.
    @size(16) object: u32,
}

@group(0) @binding(1) var<uniform> mask: ObjectUniform;

@vertex
fn object_vertex(@location(0) position: vec3<f32>) -> @builtin(position) vec4<f32> {
    return clip_position(position);
}

@fragment
fn object_number() -> @location(0) u32 {
    return mask.object;
}
