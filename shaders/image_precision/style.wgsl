// The style of lines, which every stage of the crate binds. Twin: crates/image_precision/src/style.rs

#import "shared/line_polygon.wgsl"

struct StyleUniform {
    // Recentred mesh space to clip space, as back faces are pulled.
    back_to_clip: mat4x4<f32>,
    // Recentred mesh space to the mesh's shape, which has the proportions of the world, and the shape to clip space.
    shape: mat4x4<f32>,
    shape_to_clip: mat4x4<f32>,
    // The eye with w = 1, or the unit direction towards the viewer with w = 0: in recentred mesh space, and in the shape.
    local_eye: vec4<f32>,
    eye: vec4<f32>,
    // Unit viewing axis in the shape, away from the viewer; w: pixels that a unit covers at depth 1 (in orthographic views, at all).
    axis: vec4<f32>,
    // Unit direction in the shape that points up in the image.
    up: vec4<f32>,
    // As the target takes it, premultiplied; and what it fades to.
    ink: vec4<f32>,
    paper: vec4<f32>,
    // How lines are drawn beside their edges; fattening takes its reach and its viewport from here.
    line: LinePolygon,
    // Depths, as clip-space w, between which ink fades, and the share that it has lost at the far one.
    fade: vec3<f32>,
    // Fattening is at most this many edge lengths; 0: no limit.
    clamp_edges: f32,
    // Front faces with V.N below this are fattened too; 0: none.
    band: f32,
    // Fattening: 0 exact, or one of the laws below.
    law: u32,
    // 0 solid, 1 dashes, 2 stipple.
    texture: u32,
    // Number of faces, or polygons.
    faces: u32,
    // Slots of the edge table less one; the table's size is a power of two. 0: every edge is drawn.
    slot_mask: u32,
    // Bits of a slot that hold the id of a corner.
    corner_mask: u32,
    // Corners of every polygon, or 0: the table of starts states it.
    polygon_corners: u32,
    // What each vertex of a fattened polygon carries: 0 nothing, or one of the notes below.
    noted: u32,
    // A fattened triangle is drawn as a cut triangle if that has at most this many times its area; 0: never.
    most_around: f32,
    // 1: front faces run clockwise in the image.
    turned: u32,
    // -1 where the shape is a mirror image of the mesh, otherwise 1.
    shape_sign: f32,
    // 1: the target takes linear light.
    is_linear: u32,
}

@group(0) @binding(1) var<uniform> style: StyleUniform;

const AS_PRINTED: u32 = 1u;
const WITHOUT_SINE: u32 = 2u;
// Whether the vertex's edge is level.
const NOTED_LEVEL: u32 = 1u;
// V.N of the vertex's polygon.
const NOTED_FACING: u32 = 2u;

// From a point of the shape towards the viewer; not normalised.
fn towards_viewer(p: vec3<f32>) -> vec3<f32> {
    return style.eye.xyz - p * style.eye.w;
}

// A point of recentred mesh space in the shape.
fn shaped(p: vec3<f32>) -> vec3<f32> {
    return (style.shape * vec4<f32>(p, 1.0)).xyz;
}

// Whether a direction in the image is nearer to level than to upright.
fn is_level(way: vec2<f32>) -> u32 {
    return u32(abs(way.x) > abs(way.y));
}

// Whether a texture leaves this pixel of a line blank. Dashes follow the axis of the image that is nearer to the line, so that
// they do not start again at each edge.
fn is_blank(level: u32, pixel: vec2<f32>) -> bool {
    let along = select(pixel.y, pixel.x, level != 0u);
    let cell = vec2<u32>(pixel) / 2u;
    return (style.texture == 1u && fract(along / 12.0) > 0.6) || (style.texture == 2u && (cell.x + cell.y) % 2u == 1u);
}

// Ink at a depth, given as clip-space w.
fn faded_ink(w: f32) -> vec4<f32> {
    let share = clamp((w - style.fade.x) / max(style.fade.y - style.fade.x, 1e-30), 0.0, 1.0) * style.fade.z;
    return mix(style.ink, style.paper, share);
}
