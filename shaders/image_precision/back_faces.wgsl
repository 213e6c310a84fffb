// Step 3 of Raskar and Cohen 1999, section 3.2: back faces, black, pulled. Twin: crates/image_precision/src/back_faces.rs

#import "image_precision/ink.wgsl"

@vertex
fn back_vertex(@location(0) position: vec3<f32>) -> @invariant @builtin(position) vec4<f32> {
    return style.back_to_clip * vec4<f32>(position, 1.0);
}
