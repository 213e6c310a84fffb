//! The pictures of both paths.

use crate::{SmoothingOptions, tests::shape};
use crate::options::Path;
use silhouette_core::view::Framing;
use silhouette_gpu::{FillsImage, FrameRenderer as _, MeshBuffers};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target, view_of_mesh};
use silhouette_testing::{gpu_or_skip, views};
use std::sync::Arc;

fn picture(gpu: &Gpu, name: &str, path: Path, framing: Framing) -> Image {
    let method = shape(name, SmoothingOptions { path, ..Default::default() });
    let mesh = method.shading_mesh().mesh();
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap());
    let pipelines = Arc::new(method.pipelines(gpu.device(), DEFAULT_FORMATS).unwrap());
    let mut renderer = method.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers).unwrap();
    let camera = views::three_quarter(mesh, framing, [256; 2]);
    let view = view_of_mesh(&camera, &buffers).unwrap();
    renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
    let target = Target::new(gpu, [256; 2], DEFAULT_FORMATS).unwrap();
    gpu.draw_after(&target, Load::Clear([0.0; 4]), |encoder| renderer.encode(encoder), |pass| renderer.draw(pass)).unwrap();
    target.read_color(gpu).unwrap()
}

#[test]
fn first() {
    let Some(gpu) = gpu_or_skip("first") else { return };
    for name in ["icosphere:1", "torus:16,10", "cylinder", "cube", "gear"] {
        for framing in [views::PERSPECTIVE, Framing::Orthographic] {
            let [a, b] = [Path::Cpu, Path::Gpu].map(|path| picture(gpu, name, path, framing));
            let covered = |image: &Image| image.rgba.chunks_exact(4).map(|p| p[3] > 0).collect::<Vec<_>>();
            let (ca, cb) = (covered(&a), covered(&b));
            let diff = ca.iter().zip(&cb).filter(|(a, b)| a != b).count();
            let off = a.rgba.iter().zip(&b.rgba).filter(|(a, b)| a.abs_diff(**b) > 8).count();
            println!("{name}: {} {} differ {diff} shade {off}", ca.iter().filter(|c| **c).count(), cb.iter().filter(|c| **c).count());
        }
    }
}
