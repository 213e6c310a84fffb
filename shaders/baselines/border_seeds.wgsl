// Seeds on the borders of objects, where each stands before another or before the ground.
// Twin: crates/baselines/src/jump_flood/border_seeds.rs

#import "baselines/field.wgsl"
#import "baselines/border_place.wgsl"

@group(1) @binding(0) var objects: texture_multisampled_2d<u32>;
@group(1) @binding(1) var depths: texture_depth_multisampled_2d;
@group(2) @binding(0) var records: texture_storage_2d<rg32uint, write>;
@group(2) @binding(1) var nearest: texture_storage_2d<r32uint, write>;

const SAMPLES: i32 = 4;

// Whether the object covers a part of each pixel beside this one: whatever else they have, no border runs between. One sample each
// suffices for most pixels.
fn is_within(pixel: vec2<i32>, object: u32) -> bool {
    for (var side = 0; side < 4; side++) {
        let along = select(vec2<i32>(1, 0), vec2<i32>(0, 1), side >= 2);
        let beside = pixel + along * (1 - 2 * (side % 2));
        if is_in_field(beside) && textureLoad(objects, beside, 0).x != object {
            return false;
        }
    }
    return true;
}

// Of a border that runs through a pixel, half of the diagonal.
const FARTHEST_PLACE_PX: f32 = 0.7071;

@compute @workgroup_size(8, 8)
fn plant(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = vec2<i32>(id.xy);
    if !is_in_field(pixel) {
        return;
    }
    // The object in front within the pixel.
    var object = 0u;
    var depth = 0.0;
    var is_covered = true;
    for (var i = 0; i < SAMPLES; i++) {
        let other = textureLoad(objects, pixel, i).x;
        if other == 0u {
            is_covered = false;
            continue;
        }
        let other_depth = depth_of_value(textureLoad(depths, pixel, i));
        is_covered = is_covered && (object == 0u || other == object);
        if (object == 0u || is_before(other_depth, other, depth, object)) {
            object = other;
            depth = other_depth;
        }
    }
    // Most pixels lie on the ground or within an object. Software adapters run both sides of a condition, and no loop that nobody
    // enters.
    let is_within_object = is_covered && is_within(pixel, object);
    let neighbours = select(9, 0, object == 0u || is_within_object);
    var around = 0;
    var farthest = depth;
    var inward = vec2<f32>(0.0);
    var stands_beside = false;
    for (var neighbour = 0; neighbour < neighbours; neighbour++) {
        let to = vec2<i32>(neighbour % 3 - 1, neighbour / 3 - 1);
        if !is_in_field(pixel + to) {
            continue;
        }
        var same = 0;
        var stands_before = false;
        for (var i = 0; i < SAMPLES; i++) {
            let other = textureLoad(objects, pixel + to, i).x;
            let other_depth = depth_of_value(textureLoad(depths, pixel + to, i));
            if other == object {
                same += 1;
                farthest = max(farthest, other_depth);
                inward += vec2<f32>(to) + SAMPLE_PLACES[i] - 0.5;
            } else if other == 0u || is_before(depth, object, other_depth, other) {
                stands_before = true;
            }
        }
        // Where a pixel that the object covers in part lies between, the border runs there.
        stands_beside |= same == 0 && stands_before && abs(to.x) + abs(to.y) == 1;
        around += same;
    }
    let is_border = neighbours > 0 && (!is_covered || stands_beside);
    let flags = select(0u, COVERED, is_covered) | select(0u, SEED, is_border);
    // The nine pixels as one square: its 36 samples place a border better than four do. It runs through the pixel in their middle.
    let place = 3.0 * border_place(inward, f32(around) / f32(9 * SAMPLES));
    let within = place * min(FARTHEST_PLACE_PX / max(length(place), 1e-6), 1.0);
    // The ink of a seed lies behind the object itself; other pixels say what ink must be nearer than.
    let record = packed_record(select(depth, farthest, is_border), object, flags, within);
    textureStore(records, pixel, vec4<u32>(select(record, vec2<u32>(0u), object == 0u), 0u, 0u));
    textureStore(nearest, pixel, vec4<u32>(select(NONE, packed_pixel(pixel), is_border), 0u, 0u, 0u));
}
