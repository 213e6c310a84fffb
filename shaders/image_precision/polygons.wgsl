// Lists the corners of polygons that are fattened: back faces, and front faces nearly edge-on where a band is asked for.
// Twin: crates/image_precision/src/fatten.rs

@group(2) @binding(0) var<storage, read_write> listed: array<FatCorner>;
@group(2) @binding(1) var<storage, read_write> arguments: array<atomic<u32>>;
@group(2) @binding(2) var<storage, read> starts: array<u32>;

const VERTICES_PER_CORNER: u32 = 6u;

@compute @workgroup_size(64)
fn list_polygons(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.x + id.y * groups.x * 64u;
    if index >= style.faces {
        return;
    }
    let p = polygon(corner_range(index));
    let view = towards_viewer(p.middle);
    let facing = dot(p.normal, view) / max(length(p.normal) * length(view), 1e-30);
    if facing >= 0.0 && !(facing > 0.0 && facing < style.band) {
        return;
    }
    let first = atomicAdd(&arguments[0], VERTICES_PER_CORNER * p.size) / VERTICES_PER_CORNER;
    for (var corner = 0u; corner < p.size; corner++) {
        let next = select(corner + 1u, 0u, corner + 1u == p.size);
        let a = corner_position(p.first + corner);
        let b = corner_position(p.first + next);
        let pushed = push(a, b, p);
        let ends = array<vec4<f32>, 2>(clip_position(a), clip_position(b));
        let way = 0.5 * style.viewport_px * (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w);
        listed[first + corner] = FatCorner(p.middle, facing, a + pushed, is_level(way), b + pushed, first + next);
    }
}
