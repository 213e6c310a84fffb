// Step 4: drawn edges as lines, expanded in the image plane. Twin: crates/edge_mesh/src/lines.rs
//
// Each instance draws a chunk of lines. A vertex index holds the line within its chunk, and below it the point of the line's
// polygon.

#import "shared/camera.wgsl"
#import "shared/line_polygon.wgsl"
#import "edge_mesh/edge_record.wgsl"
#import "edge_mesh/listed.wgsl"

// The number of entries, and the entries.
@group(3) @binding(0) var<storage, read> listed: array<u32>;

struct FeatureVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) pen: u32,
}

fn corner_of_line(ends: vec2<u32>, pen: u32, point: u32) -> vec4<f32> {
    let from_clip = clip_position(vertex_position(ends.x));
    let to_clip = clip_position(vertex_position(ends.y));
    let rim = style.pens[pen].rim[rim_of(point, style.pens[pen].shape)].xy;
    return line_corner(point, from_clip, to_clip, style.pens[pen].shape, rim).position;
}

fn silhouette(record: vec4<u32>, index: u32) -> vec4<f32> {
    return corner_of_line(silhouette_way(record), SILHOUETTE_PEN, index & ((1u << style.silhouette_bits) - 1u));
}

fn feature(record: vec4<u32>, pen: u32, index: u32) -> FeatureVertex {
    return FeatureVertex(corner_of_line(record.zw, pen, index & ((1u << style.feature_bits) - 1u)), pen);
}

// Any edge, drawn if it is a silhouette edge.
@vertex
fn silhouette_of_edge(@builtin(vertex_index) index: u32, @builtin(instance_index) chunk: u32) -> @builtin(position) vec4<f32> {
    let edge = chunk * CHUNK + (index >> style.silhouette_bits);
    if edge >= style.edges {
        return NO_POINT.position;
    }
    let record = records[edge];
    if !is_silhouette(record) {
        return NO_POINT.position;
    }
    return silhouette(record, index);
}

// An edge that was listed as a silhouette edge.
@vertex
fn listed_silhouette(@builtin(vertex_index) index: u32, @builtin(instance_index) chunk: u32) -> @builtin(position) vec4<f32> {
    let at = chunk * CHUNK + (index >> style.silhouette_bits);
    if at >= listed[0] {
        return NO_POINT.position;
    }
    return silhouette(records[listed[at + 1u]], index);
}

@vertex
fn feature_of_edge(@builtin(vertex_index) index: u32, @builtin(instance_index) chunk: u32) -> FeatureVertex {
    let edge = chunk * CHUNK + (index >> style.feature_bits);
    if edge >= style.features {
        return FeatureVertex(NO_POINT.position, 0u);
    }
    let record = records[edge];
    let pen = feature_pen(record);
    if pen == 0u {
        return FeatureVertex(NO_POINT.position, 0u);
    }
    return feature(record, pen, index);
}

@vertex
fn listed_feature(@builtin(vertex_index) index: u32, @builtin(instance_index) chunk: u32) -> FeatureVertex {
    let at = chunk * CHUNK + (index >> style.feature_bits);
    if at >= listed[0] {
        return FeatureVertex(NO_POINT.position, 0u);
    }
    let entry = listed[at + 1u];
    return feature(records[entry & ~LISTED_VALLEY], select(RIDGE_PEN, VALLEY_PEN, (entry & LISTED_VALLEY) != 0u), index);
}

@fragment
fn silhouette_ink() -> @location(0) vec4<f32> {
    return style.inks[SILHOUETTE_PEN];
}

@fragment
fn feature_ink(in: FeatureVertex) -> @location(0) vec4<f32> {
    return style.inks[in.pen];
}
