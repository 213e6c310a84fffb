// The cubic of Eq. 5, with tangents as long as Eq. 4 has them. Twin: crates/smoothing/src/hermite.rs

struct Hermite {
    start: vec3<f32>,
    end: vec3<f32>,
    // Derivatives by the parameter at both ends.
    leaving: vec3<f32>,
    arriving: vec3<f32>,
}

// A direction whose share of the chord is below this is noise: the chord takes its place.
const LEAST_SHARE: f32 = 1e-6;

fn arc_tangent(chord: vec3<f32>, direction: vec3<f32>) -> vec3<f32> {
    let chord_length = length(chord);
    let size = length(direction);
    if !(size > LEAST_SHARE * chord_length && chord_length > 0.0) {
        return chord;
    }
    let cosine = dot(chord, direction) / (chord_length * size);
    return direction * (2.0 * chord_length / (1.0 + cosine) / size);
}

// The curve between two points that leaves and arrives along two directions of any length.
fn hermite_along(start: vec3<f32>, end: vec3<f32>, leaving: vec3<f32>, arriving: vec3<f32>) -> Hermite {
    let chord = end - start;
    return Hermite(start, end, arc_tangent(chord, leaving), arc_tangent(chord, arriving));
}

// The ends are met exactly.
fn hermite_point(curve: Hermite, u: f32) -> vec3<f32> {
    let chord = curve.end - curve.start;
    let bend = u * (1.0 - u) * ((1.0 - u) * (curve.leaving - chord) - u * (curve.arriving - chord));
    return select(curve.start + u * chord + bend, curve.end, u >= 1.0);
}

fn hermite_derivative(curve: Hermite, u: f32) -> vec3<f32> {
    let chord = curve.end - curve.start;
    let a = curve.leaving - chord;
    let b = curve.arriving - chord;
    return chord + (1.0 - u) * (1.0 - 3.0 * u) * a + u * (3.0 * u - 2.0) * b;
}

// Section III-C: the curve between two points with unit normals that lies in their tangent planes, Eqs. 2 and 3.
fn bridge(start: vec3<f32>, end: vec3<f32>, n0: vec3<f32>, n1: vec3<f32>) -> Hermite {
    let chord = end - start;
    return hermite_along(start, end, chord - dot(chord, n0) * n0, chord - dot(chord, n1) * n1);
}
