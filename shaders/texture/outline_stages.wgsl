// Draws the object's outlines on the hull (equation 5). Twin: crates/texture/src/gpu/pipelines.rs

#import "texture/surface_stages.wgsl"

// In the order of `OutlineWidth`.
const BY_GRADIENT: u32 = 0u;
const BY_GAP: u32 = 1u;
override WIDTH_LAW: u32 = BY_GRADIENT;

// By how much the distance by gap may exceed that by gradient: gaps are means over all azimuths.
const MOST_DISAGREEMENT: f32 = 4.0;
// Signed distance from the outline in pixels, above 0 inside; as printed, in the unit of `half_width`.
fn outline_distance(in: HullVertex) -> f32 {
    let inside = margin(in);
    let w = 1.0 / in.position.w;
    if WIDTH_LAW > BY_GAP {
        return inside / (hull.allowance_per_w * w);
    }
    // Beyond any line, and no farther, so that slopes at the border of what is known stay small.
    let beyond = hull.half_width + 2.0;
    let far = sign(inside) * beyond;
    // The outline lies beyond the hull, where a pixel is larger.
    let gap = textureSampleLevel(gaps, linear, in.place, 0.0).x * hull.gap_unit;
    let outline_w = w + gap * (camera.to_clip * vec4<f32>(view_direction(in), 0.0)).w;
    let by_gap = inside * gap / (hull.pixel_per_w * outline_w);
    if WIDTH_LAW == BY_GAP {
        // Without a gap no outline is seen from here.
        return select(far, clamp(by_gap, -beyond, beyond), gap > 0.0 && inside > NOTHING);
    }
    // Where the margin jumps its slope stands for no distance. There the gap, exact or not, says that the outline is far away.
    let by_gradient = inside / max(length(vec2<f32>(dpdx(inside), dpdy(inside))), 1e-20);
    return select(far, clamp(by_gradient, -beyond, beyond), abs(by_gap) < MOST_DISAGREEMENT * hull.half_width && inside > NOTHING);
}

// Surface and ink on its border; half of the ink lies outside.
@fragment
fn inked_paper(in: HullVertex) -> Drawn {
    let distance = outline_distance(in);
    let samples = covered(distance + hull.half_width);
    // One pixel of transition where edges are soft.
    let paper = select(step(hull.half_width, distance), saturate(distance - hull.half_width + 0.5), IS_SOFT);
    if samples == 0u {
        discard;
    }
    let color = mix(hull.ink, hull.paper, paper);
    return Drawn(for_target(color.rgb, color.a, surface.is_linear), samples);
}

@fragment
fn ink_alone(in: HullVertex) -> Drawn {
    let distance = outline_distance(in);
    let samples = covered(distance + hull.half_width) & covered(hull.half_width - distance);
    if samples == 0u {
        discard;
    }
    return Drawn(for_target(hull.ink.rgb, hull.ink.a, surface.is_linear), samples);
}
