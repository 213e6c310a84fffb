// Facing of a triangle, decided once from its plane in the mesh's own space: above 0 front, below 0 back.

#import "shared/mesh.wgsl"
#import "image_precision/style.wgsl"

fn front_volume(face: u32) -> f32 {
    let a = corner_position(3u * face);
    let b = corner_position(3u * face + 1u);
    let c = corner_position(3u * face + 2u);
    return dot(cross(b - a, c - a), style.local_eye.xyz - a * style.local_eye.w);
}
