// Finds where along meridians the object begins and ceases to be shown, one invocation per texel and azimuth. Each texel follows
// the borders of two coarser ones, which an earlier dispatch has found. Twin: crates/texture/src/border_search.rs
//
// Software devices end all loops of an invocation after some number of turns, in silence. An invocation whose loops no longer turn,
// or that visits more than `most_steps` nodes and faces, marks its sample `LOST`, and the CPU bakes it.

#import "shared/invocation.wgsl"
#import "texture/visibility_function.wgsl"
#import "texture/lobe.wgsl"
#import "texture/border_answers.wgsl"

const TURN: f32 = 2.0 * HALF_TURN;

const RAYS: u32 = 0u;
const SCANS: u32 = 1u;

// Whether loops still turn.
fn loops_turn() -> bool {
    var turns = 0u;
    while turns < settings.two {
        turns += 1u;
    }
    return turns == settings.two;
}

@compute @workgroup_size(WORKGROUP)
fn find_middles(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let slot = settings.first_element + element(id, groups);
    if slot >= settings.end_element {
        return;
    }
    let distance = shown_distance(texels[slot], texels[slot].center);
    middles[slot] = select(distance, LOST, is_lost || !loops_turn());
    atomicAdd(&counts[RAYS], 1u);
}

@compute @workgroup_size(WORKGROUP)
fn find_borders(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let at = settings.first_element + element(id, groups);
    if at >= settings.end_element {
        return;
    }
    // Neighbouring invocations search along nearly the same directions from neighbouring texels.
    azimuth_index = at / settings.level_texels;
    let slot = settings.first_slot + at % settings.level_texels;
    let texel = texels[slot];
    seeds = vec2<u32>(texel.seed_before, texel.seed_after);
    let turn = f32(azimuth_index) / f32(settings.azimuths) * TURN;
    let across = cos(turn) * texel.tangent + sin(turn) * cross(texel.tangent, texel.center);
    let span = span_of(dot(texel.center, texel.normal), dot(across, texel.normal));
    let middle = middles[slot];
    is_lost = middle == LOST;
    start_search(span, middle);
    var rays = 0u;
    while search.state != DONE && !is_lost {
        var probe = search.last;
        if search.asked > search.last.angle {
            let direction = cos(search.asked) * texel.center + sin(search.asked) * across;
            probe = Probe(search.asked, shown_distance(texel, direction));
            rays += 1u;
        }
        answer(probe);
    }
    thin_borders();
    let share = lobe_angle(span) / HALF_TURN;
    let is_found = search.state == DONE && !is_lost && loops_turn();
    found[azimuth_index * settings.batch_texels + slot] = vec2<f32>(select(LOST, share, is_found), search.grazed);
    if slot < settings.known_texels {
        let to = known_at(slot);
        known[to] = border_count << 1u | u32(is_shown_first);
        for (var border = 0u; border < border_count; border += 1u) {
            known[to + 1u + border] = bitcast<u32>(borders[border]);
        }
    }
    atomicAdd(&counts[RAYS], rays);
    atomicAdd(&counts[SCANS], search.scans);
}
