// How many triangles and vertices each feature edge and then each face adds, and before the stages that write them, the sums of
// those before. x, y: triangles and vertices as the tolerance asks; z, w: with every curve in one piece.
// Twin: crates/smoothing/src/gpu/prefix_sum.rs

@group(3) @binding(0) var<storage, read_write> sums: array<vec4<u32>>;

// Elements that a workgroup sums.
const BLOCK: u32 = 256u;

// Whether the frame would exceed the room: then every curve is drawn in one piece, for which there is always room.
fn is_coarse() -> bool {
    let total = sums[settings.total_at];
    return total.x > settings.triangle_room || total.y > settings.vertex_room;
}

fn chosen(sum: vec4<u32>, coarse: bool) -> vec2<u32> {
    return select(sum.xy, sum.zw, coarse);
}

// Triangles and vertices of all elements before one.
fn sum_before(index: u32, coarse: bool) -> vec2<u32> {
    var sum = sums[index];
    if settings.levels > 1u {
        sum += sums[settings.level_1_at + index / BLOCK];
    }
    if settings.levels > 2u {
        sum += sums[settings.level_2_at + index / (BLOCK * BLOCK)];
    }
    return chosen(sum, coarse);
}
