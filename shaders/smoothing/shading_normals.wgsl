// Section III-B: a shading normal for each group of corners at a vertex, for meshes whose vertices move on the device.
// Twin: crates/smoothing/src/shading_normals.rs

#import "shared/invocation.wgsl"
#import "shared/mesh.wgsl"
#import "smoothing/frame.wgsl"

const BY_AREA: u32 = 0u;
const BY_ANGLE: u32 = 1u;

// A sum below this share of its weights is cancellation.
const LEAST_SHARE: f32 = 1e-6;

@compute @workgroup_size(WORKGROUP)
fn find_normals(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let group = element(id, groups);
    if group >= settings.groups {
        return;
    }
    var sum = vec3<f32>(0.0);
    var size = 0.0;
    var any_normal = vec3<f32>(0.0);
    // Parts that are wound inside out are turned as a whole.
    let outward = select(1.0, -1.0, tables[settings.turned_groups_at + group] != 0u);
    let end = tables[settings.first_corners_at + group + 1u];
    for (var i = tables[settings.first_corners_at + group]; i < end; i++) {
        let corner = tables[settings.group_corners_at + i];
        let at = corner_position(corner);
        let a = corner_position(next_corner(corner)) - at;
        let b = corner_position(next_corner(next_corner(corner))) - at;
        let lengths = vec2<f32>(length(a), length(b));
        if !(lengths.x > 0.0 && lengths.y > 0.0) {
            continue;
        }
        // Of unit sides, so that no product leaves the range of 32 bits.
        let across = cross(a / lengths.x, b / lengths.y);
        let sine = length(across);
        if !(sine > 0.0) {
            continue;
        }
        var weight = sine / (lengths.x * lengths.y);
        if settings.normal_weights == BY_AREA {
            weight = sine * (lengths.x * lengths.y);
        } else if settings.normal_weights == BY_ANGLE {
            weight = atan2(sine, dot(a / lengths.x, b / lengths.y));
        }
        any_normal = outward * across / sine;
        sum += weight * any_normal;
        size += weight;
    }
    let is_certain = length(sum) > LEAST_SHARE * size && length(sum) < 1e30;
    store_normal(group, select(any_normal, unit_or_zero(sum), is_certain));
}
