// Silhouette points that move continuously: they emerge from the ends of bridges, and lie beside a bridge where it does not cross the
// contour. Twin: crates/smoothing/src/emerging_points.rs

#import "smoothing/frame.wgsl"

// How many times u / (1 - u) of a point may be its value in parallel projection, or the other way around.
const MOST_UNEVEN: f32 = 2.0;

// How far beside its bridge a point may lie, as a share of the chord.
const MOST_BESIDE: f32 = 0.25;

// The parameter closest to `u` at which a silhouette point may lie, given N . D at both ends.
fn evened(u: f32, start: f32, end: f32) -> f32 {
    let a = abs(start);
    let c = abs(end);
    if c * u > MOST_UNEVEN * a * (1.0 - u) {
        return MOST_UNEVEN * a / (MOST_UNEVEN * a + c);
    }
    if a * (1.0 - u) > MOST_UNEVEN * c * u {
        return a / (a + MOST_UNEVEN * c);
    }
    return u;
}

// The unit vector across a view that is closest to a normal.
fn across_view(normal: vec3<f32>, toward: vec3<f32>) -> vec3<f32> {
    let view = unit_or_zero(toward);
    return unit_or_zero(normal - dot(normal, view) * view);
}

// The way from a point of a bridge to the contour, where the normal is `turned`, if the surface between is a sphere. None where the
// surface turns inwards.
fn way_beside(chord: vec3<f32>, turn: vec3<f32>, normal: vec3<f32>, turned: vec3<f32>) -> vec3<f32> {
    let bend = dot(chord, turn);
    if bend <= 0.0 {
        return vec3<f32>(0.0);
    }
    let way = bend / dot(turn, turn) * (turned - normal);
    return way * min(1.0, MOST_BESIDE * length(chord) / max(length(way), 1e-30));
}
