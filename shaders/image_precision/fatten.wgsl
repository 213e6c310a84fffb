// Section 3.3 of Raskar and Cohen 1999: fattened polygons as fans of 2 n triangles about their middle.
// Twin: crates/image_precision/src/fatten_list.rs

@group(1) @binding(0) var<storage, read> listed: array<FatCorner>;

struct FatVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) level: u32,
    @location(1) @interpolate(flat) facing: f32,
}

// Two triangles a corner: about the middle over its edge, and over the gap between its edge and the next.
@vertex
fn fat_vertex(@builtin(vertex_index) index: u32) -> FatVertex {
    let record = index / 6u;
    let corner = index % 6u;
    var position = listed[record].middle;
    if corner == 1u {
        position = listed[record].begin;
    } else if corner == 2u || corner == 4u {
        position = listed[record].end;
    } else if corner == 5u {
        position = listed[listed[record].next].begin;
    }
    return FatVertex(clip_position(position), listed[record].level, listed[record].facing);
}

@fragment
fn fat_fragment(in: FatVertex) -> @location(0) vec4<f32> {
    if is_blank(in.level, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}

// Section 4, charcoal: the grey of the polygon, I = (1 + V.N) / 3.
@fragment
fn charcoal_fragment(in: FatVertex) -> @location(0) vec4<f32> {
    return vec4<f32>(vec3<f32>((1.0 + in.facing) / 3.0), 1.0);
}
