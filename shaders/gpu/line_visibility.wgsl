// Which points of a line the mesh hides. Twin: crates/gpu/src/strokes/line_visibility.rs

struct LineUniform {
    // Top left corner of the viewport in the target, and its size.
    origin_px: vec2<f32>,
    viewport_px: vec2<f32>,
    // Top left corner of the viewport in the depth texture.
    depth_origin_px: vec2<f32>,
    // The stroke covers these distances to the left of the line: lowest, highest.
    span_px: vec2<f32>,
    // As the target takes it, premultiplied.
    color: vec4<f32>,
    // (p, q, r, s): a value v of the depth buffer stands for the depth (p v + q) / (r v + s) beyond the near plane.
    depth_of_value: vec4<f32>,
    // Multiplies a value of a floating-point buffer to push it one step away from the viewer.
    away_scale: f32,
    // Added to a depth-buffer value to push it one quantisation step away from the viewer.
    away_step: f32,
    // Value of pixels that nothing was drawn to.
    clear_depth: f32,
    // A line is hidden only if farther than the scene by more than this share of the scene's depth beyond the near plane ...
    relative_tolerance: f32,
    // ... plus this depth ...
    absolute_tolerance: f32,
    // ... or by more than this one.
    most_tolerance: f32,
    // 0 round, 1 miter, 2 bevel.
    join: u32,
    miter_limit: f32,
    // 1: the mesh hides lines; 0: hidden lines are drawn too.
    hide: u32,
}

@group(0) @binding(0) var<uniform> style: LineUniform;
@group(0) @binding(1) var scene_depth: texture_depth_2d;

fn view_depth(value: f32) -> f32 {
    let m = style.depth_of_value;
    return (m.x * value + m.y) / (m.z * value + m.w);
}

// Where the segment lies nearest to p: 0 at a, 1 at b.
fn along(p: vec2<f32>, a: vec2<f32>, b: vec2<f32>) -> f32 {
    let d = b - a;
    return clamp(dot(p - a, d) / max(dot(d, d), 1e-12), 0.0, 1.0);
}

// Whether the scene at the pixel that holds p lets the segment through. Buffer values are affine in the image.
fn lets_through(p: vec2<f32>, a: vec3<f32>, b: vec3<f32>) -> bool {
    let pixel = clamp(floor(p), vec2<f32>(0.0), style.viewport_px - 1.0);
    let scene = textureLoad(scene_depth, vec2<i32>(pixel + style.depth_origin_px), 0);
    if scene == style.clear_depth {
        return true;
    }
    let line = view_depth(mix(a.z, b.z, along(pixel + 0.5, a.xy, b.xy)));
    let behind = view_depth(clamp(scene * style.away_scale + style.away_step, 0.0, 1.0));
    return line <= behind + min(behind * style.relative_tolerance + style.absolute_tolerance, style.most_tolerance);
}

// Whether the segment's point nearest to p is visible: a visible silhouette edge has something farther on its outer
// side, a hidden one is behind all three samples.
fn visible_at(p: vec2<f32>, a: vec3<f32>, b: vec3<f32>) -> bool {
    let t = along(p, a.xy, b.xy);
    let q = mix(a.xy, b.xy, t);
    let d = b.xy - a.xy;
    let normal = vec2<f32>(d.y, -d.x) / max(length(d), 1e-6);
    return lets_through(q, a, b) || lets_through(q + normal, a, b) || lets_through(q - normal, a, b);
}

// Pixels of the viewport (y down) to clip space.
fn pixel_position(p: vec2<f32>) -> vec4<f32> {
    let ndc = p / style.viewport_px * 2.0 - 1.0;
    return vec4<f32>(ndc.x, -ndc.y, 0.5, 1.0);
}
