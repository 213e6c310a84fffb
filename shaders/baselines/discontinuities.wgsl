// Seeds where depth steps or normals turn. Twin: crates/baselines/src/gbuffer_filter/discontinuities.rs

#import "baselines/field.wgsl"

struct Thresholds {
    // Least step in depth, in units of view space.
    depth: f32,
    // Cosine of the least angle between normals, and the square of the chord of that angle. -2 and 5: none is found.
    cosine: f32,
    chord_squared: f32,
    is_perspective: u32,
}

@group(1) @binding(0) var normals: texture_2d<f32>;
@group(1) @binding(1) var depths: texture_depth_2d;
@group(1) @binding(2) var<uniform> thresholds: Thresholds;
@group(2) @binding(0) var records: texture_storage_2d<rg32uint, write>;
@group(2) @binding(1) var nearest: texture_storage_2d<r32uint, write>;

const NOWHERE: f32 = 3e38;

struct Texel {
    normal: vec3<f32>,
    is_mesh: bool,
    depth: f32,
    // What a plane is linear in over the image: minus the depth, or one over it in a perspective.
    flat_depth: f32,
}

fn texel(pixel: vec2<i32>) -> Texel {
    let at = clamp(pixel, vec2<i32>(0), field.size_px - 1);
    let normal = textureLoad(normals, at, 0);
    let depth = depth_of_value(textureLoad(depths, at, 0));
    let is_mesh = normal.w > 0.5;
    return Texel(normal.xyz, is_mesh, select(NOWHERE, depth, is_mesh), select(-depth, 1.0 / depth, thresholds.is_perspective != 0u));
}

// A difference of flat depths at a depth as a step in depth.
fn step_of(difference: f32, depth: f32) -> f32 {
    return difference * select(1.0, depth * depth, thresholds.is_perspective != 0u);
}

// How much the step from a to b exceeds that from a neighbour before a, and that to one after b: nothing on a plane.
fn excess(before: Texel, a: Texel, b: Texel, after: Texel) -> f32 {
    let own = b.flat_depth - a.flat_depth;
    let first = select(0.0, a.flat_depth - before.flat_depth, before.is_mesh);
    let last = select(0.0, after.flat_depth - b.flat_depth, after.is_mesh);
    return step_of(min(abs(own - first), abs(own - last)), min(a.depth, b.depth));
}

fn parts(before: Texel, a: Texel, b: Texel, after: Texel) -> bool {
    if !(a.is_mesh && b.is_mesh) {
        return a.is_mesh != b.is_mesh;
    }
    return excess(before, a, b, after) > thresholds.depth || dot(a.normal, b.normal) < thresholds.cosine;
}

fn store(pixel: vec2<i32>, is_seed: bool, place: vec2<f32>) {
    // Ink lies on the nearest of what is around it.
    var depth = NOWHERE;
    for (var neighbour = 0; neighbour < 9; neighbour++) {
        depth = min(depth, texel(pixel + vec2<i32>(neighbour % 3 - 1, neighbour / 3 - 1)).depth);
    }
    let record = packed_record(depth, 0u, select(0u, SEED, is_seed), place);
    textureStore(records, pixel, vec4<u32>(record, 0u, 0u));
    textureStore(nearest, pixel, vec4<u32>(select(NONE, packed_pixel(pixel), is_seed), 0u, 0u, 0u));
}

// Both diagonals of the four pixels around a corner (Roberts), with the next pixel along each.
@compute @workgroup_size(8, 8)
fn roberts(@builtin(global_invocation_id) id: vec3<u32>) {
    let p = vec2<i32>(id.xy);
    if !is_in_field(p) {
        return;
    }
    let down = parts(texel(p - 1), texel(p), texel(p + 1), texel(p + 2));
    let up = parts(
        texel(p + vec2<i32>(-1, 2)),
        texel(p + vec2<i32>(0, 1)),
        texel(p + vec2<i32>(1, 0)),
        texel(p + vec2<i32>(2, -1)),
    );
    store(p, down || up, vec2<f32>(0.5));
}

// The eight pixels around one: depth by the second difference along each line through it, normals by Sobel's gradient.
@compute @workgroup_size(8, 8)
fn sobel(@builtin(global_invocation_id) id: vec3<u32>) {
    let p = vec2<i32>(id.xy);
    if !is_in_field(p) {
        return;
    }
    let own = texel(p);
    var outward = vec2<f32>(0.0);
    var across = mat2x3<f32>(vec3<f32>(0.0), vec3<f32>(0.0));
    var is_whole = own.is_mesh;
    for (var i = 0; i < 4; i++) {
        let to = vec2<i32>(select(1, i - 1, i < 3), select(0, 1, i < 3));
        let a = texel(p + to);
        let b = texel(p - to);
        let drop = step_of(2.0 * own.flat_depth - a.flat_depth - b.flat_depth, own.depth);
        let is_step = a.is_mesh && b.is_mesh && drop > thresholds.depth;
        let a_is_farther = select(a.flat_depth < b.flat_depth, !a.is_mesh, !(a.is_mesh && b.is_mesh));
        let falls = own.is_mesh && (is_step || a.is_mesh != b.is_mesh);
        outward += select(vec2<f32>(0.0), select(-vec2<f32>(to), vec2<f32>(to), a_is_farther), falls);
        is_whole = is_whole && a.is_mesh && b.is_mesh;
        let weight = select(0.25, 0.5, to.x == 0 || to.y == 0);
        across += weight * mat2x3<f32>(f32(to.x) * (a.normal - b.normal), f32(to.y) * (a.normal - b.normal));
    }
    let turn = dot(across[0], across[0]) + dot(across[1], across[1]);
    let is_step = any(outward != vec2<f32>(0.0));
    store(p, is_step || (is_whole && turn > thresholds.chord_squared), 0.5 * outward / max(length(outward), 1e-30));
}
