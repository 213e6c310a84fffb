// One triangle that covers the whole target: vertices 0, 1, 2 at (-1, -1), (3, -1), (-1, 3).
@vertex
fn full_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32(index & 1u), f32(index >> 1u));
    return vec4<f32>(corner * 4.0 - 1.0, 0.5, 1.0);
}
