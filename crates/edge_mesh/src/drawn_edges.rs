//! Step 3, compacted: lists of the edges that are drawn, made on the device. Stage: `shaders/edge_mesh/drawn_edges.wgsl`;
//! [`drawn_edges`] is its twin.
//!
//! Silhouettes and features have lists of their own, with room for all edges, so that nothing overflows. Entries are unordered,
//! which changes nothing: there is one colour per kind, and depth decides between lines.

use crate::chunks::ChunkIndices;
use crate::edge_record::{Bend, EdgeRecord, OfBackFaces};
use silhouette_core::FaceId;
use silhouette_gpu::MeshTooLarge;
use silhouette_gpu::kit::{bind_layout, buffers_group, compute_pipeline, storage_buffer, storage_entry, workgroups};

/// Numbers of the records that are drawn in a view, ascending.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct DrawnEdges {
    /// Silhouettes and boundaries.
    pub silhouettes: Vec<u32>,
    /// Ridges and valleys that are no silhouettes.
    pub features: Vec<(u32, Bend)>,
}

/// The records that are drawn, at rest. O(E).
pub fn drawn_edges(records: &[EdgeRecord], is_front: impl Fn(FaceId) -> bool, of_back: OfBackFaces) -> DrawnEdges {
    let mut drawn = DrawnEdges::default();
    for (index, record) in (0..).zip(records) {
        if record.is_silhouette(&is_front, of_back.boundaries) {
            drawn.silhouettes.push(index);
        } else if let Some(feature) = record.feature()
            && (of_back.features || is_front(record.first_face()))
        {
            drawn.features.push((index, feature.bend));
        }
    }
    drawn
}

/// Words of the arguments of an indexed indirect draw.
const ARGUMENT_WORDS: u64 = 5;

/// In an entry of the list of features: a valley.
const LISTED_VALLEY: u32 = 1 << 31;

/// The stage, for all renderers.
#[derive(Debug)]
pub(crate) struct DrawnEdgesStage {
    filling: wgpu::BindGroupLayout,
    drawing: wgpu::BindGroupLayout,
    pipeline: wgpu::ComputePipeline,
}

impl DrawnEdgesStage {
    /// `bindings` are the layouts of groups 0 to 2.
    pub fn new(device: &wgpu::Device, bindings: [&wgpu::BindGroupLayout; 3]) -> Self {
        let entries = [0, 1, 2].map(|binding| storage_entry(binding, false));
        let filling = bind_layout(device, "lists of drawn edges", &entries);
        let [camera, mesh, edges] = bindings.map(Some);
        let bindings = [camera, mesh, edges, Some(&filling)];
        let wgsl = silhouette_shaders::edge_mesh::DRAWN_EDGES;
        Self {
            pipeline: compute_pipeline(device, wgsl, "list_drawn_edges", &bindings),
            drawing: bind_layout(device, "drawn edges", &[storage_entry(0, true)]),
            filling,
        }
    }

    /// Layout of a list for the stage that draws it.
    pub fn drawing_layout(&self) -> &wgpu::BindGroupLayout {
        &self.drawing
    }
}

/// The lists of one renderer.
#[derive(Debug)]
pub(crate) struct DrawnLists {
    edges: u32,
    silhouettes: wgpu::Buffer,
    features: wgpu::Buffer,
    arguments: wgpu::Buffer,
    /// Indices of a chunk as the arguments have them.
    written: [u32; 2],
    filling: wgpu::BindGroup,
    drawing: [wgpu::BindGroup; 2],
}

impl DrawnLists {
    /// Room for `edges` silhouettes and `features` features.
    pub fn new(
        device: &wgpu::Device,
        stage: &DrawnEdgesStage,
        edges: u32,
        features: u32,
    ) -> Result<Self, MeshTooLarge> {
        let source = wgpu::BufferUsages::COPY_SRC;
        let list = |what, entries: u32| storage_buffer(device, what, 4 + 4 * u64::from(entries), source);
        let silhouettes = list("drawn silhouettes", edges)?;
        let features = list("drawn features", features)?;
        let indirect = wgpu::BufferUsages::INDIRECT;
        let arguments = storage_buffer(device, "arguments of draws", 8 * ARGUMENT_WORDS, indirect)?;
        let drawing =
            [&silhouettes, &features].map(|list| buffers_group(device, "drawn edges", &stage.drawing, &[list]));
        let filled = [&silhouettes, &features, &arguments];
        let filling = buffers_group(device, "lists of drawn edges", &stage.filling, &filled);
        Ok(Self { edges, silhouettes, features, arguments, written: [0; 2], filling, drawing })
    }

    /// Writes how many indices the lines of a chunk have, where that changed.
    pub fn prepare(&mut self, queue: &wgpu::Queue, indices: [u32; 2]) {
        if self.written != indices {
            let [silhouette, feature] = indices;
            queue.write_buffer(&self.arguments, 0, bytemuck::bytes_of(&[silhouette, 0, 0, 0, 0, feature, 0, 0, 0, 0]));
            self.written = indices;
        }
    }

    /// Makes both counts zero; before the pass of [`dispatch`](Self::dispatch).
    pub fn clear(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.silhouettes, 0, Some(4));
        encoder.clear_buffer(&self.features, 0, Some(4));
        for draw in 0..2 {
            encoder.clear_buffer(&self.arguments, 4 * (ARGUMENT_WORDS * draw + 1), Some(4));
        }
    }

    /// Makes the lists, with groups 0 to 2 bound.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, stage: &DrawnEdgesStage) {
        pass.set_pipeline(&stage.pipeline);
        pass.set_bind_group(3, &self.filling, &[]);
        let [x, y] = workgroups(self.edges);
        pass.dispatch_workgroups(x, y, 1);
    }

    /// Draws the silhouettes (0) or the features (1) with the pipeline that is set.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, list: usize, indices: &ChunkIndices) {
        pass.set_bind_group(3, &self.drawing[list], &[]);
        indices.set(pass);
        pass.draw_indexed_indirect(&self.arguments, 4 * ARGUMENT_WORDS * list as u64);
    }

    /// Both lists on the device, each its count and then its entries.
    pub fn buffers(&self) -> [&wgpu::Buffer; 2] {
        [&self.silhouettes, &self.features]
    }
}

impl DrawnEdges {
    /// The lists as the stage made them, from the words of both buffers.
    pub fn of_words(silhouettes: &[u32], features: &[u32]) -> Self {
        let entries = |words: &[u32]| {
            let count = words.first().map_or(0, |count| *count as usize);
            let mut entries: Vec<u32> = words.iter().skip(1).take(count).copied().collect();
            entries.sort_unstable_by_key(|entry| entry & !LISTED_VALLEY);
            entries
        };
        let bend = |entry: u32| if entry & LISTED_VALLEY == 0 { Bend::Ridge } else { Bend::Valley };
        Self {
            silhouettes: entries(silhouettes),
            features: entries(features).into_iter().map(|entry| (entry & !LISTED_VALLEY, bend(entry))).collect(),
        }
    }
}
