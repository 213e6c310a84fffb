// Edges of back faces, listed for drawing. Twin: crates/image_precision/src/back_edges.rs
//
// An edge between two back faces cannot be a silhouette edge. The table counts back faces for every edge, known by the
// positions of its ends; those counted once are listed. Which face comes first is left to chance; the list as a set is not,
// as long as every edge finds a place within the longest probe.

#import "shared/invocation.wgsl"
#import "shared/mesh.wgsl"
#import "shared/line_polygon.wgsl"
#import "image_precision/style.wgsl"
#import "image_precision/front_mark.wgsl"

// The faces: their number, and their own numbers.
@group(2) @binding(0) var<storage, read> faces: array<u32>;
@group(2) @binding(1) var<storage, read_write> table: array<atomic<u32>>;
// The same, read once it is complete.
@group(2) @binding(1) var<storage, read_write> slots: array<vec4<u32>>;
@group(2) @binding(2) var<storage, read_write> listed: array<u32>;
@group(2) @binding(3) var<storage, read_write> arguments: array<atomic<u32>>;

// In a slot: counted more than once. Below it `FRONT`, and the corner where the edge begins, plus one; in the bits that no
// corner needs a part of the hash, so that most other edges are ruled out without comparing their ends.
const SHARED: u32 = 0x80000000u;
const LONGEST_PROBE: u32 = 64u;

fn list(edge: u32) {
    let vertices = vertices_per_line(style.line.shape);
    listed[atomicAdd(&arguments[0], vertices) / vertices] = edge;
}

fn mixed(hash: u32, word: u32) -> u32 {
    let h = (hash ^ word) * 0x9e3779b1u;
    return h ^ (h >> 15u);
}

// The end of Appleby's MurmurHash3: every bit takes part in every other.
fn finished(hash: u32) -> u32 {
    let h = (hash ^ (hash >> 16u)) * 0x85ebca6bu;
    let g = (h ^ (h >> 13u)) * 0xc2b2ae35u;
    return g ^ (g >> 16u);
}

fn hash_of(p: vec3<f32>) -> u32 {
    // Minus zero is zero.
    let words = bitcast<vec3<u32>>(select(p, vec3<f32>(0.0), p == vec3<f32>(0.0)));
    return mixed(mixed(mixed(0x811c9dc5u, words.x), words.y), words.z);
}

// Whether the edge from a to b has the ends of another one, in either order. Places count, not numbers, so that triangles
// need not share vertices.
fn is_same(a: vec3<f32>, b: vec3<f32>, other: u32) -> bool {
    let c = corner_position(other);
    let d = corner_position(next_corner(other));
    return (all(a == c) && all(b == d)) || (all(a == d) && all(b == c));
}

fn count(corner: u32, front: u32) {
    let a = corner_position(corner);
    let b = corner_position(next_corner(corner));
    let ends = vec2<u32>(hash_of(a), hash_of(b));
    // The same whichever end comes first.
    let hash = finished(mixed(mixed(0x811c9dc5u, min(ends.x, ends.y)), max(ends.x, ends.y)));
    let tag_mask = ~(SHARED | FRONT | style.corner_mask);
    let entry = (corner + 1u) | front | (hash & tag_mask);
    // Bits that no tag holds take part as well.
    var slot = (hash ^ (hash >> 16u)) & style.slot_mask;
    for (var probe = 0u; probe < LONGEST_PROBE; probe++) {
        let seen = atomicCompareExchangeWeak(&table[slot], 0u, entry);
        if seen.exchanged {
            return;
        }
        // A weak exchange may fail without a reason; the slot is then still empty and is tried again.
        if seen.old_value != 0u {
            let may_be = ((seen.old_value ^ entry) & tag_mask) == 0u;
            if may_be && is_same(a, b, (seen.old_value & style.corner_mask) - 1u) {
                atomicOr(&table[slot], SHARED);
                return;
            }
            // Steps that grow by one visit every slot of a power of two, and part edges that begin side by side.
            slot = (slot + probe + 1u) & style.slot_mask;
        }
    }
    // A full neighbourhood: the edge is drawn, hidden or not.
    list(corner | front);
}

// One invocation per edge of a listed face; y is the edge, 0 to 2.
@compute @workgroup_size(WORKGROUP)
fn add_edges(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    for (var at = id.x; at < faces[0]; at += row(groups)) {
        let face = faces[at + 1u];
        count(3u * (face & ~FRONT) + id.y, face & FRONT);
    }
}

@compute @workgroup_size(WORKGROUP)
fn list_every_edge(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    for (var at = id.x; at < faces[0]; at += row(groups)) {
        let face = faces[at + 1u];
        list(3u * (face & ~FRONT) + id.y + (face & FRONT));
    }
}

@compute @workgroup_size(WORKGROUP)
fn list_unshared(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let four = element(id, groups);
    if four > style.slot_mask / 4u {
        return;
    }
    let entries = slots[four];
    for (var slot = 0u; slot < 4u; slot++) {
        let entry = entries[slot];
        if entry != 0u && (entry & SHARED) == 0u {
            list(((entry & style.corner_mask) - 1u) | (entry & FRONT));
        }
    }
}
