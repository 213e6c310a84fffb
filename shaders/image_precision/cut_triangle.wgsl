// A triangle around a fattened triangle, in the coordinates of its plane.
//
// A fattened triangle is a hexagon of pushed edges and bevels in turn. If it is convex, every second side, extended, is a side of
// a triangle around it, and the three sides between cut off its corners. A rasteriser draws it faster than the four triangles
// of the hexagon.

#import "image_precision/style.wgsl"

#import "image_precision/style.wgsl"

// Corners, counter-clockwise: begin and end of the first edge, of the second, of the third.
struct Hexagon {
    a: vec2<f32>,
    b: vec2<f32>,
    c: vec2<f32>,
    d: vec2<f32>,
    e: vec2<f32>,
    f: vec2<f32>,
}

// Its sides ab, cd and ef made longer meet beyond bc, de and fa.
struct Around {
    bc: vec2<f32>,
    de: vec2<f32>,
    fa: vec2<f32>,
    // Twice the area; beyond all bounds where sides do not meet there.
    area: f32,
}

struct CutTriangle {
    around: Around,
    // The hexagon, from the corner on that makes ab, cd and ef the sides made longer.
    hexagon: Hexagon,
    is_found: bool,
}

// Twice the area between two ways; above 0 where the second turns left.
fn perp_dot(way: vec2<f32>, other: vec2<f32>) -> f32 {
    return way.x * other.y - way.y * other.x;
}

fn is_convex(h: Hexagon) -> bool {
    let ab = h.b - h.a;
    let bc = h.c - h.b;
    let cd = h.d - h.c;
    let de = h.e - h.d;
    let ef = h.f - h.e;
    let fa = h.a - h.f;
    let bends = min(min(perp_dot(ab, bc), perp_dot(bc, cd)), min(perp_dot(cd, de), perp_dot(de, ef)));
    return min(bends, min(perp_dot(ef, fa), perp_dot(fa, ab))) >= 0.0;
}

fn twice_area(h: Hexagon) -> f32 {
    return perp_dot(h.b - h.a, h.c - h.a) + perp_dot(h.c - h.a, h.d - h.a) + perp_dot(h.d - h.a, h.e - h.a)
        + perp_dot(h.e - h.a, h.f - h.a);
}

// Where the line from p along `way` meets that from q along `other`.
fn meeting(p: vec2<f32>, way: vec2<f32>, q: vec2<f32>, other: vec2<f32>) -> vec2<f32> {
    return p + way * (perp_dot(q - p, other) / perp_dot(way, other));
}

fn around(h: Hexagon) -> Around {
    let ab = h.b - h.a;
    let cd = h.d - h.c;
    let ef = h.f - h.e;
    let bc = meeting(h.b, ab, h.c, cd);
    let de = meeting(h.d, cd, h.e, ef);
    let fa = meeting(h.f, ef, h.a, ab);
    // Sides of a convex hexagon that turn left into each other meet; the others are divided by nothing or less.
    let meet = perp_dot(ab, cd) > 0.0 && perp_dot(cd, ef) > 0.0 && perp_dot(ef, ab) > 0.0;
    return Around(bc, de, fa, select(1e30, perp_dot(de - bc, fa - bc), meet));
}

// The smaller of the two triangles around a hexagon, where it is small enough.
fn cut_triangle(h: Hexagon) -> CutTriangle {
    let shifted = Hexagon(h.b, h.c, h.d, h.e, h.f, h.a);
    let pushed = around(h);
    let bevelled = around(shifted);
    let is_small = is_convex(h) && min(pushed.area, bevelled.area) < style.most_around * twice_area(h);
    if bevelled.area < pushed.area {
        return CutTriangle(bevelled, shifted, is_small);
    }
    return CutTriangle(pushed, h, is_small);
}

// How far inside the sides bc, de and fa a point is, each in a unit of its own; below 0 outside.
fn inside(h: Hexagon, p: vec2<f32>) -> vec3<f32> {
    return vec3<f32>(
        perp_dot(h.c - h.b, p - h.b),
        perp_dot(h.e - h.d, p - h.d),
        perp_dot(h.a - h.f, p - h.f),
    );
}
