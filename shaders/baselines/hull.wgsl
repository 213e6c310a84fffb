// The vertices of a hull: those of the mesh, pushed along their outline normals. Twin: crates/baselines/src/inverted_hull/hull.rs

#import "shared/camera.wgsl"
#import "shared/mesh.wgsl"

struct HullUniform {
    // A normal in the local frame to the direction there that is normal to the surface in the world.
    outward: mat3x3<f32>,
    // Local frame to the mesh's shape.
    shape: mat3x3<f32>,
    // As the target takes it, premultiplied.
    ink: vec4<f32>,
    viewport_px: vec2<f32>,
    // How far vertices are pushed in the image, in pixels: x + y / w at a clip-space w.
    reach: vec2<f32>,
    // Pixels per unit of the shape at w = 1.
    px_per_unit: f32,
    // How far vertices are pushed in space, in units of the shape; 0: in the image.
    world_push: f32,
}

@group(0) @binding(1) var<uniform> hull: HullUniform;
// The place of each vertex, and the outline normal of each place.
@group(2) @binding(0) var<storage, read> place_of: array<u32>;
@group(2) @binding(1) var<storage, read> normals: array<vec4<f32>>;

// Normals whose projection is shorter than this share of their length, 3 degrees off the sight line, are pushed less in
// proportion. The push is then continuous where the direction of the projection is not.
const FULL_PUSH: f32 = 0.05;

fn pushed(position: vec3<f32>, normal: vec3<f32>) -> vec4<f32> {
    let along = hull.outward * normal;
    let unit = length(hull.shape * along);
    if !(unit > 0.0) {
        return clip_position(position);
    }
    if hull.world_push > 0.0 {
        return clip_position(position + along * (hull.world_push / unit));
    }
    let at = clip_position(position);
    let way = camera.to_clip * vec4<f32>(along, 0.0);
    // The derivative of the pixel along the normal, times the square of w.
    let projected = (way.xy * at.w - at.xy * way.w) * 0.5 * hull.viewport_px;
    let projected_px = length(projected);
    let most_px = hull.px_per_unit * abs(at.w) * unit;
    let full = max(projected_px, FULL_PUSH * most_px);
    // A reach of x + y / w pixels along the projection, times w: linear in w, so that it holds along edges that pass the eye as well.
    let reach = hull.reach.x * at.w + hull.reach.y;
    let offset = projected / max(full, 1e-30) * reach * 2.0 / hull.viewport_px;
    // As far back, or forth, as the normal leads on that way, but less than the push is long: a vertex that moved across the view alone
    // would lift back faces that recede over what is before them. At most half of the way to the eye, and not beyond the planes.
    let push = reach * abs(at.w) / max(full, 1e-30) * min(projected_px / max(most_px, 1e-30), 1.0);
    let most = 0.5 * abs(at.w) / max(abs(way.w * push), 1e-30);
    let depth = at.zw + way.zw * push * min(most, 1.0);
    let is_between = at.z >= 0.0 && at.z <= at.w;
    let z = select(depth.x, clamp(depth.x, 0.0, max(depth.y, 0.0)), is_between);
    return vec4<f32>((at.xy + offset) * select(depth.y / at.w, 1.0, at.w == 0.0), z, depth.y);
}

@vertex
fn welded_vertex(@location(0) position: vec3<f32>, @builtin(vertex_index) vertex: u32) -> @builtin(position) vec4<f32> {
    return pushed(position, normals[place_of[vertex]].xyz);
}

// Each corner along the normal of its own face, which leaves its neighbours behind at hard edges.
@vertex
fn split_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let at = corner_position(corner);
    let next = corner_position(next_corner(corner));
    let last = corner_position(next_corner(next_corner(corner)));
    return pushed(at, cross(next - at, last - at));
}

@fragment
fn hull_ink() -> @location(0) vec4<f32> {
    return hull.ink;
}
