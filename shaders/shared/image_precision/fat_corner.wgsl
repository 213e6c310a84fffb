// One for each corner of a listed polygon, corners of a polygon one after another.
struct FatCorner {
    // The polygon's middle, and its V.N towards the viewer.
    middle: vec3<f32>,
    facing: f32,
    // This corner and the next one, pushed outwards with the edge between them.
    begin: vec3<f32>,
    // Whether the edge between them is nearer to level than to upright.
    level: u32,
    end: vec3<f32>,
    // The record of the next corner around the polygon.
    next: u32,
}
