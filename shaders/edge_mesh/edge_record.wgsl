// Records of edges, and which of them are drawn. Twin: crates/edge_mesh/src/edge_record.rs

#import "shared/mesh.wgsl"
#import "edge_mesh/style.wgsl"
#import "edge_mesh/oct_normal.wgsl"

// Faces x and y, with the bits below in their words, and ends z and w. Stages that read only the faces load half of a record.
@group(2) @binding(0) var<storage, read> records: array<vec4<u32>>;
// One bit per face, set for front faces.
@group(2) @binding(1) var<storage, read> facing: array<u32>;
// One word per face, where ridges and valleys are found from this frame's normals.
@group(2) @binding(2) var<storage, read> normals: array<u32>;

const FACE_MASK: u32 = 0x1fffffffu;
// In the word of the first face.
const RIDGE: u32 = 0x20000000u;
const VALLEY: u32 = 0x40000000u;
const GIVEN: u32 = 0x80000000u;
// In the word of the second face.
const SAME_WAY: u32 = 0x40000000u;
const BOUNDARY: u32 = 0x80000000u;

fn is_front(face_word: u32) -> bool {
    let face = face_word & FACE_MASK;
    return ((facing[face >> 5u] >> (face & 31u)) & 1u) != 0u;
}

fn is_silhouette(record: vec4<u32>) -> bool {
    // The second face of a boundary edge is the first.
    let front = is_front(record.x);
    let is_boundary = (record.y & BOUNDARY) != 0u;
    return is_front(record.y) != front || (is_boundary && (front || style.back_boundaries != 0u));
}

// The ends of a silhouette edge in an order that has the front face to the right in the image, so that left is outwards.
fn silhouette_way(record: vec4<u32>) -> vec2<u32> {
    let backwards = is_front(record.x) || (record.y & SAME_WAY) != 0u;
    return select(record.zw, record.wz, backwards != (style.turned != 0u));
}

fn bend_pen(record: vec4<u32>) -> u32 {
    if style.bends_now == 0u || (record.x & GIVEN) != 0u {
        return select(select(0u, VALLEY_PEN, (record.x & VALLEY) != 0u), RIDGE_PEN, (record.x & RIDGE) != 0u);
    }
    let stored = vec2<u32>(normals[record.x & FACE_MASK], normals[record.y & FACE_MASK]);
    if any(stored == vec2<u32>(NO_NORMAL)) {
        return 0u;
    }
    let first = oct_decode(stored.x);
    let second = oct_decode(stored.y) * select(1.0, -1.0, (record.y & SAME_WAY) != 0u);
    let way = vertex_position(record.w) - vertex_position(record.z);
    let cosine = dot(first, second);
    if dot(cross(first, second), way) < 0.0 {
        return select(0u, VALLEY_PEN, cosine <= style.valley_cosine);
    }
    return select(0u, RIDGE_PEN, cosine <= style.ridge_cosine);
}

// The pen of an edge that is drawn as a ridge or valley; 0 for all others.
fn feature_pen(record: vec4<u32>) -> u32 {
    if is_silhouette(record) || (style.back_features == 0u && !is_front(record.x)) {
        return 0u;
    }
    return bend_pen(record);
}
