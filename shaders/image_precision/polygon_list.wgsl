// Lists the polygons that are fattened: back faces, and front faces nearly edge-on where a band is asked for.
// Twin: crates/image_precision/src/fatten_list.rs

@group(2) @binding(1) var<storage, read> starts: array<u32>;

@compute @workgroup_size(64)
fn list_polygons(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = element(id, groups);
    if index < style.faces {
        let facing = polygon_facing(polygon(corner_range(index)));
        if facing < 0.0 || (facing > 0.0 && facing < style.band) {
            list_face(index);
        }
    }
}
