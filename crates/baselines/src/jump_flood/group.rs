//! [`JumpFloodGroup`]: several objects in one field. [`JumpFloodRenderer`]: a group of one.

use super::method::{Antialiasing, JumpFlood, JumpFloodOptions};
use super::object_mask::{self, MOST_OBJECTS, ObjectMask, ObjectUniform};
use super::{border_seeds, outline_ink};
use crate::distance_field::{Extent, Field, FieldLayouts, FieldUniform, FloodStage, Rim, check_size, widest_px};
use silhouette_core::glam::DMat4;
use silhouette_gpu::{
    CameraBinding, CameraUniform, Cull, DrawsLines, FillPipelines, FillRenderer, FrameRenderer, FrameView, MeshBuffers,
    PenPlacement, RendererError, TargetFormats, Viewport, WidthOverDepth,
};
use std::sync::Arc;

/// What all renderers with the same options, on the same device and formats, share.
#[derive(Debug)]
pub struct JumpFloodPipelines {
    formats: TargetFormats,
    interior: Option<Arc<FillPipelines>>,
    layouts: FieldLayouts,
    mask: wgpu::RenderPipeline,
    plant: wgpu::ComputePipeline,
    flood: wgpu::ComputePipeline,
    ink: wgpu::RenderPipeline,
}

/// Draws objects with an outline for each, which lies over the objects behind it: neighbours in the image stay apart, whether they
/// touch or one hides the other. All take part in one field, whose cost does not depend on their number.
#[derive(Debug)]
pub struct JumpFloodGroup {
    options: JumpFloodOptions,
    pipelines: Arc<JumpFloodPipelines>,
    flood: FloodStage,
    binding: CameraBinding,
    objects: Vec<Object>,
    textures: Option<Textures>,
    viewport: Option<Viewport>,
}

/// A mesh of a group.
#[derive(Debug)]
struct Object {
    mesh: Arc<MeshBuffers>,
    /// The view into the field, and the object's number.
    binding: CameraBinding,
    interior: Option<FillRenderer>,
    is_drawn: bool,
}

/// What is as large as the field.
#[derive(Debug)]
struct Textures {
    mask: ObjectMask,
    field: Field,
}

impl JumpFlood {
    /// A renderer of several objects, each a mesh that may be that of others too; `pipelines` are this method's
    /// ([`DrawsLines::pipelines`]).
    ///
    /// # Errors
    /// [`RendererError::TooMany`] for more than 65 535 objects.
    pub fn group(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<JumpFloodPipelines>,
        meshes: &[Arc<MeshBuffers>],
    ) -> Result<JumpFloodGroup, RendererError> {
        if meshes.len() > MOST_OBJECTS {
            let (count, limit) = (meshes.len(), MOST_OBJECTS);
            return Err(RendererError::TooMany { what: "objects of a group", count, limit });
        }
        let layout = CameraBinding::layout(device);
        let object = |mesh: &Arc<MeshBuffers>| Object {
            mesh: Arc::clone(mesh),
            binding: CameraBinding::new(device, &layout, size_of::<ObjectUniform>()),
            interior: pipelines.interior.as_ref().map(|interior| FillRenderer::new(device, interior, mesh)),
            is_drawn: false,
        };
        Ok(JumpFloodGroup {
            options: self.options,
            pipelines: Arc::clone(pipelines),
            flood: FloodStage::new(device, queue, &pipelines.flood),
            binding: CameraBinding::new(device, &layout, size_of::<FieldUniform>()),
            objects: meshes.iter().map(object).collect(),
            textures: None,
            viewport: None,
        })
    }
}

impl JumpFloodGroup {
    /// Uploads a view in which object i is placed by `models[i]`; objects beyond the end of `models` are not drawn. Textures are made
    /// anew where the viewport or the width of lines needs others.
    ///
    /// # Errors
    /// [`RendererError`]: the view's depth direction is not the target's, a model matrix has no inverse, or the device has no
    /// textures as large as the view with a margin as wide as the lines.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        view: &FrameView,
        models: &[DMat4],
    ) -> Result<(), RendererError> {
        let placed = |object: usize| models.get(object).map(|&model| view.with_model(model)).transpose();
        self.prepare_placed(device, queue, view, |object| Ok(placed(object)?))
    }

    /// Uploads a view, of which `placed` says how each object is seen, if at all.
    fn prepare_placed(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        view: &FrameView,
        placed: impl Fn(usize) -> Result<Option<FrameView>, RendererError>,
    ) -> Result<(), RendererError> {
        let formats = self.pipelines.formats;
        formats.check(view)?;
        self.viewport = None;
        let style = self.options.line_style();
        let (mut reach_px, mut radius, mut width) = (0.0_f64, 0.0_f64, None);
        for (index, object) in self.objects.iter_mut().enumerate() {
            let seen = placed(index)?.zip(object.mesh.bounds());
            object.is_drawn = seen.is_some();
            let Some((view, bounds)) = seen else { continue };
            let own = WidthOverDepth::new(&style.width, &view, &bounds);
            reach_px = reach_px.max(widest_px(&view, &bounds, &own));
            radius = radius.max(bounds.radius * view.largest_scale());
            width = Some(own);
        }
        let Some(width) = width else { return Ok(()) };
        let extent = Extent::new(view.viewport(), reach_px);
        self.resize(device, extent)?;
        for (number, object) in (1_u32..).zip(&mut self.objects) {
            let Some(view) = placed(number as usize - 1)?.filter(|_| object.is_drawn) else { continue };
            let frame = object.mesh.frame();
            let camera = CameraUniform::new(frame.to_clip(&extent.view(&view)?));
            object.binding.write(queue, &camera, &ObjectUniform { object: number, _pad: [0; 3] });
            if let Some(interior) = &mut object.interior {
                interior.prepare(device, queue, &view)?;
            }
        }
        let rim = match self.options.antialiasing {
            Antialiasing::Samples => Rim::Samples,
            Antialiasing::Coverage => Rim::Smooth,
        };
        let uniform = FieldUniform::new(view, radius, &extent, &width, 1.0, &formats);
        let uniform = uniform.with_ink(style.ink.for_target(&formats), rim);
        self.binding.write(queue, &CameraUniform::new(DMat4::IDENTITY), &uniform);
        self.viewport = Some(view.viewport());
        Ok(())
    }

    /// Textures for a field of this extent: those that there are, where they are of its size.
    fn resize(&mut self, device: &wgpu::Device, extent: Extent) -> Result<(), RendererError> {
        match &mut self.textures {
            Some(textures) if textures.field.size_px() == extent.size_px() => textures.field.set_extent(extent),
            textures => {
                check_size(device, &extent)?;
                let field = Field::new(device, &self.pipelines.layouts, extent);
                *textures = Some(Textures { mask: ObjectMask::new(device, extent.size_px()), field });
            }
        }
        Ok(())
    }

    /// Records the passes that find the nearest seed of every pixel.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        let (Some(Textures { mask, field }), Some(_)) = (&self.textures, self.viewport) else { return };
        let JumpFloodPipelines { formats, mask: draw_mask, plant, .. } = &*self.pipelines;
        let mut pass = mask.picture.begin_pass(encoder, formats.clear_depth());
        pass.set_pipeline(draw_mask);
        for object in self.objects.iter().filter(|object| object.is_drawn) {
            pass.set_bind_group(0, object.binding.bind_group(), &[]);
            object.mesh.draw(&mut pass);
        }
        drop(pass);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, &mask.read, &[]);
        pass.set_bind_group(2, field.planted(), &[]);
        pass.set_pipeline(plant);
        field.dispatch(&mut pass);
        field.flood(&mut pass, &self.flood);
    }

    /// Records the objects, as the interior says, and then their outlines.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(Textures { field, .. }), Some(viewport)) = (&self.textures, self.viewport) else { return };
        for object in self.objects.iter().filter(|object| object.is_drawn) {
            if let Some(interior) = &object.interior {
                interior.draw(pass);
            }
        }
        viewport.set(pass);
        pass.set_pipeline(&self.pipelines.ink);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, field.known(), &[]);
        pass.draw(0..3, 0..1);
    }
}

/// Draws a mesh and its outline.
#[derive(Debug)]
pub struct JumpFloodRenderer {
    group: JumpFloodGroup,
}

impl DrawsLines for JumpFlood {
    type Pipelines = JumpFloodPipelines;
    type Renderer = JumpFloodRenderer;

    fn pen_placement(&self) -> PenPlacement {
        PenPlacement::Outside
    }

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<JumpFloodPipelines, RendererError> {
        let layouts = FieldLayouts::new(device);
        Ok(JumpFloodPipelines {
            formats,
            interior: self.options.line_style().interior(device, formats, Cull::None),
            mask: object_mask::pipeline(device, formats),
            plant: border_seeds::pipeline(device, &layouts),
            flood: FloodStage::pipeline(device, &layouts),
            ink: outline_ink::pipeline(device, formats, &layouts, &self.options),
            layouts,
        })
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<JumpFloodPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<JumpFloodRenderer, RendererError> {
        Ok(JumpFloodRenderer { group: self.group(device, queue, pipelines, std::slice::from_ref(mesh))? })
    }
}

impl FrameRenderer for JumpFloodRenderer {
    /// Textures are made anew where the viewport or the width of lines needs others.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        self.group.prepare_placed(device, queue, view, |_| Ok(Some(*view)))
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        self.group.encode(encoder);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.group.draw(pass);
    }
}
