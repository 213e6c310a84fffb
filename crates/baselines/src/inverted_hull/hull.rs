//! Step 3: back faces with their vertices pushed outwards. Stage: `shaders/baselines/hull.wgsl`.

use super::method::{InvertedHullOptions, Push};
use bytemuck::{Pod, Zeroable};
use silhouette_core::glam::DMat3;
use silhouette_core::mesh::Bounds;
use silhouette_gpu::kit::{RenderStage, WoundPipeline, bind_layout, storage_entry};
use silhouette_gpu::{
    CameraBinding, FrameView, LocalFrame, MeshBinding, POSITION_LAYOUT, TargetFormats, WidthOverDepth,
};

/// Twin of the struct in `hull.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct HullUniform {
    outward: [[f32; 4]; 3],
    shape: [[f32; 4]; 3],
    ink: [f32; 4],
    viewport_px: [f32; 2],
    reach: [f32; 2],
    px_per_unit: f32,
    world_push: f32,
    _pad: [u32; 2],
}

impl HullUniform {
    /// What the stage must know to draw a mesh with these bounds, whose positions are in `frame`.
    pub fn new(
        options: &InvertedHullOptions,
        view: &FrameView,
        bounds: &Bounds,
        frame: &LocalFrame,
        formats: &TargetFormats,
    ) -> Self {
        let style = options.line_style();
        let width = WidthOverDepth::new(&style.width, view, bounds);
        // The shape is in units of clip-space w, and in those of the frame in an orthographic view.
        let depth_per_w = frame.depth_per_w(view);
        let unit = if view.is_perspective() { depth_per_w } else { frame.unit() };
        let world_push = match options.push {
            Push::Image => 0.0,
            Push::World => {
                let middle = view.depth(bounds.center).max(view.depth_law().range().near);
                width.px_at(middle) / view.pixels_per_unit(middle) / unit
            }
        };
        let px_per_unit = view.pixels_per_unit(1.0) * if view.is_perspective() { 1.0 } else { unit };
        let shape = frame.shape(view);
        let columns = |matrix: DMat3| matrix.as_mat3().to_cols_array_2d().map(|[x, y, z]| [x, y, z, 0.0]);
        Self {
            outward: columns(outward(shape)),
            shape: columns(shape),
            ink: style.ink.for_target(formats),
            viewport_px: view.viewport().size_px.map(|side| side as f32),
            reach: [width.constant_px as f32, (width.px_at_depth_1 / depth_per_w) as f32],
            px_per_unit: px_per_unit as f32,
            world_push: world_push as f32,
            _pad: [0; 2],
        }
    }
}

/// A normal before a linear map to the vector that the map takes to the normal after it, up to length: normals go by the inverse
/// of the transpose, and from there back. It has no sign to get wrong where the map mirrors.
fn outward(shape: DMat3) -> DMat3 {
    let inverse = shape.inverse();
    let outward = inverse * inverse.transpose();
    let largest = outward.to_cols_array().into_iter().fold(0.0, |most: f64, part| most.max(part.abs()));
    outward * (1.0 / largest)
}

/// Layout of places and their normals, group 2.
pub(super) fn normals_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    bind_layout(device, "outline normals", &[storage_entry(0, true), storage_entry(1, true)])
}

/// Back faces of the hull, over what is farther; `is_welded` by the normals of group 2, otherwise by each face's own.
pub(super) fn pipeline(
    device: &wgpu::Device,
    formats: TargetFormats,
    options: &InvertedHullOptions,
    is_welded: bool,
) -> WoundPipeline {
    let blend = options.line_style().blend();
    WoundPipeline::new(device, move |device, front_face| {
        let camera = CameraBinding::layout(device);
        let mesh = MeshBinding::layout(device);
        let normals = normals_layout(device);
        let bindings = [Some(&camera), Some(&mesh), Some(&normals)];
        RenderStage {
            label: "inverted hull",
            wgsl: silhouette_shaders::baselines::HULL,
            vertex: if is_welded { "welded_vertex" } else { "split_vertex" },
            fragment: "hull_ink",
            bindings: if is_welded { &bindings } else { &bindings[..2] },
            vertex_buffers: if is_welded { &[Some(POSITION_LAYOUT)] } else { &[] },
            front_face,
            cull_mode: Some(wgpu::Face::Front),
            depth: Some(formats.depth_state(formats.nearer())),
            color: formats.color,
            blend,
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::DVec3;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("outward", offset_of!(HullUniform, outward)),
            ("shape", offset_of!(HullUniform, shape)),
            ("ink", offset_of!(HullUniform, ink)),
            ("viewport_px", offset_of!(HullUniform, viewport_px)),
            ("reach", offset_of!(HullUniform, reach)),
            ("px_per_unit", offset_of!(HullUniform, px_per_unit)),
            ("world_push", offset_of!(HullUniform, world_push)),
        ];
        let stage = silhouette_shaders::baselines::HULL;
        assert!(silhouette_shaders::layout::matches(stage, "HullUniform", size_of::<HullUniform>(), &members));
    }

    #[test]
    fn normals_stay_normal_under_stretching_and_mirroring() {
        for scale in [DVec3::new(3.0, 1.0, 0.2), DVec3::new(-1.0, 2.0, 1.0)] {
            let shape = DMat3::from_rotation_y(0.6) * DMat3::from_diagonal(scale) * DMat3::from_rotation_x(0.3);
            let [a, b] = [DVec3::new(1.0, 0.4, -0.2), DVec3::new(0.3, -1.0, 0.5)];
            let normal = a.cross(b);
            let moved = shape * (outward(shape) * normal);
            assert!(moved.dot(shape * a).abs() < 1e-9 && moved.dot(shape * b).abs() < 1e-9, "{scale}");
            // A point on the outer side of the plane stays there.
            assert!(moved.dot(shape * normal) > 0.0, "{scale}");
        }
    }
}
