// Which element of a list an invocation works on. Twin: `groups` in crates/image_precision/src/stage.rs

const WORKGROUP: u32 = 64u;

// Invocations in a row: the step of stages that go round.
fn row(groups: vec3<u32>) -> u32 {
    return groups.x * WORKGROUP;
}

// Where there is one invocation for each.
fn element(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.x + id.y * row(groups);
}
