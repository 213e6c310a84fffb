//! Outlines of instances of a skinned mesh: nothing on the CPU is done per vertex, edge or face in a frame.
//!
//! ```text
//! cargo run --release -p silhouette-edge-mesh --example skinned -- out/skinned
//! ```
//!
//! A beam bends between two joints. In each frame a compute stage blends the joints' matrices and writes this frame's positions
//! into a buffer of the application's ([`skin`]); the edge mesh finds facing, ridges and silhouettes from there, on the device, in
//! the same submission. Two poses with three instances each stand in the picture, one of which is mirrored and one stretched; all
//! share pipelines and records.

mod beam;
mod skin;
#[cfg(test)]
mod tests;

use beam::beam;
use silhouette_core::glam::{DMat4, DQuat, DVec3, Vec3};
use silhouette_core::line_style::WidthUnitChoice;
use silhouette_core::view::{Camera, ClipRange, Projection};
use silhouette_core::{Method, PreparedMesh};
use silhouette_edge_mesh::{EdgeMesh, EdgeMeshOptions, Renderer};
use silhouette_gpu::{DrawsLines, FrameRenderer, FrameView, MeshBuffers};
use silhouette_render::{AdapterChoice, DEFAULT_FORMATS, Gpu, Image, Load, Target};
use skin::Skin;
use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;

/// Width and height of the pictures.
const SIZE: [u32; 2] = [640, 400];

/// Pictures that are written.
const FRAMES: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("out/skinned"), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    let mut scene = Scene::new(&gpu)?;
    for frame in 0..FRAMES {
        let picture = scene.draw(&gpu, f64::from(frame) * 0.4)?;
        picture.save_png(&folder.join(format!("{frame}.png")))?;
    }
    Ok(())
}

/// Everything that is made once.
struct Scene {
    poses: Vec<Skin>,
    instances: Instances,
}

/// The instances, and where they are drawn.
struct Instances {
    /// Renderers with their places in the world.
    renderers: Vec<(Renderer, DMat4)>,
    target: Target,
    view: FrameView,
}

impl Scene {
    fn new(gpu: &Gpu) -> Result<Self, Box<dyn Error>> {
        let (device, queue) = (gpu.device(), gpu.queue());
        let mesh = Arc::new(PreparedMesh::new(beam()?));
        let options = EdgeMeshOptions {
            width: 0.8,
            ridge_width: 0.4,
            width_unit: WidthUnitChoice::HeightPercent,
            ridge_angle_deg: 50.0,
            ridge_red: 0.7,
            ..EdgeMeshOptions::default()
        };
        let method = EdgeMesh::new(&mesh, options)?;
        let pipelines = Arc::new(method.pipelines(device, DEFAULT_FORMATS)?);
        let (mut poses, mut renderers) = (Vec::new(), Vec::new());
        for pose in 0..2 {
            let skin = Skin::new(gpu, mesh.mesh());
            let positions = skin.positions().clone();
            let triangles = mesh.mesh().triangles();
            let buffers = MeshBuffers::from_position_buffer(device, queue, positions, triangles, beam::bounds())?;
            let buffers = Arc::new(buffers);
            for (column, scale) in
                [DVec3::ONE, DVec3::new(-1.0, 1.0, 1.0), DVec3::new(1.3, 0.7, 0.6)].into_iter().enumerate()
            {
                let place = DVec3::new(2.4 * column as f64 - 2.4, 0.0, -3.0 * f64::from(pose));
                let turn = DQuat::from_rotation_y(0.5 + 0.3 * f64::from(pose));
                let model = DMat4::from_scale_rotation_translation(scale, turn, place);
                renderers.push((method.renderer(device, queue, &pipelines, &buffers)?, model));
            }
            poses.push(skin);
        }
        let projection = Projection::Perspective { fov_y_rad: 0.42 };
        let camera = Camera::new(Vec3::new(0.5, 2.5, 9.0), Vec3::new(0.1, 0.1, -1.0), Vec3::Y, projection, SIZE)?;
        let range = ClipRange { near: 0.5, far: 40.0 };
        let view = FrameView::from_camera(&camera, range, DEFAULT_FORMATS.depth_direction)?;
        let target = Target::new(gpu, SIZE, DEFAULT_FORMATS)?;
        Ok(Self { poses, instances: Instances { renderers, target, view } })
    }

    /// A frame in one submission.
    fn draw(&mut self, gpu: &Gpu, seconds: f64) -> Result<Image, Box<dyn Error>> {
        for (pose, bend_rad) in self.poses.iter().zip(bends_rad(seconds)) {
            pose.prepare(gpu, &skin::joints(bend_rad));
        }
        self.instances.draw(gpu, |encoder| self.poses.iter().for_each(|pose| pose.encode(encoder)))
    }
}

/// How far the beam is bent in either pose.
fn bends_rad(seconds: f64) -> [f64; 2] {
    [seconds.sin(), -0.8 * (seconds + 0.6).cos()]
}

impl Instances {
    /// Draws what the position buffers hold after what `encode_poses` records.
    fn draw(
        &mut self,
        gpu: &Gpu,
        encode_poses: impl FnOnce(&mut wgpu::CommandEncoder),
    ) -> Result<Image, Box<dyn Error>> {
        for (renderer, model) in &mut self.renderers {
            renderer.prepare(gpu.device(), gpu.queue(), &self.view.with_model(*model)?)?;
        }
        let encode = |encoder: &mut wgpu::CommandEncoder| {
            encode_poses(encoder);
            self.renderers.iter().for_each(|(renderer, _)| renderer.encode(encoder));
        };
        gpu.draw_after(&self.target, Load::Clear([1.0; 4]), encode, |pass| {
            self.renderers.iter().for_each(|(renderer, _)| renderer.draw(pass));
        })?;
        Ok(self.target.read_color(gpu)?)
    }
}
