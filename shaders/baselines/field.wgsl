// The field of nearest seeds around a view. Twins: crates/baselines/src/distance_field/field.rs, uniform.rs
//
// Depths count from the near plane: 32 bits hold little of how deep a mesh is that lies far away, and all of where in it a point lies.
//
// A seed is a point of a line within half a pixel or so of a pixel's middle. Each pixel of the field has a record (its own depth
// and object, and its seed where it has one) and the pixel whose seed is nearest to it.

struct FieldUniform {
    // Added to a pixel of the target, it yields the pixel of the field.
    to_field: vec2<i32>,
    size_px: vec2<i32>,
    // (p, q, r, s): a value v of the depth buffer stands for the depth (p v + q) / (r v + s) beyond the near plane.
    depth_terms: vec4<f32>,
    // How far ink reaches from a seed in pixels: x + y / depth, which counts from the viewer.
    reach: vec2<f32>,
    // A step in depth that rounding cannot hide: x depth + y.
    lift: vec2<f32>,
    // As the target takes it, premultiplied.
    ink: vec4<f32>,
    // Samples per pixel of the target.
    samples: u32,
    // 1: rims are blended by the share of the pixel that they cover.
    is_smooth: u32,
    // Depth of the near plane.
    near: f32,
}

@group(0) @binding(1) var<uniform> field: FieldUniform;

// Where WebGPU has the four samples of a pixel, from its corner.
const SAMPLE_PLACES = array<vec2<f32>, 4>(
    vec2<f32>(0.375, 0.125),
    vec2<f32>(0.875, 0.375),
    vec2<f32>(0.125, 0.625),
    vec2<f32>(0.625, 0.875),
);

// Of a pixel without a seed near by.
const NONE: u32 = 0xffffffffu;
// Flags of a record beside its object (bits 0 to 15) and the place of its seed (7 bits each).
const COVERED: u32 = 0x40000000u;
const SEED: u32 = 0x80000000u;
// Places of seeds are stored in this share of a pixel, up to a pixel from its middle.
const PLACES_PER_PX: f32 = 63.0;

fn packed_pixel(pixel: vec2<i32>) -> u32 {
    return u32(pixel.x) | (u32(pixel.y) << 16u);
}

fn unpacked_pixel(pixel: u32) -> vec2<i32> {
    return vec2<i32>(i32(pixel & 0xffffu), i32(pixel >> 16u));
}

// A record; `seed` is the place of the seed from the pixel's middle in pixels.
fn packed_record(depth: f32, object: u32, flags: u32, seed: vec2<f32>) -> vec2<u32> {
    let place = vec2<u32>(clamp(seed, vec2<f32>(-1.0), vec2<f32>(1.0)) * PLACES_PER_PX + 64.5);
    return vec2<u32>(bitcast<u32>(depth), object | (place.x << 16u) | (place.y << 23u) | flags);
}

fn depth_of(record: vec2<u32>) -> f32 {
    return bitcast<f32>(record.x);
}

fn object_of(record: vec2<u32>) -> u32 {
    return record.y & 0xffffu;
}

// Where the seed of a pixel is, in pixels of the field.
fn seed_of(pixel: vec2<i32>, record: vec2<u32>) -> vec2<f32> {
    let place = vec2<u32>((record.y >> 16u) & 0x7fu, (record.y >> 23u) & 0x7fu);
    return vec2<f32>(pixel) + 0.5 + (vec2<f32>(place) - 64.0) / PLACES_PER_PX;
}

fn is_in_field(pixel: vec2<i32>) -> bool {
    return all(pixel >= vec2<i32>(0)) && all(pixel < field.size_px);
}

fn depth_of_value(value: f32) -> f32 {
    let t = field.depth_terms;
    return (t.x * value + t.y) / (t.z * value + t.w);
}

fn value_of_depth(depth: f32) -> f32 {
    let t = field.depth_terms;
    return clamp((t.w * depth - t.y) / (t.x - t.z * depth), 0.0, 1.0);
}

fn lift_at(depth: f32) -> f32 {
    return field.lift.x * depth + field.lift.y;
}

// How far ink reaches from a seed of this depth, in pixels.
fn reach_px_at(depth: f32) -> f32 {
    return field.reach.x + field.reach.y / max(depth + field.near, 1e-30);
}

// Whether the first stands before the second; of two at one depth, that of the lower object does.
fn is_before(depth: f32, object: u32, other_depth: f32, other: u32) -> bool {
    let gap = other_depth - depth;
    return select(gap > 0.0, object < other, abs(gap) < lift_at(depth));
}

// Whether the ink of a seed lies over the object of a pixel: another one, and behind.
fn lies_over(seed: vec2<u32>, own: vec2<u32>) -> bool {
    return object_of(own) != object_of(seed)
        && is_before(depth_of(seed), object_of(seed), depth_of(own), object_of(own));
}

// Whether the ink of a seed may lie on a pixel: on what no object covers altogether, and on objects behind the seed's own.
fn accepts(own: vec2<u32>, seed: vec2<u32>) -> bool {
    return (own.y & COVERED) == 0u || lies_over(seed, own);
}
