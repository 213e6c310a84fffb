// Which element of a list an invocation works on. Twin: `groups` in crates/gpu/src/kit/workgroups.rs

const WORKGROUP: u32 = 64u;

// Invocations in one row of workgroups: the stride of stages whose invocations each take several elements.
fn row(groups: vec3<u32>) -> u32 {
    return groups.x * WORKGROUP;
}

// The element of an invocation, where each element has one.
fn element(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.x + id.y * row(groups);
}
