// Shows the picture of a method in a window, on white paper: it fills the viewport, whose pixels are its own where both are of one
// size.

#import "shared/color.wgsl"

struct Corner {
    @builtin(position) position: vec4<f32>,
    // Across the picture from its top left, 0 to 1.
    @location(0) share: vec2<f32>,
}

@group(0) @binding(0) var picture: texture_2d<f32>;

// One triangle that covers the viewport.
@vertex
fn picture_corner(@builtin(vertex_index) index: u32) -> Corner {
    let share = vec2<f32>(f32(index & 1u), f32(index >> 1u)) * 2.0;
    return Corner(vec4<f32>(share.x * 2.0 - 1.0, 1.0 - share.y * 2.0, 0.5, 1.0), share);
}

// The picture, premultiplied by alpha, on paper.
fn on_paper(share: vec2<f32>) -> vec3<f32> {
    let size = textureDimensions(picture);
    let texel = textureLoad(picture, min(vec2<u32>(share * vec2<f32>(size)), size - 1u), 0);
    return texel.rgb + (1.0 - texel.a);
}

// For a window whose pixels take colours as they are stored.
@fragment
fn picture_as_stored(corner: Corner) -> @location(0) vec4<f32> {
    return vec4<f32>(on_paper(corner.share), 1.0);
}

// For a window whose pixels take linear light.
@fragment
fn picture_as_light(corner: Corner) -> @location(0) vec4<f32> {
    return vec4<f32>(linear_light(on_paper(corner.share)), 1.0);
}
