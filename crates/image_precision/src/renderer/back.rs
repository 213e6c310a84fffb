//! [`Back`]: step 3 by variant.

use crate::back_edges::{self, BackEdges, Listed};
use crate::fat_polygons::FatPolygons;
use crate::later_faces::LaterFaces;
use crate::method::ImagePrecision;
use crate::settings::Variant;
use crate::style::StyleUniform;
use crate::{back_faces, screen};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshBuffers, RendererError, TargetFormats};

/// What draws back faces.
#[derive(Debug)]
pub(super) enum Back {
    /// The faces themselves, pulled by the matrix or by polygon offset, or as the adapter's own lines.
    Faces(wgpu::RenderPipeline),
    /// Their edges as lines.
    Edges { list: BackEdges, pipeline: wgpu::RenderPipeline },
    /// Their fattened polygons.
    Fat(Box<FatPolygons>),
    /// Whatever lies behind the first layer.
    Later(Box<LaterFaces>),
}

impl Back {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        method: &ImagePrecision,
        buffers: &MeshBuffers,
        formats: TargetFormats,
    ) -> Result<Self, RendererError> {
        let settings = method.settings();
        let variant = settings.variant;
        let faces = buffers.face_count();
        let edges = |listed| -> Result<Self, RendererError> {
            let list = BackEdges::new(device, queue, faces, listed, None)?;
            Ok(Self::Edges { list, pipeline: screen::pipeline(device, formats, settings, "line_of_edge") })
        };
        match variant {
            Variant::Screen => edges(Listed::Unshared),
            Variant::Wireframe { polygon_mode: false } => edges(Listed::EveryEdge),
            Variant::Wireframe { polygon_mode: true } => {
                if !device.features().contains(wgpu::Features::POLYGON_MODE_LINE) {
                    return Err(RendererError::MissingFeature {
                        what: "wireframe-lines=polygon-mode",
                        feature: "POLYGON_MODE_LINE",
                        instead: "use wireframe-lines=quads, which needs none",
                    });
                }
                Ok(Self::Faces(back_faces::pipeline(device, formats, settings)))
            }
            Variant::Fatten { .. } | Variant::Charcoal { .. } => {
                let fat = FatPolygons::new(device, queue, faces, method.polygons(), settings, formats)?;
                Ok(Self::Fat(Box::new(fat)))
            }
            Variant::Unoriented { k } => {
                let layer = LaterFaces::new(device, queue, faces, k.is_some(), settings, formats)?;
                Ok(Self::Later(Box::new(layer)))
            }
            Variant::Equal
            | Variant::FixedPull { .. }
            | Variant::Scale { .. }
            | Variant::DepthRange { .. }
            | Variant::Offset { .. } => Ok(Self::Faces(back_faces::pipeline(device, formats, settings))),
        }
    }

    /// Corners of the polygons, where they are not the triangles.
    pub fn corners(&self) -> Option<&wgpu::Buffer> {
        if let Self::Fat(fat) = self { fat.corners() } else { None }
    }

    /// Fills in what the mesh and the tables decide of the uniform.
    pub fn complete(&self, style: &mut StyleUniform) {
        match self {
            Self::Faces(_) => {}
            Self::Edges { list, .. } => {
                style.faces = list.faces();
                style.slot_mask = list.slot_mask();
                style.corner_mask = back_edges::corner_mask(list.faces());
            }
            Self::Fat(fat) => {
                style.faces = fat.count();
                style.polygon_corners = fat.polygon_corners();
                style.noted = fat.noted();
                style.most_around = fat.most_around();
            }
            Self::Later(layer) => {
                style.faces = layer.faces();
                style.slot_mask = layer.slot_mask();
                style.corner_mask = back_edges::corner_mask(layer.faces());
            }
        }
    }

    /// Makes room for a viewport of this size.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        if let Self::Later(layer) = self {
            layer.resize(device, size);
        }
    }

    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, mesh: &MeshBinding) {
        match self {
            Self::Faces(_) => {}
            Self::Edges { list, .. } => list.encode(encoder, camera, mesh),
            Self::Fat(fat) => fat.encode(encoder, camera, mesh),
            Self::Later(layer) => layer.encode(encoder, camera, mesh),
        }
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, buffers: &MeshBuffers, mesh: Option<&MeshBinding>) {
        match (self, mesh) {
            (Self::Faces(pipeline), _) => {
                pass.set_pipeline(pipeline);
                buffers.draw(pass);
            }
            (Self::Fat(fat), Some(_)) => fat.draw(pass),
            (Self::Edges { list, pipeline }, Some(mesh)) => {
                pass.set_bind_group(1, mesh.bind_group(), &[]);
                pass.set_pipeline(pipeline);
                list.draw(pass);
            }
            (Self::Later(layer), Some(mesh)) => {
                pass.set_bind_group(1, mesh.bind_group(), &[]);
                layer.draw(pass);
            }
            (_, None) => {}
        }
    }
}
