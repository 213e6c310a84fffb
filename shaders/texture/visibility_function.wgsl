// How far away a hull point shows the object. Twin: crates/texture/src/visibility_function.rs

#import "texture/bake.wgsl"
#import "texture/ray.wgsl"

// Distance from the middle of the mesh beyond which a ray begins later, in local units.
const NEAR: f32 = 2.0;

// In local units of the object; `HIDDEN` where the point does not show it.
fn shown_distance(texel: DeviceTexel, direction: vec3<f32>) -> f32 {
    if dot(texel.normal, direction) >= 0.0 {
        return HIDDEN;
    }
    let origin = texel.in_object;
    let is_far = dot(origin, origin) > NEAR * NEAR;
    let skipped = select(0.0, max(-dot(origin, direction) - NEAR, 0.0), is_far);
    let met = nearest_crossing(ray_of(origin + skipped * direction, direction), 0u, HIDDEN, NEVER, false);
    if met >= NEVER {
        return HIDDEN;
    }
    let distance = met + skipped;
    if settings.is_interior != 0u {
        let within = distance * settings.hull_per_object;
        let hull_ray = ray_of(texel.in_hull, direction);
        if nearest_crossing(hull_ray, settings.hull_root, settings.beyond, within, true) < within {
            return HIDDEN;
        }
    }
    return distance;
}
