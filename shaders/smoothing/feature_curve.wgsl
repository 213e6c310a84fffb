// The curve of a side: one cubic, or two of half the parameters each. Twin: crates/smoothing/src/feature_segments.rs

#import "smoothing/frame.wgsl"
#import "smoothing/hermite.wgsl"

// Elements of `curves` that a feature edge takes: of either cubic its ends and its tangents. In the first w, 1 if there are two.
const CURVE_SIZE: u32 = 8u;

struct SideCurve {
    first: Hermite,
    second: Hermite,
    is_split: bool,
}

fn unsplit(curve: Hermite) -> SideCurve {
    return SideCurve(curve, curve, false);
}

fn load_cubic(at: u32) -> Hermite {
    return Hermite(curves[at].xyz, curves[at + 1u].xyz, curves[at + 2u].xyz, curves[at + 3u].xyz);
}

// The curve of a feature edge, from its lower vertex to its higher.
fn feature_curve(feature: u32) -> SideCurve {
    let at = CURVE_SIZE * feature;
    return SideCurve(load_cubic(at), load_cubic(at + 4u), curves[at].w != 0.0);
}

fn store_cubic(at: u32, curve: Hermite, w: f32) {
    curves[at] = vec4<f32>(curve.start, w);
    curves[at + 1u] = vec4<f32>(curve.end, 0.0);
    curves[at + 2u] = vec4<f32>(curve.leaving, 0.0);
    curves[at + 3u] = vec4<f32>(curve.arriving, 0.0);
}

fn store_feature_curve(feature: u32, curve: SideCurve) {
    let at = CURVE_SIZE * feature;
    store_cubic(at, curve.first, select(0.0, 1.0, curve.is_split));
    store_cubic(at + 4u, curve.second, 0.0);
}

fn side_point(curve: SideCurve, u: f32) -> vec3<f32> {
    if !curve.is_split {
        return hermite_point(curve.first, u);
    }
    if u > 0.5 {
        return hermite_point(curve.second, 2.0 * u - 1.0);
    }
    return hermite_point(curve.first, 2.0 * u);
}

fn side_derivative(curve: SideCurve, u: f32) -> vec3<f32> {
    if !curve.is_split {
        return hermite_derivative(curve.first, u);
    }
    if u > 0.5 {
        return 2.0 * hermite_derivative(curve.second, 2.0 * u - 1.0);
    }
    return 2.0 * hermite_derivative(curve.first, 2.0 * u);
}
