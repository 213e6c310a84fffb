// Running sums: before each element, the sum of those before it. Each workgroup sums a block and leaves its total to the next
// level; whoever needs a sum adds up the levels. Twin: crates/smoothing/src/gpu/prefix_sum.rs

#import "smoothing/frame.wgsl"
#import "smoothing/sums.wgsl"

const LANES: u32 = 64u;
// BLOCK / LANES.
const PER_LANE: u32 = 4u;

var<workgroup> lanes: array<vec4<u32>, LANES>;

// Sums one block of the level that begins at `from_at` and ends before `to_at`, where the totals of its blocks go.
fn sum_block(block: u32, lane: u32, from_at: u32, to_at: u32, count: u32) {
    let first = block * BLOCK + lane * PER_LANE;
    var own: array<vec4<u32>, PER_LANE>;
    var sum = vec4<u32>(0u);
    for (var i = 0u; i < PER_LANE; i++) {
        own[i] = sum;
        if first + i < count {
            sum += sums[from_at + first + i];
        }
    }
    lanes[lane] = sum;
    workgroupBarrier();
    for (var step = 1u; step < LANES; step *= 2u) {
        var before = vec4<u32>(0u);
        if lane >= step {
            before = lanes[lane - step];
        }
        workgroupBarrier();
        lanes[lane] += before;
        workgroupBarrier();
    }
    let base = lanes[lane] - sum;
    for (var i = 0u; i < PER_LANE; i++) {
        if first + i < count {
            sums[from_at + first + i] = base + own[i];
        }
    }
    if lane == LANES - 1u && block * BLOCK < count {
        sums[to_at + block] = lanes[lane];
    }
}

@compute @workgroup_size(LANES)
fn sum_level_0(
    @builtin(workgroup_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    sum_block(id.x + id.y * groups.x, lane, 0u, settings.level_1_at, settings.level_1_at);
}

@compute @workgroup_size(LANES)
fn sum_level_1(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    sum_block(id.x, lane, settings.level_1_at, settings.level_2_at, settings.level_2_at - settings.level_1_at);
}

@compute @workgroup_size(LANES)
fn sum_level_2(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    sum_block(id.x, lane, settings.level_2_at, settings.total_at, settings.total_at - settings.level_2_at);
}
