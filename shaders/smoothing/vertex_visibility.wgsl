// Section III-B, second half: a vertex is visible where its normal points to the viewer or across. Each shading vertex takes its
// vertex's position and decides its bit, from which everything else is derived. Twin: crates/smoothing/src/vertex_visibility.rs

#import "shared/invocation.wgsl"
#import "shared/mesh.wgsl"
#import "smoothing/frame.wgsl"

@compute @workgroup_size(WORKGROUP)
fn decide_visibility(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let group = element(id, groups);
    if group >= settings.groups {
        return;
    }
    let vertex = tables[settings.group_vertices_at + group];
    let position = vertex_position(vertex);
    store_position(group, position);
    state[group] = select(0u, 1u, dot(normal_of(group), toward_viewer(position)) >= 0.0);
    atomicStore(&at_concave[vertex], 0u);
}
