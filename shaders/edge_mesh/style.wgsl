// What every stage of the crate binds. Twin: crates/edge_mesh/src/style.rs

#import "shared/line_polygon.wgsl"

struct StyleUniform {
    // Lines of silhouettes, ridges and valleys.
    pens: array<LinePolygon, 3>,
    // As the target takes them, premultiplied.
    inks: array<vec4<f32>, 3>,
    // The eye with w = 1, or the unit direction towards the viewer with w = 0, in recentred mesh space.
    viewer: vec4<f32>,
    faces: u32,
    // Number of records.
    edges: u32,
    // Records from the first on that may be features.
    features: u32,
    // 1: front faces run clockwise in the image.
    turned: u32,
    // Bits of a vertex index that hold the point of the polygon, for silhouettes and for features.
    silhouette_bits: u32,
    feature_bits: u32,
    // 1: a feature between two back faces is drawn.
    back_features: u32,
    // 1: a boundary edge of a back face is drawn.
    back_boundaries: u32,
    // 1: ridges and valleys are found from this frame's normals.
    bends_now: u32,
    // Cosines of the least angles of ridges and valleys; below -1: none.
    ridge_cosine: f32,
    valley_cosine: f32,
}

@group(0) @binding(1) var<uniform> style: StyleUniform;

const SILHOUETTE_PEN: u32 = 0u;
const RIDGE_PEN: u32 = 1u;
const VALLEY_PEN: u32 = 2u;
