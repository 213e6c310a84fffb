// The farthest depth of front faces in squares of the image. Twin: crates/image_precision/src/front_depth.rs

@group(1) @binding(1) var tiles: texture_storage_2d<r32float, write>;

@compute @workgroup_size(8, 8)
fn find_farthest(@builtin(global_invocation_id) id: vec3<u32>) {
    let count = textureDimensions(tiles);
    if id.x >= count.x || id.y >= count.y {
        return;
    }
    let last = vec2<u32>(style.viewport_px) - 1u;
    var farthest = 0.0;
    for (var at = 0u; at < TILE_PX * TILE_PX; at++) {
        let pixel = min(id.xy * TILE_PX + vec2<u32>(at % TILE_PX, at / TILE_PX), last);
        for (var sample = 0u; sample < samples(); sample++) {
            farthest = max(farthest, distance_of(depth_at(vec2<i32>(pixel), sample)));
        }
    }
    textureStore(tiles, id.xy, vec4<f32>(farthest));
}
