// The tangent frame in which directions at a hull point are expressed. Twin: crates/texture/src/frame.rs

const TURN: f32 = 6.283185307;
const LEAST_TANGENT: f32 = 1e-4;

struct Frame {
    center: vec3<f32>,
    tangent: vec3<f32>,
    binormal: vec3<f32>,
}

// A unit vector across a unit vector: along the axis that it is least along.
fn perpendicular(unit: vec3<f32>) -> vec3<f32> {
    let size = abs(unit);
    var axis = vec3<f32>(0.0, 0.0, 1.0);
    if size.x <= size.y && size.x <= size.z {
        axis = vec3<f32>(1.0, 0.0, 0.0);
    } else if size.y <= size.z {
        axis = vec3<f32>(0.0, 1.0, 0.0);
    }
    return normalize(axis - dot(axis, unit) * unit);
}

fn frame_of(given_center: vec3<f32>, given_tangent: vec3<f32>) -> Frame {
    let size = length(given_center);
    let center = select(vec3<f32>(0.0, 0.0, 1.0), given_center / size, size > 0.0);
    let across = given_tangent - dot(given_tangent, center) * center;
    let width = length(across);
    let tangent = select(perpendicular(center), across / width, width > LEAST_TANGENT);
    return Frame(center, tangent, cross(tangent, center));
}

// In turns from -1/2 to 1/2; 0 for the centre and its opposite.
fn azimuth(frame: Frame, direction: vec3<f32>) -> f32 {
    let x = dot(direction, frame.tangent);
    let y = dot(direction, frame.binormal);
    return atan2(y, select(x, 1.0, x == 0.0 && y == 0.0)) / TURN;
}

// In radians from 0 to half a turn, for a direction of any length.
fn angle(frame: Frame, direction: vec3<f32>) -> f32 {
    return atan2(length(cross(frame.center, direction)), dot(frame.center, direction));
}
