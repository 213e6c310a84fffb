// A line as a convex polygon in the image, whatever its width. Twin: crates/gpu/src/line_polygon.rs
//
// The polygon goes around the line's end, along its far side and around its begin. Where its ink lies on one side only, the
// line itself is the last side of the polygon. A stage that draws lines holds a `LinePolygon` in a uniform and draws
// 6 * end_sides vertices for each line.

struct LineShape {
    viewport_px: vec2<f32>,
    // How far the ink reaches beside the line in pixels: x + y / w at a clip-space w.
    reach: vec2<f32>,
    // Unit direction in the image towards the light, times the share by which lines that face it are thinned.
    light: vec2<f32>,
    // Lines are clipped where their clip-space w is below this.
    near_w: f32,
    // Added to the values of the depth buffer, for lines that lie on front faces.
    lift: f32,
    // Sides of the polygon around either end.
    @size(16) end_sides: u32,
}

struct LinePolygon {
    shape: LineShape,
    // Points of the polygon around an end, in reaches from there: x beside the line, y beyond its end. The first is the outer
    // corner; there is one more point than there are sides.
    rim: array<vec4<f32>, 17>,
}

struct LinePoint {
    position: vec4<f32>,
    // Way of the line in the image, in pixels.
    way: vec2<f32>,
}

// Outside the clip volume: what vertices of a line that is not drawn yield.
const NO_POINT: LinePoint = LinePoint(vec4<f32>(2.0, 2.0, 0.0, 1.0), vec2<f32>(0.0));

fn vertices_per_line(shape: LineShape) -> u32 {
    return 6u * shape.end_sides;
}

// Which point of the polygon a vertex is: triangles go round the polygon about its first point, at the line's end.
fn polygon_point(vertex: u32) -> u32 {
    return select(vertex / 3u + vertex % 3u, 0u, vertex % 3u == 0u);
}

// Which point of the rim a point of the polygon is. Callers read the rim themselves: passed by value, it would be copied for each
// vertex.
fn rim_of(point: u32, shape: LineShape) -> u32 {
    return select(point - shape.end_sides - 1u, shape.end_sides - point, point <= shape.end_sides);
}

fn rim_point(vertex: u32, shape: LineShape) -> u32 {
    return rim_of(polygon_point(vertex), shape);
}

fn line_pixel(clip: vec4<f32>, shape: LineShape) -> vec2<f32> {
    return clip.xy / clip.w * 0.5 * shape.viewport_px;
}

// The begin of a line, moved onto the near plane where it lies before it.
fn clipped(begin: vec4<f32>, end: vec4<f32>, near_w: f32) -> vec4<f32> {
    if begin.w >= near_w {
        return begin;
    }
    return mix(begin, end, (near_w - begin.w) / (end.w - begin.w));
}

fn reach_px(w: f32, outward: vec2<f32>, shape: LineShape) -> f32 {
    return (shape.reach.x + shape.reach.y / w) * (1.0 - max(dot(outward, shape.light), 0.0));
}

// A vertex of the line between two positions in clip space, with ink to the left of that way. `rim` is the entry of the rim at
// `rim_point`.
fn line_point(vertex: u32, from_clip: vec4<f32>, to_clip: vec4<f32>, shape: LineShape, rim: vec2<f32>) -> LinePoint {
    return line_corner(polygon_point(vertex), from_clip, to_clip, shape, rim);
}

// The same for a point of the polygon, 0 to 2 * end_sides + 1. `rim` is the entry of the rim at `rim_of`.
fn line_corner(point: u32, from_clip: vec4<f32>, to_clip: vec4<f32>, shape: LineShape, rim: vec2<f32>) -> LinePoint {
    if max(from_clip.w, to_clip.w) <= shape.near_w {
        return NO_POINT;
    }
    let a = clipped(from_clip, to_clip, shape.near_w);
    let b = clipped(to_clip, from_clip, shape.near_w);
    let way = line_pixel(b, shape) - line_pixel(a, shape);
    let length_px = length(way);
    // Two ends at one point, and values beyond 32 bits, are not a line; the comparison also refuses NaN.
    if !(length_px > 1e-5 && length_px < 1e30) {
        return NO_POINT;
    }
    let direction = way / length_px;
    let left = vec2<f32>(-direction.y, direction.x);
    let of_b = point <= shape.end_sides;
    let anchor = select(a, b, of_b);
    let from_end = rim * reach_px(anchor.w, left, shape);
    let beyond = select(-direction, direction, of_b);
    let ndc = anchor.xy / anchor.w + 2.0 * (from_end.x * left + from_end.y * beyond) / shape.viewport_px;
    // The depth of either end around it, and interpolated between them.
    let z = clamp(anchor.z / anchor.w + shape.lift, 0.0, 1.0);
    return LinePoint(vec4<f32>(ndc, z, 1.0) * anchor.w, way);
}
