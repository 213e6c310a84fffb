// Facing of a triangle, decided once from its plane in the mesh's own space: above 0 front, below 0 back.

#import "shared/front_volume.wgsl"
#import "image_precision/style.wgsl"

fn front_volume(face: u32) -> f32 {
    return front_volume_seen_from(face, style.local_eye);
}
