// Ink along discontinuities, as wide as asked. Twin: crates/baselines/src/gbuffer_filter/filter_ink.rs

#import "shared/full_screen.wgsl"
#import "baselines/field.wgsl"
#import "baselines/rim.wgsl"

@group(1) @binding(0) var records: texture_2d<u32>;
@group(1) @binding(1) var nearest: texture_2d<u32>;

@fragment
fn filter_ink(@builtin(position) position: vec4<f32>) -> Inked {
    let pixel = vec2<i32>(position.xy) + field.to_field;
    let known = textureLoad(nearest, pixel, 0).x;
    if known == NONE {
        discard;
    }
    let at = unpacked_pixel(known);
    let record = textureLoad(records, at, 0).xy;
    let depth = depth_of(record);
    // The middle of a pixel is up to half a pixel beside the nearest seed of a line, along the line.
    let half_px = reach_px_at(depth);
    let reach_px = sqrt(half_px * half_px + 0.25);
    let is_near = half_px > 0.0 && distance(vec2<f32>(pixel) + 0.5, seed_of(at, record)) < reach_px + 1.0;
    // On whatever of the mesh is around the pixel: its samples may be nearer than its middle.
    var nearer = depth;
    let neighbours = select(0, 9, is_near);
    for (var neighbour = 0; neighbour < neighbours; neighbour++) {
        let beside = pixel + vec2<i32>(neighbour % 3 - 1, neighbour / 3 - 1);
        let other = depth_of(textureLoad(records, clamp(beside, vec2<i32>(0), field.size_px - 1), 0).xy);
        nearer = min(nearer, other);
    }
    let ink = inked(pixel, seed_of(at, record), reach_px, nearer - lift_at(nearer));
    if ink.samples == 0u || !is_near {
        discard;
    }
    return ink;
}
