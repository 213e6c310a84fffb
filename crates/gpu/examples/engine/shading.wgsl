// The engine's own shading, and its depth pass.

struct Drawn {
    to_clip: mat4x4<f32>,
    // Linear light.
    color: vec4<f32>,
}

@group(0) @binding(0) var<uniform> drawn: Drawn;

struct Shaded {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) local: vec3<f32>,
}

@vertex
fn vertex(@location(0) position: vec3<f32>) -> Shaded {
    return Shaded(drawn.to_clip * vec4<f32>(position, 1.0), position);
}

@fragment
fn shaded(in: Shaded) -> @location(0) vec4<f32> {
    let normal = normalize(cross(dpdx(in.local), dpdy(in.local)));
    let light = 0.35 + 0.65 * abs(dot(normal, normalize(vec3<f32>(0.4, 0.8, 0.5))));
    return vec4<f32>(drawn.color.rgb * light, 1.0);
}
