// Unit vectors in 32 bits. Twin: crates/edge_mesh/src/oct_normal.rs

// What stands for a vector without direction.
const NO_NORMAL: u32 = 0x80008000u;

// Mirrors a point of one half of the square at the diagonal of its quadrant.
fn oct_fold(point: vec2<f32>) -> vec2<f32> {
    return (1.0 - abs(point.yx)) * select(vec2<f32>(1.0), vec2<f32>(-1.0), point < vec2<f32>(0.0));
}

fn oct_encode(normal: vec3<f32>) -> u32 {
    let sum = abs(normal.x) + abs(normal.y) + abs(normal.z);
    if !(sum > 0.0 && sum <= 3.4028234e38) {
        return NO_NORMAL;
    }
    let upper = normal.xy / sum;
    return pack2x16snorm(select(upper, oct_fold(upper), normal.z < 0.0));
}

fn oct_decode(stored: u32) -> vec3<f32> {
    let square = unpack2x16snorm(stored);
    let z = 1.0 - abs(square.x) - abs(square.y);
    return normalize(vec3<f32>(select(square, oct_fold(square), z < 0.0), z));
}
