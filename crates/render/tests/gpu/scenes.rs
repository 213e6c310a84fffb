//! Meshes, cameras and lines that several tests draw.

use glam::{DVec2, DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::silhouette::SilhouetteEdges;
use silhouette_core::view::{Camera, DepthDirection, Framing, Projection};
use silhouette_core::{FaceFacings, Topology};
use silhouette_gpu::{
    Color, FillPipelines, FillRenderer, FillStyle, FrameRenderer, FrameView, Interior, MeshBuffers, Polylines,
    StrokePipelines, StrokeRenderer, StrokeStyle, TargetFormats,
};
use silhouette_render::{Gpu, Image, Load, Target, view_of_mesh};
use std::sync::Arc;

pub const WHITE: [f64; 4] = [1.0; 4];

/// A camera under which a world unit is a pixel: (0, 0) at the top left corner, y up, so pixel rows are at -y.
pub fn pixel_camera(size: [u32; 2]) -> Camera {
    let middle = Vec3::new(size[0] as f32 * 0.5, size[1] as f32 * -0.5, 0.0);
    let projection = Projection::Orthographic { height: f64::from(size[1]) };
    Camera::new(middle + Vec3::Z * 10.0, middle, Vec3::Y, projection, size).unwrap()
}

/// The point that [`pixel_camera`] shows at a pixel position.
pub fn at_pixel(p: DVec2) -> DVec3 {
    DVec3::new(p.x, -p.y, 0.0)
}

pub fn framed(mesh: &TriangleMesh, framing: Framing, size: [u32; 2]) -> Camera {
    Camera::framing(&mesh.bounds().unwrap(), DVec3::new(0.55, 0.35, 1.0), Vec3::Y, framing, size).unwrap()
}

pub const PERSPECTIVE: Framing = Framing::Perspective { fov_y_rad: 0.7 };

pub fn empty_mesh() -> TriangleMesh {
    TriangleMesh::new(vec![], vec![]).unwrap()
}

pub fn upload(gpu: &Gpu, mesh: &TriangleMesh) -> Arc<MeshBuffers> {
    Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap())
}

/// Every silhouette edge as a line of its own.
pub fn silhouette(mesh: &TriangleMesh, camera: &Camera) -> Polylines {
    let topology = Topology::new(mesh);
    let facings = FaceFacings::new(mesh, &camera.viewpoint());
    let mut lines = Polylines::new();
    for edge in SilhouetteEdges::of(&topology, &facings).iter() {
        lines.push(topology.end_points(edge).map(|vertex| mesh.positions()[vertex.index()].as_dvec3()), false);
    }
    lines
}

/// A view of a mesh for a target of these formats.
pub fn view_for(camera: &Camera, mesh: &MeshBuffers, formats: TargetFormats) -> FrameView {
    let range = view_of_mesh(camera, mesh).unwrap().depth_law().range();
    FrameView::from_camera(camera, range, formats.depth_direction).unwrap()
}

/// What a renderer draws on white paper.
pub fn draw_on_paper(gpu: &Gpu, renderer: &mut dyn FrameRenderer, view: &FrameView, formats: TargetFormats) -> Target {
    let target = Target::new(gpu, view.viewport().size_px, formats).unwrap();
    renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
    let renderer = &*renderer;
    gpu.draw_after(&target, Load::Clear(WHITE), |encoder| renderer.encode(encoder), |pass| renderer.draw(pass))
        .unwrap();
    target
}

/// A renderer of some lines.
pub fn strokes(
    gpu: &Gpu,
    mesh: &Arc<MeshBuffers>,
    lines: &Polylines,
    style: &StrokeStyle,
    formats: TargetFormats,
) -> StrokeRenderer {
    let pipelines = Arc::new(gpu.scoped(|| StrokePipelines::new(gpu.device(), formats, *style)).unwrap());
    let mut strokes = StrokeRenderer::new(gpu.device(), &pipelines, mesh);
    strokes.lines_mut().clone_from(lines);
    strokes
}

/// White paper with the mesh on it and lines over it.
pub fn draw_direct(
    gpu: &Gpu,
    mesh: &Arc<MeshBuffers>,
    camera: &Camera,
    lines: &Polylines,
    style: &StrokeStyle,
    formats: TargetFormats,
) -> Image {
    let style = StrokeStyle { interior: Interior::Paper(Color::WHITE), ..*style };
    let view = view_for(camera, mesh, formats);
    draw_on_paper(gpu, &mut strokes(gpu, mesh, lines, &style, formats), &view, formats).read_color(gpu).unwrap()
}

/// The mesh alone, on white paper.
pub fn fill(gpu: &Gpu, mesh: &Arc<MeshBuffers>, view: &FrameView, style: FillStyle, formats: TargetFormats) -> Target {
    let pipelines = Arc::new(gpu.scoped(|| FillPipelines::new(gpu.device(), formats, style)).unwrap());
    draw_on_paper(gpu, &mut FillRenderer::new(gpu.device(), &pipelines, mesh), view, formats)
}

/// Share of black of each pixel.
pub fn darkness(image: &Image) -> impl Iterator<Item = f64> {
    image.rgba.chunks_exact(4).map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0)
}

/// Area of black in pixels.
pub fn ink(image: &Image) -> f64 {
    darkness(image).sum()
}

/// Number of pixels in which two images differ.
pub fn difference(a: &Image, b: &Image) -> usize {
    assert_eq!((a.width, a.height), (b.width, b.height));
    a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)).filter(|(a, b)| a != b).count()
}

pub const DIRECTIONS: [DepthDirection; 2] = [DepthDirection::Standard, DepthDirection::Reversed];

pub const DEPTH_FORMATS: [wgpu::TextureFormat; 3] =
    [wgpu::TextureFormat::Depth16Unorm, wgpu::TextureFormat::Depth24Plus, wgpu::TextureFormat::Depth32Float];
