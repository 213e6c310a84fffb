// Draws the object's surface on the hull: whole, or where the stored angles show it. Twin: crates/texture/src/gpu/pipelines.rs

#import "texture/hull.wgsl"

// In the order of `Shading`.
const LIT: u32 = 0u;
const FLAT: u32 = 1u;
override SHADING: u32 = LIT;

// Whether edges are cut at each of the pixel's four samples.
override IS_SOFT: bool = false;

// Where the samples of a pixel lie, from its middle, in pixels: the pattern that all graphics interfaces have in common.
const SAMPLES = array<vec2<f32>, 4>(
    vec2<f32>(-0.125, -0.375), vec2<f32>(0.375, -0.125), vec2<f32>(-0.375, 0.125), vec2<f32>(0.125, 0.375),
);

struct Drawn {
    @location(0) color: vec4<f32>,
    @builtin(sample_mask) samples: u32,
}

// The samples at which a smooth function of the image is at least 0. Its derivatives extend it from the middle of the pixel.
fn covered(value: f32) -> u32 {
    if !IS_SOFT {
        return select(0u, 0xffffffffu, value >= 0.0);
    }
    let slope = vec2<f32>(dpdx(value), dpdy(value));
    var samples = 0u;
    for (var i = 0u; i < 4u; i++) {
        samples |= select(0u, 1u << i, value + dot(slope, SAMPLES[i]) >= 0.0);
    }
    return samples;
}

// Of the object, sRGB.
fn baked_color(in: HullVertex) -> vec3<f32> {
    return textureSampleLevel(colors, linear, in.place, 0.0).rgb;
}

// Of the object, in its own space, of any length.
fn baked_normal(in: HullVertex) -> vec3<f32> {
    return textureSampleLevel(normals, linear, in.place, 0.0).xyz;
}

// Margins of points that show nothing are below.
const NOTHING: f32 = -3.0;

// How far inside the border of the lobe the direction of view lies, in radians; below 0 outside.
fn margin(in: HullVertex) -> f32 {
    let frame = hull_frame(in);
    let direction = view_direction(in);
    let share = stored_share(in.place, azimuth(frame, direction) + hull.azimuth_shift);
    return select(-0.5 * TURN, 0.5 * TURN * share - angle(frame, direction), share > 0.0);
}

// The samples at which the hull point shows the object (equation 4). The comparison of cosines is cheaper than that of angles.
fn carve(in: HullVertex) -> u32 {
    if IS_SOFT {
        let inside = margin(in);
        return select(0u, covered(inside), inside > NOTHING);
    }
    let frame = hull_frame(in);
    let direction = view_direction(in);
    let share = stored_share(in.place, azimuth(frame, direction) + hull.azimuth_shift);
    let shows = share > 0.0 && dot(frame.center, direction) >= cos(0.5 * TURN * share);
    return select(0u, 0xffffffffu, shows);
}

fn shade(in: HullVertex) -> vec4<f32> {
    if SHADING == LIT {
        return lit(vec4<f32>(baked_color(in), 1.0), hull.normal_to_shape * baked_normal(in));
    }
    if SHADING == FLAT {
        return flat_surface();
    }
    return for_target(0.5 + 0.5 * normalize(baked_normal(in)), 1.0, surface.is_linear);
}

@fragment
fn carved(in: HullVertex) -> Drawn {
    let samples = carve(in);
    if samples == 0u {
        discard;
    }
    return Drawn(shade(in), samples);
}

@fragment
fn uncarved(in: HullVertex) -> @location(0) vec4<f32> {
    return shade(in);
}
