// Seeds where depth steps or normals turn. Twin: crates/baselines/src/gbuffer_filter/discontinuities.rs

#import "baselines/field.wgsl"
#import "baselines/texel.wgsl"

@group(2) @binding(0) var records: texture_storage_2d<rg32uint, write>;
@group(2) @binding(1) var nearest: texture_storage_2d<r32uint, write>;

// Whether depth steps between neighbours a and b, b being `to` from a: the step counts as far as it exceeds those beside it, from the
// pixel before a and to the one after b, which on a plane is nothing. Beside the end of the mesh no step counts: surfaces that curve
// away fall there ever more steeply.
fn steps(a: Texel, b: Texel, at: vec2<i32>, to: vec2<i32>) -> bool {
    if !(a.is_mesh && b.is_mesh) {
        return a.is_mesh != b.is_mesh;
    }
    let own = b.flat_depth - a.flat_depth;
    let nearer = min(a.depth, b.depth);
    if step_of(abs(own), nearer) <= thresholds.depth {
        return false;
    }
    let before = texel(at - to);
    let after = texel(at + 2 * to);
    let beside = max((a.flat_depth - before.flat_depth) * sign(own), (after.flat_depth - b.flat_depth) * sign(own));
    let excess = abs(own) - max(beside, 0.0);
    return before.is_mesh && after.is_mesh && step_of(excess, nearer) > thresholds.depth;
}

fn turns(a: Texel, b: Texel, at: vec2<i32>, to: vec2<i32>) -> bool {
    return thresholds.finds_turns != 0u && a.is_mesh && b.is_mesh && dot(normal(at), normal(at + to)) < thresholds.cosine;
}

fn store(pixel: vec2<i32>, depth: f32, is_seed: bool, place: vec2<f32>) {
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
    let up_from = p + vec2<i32>(0, 1);
    let up = vec2<i32>(1, -1);
    let is_seed = steps(four[0], four[3], p, vec2<i32>(1)) || steps(four[2], four[1], up_from, up)
        || turns(four[0], four[3], p, vec2<i32>(1)) || turns(four[2], four[1], up_from, up);
    if !is_seed {
        store(p, four[0].depth, false, vec2<f32>(0.0));
        return;
    }
    let around = vec4<f32>(four[0].depth, four[1].depth, four[2].depth, four[3].depth);
    let nearest_depth = min(min(around.x, around.y), min(around.z, around.w));
    let farthest_depth = max(max(around.x, around.y), max(around.z, around.w));
    let near = select(vec4<f32>(0.0), vec4<f32>(1.0), around <= vec4<f32>(mix(nearest_depth, farthest_depth, 0.5)));
    let far = 1.0 - near;
    let nearer = vec2<f32>(near.y + near.w, near.z + near.w) / max(dot(near, vec4<f32>(1.0)), 1.0);
    let farther = vec2<f32>(far.y + far.w, far.z + far.w) / max(dot(far, vec4<f32>(1.0)), 1.0);
    let is_flat = all(far == vec4<f32>(0.0));
    store(p, nearest_depth, true, select(0.5 * (nearer + farther), vec2<f32>(0.5), is_flat));
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
        let falls = own.is_mesh && other.depth > own.depth && steps(own, other, p, to);
        outward += select(vec2<f32>(0.0), vec2<f32>(to), falls);
        is_whole = is_whole && other.is_mesh;
        if thresholds.finds_turns != 0u {
            let weighted = select(0.25, 0.5, to.x == 0 || to.y == 0) * normal(p + to);
            across += mat2x3<f32>(f32(to.x) * weighted, f32(to.y) * weighted);
        }
    }
    let turn = dot(across[0], across[0]) + dot(across[1], across[1]);
    let is_crease = thresholds.finds_turns != 0u && is_whole && turn > thresholds.chord_squared;
    let is_step = any(outward != vec2<f32>(0.0));
    store(p, own.depth, is_step || is_crease, 0.5 * outward / max(length(outward), 1e-30));
}
