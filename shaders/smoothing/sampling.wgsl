// Section III-E, adaptive sampling: how many straight segments a curve is drawn as. Twin: crates/smoothing/src/sampling.rs

#import "shared/camera.wgsl"
#import "smoothing/frame.wgsl"
#import "smoothing/hermite.wgsl"

const MAX_SEGMENTS: f32 = 64.0;

const SAMPLING_AS_PRINTED: u32 = 1u;

// Homogeneous pixels from the middle of the image: their last part is w.
fn pixel_of(point: vec3<f32>) -> vec3<f32> {
    let clip = clip_position(point);
    return vec3<f32>(0.5 * settings.viewport_px * clip.xy, clip.w);
}

fn whole_segments(count: f32) -> u32 {
    return u32(clamp(ceil(count), 1.0, MAX_SEGMENTS));
}

// Second difference of three control points, less the part that w has as well, which moves points along the line of sight.
fn bend_at(before: vec3<f32>, at: vec3<f32>, after: vec3<f32>) -> f32 {
    let difference = (before - at) - (at - after);
    return length(difference.xy - difference.z / at.z * at.xy);
}

fn guaranteed_segments(curve: Hermite) -> u32 {
    let a = pixel_of(curve.start);
    let b = pixel_of(curve.start + curve.leaving / 3.0);
    let c = pixel_of(curve.end - curve.arriving / 3.0);
    let d = pixel_of(curve.end);
    let nearest = min(min(a.z, b.z), min(c.z, d.z));
    let farthest = max(max(a.z, b.z), max(c.z, d.z));
    if farthest <= 0.0 {
        return 1u;
    }
    // A curve through the plane of the eye has no bound.
    if nearest <= 0.0 {
        return u32(MAX_SEGMENTS);
    }
    let bend = max(bend_at(a, b, c), bend_at(b, c, d)) / nearest;
    return whole_segments(sqrt(0.75 * bend / settings.tolerance_px) * (farthest / nearest));
}

// Eq. 8, its n read as the number of segments.
fn printed_segments(curve: Hermite, n0: vec3<f32>, n1: vec3<f32>) -> u32 {
    let middle = pixel_of(hermite_point(curve, 0.5));
    if middle.z <= 0.0 {
        return 1u;
    }
    let start = pixel_of(curve.start);
    let end = pixel_of(curve.end);
    let height = distance(middle.xy / middle.z, 0.5 * (start.xy / start.z + end.xy / end.z));
    let sine_of_half = sqrt(0.5 * (1.0 - clamp(dot(n0, n1), -1.0, 1.0)));
    return whole_segments(0.5 * sqrt(height * sine_of_half / settings.tolerance_px));
}
