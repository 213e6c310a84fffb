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

// How much the step from a to b exceeds those beside it, from a neighbour before a and to one after b, as a step in depth: nothing on
// a plane. Beside the end of the mesh no step counts: surfaces that curve away fall there ever more steeply.
fn excess(before: Texel, a: Texel, b: Texel, after: Texel) -> f32 {
    if !(before.is_mesh && after.is_mesh) {
        return 0.0;
    }
    let own = b.flat_depth - a.flat_depth;
    let beside = max((a.flat_depth - before.flat_depth) * sign(own), (after.flat_depth - b.flat_depth) * sign(own));
    let nearer = min(a.depth, b.depth);
    return (abs(own) - max(beside, 0.0)) * select(1.0, nearer * nearer, thresholds.is_perspective != 0u);
}

fn steps(before: Texel, a: Texel, b: Texel, after: Texel) -> bool {
    return a.is_mesh != b.is_mesh || (a.is_mesh && excess(before, a, b, after) > thresholds.depth);
}

fn parts(before: Texel, a: Texel, b: Texel, after: Texel) -> bool {
    let turns = a.is_mesh && b.is_mesh && dot(a.normal, b.normal) < thresholds.cosine;
    return turns || steps(before, a, b, after);
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

// Both diagonals of the four pixels around a corner (Roberts), with the next pixel along each. The seed lies between the middle of
// the nearer pixels and that of the farther ones.
@compute @workgroup_size(8, 8)
fn roberts(@builtin(global_invocation_id) id: vec3<u32>) {
    let p = vec2<i32>(id.xy);
    if !is_in_field(p) {
        return;
    }
    let four = array(texel(p), texel(p + vec2<i32>(1, 0)), texel(p + vec2<i32>(0, 1)), texel(p + 1));
    let down = parts(texel(p - 1), four[0], four[3], texel(p + 2));
    let up = parts(texel(p + vec2<i32>(-1, 2)), four[2], four[1], texel(p + vec2<i32>(2, -1)));
    let depths = vec4<f32>(four[0].depth, four[1].depth, four[2].depth, four[3].depth);
    let nearest_depth = min(min(depths.x, depths.y), min(depths.z, depths.w));
    let farthest_depth = max(max(depths.x, depths.y), max(depths.z, depths.w));
    let near = select(vec4<f32>(0.0), vec4<f32>(1.0), depths <= vec4<f32>(mix(nearest_depth, farthest_depth, 0.5)));
    let far = 1.0 - near;
    let nearer = vec2<f32>(near.y + near.w, near.z + near.w) / max(dot(near, vec4<f32>(1.0)), 1.0);
    let farther = vec2<f32>(far.y + far.w, far.z + far.w) / max(dot(far, vec4<f32>(1.0)), 1.0);
    let is_flat = all(far == vec4<f32>(0.0));
    store(p, down || up, select(0.5 * (nearer + farther), vec2<f32>(0.5), is_flat));
}

// The eight pixels around one, and one more beyond each: seeds lie on the nearer side of a step. Normals by Sobel's gradient.
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
    for (var neighbour = 0; neighbour < 9; neighbour++) {
        let to = vec2<i32>(neighbour % 3 - 1, neighbour / 3 - 1);
        if neighbour == 4 {
            continue;
        }
        let other = texel(p + to);
        let falls = own.is_mesh && other.depth > own.depth && steps(texel(p - to), own, other, texel(p + 2 * to));
        outward += select(vec2<f32>(0.0), vec2<f32>(to), falls);
        is_whole = is_whole && other.is_mesh;
        let weight = select(0.25, 0.5, to.x == 0 || to.y == 0);
        across += weight * mat2x3<f32>(f32(to.x) * other.normal, f32(to.y) * other.normal);
    }
    let turn = dot(across[0], across[0]) + dot(across[1], across[1]);
    let is_step = any(outward != vec2<f32>(0.0));
    store(p, is_step || (is_whole && turn > thresholds.chord_squared), 0.5 * outward / max(length(outward), 1e-30));
}
