// The article's vertex and pixel stages, as printed. Twin: crates/edge_mesh/src/as_printed.rs

struct AsPrintedUniform {
    // The mesh's own space to world space.
    model_world: mat4x4<f32>,
    // The mesh's own space to clip space.
    transform: mat4x4<f32>,
    // Position of the camera in world space with w = 1; of an orthographic view the unit direction towards it with w = 0.
    camera: vec4<f32>,
    // As the target takes it.
    ink: vec4<f32>,
}

@group(0) @binding(0) var<uniform> printed: AsPrintedUniform;

struct PrintedVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) alpha: f32,
}

@vertex
fn printed_vertex(
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) tangent: vec3<f32>,
    @location(3) ridge: f32,
) -> PrintedVertex {
    let world = mat3x3<f32>(printed.model_world[0].xyz, printed.model_world[1].xyz, printed.model_world[2].xyz);
    let p = (printed.model_world * vec4<f32>(position, 1.0)).xyz;
    let n = world * normal;
    let t = world * tangent;
    // From the camera; not normalised.
    let e = p * printed.camera.w - printed.camera.xyz;
    var alpha = 0.0;
    let e_dot_n = dot(e, n);
    let e_dot_t = dot(e, t);
    let extend = 0.1 * (length(e) / 75.0);
    var moved = position + normal * extend;
    if e_dot_n * e_dot_t < 0.0 {
        alpha = 1.0;
        // The article calls these vertices front facing; as e points away from the camera, they are those of the back face.
        if e_dot_n > 0.0 {
            moved = position - normal * extend;
        }
    }
    alpha += ridge;
    return PrintedVertex(printed.transform * vec4<f32>(moved, 1.0), clamp(alpha, 0.0, 1.0));
}

// The alpha test lets through what is greater than 1 / 255.
@fragment
fn printed_pixel(in: PrintedVertex) -> @location(0) vec4<f32> {
    if in.alpha <= 1.0 / 255.0 {
        discard;
    }
    return printed.ink;
}
