// One outline normal per place, the mean of its corners' face normals weighted by their angles, for meshes whose vertices move
// on the device. Twin: crates/baselines/src/inverted_hull/outline_normals.rs

#import "shared/invocation.wgsl"
#import "shared/mesh.wgsl"

// The corners at a place are `place_corners` from `first_corners[place]` on, up to those of the next place.
@group(2) @binding(0) var<storage, read> first_corners: array<u32>;
@group(2) @binding(1) var<storage, read> place_corners: array<u32>;
@group(2) @binding(2) var<storage, read_write> normals: array<vec4<f32>>;

// A sum below this share of its weights is cancellation, as on a sheet with a face on either side: no normal.
const LEAST_SHARE: f32 = 1e-5;

fn unit_side(from_corner: u32, to_corner: u32) -> vec3<f32> {
    let side = corner_position(to_corner) - corner_position(from_corner);
    return side / max(length(side), 1e-30);
}

@compute @workgroup_size(WORKGROUP)
fn find_outline_normals(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let place = element(id, groups);
    if place >= arrayLength(&normals) || place + 1u >= arrayLength(&first_corners) {
        return;
    }
    var sum = vec3<f32>(0.0);
    var weights = 0.0;
    for (var i = first_corners[place]; i < first_corners[place + 1u]; i++) {
        let corner = place_corners[i];
        let next = next_corner(corner);
        let a = unit_side(corner, next);
        let b = unit_side(corner, next_corner(next));
        let across = cross(a, b);
        let sine = length(across);
        if sine > 0.0 {
            let angle = atan2(sine, dot(a, b));
            sum += across * (angle / sine);
            weights += angle;
        }
    }
    let size = length(sum);
    let normal = select(vec3<f32>(0.0), sum / max(size, 1e-30), size > LEAST_SHARE * weights);
    normals[place] = vec4<f32>(normal, 0.0);
}
