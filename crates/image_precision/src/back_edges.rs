//! Lists the edges of back faces on the adapter, without those between two back faces. Stages:
//! `shaders/image_precision/face_list.wgsl`, `back_edges.wgsl`.

use crate::face_list::{FaceList, FaceListStage};
use silhouette_gpu::kit::{bind_layout, buffers_group, compute_pipeline, storage_buffer, storage_entry, workgroups};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge};
use silhouette_shaders::image_precision::BACK_EDGES;

/// Which faces' edges are listed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Listed {
    /// Every edge of every back face, once for each.
    EveryEdge,
    /// Edges that one back face has.
    Unshared,
    /// Edges that one face behind the first layer has.
    UnsharedLater,
}

/// The stages that make a list, shared by all renderers.
#[derive(Debug, Clone)]
pub(crate) struct BackEdgesStages {
    listed: Listed,
    faces: FaceListStage,
    filling: wgpu::BindGroupLayout,
    drawing: wgpu::BindGroupLayout,
    add: wgpu::ComputePipeline,
    list_unshared: wgpu::ComputePipeline,
}

impl BackEdgesStages {
    pub fn new(device: &wgpu::Device, listed: Listed) -> Self {
        let entries = [0, 1, 2, 3].map(|binding| storage_entry(binding, binding == 0));
        let filling = bind_layout(device, "listing of edges", &entries);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let layouts = [Some(&camera), Some(&mesh), Some(&filling)];
        let listing = if listed == Listed::UnsharedLater { "list_later_layers" } else { "list_back_faces" };
        let add = if listed == Listed::EveryEdge { "list_every_edge" } else { "add_edges" };
        Self {
            listed,
            faces: FaceListStage::new(device, listing),
            drawing: drawing_layout(device),
            add: compute_pipeline(device, BACK_EDGES, add, &layouts),
            list_unshared: compute_pipeline(device, BACK_EDGES, "list_unshared", &layouts),
            filling,
        }
    }
}

/// A list of edges that is made anew for each view, without the CPU.
#[derive(Debug)]
pub(crate) struct BackEdges {
    stages: BackEdgesStages,
    faces: FaceList,
    slots: u32,
    table: wgpu::Buffer,
    arguments: wgpu::Buffer,
    filling: wgpu::BindGroup,
    drawing: wgpu::BindGroup,
}

/// Slots that an invocation of the listing stage reads at once.
const SLOTS_PER_INVOCATION: u32 = 4;

/// Layout of the list for the stage that draws it.
pub(crate) fn drawing_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    bind_layout(device, "lines to draw", &[storage_entry(0, true)])
}

/// Arguments of an indirect draw whose vertices stages count: one instance of none so far.
pub(crate) fn draw_arguments(device: &wgpu::Device, queue: &wgpu::Queue) -> Result<wgpu::Buffer, MeshTooLarge> {
    let arguments = storage_buffer(device, "arguments of the draw", 16, wgpu::BufferUsages::INDIRECT)?;
    queue.write_buffer(&arguments, 0, bytemuck::bytes_of(&[0_u32, 1, 0, 0]));
    Ok(arguments)
}

impl BackEdges {
    /// `first_layer` holds one word per face where faces behind the first layer are asked for.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stages: &BackEdgesStages,
        faces: u32,
        first_layer: Option<&wgpu::Buffer>,
    ) -> Result<Self, MeshTooLarge> {
        let slots = if stages.listed == Listed::EveryEdge { 1 } else { slots(faces) };
        let none = wgpu::BufferUsages::empty();
        let table = storage_buffer(device, "edge table", 4 * u64::from(slots), none)?;
        let list = storage_buffer(device, "edges of back faces", 12 * u64::from(faces), none)?;
        let arguments = draw_arguments(device, queue)?;
        let nothing = storage_buffer(device, "no first layer", 4, none)?;
        let faces = FaceList::new(device, &stages.faces, faces, first_layer.unwrap_or(&nothing))?;
        let filled = [faces.entries(), &table, &list, &arguments];
        Ok(Self {
            slots,
            filling: buffers_group(device, "listing of edges", &stages.filling, &filled),
            drawing: buffers_group(device, "lines to draw", &stages.drawing, &[&list]),
            stages: stages.clone(),
            faces,
            table,
            arguments,
        })
    }

    /// Number of faces.
    pub fn faces(&self) -> u32 {
        self.faces.count()
    }

    /// What the stages expect as `slot_mask`.
    pub fn slot_mask(&self) -> u32 {
        self.slots - 1
    }

    /// Makes the list for the view whose uniforms are bound.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        encoder.clear_buffer(&self.table, 0, None);
        encoder.clear_buffer(&self.arguments, 0, Some(4));
        self.faces.clear(encoder);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        self.faces.encode(&mut pass);
        pass.set_bind_group(2, &self.filling, &[]);
        pass.set_pipeline(&self.stages.add);
        self.faces.dispatch(&mut pass, 3);
        if self.slots > 1 {
            pass.set_pipeline(&self.stages.list_unshared);
            let [x, y] = workgroups(self.slots / SLOTS_PER_INVOCATION);
            pass.dispatch_workgroups(x, y, 1);
        }
    }

    /// Draws the list with the pipeline that is set.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(2, &self.drawing, &[]);
        pass.draw_indirect(&self.arguments, 0);
    }
}

/// Slots of the table: a power of two, at least four thirds of the edges of a surface all of whose faces are back. A soup of
/// faces that share no edge has up to 3 F, more than the table holds; each that finds no place is drawn, as it should be.
fn slots(faces: u32) -> u32 {
    faces.saturating_mul(2).clamp(SLOTS_PER_INVOCATION, 1 << 31).next_power_of_two()
}

/// What the stages expect as `corner_mask`: as many low bits as the number of any corner, plus one, takes.
pub(crate) fn corner_mask(faces: u32) -> u32 {
    u32::MAX >> faces.saturating_mul(3).max(1).leading_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_has_room_for_every_edge_of_a_surface() {
        for faces in [0, 1, 5, 1000, 1_000_000, 20_000_000] {
            let slots = slots(faces);
            assert!(
                slots.is_power_of_two()
                    && slots >= SLOTS_PER_INVOCATION
                    && u64::from(slots) * 3 >= u64::from(faces) * 3 / 2 * 4
            );
        }
    }
}
