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

fn bits(p: vec3<f32>) -> vec3<u32> {
    // Minus zero is zero.
    return bitcast<vec3<u32>>(select(p, vec3<f32>(0.0), p == vec3<f32>(0.0)));
}

fn is_less(a: vec3<u32>, b: vec3<u32>) -> bool {
    return a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z)));
}

struct Ends {
    low: vec3<u32>,
    high: vec3<u32>,
}

fn ends_of(corner: u32) -> Ends {
    let a = bits(corner_position(corner));
    let b = bits(corner_position(next_corner(corner)));
    if is_less(a, b) {
        return Ends(a, b);
    }
    return Ends(b, a);
}

fn mixed(hash: u32, word: u32) -> u32 {
    let h = (hash ^ word) * 0x9e3779b1u;
    return h ^ (h >> 15u);
}

fn hash_of(e: Ends) -> u32 {
    let low = mixed(mixed(mixed(0x811c9dc5u, e.low.x), e.low.y), e.low.z);
    return mixed(mixed(mixed(low, e.high.x), e.high.y), e.high.z);
}

fn count(corner: u32) {
    let e = ends_of(corner);
    if all(e.low == e.high) {
        return;
    }
    var slot = hash_of(e) & style.slot_mask;
    for (var probe = 0u; probe < LONGEST_PROBE; probe++) {
        let seen = atomicCompareExchangeWeak(&table[slot], 0u, corner + 1u);
        if seen.exchanged {
            return;
        }
        // A weak exchange may fail without a reason; the slot is then still empty and is tried again.
        if seen.old_value != 0u {
            let other = ends_of((seen.old_value & ~SHARED) - 1u);
            if all(other.low == e.low) && all(other.high == e.high) {
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
    for (var slot = 0u; slot < 3u; slot++) {
        if style.slot_mask == 0u {
            list(3u * face + slot);
        } else {
            count(3u * face + slot);
        }
    }
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
