// Positions and triangles, fetched by index. Twin: crates/gpu/src/mesh_binding.rs

@group(1) @binding(0) var<storage, read> positions: array<f32>;
@group(1) @binding(1) var<storage, read> corners: array<u32>;

fn vertex_position(vertex: u32) -> vec3<f32> {
    return vec3<f32>(positions[3u * vertex], positions[3u * vertex + 1u], positions[3u * vertex + 2u]);
}

// Position of a corner: half-edge 3 f + i of a triangle f begins at its corner i.
fn corner_position(corner: u32) -> vec3<f32> {
    return vertex_position(corners[corner]);
}

// The corner after this one, around its triangle.
fn next_corner(corner: u32) -> u32 {
    return select(corner + 1u, corner - 2u, corner % 3u == 2u);
}
