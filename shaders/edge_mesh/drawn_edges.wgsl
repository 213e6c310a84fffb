// Step 3, compacted: lists the edges that are drawn, in any order. Twin: crates/edge_mesh/src/drawn_edges.rs

#import "shared/invocation.wgsl"
#import "edge_mesh/edge_record.wgsl"
#import "edge_mesh/listed.wgsl"

// The number of entries, and the entries.
@group(3) @binding(0) var<storage, read_write> silhouettes: array<atomic<u32>>;
@group(3) @binding(1) var<storage, read_write> features: array<atomic<u32>>;
// Arguments of both indirect draws, five words each.
@group(3) @binding(2) var<storage, read_write> arguments: array<atomic<u32>>;

// Where the instance counts are among the arguments.
const SILHOUETTE_CHUNKS: u32 = 1u;
const FEATURE_CHUNKS: u32 = 6u;

@compute @workgroup_size(WORKGROUP)
fn list_drawn_edges(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let edge = element(id, groups);
    if edge >= style.edges {
        return;
    }
    let record = records[edge];
    if is_silhouette(record) {
        let at = atomicAdd(&silhouettes[0], 1u);
        atomicStore(&silhouettes[at + 1u], edge);
        atomicMax(&arguments[SILHOUETTE_CHUNKS], at / CHUNK + 1u);
    } else if edge < style.features {
        let pen = feature_pen(record);
        if pen != 0u {
            let at = atomicAdd(&features[0], 1u);
            atomicStore(&features[at + 1u], edge | select(0u, LISTED_VALLEY, pen == VALLEY_PEN));
            atomicMax(&arguments[FEATURE_CHUNKS], at / CHUNK + 1u);
        }
    }
}
