//! The outlines that engines ship, in passes of an application's own: its device, its encoder, its targets with four samples per
//! pixel, its matrices with reversed depth and an infinite far plane.
//!
//! `cargo run --release -p silhouette-baselines --example outlines -- [FOLDER]` writes one picture per method, of a cube, a mirrored
//! knot and a stretched torus. `inverted-hull` and `gbuffer-filter` draw each object by a renderer of its own; `jump-flood` draws all
//! of them in one field, so that they keep apart where they overlap.

use silhouette_baselines::jump_flood::JumpFloodGroup;
use silhouette_baselines::{
    GbufferFilter, GbufferFilterOptions, InvertedHull, InvertedHullOptions, JumpFlood, JumpFloodOptions,
};
use silhouette_core::glam::dcamera::rh::{proj, view};
use silhouette_core::glam::{DMat4, DQuat, DVec3};
use silhouette_core::method::Method;
use silhouette_core::view::DepthDirection;
use silhouette_core::{PreparedMesh, shapes};
use silhouette_gpu::{DrawsLines, FrameRenderer, FrameView, MeshBuffers, TargetFormats, Viewport};
use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;

const SIZE: [u32; 2] = [640, 400];

const FORMATS: TargetFormats = TargetFormats {
    color: wgpu::TextureFormat::Rgba8UnormSrgb,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_direction: DepthDirection::Reversed,
    samples: 4,
};

type Failure = Box<dyn Error>;

fn main() -> Result<(), Failure> {
    let folder = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("out/outlines"), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    let app = Application::new()?;
    for (name, pixels) in pictures(&app)? {
        let image = image::RgbaImage::from_raw(SIZE[0], SIZE[1], pixels).ok_or("as many bytes as pixels have")?;
        image.save(folder.join(format!("{name}.png")))?;
    }
    Ok(())
}

/// A picture by each method, as sRGB bytes.
fn pictures(app: &Application) -> Result<[(&'static str, Vec<u8>); 3], Failure> {
    let hull = InvertedHullOptions { width: 4.0, ..InvertedHullOptions::default() };
    let filter = GbufferFilterOptions { width: 3.0, ..GbufferFilterOptions::default() };
    let flood = JumpFloodOptions { width: 10.0, ink_red: 0.9, ink_green: 0.4, ..JumpFloodOptions::default() };
    Ok([
        ("inverted-hull", app.draw_each::<InvertedHull>(&hull)?),
        ("gbuffer-filter", app.draw_each::<GbufferFilter>(&filter)?),
        ("jump-flood", app.draw_group(flood)?),
    ])
}

/// What the application has whoever draws outlines: a device, objects with their places, a camera.
struct Application {
    device: wgpu::Device,
    queue: wgpu::Queue,
    objects: Vec<(Arc<PreparedMesh>, Arc<MeshBuffers>)>,
    models: Vec<DMat4>,
    view: FrameView,
}

impl Application {
    fn new() -> Result<Self, Failure> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
        let instance = wgpu::Instance::new(descriptor);
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
        let (device, queue) = pollster::block_on(
            adapter.request_device(&wgpu::DeviceDescriptor { required_limits: adapter.limits(), ..Default::default() }),
        )?;
        let object = |name| -> Result<_, Failure> {
            let mesh = shapes::by_name(name)?;
            let buffers = Arc::new(MeshBuffers::new(&device, &queue, &mesh)?);
            Ok((Arc::new(PreparedMesh::new(mesh)), buffers))
        };
        let objects = ["cube", "knot", "torus"].into_iter().map(object).collect::<Result<_, _>>()?;
        let place = |x, y, z| DMat4::from_translation(DVec3::new(x, y, z));
        let stretch = DVec3::new(1.0, 0.6, 1.4);
        let models = vec![
            place(-0.7, -0.2, 0.4) * DMat4::from_rotation_y(0.5),
            place(1.6, 0.1, -2.4) * DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0)),
            DMat4::from_scale_rotation_translation(stretch, DQuat::from_rotation_x(0.9), DVec3::new(-2.2, 0.4, -2.6)),
        ];
        let eye = view::look_at_mat4(DVec3::new(0.3, 1.8, 6.5), DVec3::new(-0.4, 0.0, 0.0), DVec3::Y);
        let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
        let projection = proj::directx::perspective_infinite_reverse(0.7, aspect, 0.1);
        let view = FrameView::from_matrices(eye, projection, FORMATS.depth_direction, Viewport::whole(SIZE))?;
        Ok(Self { device, queue, objects, models, view })
    }

    /// Draws each object by a renderer of its own.
    fn draw_each<M: DrawsLines>(&self, options: &M::Options) -> Result<Vec<u8>, Failure> {
        let mut pipelines = None;
        let mut renderers = Vec::new();
        for ((mesh, buffers), model) in self.objects.iter().zip(&self.models) {
            let method = M::new(mesh, options.clone())?;
            let shared = match &pipelines {
                Some(shared) => Arc::clone(shared),
                None => Arc::new(method.pipelines(&self.device, FORMATS)?),
            };
            let mut renderer = method.renderer(&self.device, &self.queue, &shared, buffers)?;
            renderer.prepare(&self.device, &self.queue, &self.view.with_model(*model)?)?;
            renderers.push(renderer);
            pipelines = Some(shared);
        }
        self.frame(
            |encoder| renderers.iter().for_each(|renderer| renderer.encode(encoder)),
            |pass| renderers.iter().for_each(|renderer| renderer.draw(pass)),
        )
    }

    /// Draws all objects in one field.
    fn draw_group(&self, options: JumpFloodOptions) -> Result<Vec<u8>, Failure> {
        let (mesh, _) = self.objects.first().ok_or("a scene has objects")?;
        let method = JumpFlood::new(mesh, options)?;
        let pipelines = Arc::new(method.pipelines(&self.device, FORMATS)?);
        let meshes: Vec<_> = self.objects.iter().map(|(_, buffers)| Arc::clone(buffers)).collect();
        let mut group: JumpFloodGroup = method.group(&self.device, &self.queue, &pipelines, &meshes)?;
        group.prepare(&self.device, &self.queue, &self.view, &self.models)?;
        self.frame(|encoder| group.encode(encoder), |pass| group.draw(pass))
    }

    /// A frame in one submission, over white, read back.
    fn frame(
        &self,
        encode: impl FnOnce(&mut wgpu::CommandEncoder),
        draw: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Result<Vec<u8>, Failure> {
        let texture = |format, samples, usage| {
            self.device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            })
        };
        let view_of = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let samples = view_of(&texture(FORMATS.color, FORMATS.samples, wgpu::TextureUsages::empty()));
        let depth = view_of(&texture(FORMATS.depth, FORMATS.samples, wgpu::TextureUsages::empty()));
        let color = texture(FORMATS.color, 1, wgpu::TextureUsages::COPY_SRC);
        let resolved = view_of(&color);

        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encode(&mut encoder);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &samples,
                depth_slice: None,
                resolve_target: Some(&resolved),
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::WHITE), store: wgpu::StoreOp::Discard },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(FORMATS.clear_depth()),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        draw(&mut pass);
        drop(pass);

        // Rows of 640 pixels are a multiple of the 256 bytes that copies are aligned to.
        let row = 4 * SIZE[0];
        let readable = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(row) * u64::from(SIZE[1]),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        let destination = wgpu::TexelCopyBufferInfo { buffer: &readable, layout };
        encoder.copy_texture_to_buffer(color.as_image_copy(), destination, color.size());
        self.queue.submit([encoder.finish()]);
        readable.map_async(wgpu::MapMode::Read, .., |_| {});
        self.device.poll(wgpu::PollType::wait_indefinitely())?;
        let bytes = readable.get_mapped_range(..)?.to_vec();
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_draws_its_ink_in_the_application_s_pass() {
        let test = "every_method_draws_its_ink_in_the_application_s_pass";
        if silhouette_testing::gpu_or_skip(test).is_none() {
            return;
        }
        let app = Application::new().unwrap();
        for (name, pixels) in pictures(&app).unwrap() {
            let count = |is: fn(&[u8]) -> bool| pixels.chunks_exact(4).filter(|pixel| is(pixel)).count();
            let (ink, white) = (count(|pixel| pixel[2] == 0), count(|pixel| pixel[..3] == [255; 3]));
            assert!(ink > 4000 && white > 200_000, "{name}: {ink} pixels of ink, {white} of paper");
            assert!(count(|pixel| (1..255).contains(&pixel[2])) > 500, "{name}: rims are antialiased");
        }
    }
}
