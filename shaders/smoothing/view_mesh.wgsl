// Triangles with interpolated normals. Twin: crates/smoothing/src/view_mesh_renderer.rs draws crates/smoothing/src/view_mesh.rs

#import "shared/camera.wgsl"
#import "shared/surface.wgsl"

struct ViewMeshVertex {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) normal: vec3<f32>,
}

// Normals transform by the inverse transpose: by the cofactors of the matrix, which differ from it by a factor only. Lighting is the
// same from both sides, so that its sign does not matter.
@vertex
fn view_mesh_vertex(@location(0) position: vec3<f32>, @location(1) normal: vec3<f32>) -> ViewMeshVertex {
    let shape = surface.shape;
    let cofactors = mat3x3<f32>(cross(shape[1], shape[2]), cross(shape[2], shape[0]), cross(shape[0], shape[1]));
    return ViewMeshVertex(clip_position(position), cofactors * normal);
}

@fragment
fn view_mesh_flat() -> @location(0) vec4<f32> {
    return flat_surface();
}

@fragment
fn view_mesh_lit(in: ViewMeshVertex) -> @location(0) vec4<f32> {
    return lit_surface(in.normal);
}
