//! Meshes, cameras and lines that several tests draw.

use glam::{DVec2, DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::silhouette::SilhouetteEdges;
use silhouette_core::view::{Camera, DepthDirection, Framing, Projection};
use silhouette_core::{FaceFacings, Topology};
use silhouette_gpu::{MeshBuffers, TargetFormats};
use silhouette_render::{FillPass, FillStyle, Gpu, Image, LinePass, LineStyle, Load, PassView, Polylines, Target};

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

pub fn upload(gpu: &Gpu, mesh: &TriangleMesh) -> MeshBuffers {
    MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap()
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

/// White paper with the mesh on it and lines over it, at one sample a pixel.
pub fn draw_direct(
    gpu: &Gpu,
    mesh: &MeshBuffers,
    camera: &Camera,
    lines: &Polylines,
    style: &LineStyle,
    formats: TargetFormats,
) -> Image {
    let view = PassView::new(camera, mesh.bounds(), formats.depth_direction);
    let target = Target::new(gpu, camera.size(), formats).unwrap();
    let fill = FillPass::new(gpu, formats, FillStyle::PAPER).unwrap();
    fill.prepare(gpu, mesh, &view);
    gpu.draw(&target, Load::Clear(WHITE), |pass| fill.draw(pass, mesh)).unwrap();
    let mut strokes = LinePass::new(gpu, formats.color, formats.samples).unwrap();
    strokes.prepare(gpu, &view, lines, style, &target).unwrap();
    gpu.draw_over(&target, |pass| strokes.draw(pass)).unwrap();
    target.read_color(gpu).unwrap()
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
