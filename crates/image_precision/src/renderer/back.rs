//! [`Back`]: step 3 by variant, for one instance of a mesh.

use crate::back_edges::{self, BackEdges};
use crate::fat_polygons::FatPolygons;
use crate::later_faces::LaterFaces;
use crate::method::ImagePrecision;
use crate::pipelines::BackStages;
use crate::style::StyleUniform;
use silhouette_gpu::{CameraBinding, MeshBinding, MeshBuffers, MeshTooLarge};

/// What draws back faces.
#[derive(Debug)]
pub(super) enum Back {
    /// The faces themselves; the pipeline is that of the view last prepared.
    Faces(wgpu::RenderPipeline),
    /// Their edges as lines.
    Edges { list: Box<BackEdges>, pipeline: wgpu::RenderPipeline },
    /// Their fattened polygons.
    Fat(Box<FatPolygons>),
    /// What lies behind the first layer.
    Later(Box<LaterFaces>),
}

impl Back {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stages: &BackStages,
        method: &ImagePrecision,
        mesh: &MeshBuffers,
    ) -> Result<Self, MeshTooLarge> {
        let faces = mesh.face_count();
        Ok(match stages {
            BackStages::Faces(pipeline) => Self::Faces(pipeline.get(false).clone()),
            BackStages::Edges { list, pipeline } => {
                let list = Box::new(BackEdges::new(device, queue, list, faces, None)?);
                Self::Edges { list, pipeline: pipeline.clone() }
            }
            BackStages::Fat(stages) => {
                Self::Fat(Box::new(FatPolygons::new(device, queue, stages, faces, method.polygons())?))
            }
            BackStages::Later(stages) => Self::Later(Box::new(LaterFaces::new(device, queue, stages, faces)?)),
        })
    }

    /// Corners of the polygons, where they are not the triangles.
    pub fn corners(&self) -> Option<&wgpu::Buffer> {
        if let Self::Fat(fat) = self { fat.corners() } else { None }
    }

    /// Whether stages pull the mesh by index.
    pub fn pulls_mesh(&self) -> bool {
        !matches!(self, Self::Faces(_))
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

    /// Chooses the pipeline for the winding of the view, and makes room for a viewport of this size.
    pub fn prepare(&mut self, device: &wgpu::Device, stages: &BackStages, is_mirrored: bool, size_px: [u32; 2]) {
        match (self, stages) {
            (Self::Faces(pipeline), BackStages::Faces(wound)) => *pipeline = wound.get(is_mirrored).clone(),
            (Self::Later(layer), _) => layer.resize(device, size_px),
            _ => {}
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
