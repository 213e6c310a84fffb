// Faces behind the first layer, pulled as back faces are. Twin: crates/image_precision/src/later_faces.rs

#import "shared/mesh.wgsl"
#import "image_precision/ink.wgsl"

@group(2) @binding(0) var<storage, read> listed: array<u32>;

@vertex
fn later_vertex(@builtin(vertex_index) index: u32) -> @invariant @builtin(position) vec4<f32> {
    let position = corner_position(3u * listed[index / 3u] + index % 3u);
    return style.back_to_clip * vec4<f32>(position, 1.0);
}
