//! Outlines over an application's own shading, on its own device and in its own render pass.
//!
//! `cargo run --release -p silhouette-edge-mesh --example outlines -- [MESH] [FILE.png]`, a mesh being a file or `builtin:NAME`.
//!
//! Everything that touches a device is here: the adapter, the textures, the pass, the submission. The mesh is shaded first; the
//! outlines come after it in the same pass, and the depth that is there hides them.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::line_style::InteriorChoice;
use silhouette_core::view::{Camera, DepthDirection, Framing};
use silhouette_core::{Method, PreparedMesh, TriangleMesh, shapes};
use silhouette_edge_mesh::{EdgeMesh, EdgeMeshOptions};
use silhouette_gpu::{
    Color, Cull, DrawsLines, FillPipelines, FillRenderer, FillStyle, FrameRenderer, FrameView, MeshBuffers, Shade,
    TargetFormats,
};
use std::error::Error;
use std::path::Path;
use std::sync::Arc;

/// Width and height of the picture. Rows of 512 texels need no padding when they are read back.
const SIZE: [u32; 2] = [512, 512];

const FORMATS: TargetFormats = TargetFormats {
    color: wgpu::TextureFormat::Rgba8UnormSrgb,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_direction: DepthDirection::Reversed,
    samples: 1,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "builtin:gear".to_owned());
    let file = arguments.next().unwrap_or_else(|| "out/outlines.png".to_owned());
    let mesh = match name.strip_prefix("builtin:") {
        Some(shape) => shapes::by_name(shape)?,
        None => silhouette_core::load::load(Path::new(&name))?,
    };
    let texels = draw(mesh, true)?;
    if let Some(folder) = Path::new(&file).parent() {
        std::fs::create_dir_all(folder)?;
    }
    image::RgbaImage::from_raw(SIZE[0], SIZE[1], texels).ok_or("as many texels as pixels")?.save(file)?;
    Ok(())
}

/// The picture of a mesh as RGBA bytes, with outlines or without.
fn draw(mesh: TriangleMesh, outlined: bool) -> Result<Vec<u8>, Box<dyn Error>> {
    // The application's device and targets.
    let (device, queue) = device()?;
    let color = texture(&device, FORMATS.color, wgpu::TextureUsages::COPY_SRC);
    let depth = texture(&device, FORMATS.depth, wgpu::TextureUsages::empty());

    // Once per mesh, and once per set of options.
    let prepared = Arc::new(PreparedMesh::new(mesh));
    let options = EdgeMeshOptions {
        width: 3.0,
        ridge_angle_deg: 40.0,
        valley_angle_deg: 40.0,
        ridge_width: 1.5,
        valley_width: 1.5,
        interior: InteriorChoice::None,
        ..EdgeMeshOptions::default()
    };
    let method = EdgeMesh::new(&prepared, options)?;
    let pipelines = Arc::new(method.pipelines(&device, FORMATS)?);
    let buffers = Arc::new(MeshBuffers::new(&device, &queue, prepared.mesh())?);
    let mut outlines = method.renderer(&device, &queue, &pipelines, &buffers)?;

    // What stands for the application's own shading.
    let shade = Shade::Lit(Color { srgb: [0.8, 0.6, 0.4], alpha: 1.0 });
    let shading = Arc::new(FillPipelines::new(&device, FORMATS, FillStyle { shade, cull: Cull::None }));
    let mut shading = FillRenderer::new(&device, &shading, &buffers);

    // Once per frame.
    let bounds = buffers.bounds().ok_or("a mesh without triangles")?;
    let framing = Framing::Perspective { fov_y_rad: 0.7 };
    let camera = Camera::framing(&bounds, DVec3::new(0.55, 0.5, 1.0), Vec3::Y, framing, SIZE)?;
    let view = FrameView::from_camera(&camera, camera.clip_range(&bounds), FORMATS.depth_direction)?;
    shading.prepare(&device, &queue, &view)?;
    outlines.prepare(&device, &queue, &view)?;
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    outlines.encode(&mut encoder);
    let [color_view, depth_view] = [&color, &depth].map(|texture| texture.create_view(&Default::default()));
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &color_view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::WHITE), store: wgpu::StoreOp::Store },
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &depth_view,
            depth_ops: Some(wgpu::Operations {
                load: wgpu::LoadOp::Clear(FORMATS.clear_depth()),
                store: wgpu::StoreOp::Discard,
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    shading.draw(&mut pass);
    if outlined {
        outlines.draw(&mut pass);
    }
    drop(pass);
    queue.submit([encoder.finish()]);
    read(&device, &queue, &color)
}

fn device() -> Result<(wgpu::Device, wgpu::Queue), Box<dyn Error>> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
    let instance = wgpu::Instance::new(descriptor);
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    Ok(pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?)
}

fn texture(device: &wgpu::Device, format: wgpu::TextureFormat, usage: wgpu::TextureUsages) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    })
}

fn read(device: &wgpu::Device, queue: &wgpu::Queue, texture: &wgpu::Texture) -> Result<Vec<u8>, Box<dyn Error>> {
    let readable = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(4 * SIZE[0] * SIZE[1]),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE[0]), rows_per_image: None };
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let destination = wgpu::TexelCopyBufferInfo { buffer: &readable, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), destination, texture.size());
    queue.submit([encoder.finish()]);
    readable.map_async(wgpu::MapMode::Read, .., |_| {});
    device.poll(wgpu::PollType::wait_indefinitely())?;
    Ok(readable.get_mapped_range(..)?.to_vec())
}

/// The device is one with the limits that WebGPU guarantees, and the shading beside the lines keeps every bit.
#[test]
fn outlines_are_drawn_over_shading_that_stays_as_it_is() {
    if silhouette_testing::gpu_or_skip("outlines_are_drawn_over_shading_that_stays_as_it_is").is_none() {
        return;
    }
    let [with, without] = [true, false].map(|outlined| draw(shapes::by_name("gear").unwrap(), outlined).unwrap());
    let changed: Vec<&[u8]> =
        with.chunks_exact(4).zip(without.chunks_exact(4)).filter(|(a, b)| a != b).map(|(a, _)| a).collect();
    assert!(changed.len() > 3000, "{}", changed.len());
    assert!(changed.iter().all(|pixel| pixel == &[0, 0, 0, 255]));
}
