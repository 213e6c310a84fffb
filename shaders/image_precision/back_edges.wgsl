// Edges of back faces, listed for drawing. Twin: crates/image_precision/src/back_edges.rs
//
// An edge between two back faces cannot be a silhouette edge. The table counts back faces for every edge, known by the
// positions of its ends; those counted once are listed. Which face comes first is left to chance; the list as a set is not.

@group(2) @binding(0) var<storage, read_write> table: array<atomic<u32>>;
@group(2) @binding(1) var<storage, read_write> listed: array<u32>;
@group(2) @binding(2) var<storage, read_write> arguments: array<atomic<u32>>;
// For unoriented polygons: 1 for faces of the first layer.
@group(2) @binding(3) var<storage, read> first_layer: array<u32>;

// In a slot: counted more than once.
const SHARED: u32 = 0x80000000u;
const LONGEST_PROBE: u32 = 64u;

fn element(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.x + id.y * groups.x * 64u;
}

fn list(corner: u32) {
    let vertices = vertices_per_line();
    listed[atomicAdd(&arguments[0], vertices) / vertices] = corner;
}

fn mixed(hash: u32, word: u32) -> u32 {
    let h = (hash ^ word) * 0x9e3779b1u;
    return h ^ (h >> 15u);
}

fn hash_of(p: vec3<f32>) -> u32 {
    // Minus zero is zero.
    let words = bitcast<vec3<u32>>(select(p, vec3<f32>(0.0), p == vec3<f32>(0.0)));
    return mixed(mixed(mixed(0x811c9dc5u, words.x), words.y), words.z);
}

// Whether two edges have the same ends, in either order: by their numbers, and where those differ by their places.
fn is_same(first: vec2<u32>, second: vec2<u32>) -> bool {
    if all(first == second) || all(first == second.yx) {
        return true;
    }
    let a = vertex_position(first.x);
    let b = vertex_position(first.y);
    let c = vertex_position(second.x);
    let d = vertex_position(second.y);
    return (all(a == c) && all(b == d)) || (all(a == d) && all(b == c));
}

fn count(corner: u32, ends: vec2<u32>, hash: u32) {
    var slot = hash & style.slot_mask;
    for (var probe = 0u; probe < LONGEST_PROBE; probe++) {
        let seen = atomicCompareExchangeWeak(&table[slot], 0u, corner + 1u);
        if seen.exchanged {
            return;
        }
        // A weak exchange may fail without a reason; the slot is then still empty and is tried again.
        if seen.old_value != 0u {
            let other = (seen.old_value & ~SHARED) - 1u;
            if is_same(ends, vec2<u32>(corners[other], corners[next_corner(other)])) {
                atomicOr(&table[slot], SHARED);
                return;
            }
            slot = (slot + 1u) & style.slot_mask;
        }
    }
    // A full neighbourhood: the edge is drawn, hidden or not.
    list(corner);
}

fn add_face(face: u32) {
    if style.slot_mask == 0u {
        for (var slot = 0u; slot < 3u; slot++) {
            list(3u * face + slot);
        }
        return;
    }
    let ends = vec3<u32>(corners[3u * face], corners[3u * face + 1u], corners[3u * face + 2u]);
    let a = hash_of(vertex_position(ends.x));
    let b = hash_of(vertex_position(ends.y));
    let c = hash_of(vertex_position(ends.z));
    // The same whichever end comes first.
    count(3u * face, ends.xy, mixed(a ^ b, a + b));
    count(3u * face + 1u, ends.yz, mixed(b ^ c, b + c));
    count(3u * face + 2u, ends.zx, mixed(c ^ a, c + a));
}

@compute @workgroup_size(64)
fn add_back_faces(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && front_volume(face) < 0.0 {
        add_face(face);
    }
}

@compute @workgroup_size(64)
fn add_later_layers(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face < style.faces && first_layer[face] == 0u {
        add_face(face);
    }
}

@compute @workgroup_size(64)
fn list_unshared(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let slot = element(id, groups);
    if slot <= style.slot_mask {
        let value = atomicLoad(&table[slot]);
        if value != 0u && (value & SHARED) == 0u {
            list(value - 1u);
        }
    }
}
