// What all stages of the method share: the view and the options, tables of the mesh, and what a frame makes of them.
// Twins: crates/smoothing/src/gpu/settings.rs and crates/smoothing/src/gpu/tables.rs

struct SmoothingUniform {
    // In the local frame: the eye with w = 1, or a unit vector towards the viewer with w = 0.
    eye: vec4<f32>,
    viewport_px: vec2<f32>,
    tolerance_px: f32,
    newton_steps: u32,
    // Options, numbered in the order of their words.
    segment_law: u32,
    sampling_law: u32,
    perturbation_law: u32,
    normal_weights: u32,
    tangent_law: u32,
    // How many there are: shading vertices, vertices, faces, silhouette points at most, feature edges.
    groups: u32,
    vertices: u32,
    faces: u32,
    points: u32,
    features: u32,
    // Room for triangles, and for vertices beyond the shading vertices and points.
    triangle_room: u32,
    vertex_room: u32,
    // Where the parts of `tables` begin; the shading vertices of the faces' corners come first.
    // For each half-edge a word: see `side_point_of`, `runs_forward` and `is_feature`.
    sides_at: u32,
    // For each point, a half-edge that it lies on, and the feature edge or NONE.
    owners_at: u32,
    point_features_at: u32,
    // For each shading vertex, its vertex, whether its faces are wound inside out, and its corners.
    group_vertices_at: u32,
    turned_groups_at: u32,
    first_corners_at: u32,
    group_corners_at: u32,
    // For each vertex, its shading vertices and its neighbours.
    first_groups_at: u32,
    first_neighbours_at: u32,
    neighbours_at: u32,
    // For each feature edge, its points; its vertices, lower first, and those before and after it on its polyline or NONE.
    first_feature_points_at: u32,
    feature_points_at: u32,
    feature_ends_at: u32,
    // Where the parts of `state` begin; the visibility of shading vertices comes first.
    // For each point, its parameter from the lower vertex to the higher.
    parameters_at: u32,
    // For each feature edge, its FeatureSampling.
    sampling_at: u32,
    // Silhouette points inside feature edges, sorted, in the places of their points.
    inner_points_at: u32,
    // For each face, its segment: see `segment_word`, and 9 numbers for tangents and blocking plane.
    segments_at: u32,
    segment_data_at: u32,
    // Where the levels of `sums` begin, level 0 at 0, and how many levels there are.
    level_1_at: u32,
    level_2_at: u32,
    total_at: u32,
    levels: u32,
    // Whether triangles of invisible parts that are seen from behind draw nothing in this view.
    leaves_out: u32,
}

@group(0) @binding(1) var<uniform> settings: SmoothingUniform;
// 6 numbers each, position and normal: shading vertices, silhouette points, then what the view adds.
@group(2) @binding(0) var<storage, read_write> vertices: array<f32>;
@group(2) @binding(1) var<storage, read> tables: array<u32>;
@group(2) @binding(2) var<storage, read_write> state: array<u32>;
// Feature segments, see feature_curve.wgsl.
@group(2) @binding(3) var<storage, read_write> curves: array<vec4<f32>>;
// For each vertex, whether it is a corner of a face with a concave segment.
@group(2) @binding(4) var<storage, read_write> at_concave: array<atomic<u32>>;

const NONE: u32 = 0xffffffffu;

fn position_of(vertex: u32) -> vec3<f32> {
    return vec3<f32>(vertices[6u * vertex], vertices[6u * vertex + 1u], vertices[6u * vertex + 2u]);
}

fn normal_of(vertex: u32) -> vec3<f32> {
    return vec3<f32>(vertices[6u * vertex + 3u], vertices[6u * vertex + 4u], vertices[6u * vertex + 5u]);
}

fn store_position(vertex: u32, position: vec3<f32>) {
    vertices[6u * vertex] = position.x;
    vertices[6u * vertex + 1u] = position.y;
    vertices[6u * vertex + 2u] = position.z;
}

fn store_normal(vertex: u32, normal: vec3<f32>) {
    vertices[6u * vertex + 3u] = normal.x;
    vertices[6u * vertex + 4u] = normal.y;
    vertices[6u * vertex + 5u] = normal.z;
}

fn unit_or_zero(v: vec3<f32>) -> vec3<f32> {
    let size = length(v);
    return select(vec3<f32>(0.0), v / size, size > 0.0);
}

// From a point towards the viewer.
fn toward_viewer(point: vec3<f32>) -> vec3<f32> {
    return settings.eye.xyz - settings.eye.w * point;
}

fn is_visible(group: u32) -> bool {
    return state[group] != 0u;
}

// The half-edge after another around their face.
fn next_side(half_edge: u32) -> u32 {
    return select(half_edge + 1u, half_edge - 2u, half_edge % 3u == 2u);
}

fn side_word(half_edge: u32) -> u32 {
    return tables[settings.sides_at + half_edge];
}

// The place of the silhouette point on a side.
fn side_point_of(word: u32) -> u32 {
    return word >> 2u;
}

// Whether a side is a feature edge.
fn is_feature(word: u32) -> bool {
    return (word & 2u) != 0u;
}

// Whether a side runs from the lower vertex to the higher.
fn runs_forward(word: u32) -> bool {
    return (word & 1u) != 0u;
}

// Where a silhouette point lies among the vertices.
fn point_vertex(point: u32) -> u32 {
    return settings.groups + point;
}
