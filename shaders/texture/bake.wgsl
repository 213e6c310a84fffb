// What a bake reads and writes on a device. Twins: crates/texture/src/gpu/bake/{settings,device_texel}.rs and
// crates/rays/src/ray/flat.rs

struct BakeUniform {
    // The root of the hull's hierarchy; that of the object is node 0.
    hull_root: u32,
    // Texels of the level that is searched: its first slot, and how many there are.
    first_slot: u32,
    level_texels: u32,
    // Texels and azimuths of this dispatch, as a range of elements of the level.
    first_element: u32,
    end_element: u32,
    // Texels of the batch, and those among them whose borders other texels follow.
    batch_texels: u32,
    known_texels: u32,
    azimuths: u32,
    is_interior: u32,
    lobe_rule: u32,
    // Nodes and faces that an invocation may visit before its sample is left to the CPU.
    most_steps: u32,
    // Two: turns of a loop that shows that loops still turn.
    two: u32,
    // The hull's local units per local unit of the object.
    hull_per_object: f32,
    // Distance within which exits do not count, in the hull's local units.
    beyond: f32,
    // In radians.
    tolerance: f32,
    _pad: f32,
}

struct Node {
    low: vec3<f32>,
    // 0 for an inner node.
    faces: u32,
    high: vec3<f32>,
    // The first of two children, or the first face.
    first: u32,
}

struct DeviceTexel {
    // In local coordinates of the object and of the hull.
    in_object: vec3<f32>,
    // Slots of the coarser texels on both sides, or `NO_SLOT`.
    seed_before: u32,
    in_hull: vec3<f32>,
    seed_after: u32,
    normal: vec3<f32>,
    center: vec3<f32>,
    tangent: vec3<f32>,
}

const NO_SLOT: u32 = 0xffffffffu;
// Words per meridian in `known`.
const MERIDIAN_WORDS: u32 = 7u;
// Distances that are none.
const HIDDEN: f32 = -1.0;
const LOST: f32 = -2.0;

@group(0) @binding(0) var<uniform> settings: BakeUniform;
@group(0) @binding(1) var<storage, read> nodes: array<Node>;
// Nine coordinates per face.
@group(0) @binding(2) var<storage, read> corners: array<f32>;
@group(0) @binding(3) var<storage, read> texels: array<DeviceTexel>;
// Per texel, how far away the object is shown along the middle of the lobe.
@group(0) @binding(4) var<storage, read_write> middles: array<f32>;
// Per azimuth and texel of all levels but the finest: number of borders and whether it is shown first, then the borders.
@group(0) @binding(5) var<storage, read_write> known: array<u32>;
// Per azimuth and texel: the angle as a share of pi, or `LOST`; the distance at the lobe's border, or `HIDDEN`.
@group(0) @binding(6) var<storage, read_write> found: array<vec2<f32>>;
// Rays, scans.
@group(0) @binding(7) var<storage, read_write> counts: array<atomic<u32>, 2>;
