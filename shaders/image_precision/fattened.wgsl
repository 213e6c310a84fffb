// Which polygons are fattened, and what they are listed in. Twin: crates/image_precision/src/fat_polygons.rs

#import "image_precision/style.wgsl"

// Arguments of two draws and two counts, see below.
@group(2) @binding(0) var<storage, read_write> arguments: array<atomic<u32>>;
@group(2) @binding(1) var<storage, read> starts: array<u32>;
// From the front cut triangles, two elements a vertex: clip space, then how far inside of each cut and V.N of the polygon. From
// the back vertices of fans in clip space.
@group(2) @binding(2) var<storage, read_write> places: array<vec4<f32>>;
// One for each place that may hold a vertex of a fan.
@group(2) @binding(3) var<storage, read_write> notes: array<u32>;
// Triangles of fans.
@group(2) @binding(4) var<storage, read_write> indices: array<u32>;
// Polygons that become fans.
@group(2) @binding(5) var<storage, read_write> rest: array<u32>;

// In `arguments`: indices of fans, vertices of cut triangles, places that fans take, entries of `rest`.
const FAN_INDICES: u32 = 0u;
const CUT_VERTICES: u32 = 5u;
const FAN_PLACES: u32 = 9u;
const REST: u32 = 10u;

// Back faces, and front faces nearly edge-on where a band is asked for; a polygon without area faces nowhere.
fn is_fattened(facing: f32) -> bool {
    return facing < 0.0 || (facing > 0.0 && facing < style.band);
}
