//! [`SmoothingPipelines`]: all stages, for all meshes.

use crate::gpu::prefix_sum::SumStages;
use crate::view_mesh_renderer::ViewMeshPipelines;
use silhouette_gpu::kit::{bind_group, bind_layout, compute_pipeline, storage_entry};
use silhouette_gpu::{CameraBinding, MeshBinding, Shade, TargetFormats};
use silhouette_shaders::smoothing as stages;

/// The compute stages, and the pipeline that draws what they make.
#[derive(Debug)]
pub struct SmoothingPipelines {
    pub(crate) surface: ViewMeshPipelines,
    pub(crate) frame_layout: wgpu::BindGroupLayout,
    pub(crate) output_layout: wgpu::BindGroupLayout,
    /// Group 1 of stages that do not read the mesh. A layout of `None` in its place would leave group 2 unbound when wgpu 30 goes
    /// from a pipeline with a group 1 to one without.
    pub(crate) no_mesh: wgpu::BindGroup,
    pub(crate) shading_normals: wgpu::ComputePipeline,
    pub(crate) feature_segments: wgpu::ComputePipeline,
    pub(crate) vertex_visibility: wgpu::ComputePipeline,
    pub(crate) silhouette_points: wgpu::ComputePipeline,
    pub(crate) count_samples: wgpu::ComputePipeline,
    pub(crate) silhouette_segments: wgpu::ComputePipeline,
    pub(crate) sums: SumStages,
    pub(crate) place_samples: wgpu::ComputePipeline,
    pub(crate) remeshing: wgpu::ComputePipeline,
    pub(crate) perturbation: wgpu::ComputePipeline,
}

impl SmoothingPipelines {
    /// Builds all pipelines. Some tens of milliseconds.
    pub fn new(device: &wgpu::Device, formats: TargetFormats, shade: Shade) -> Self {
        let written = |binding| storage_entry(binding, false);
        let frame_layout = bind_layout(
            device,
            "smoothing: frame",
            &[written(0), storage_entry(1, true), written(2), written(3), written(4)],
        );
        let output_layout = bind_layout(device, "smoothing: output", &[written(0), written(1), written(2)]);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let of_mesh = [Some(&camera), Some(&mesh), Some(&frame_layout)];
        let empty = bind_layout(device, "smoothing: no mesh", &[]);
        let of_output = [Some(&camera), Some(&empty), Some(&frame_layout), Some(&output_layout)];
        let of_mesh = |wgsl, entry| compute_pipeline(device, wgsl, entry, &of_mesh);
        let counting = |wgsl, entry| compute_pipeline(device, wgsl, entry, &of_output);
        Self {
            surface: ViewMeshPipelines::new(device, formats, shade),
            shading_normals: of_mesh(stages::SHADING_NORMALS, "find_normals"),
            feature_segments: of_mesh(stages::FEATURE_SEGMENTS, "find_curves"),
            vertex_visibility: of_mesh(stages::VERTEX_VISIBILITY, "decide_visibility"),
            silhouette_points: of_mesh(stages::SILHOUETTE_POINTS, "find_points"),
            count_samples: counting(stages::FEATURE_SAMPLES, "count_samples"),
            silhouette_segments: counting(stages::SILHOUETTE_SEGMENTS, "find_segments"),
            sums: SumStages::new(device, &of_output),
            place_samples: counting(stages::FEATURE_SAMPLES, "place_samples"),
            remeshing: counting(stages::REMESHING, "write_triangles"),
            perturbation: of_mesh(stages::PERTURBATION, "lower_vertices"),
            no_mesh: bind_group(device, "smoothing: no mesh", &empty, &[]),
            frame_layout,
            output_layout,
        }
    }
}
