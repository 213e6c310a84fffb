// Section III-E, local re-meshing: writes the triangles that each face becomes. Twin: crates/smoothing/src/remeshing.rs

#import "shared/invocation.wgsl"
#import "smoothing/segment_record.wgsl"
#import "smoothing/sides.wgsl"
#import "smoothing/sums.wgsl"
#import "smoothing/silhouette_triangle.wgsl"

@group(3) @binding(1) var<storage, read_write> indices: array<u32>;
// Of the indexed draw.
@group(3) @binding(2) var<storage, read_write> arguments: array<u32>;

// The next triangle and the next vertex of this face.
var<private> triangle: u32;
var<private> vertex: u32;
// The fan that is being written: its centre, its first vertex and its last one.
var<private> fan_centre: u32;
var<private> fan_first: u32;
var<private> fan_last: u32;

// The sign of facing of the part that is being written if what is seen from behind is left out of it, or 0.
var<private> outward: f32;

// Leaves out what is seen from behind until the next call, if the view does and the corner is not visible.
fn begin_part(corner: u32) {
    let turned = tables[settings.turned_groups_at + corner] != 0u;
    outward = select(0.0, select(1.0, -1.0, turned), settings.leaves_out != 0u && !is_visible(corner));
}

fn push_triangle(a: u32, b: u32, c: u32) {
    var third = c;
    if outward != 0.0 {
        let p = position_of(a);
        let facing = dot(cross(position_of(b) - p, position_of(c) - p), toward_viewer(p));
        // Two equal corners draw nothing.
        third = select(c, a, outward * facing < 0.0);
    }
    indices[3u * triangle] = a;
    indices[3u * triangle + 1u] = b;
    indices[3u * triangle + 2u] = third;
    triangle++;
}

fn begin_fan(centre: u32, first: u32) {
    fan_centre = centre;
    fan_first = first;
    fan_last = first;
}

fn extend_fan(next: u32) {
    push_triangle(fan_centre, fan_last, next);
    fan_last = next;
}

fn extend_fan_by_side(side: Side, begin: u32, end: u32) {
    for (var i = begin; i < end; i++) {
        extend_fan(side_vertex(side, i));
    }
}

fn push_vertex(position: vec3<f32>, normal: vec3<f32>) -> u32 {
    store_position(vertex, position);
    store_normal(vertex, unit_or_zero(normal));
    vertex++;
    return vertex - 1u;
}

// Copies the samples of a feature edge, with normals of this face.
fn written_side(half_edge: u32, has_point: bool, coarse: bool) -> Side {
    let side = bent_side(half_edge, has_point, coarse, vertex);
    if side.feature == NONE {
        return side;
    }
    let samples = point_vertex(settings.points) + sum_before(side.feature, coarse).y;
    for (var i = 0u; i < side.inner; i++) {
        let sample = samples + select(side.inner - 1u - i, i, side.is_forward);
        let u = vertices[6u * sample + 3u];
        var normal = mix(normal_of(side.begin), normal_of(side.end), share_of(side, u));
        if side.point != NONE && parameter_of(side.point) == u {
            normal = normal_of(point_vertex(side.point));
        }
        push_vertex(position_of(sample), normal);
    }
    return side;
}

fn write_bent(face: u32, coarse: bool) {
    let sides = array<Side, 3>(
        written_side(3u * face, false, coarse),
        written_side(3u * face + 1u, false, coarse),
        written_side(3u * face + 2u, false, coarse),
    );
    let corners = vec3<u32>(sides[0].begin, sides[1].begin, sides[2].begin);
    let bent = vec3<bool>(sides[0].inner > 0u, sides[1].inner > 0u, sides[2].inner > 0u);
    if !any(bent) {
        push_triangle(corners.x, corners.y, corners.z);
        return;
    }
    // The corner opposite to the only bent side sees all of it.
    var centre = select(select(corners.y, corners.x, bent.y), corners.z, bent.x);
    if u32(bent.x) + u32(bent.y) + u32(bent.z) > 1u {
        let middle = (position_of(corners.x) + position_of(corners.y) + position_of(corners.z)) / 3.0;
        centre = push_vertex(middle, normal_of(corners.x) + normal_of(corners.y) + normal_of(corners.z));
    }
    begin_fan(centre, corners.x);
    extend_fan_by_side(sides[0], 0u, sides[0].inner);
    extend_fan(corners.y);
    extend_fan_by_side(sides[1], 0u, sides[1].inner);
    extend_fan(corners.z);
    extend_fan_by_side(sides[2], 0u, sides[2].inner);
    extend_fan(corners.x);
}

@compute @workgroup_size(WORKGROUP)
fn write_triangles(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face >= settings.faces {
        return;
    }
    let coarse = is_coarse();
    if face == 0u {
        arguments[0] = 3u * chosen(sums[settings.total_at], coarse).x;
    }
    let before = sum_before(settings.features + face, coarse);
    triangle = before.x;
    vertex = point_vertex(settings.points) + before.y;
    let word = state[settings.segments_at + face];
    if pieces_of(word) > 0u {
        write_silhouette(face, lone_of(word), select(pieces_of(word), 1u, coarse), coarse);
    } else if has_feature(face) {
        write_bent(face, coarse);
    } else {
        push_triangle(tables[3u * face], tables[3u * face + 1u], tables[3u * face + 2u]);
    }
}
