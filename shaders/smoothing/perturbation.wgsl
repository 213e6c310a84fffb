// Section III-E, local perturbation: vertices near concave segments are lowered until they hide none. Twin:
// crates/smoothing/src/perturbation.rs

#import "shared/invocation.wgsl"
#import "shared/mesh.wgsl"
#import "smoothing/segment_record.wgsl"

const LOWERED: u32 = 0u;

// Vertices further above the middle of a segment than this many times its height belong to no smooth surface that holds it.
const SAME_ARC: f32 = 9.0;

fn first_neighbour(vertex: u32) -> u32 {
    return tables[settings.first_neighbours_at + vertex];
}

fn first_group(vertex: u32) -> u32 {
    return tables[settings.first_groups_at + vertex];
}

// A vertex and its neighbours: it itself is the 0th.
fn around(vertex: u32, i: u32) -> u32 {
    if i == 0u {
        return vertex;
    }
    return tables[settings.neighbours_at + first_neighbour(vertex) + i - 1u];
}

fn around_count(vertex: u32) -> u32 {
    return 1u + first_neighbour(vertex + 1u) - first_neighbour(vertex);
}

fn is_around(vertex: u32, other: u32) -> bool {
    for (var i = 0u; i < around_count(vertex); i++) {
        if around(vertex, i) == other {
            return true;
        }
    }
    return false;
}

// Whether this corner belongs to a face with a concave segment and is the first of its corners that are around the vertex, so that
// each face counts once.
fn is_counted(vertex: u32, corner: u32) -> bool {
    let face = corner / 3u;
    if !is_concave(state[settings.segments_at + face]) {
        return false;
    }
    for (var other = 3u * face; other < corner; other++) {
        if is_around(vertex, corners[other]) {
            return false;
        }
    }
    return true;
}

// What the planes around a vertex ask for.
struct Demand {
    // Sum of their normals.
    normals: vec3<f32>,
    // How far along a direction the vertex moves, and whether any plane can be reached along it.
    way: f32,
    is_reached: bool,
}

// Adds a plane, given the direction of the move, which is 0 as long as normals are summed.
fn with_plane(demand: Demand, position: vec3<f32>, direction: vec3<f32>, face: u32) -> Demand {
    let normal = blocking_normal(face);
    let slope = dot(direction, normal);
    var next = demand;
    next.normals += normal;
    let curve = load_segment(face, lone_of(state[settings.segments_at + face]));
    let middle = hermite_point(curve, 0.5);
    let height = dot(0.5 * (curve.start + curve.end) - middle, normal);
    let above = dot(position - middle, normal);
    if slope > 0.0 && above <= SAME_ARC * height {
        let way = -above / slope;
        if settings.perturbation_law == LOWERED {
            next.way = min(demand.way, way);
        } else {
            next.way = select(way, max(demand.way, way), demand.is_reached);
        }
        next.is_reached = true;
    }
    return next;
}

fn demand_of_planes(vertex: u32, position: vec3<f32>, direction: vec3<f32>) -> Demand {
    var demand = Demand(vec3<f32>(0.0), 0.0, false);
    for (var i = 0u; i < around_count(vertex); i++) {
        let other = around(vertex, i);
        if atomicLoad(&at_concave[other]) == 0u {
            continue;
        }
        let end = tables[settings.first_corners_at + first_group(other + 1u)];
        for (var at = tables[settings.first_corners_at + first_group(other)]; at < end; at++) {
            let corner = tables[settings.group_corners_at + at];
            if is_counted(vertex, corner) {
                demand = with_plane(demand, position, direction, corner / 3u);
            }
        }
    }
    return demand;
}

@compute @workgroup_size(WORKGROUP)
fn lower_vertices(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let vertex = element(id, groups);
    if vertex >= settings.vertices {
        return;
    }
    let position = vertex_position(vertex);
    let direction = unit_or_zero(demand_of_planes(vertex, position, vec3<f32>(0.0)).normals);
    if all(direction == vec3<f32>(0.0)) {
        return;
    }
    let way = demand_of_planes(vertex, position, direction).way;
    var reach = 1e30;
    for (var i = 1u; i < around_count(vertex); i++) {
        reach = min(reach, distance(position, vertex_position(around(vertex, i))));
    }
    let lowered = position + clamp(way, -reach, reach) * direction;
    for (var group = first_group(vertex); group < first_group(vertex + 1u); group++) {
        store_position(group, lowered);
    }
}
