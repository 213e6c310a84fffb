//! Each stage against its CPU twin.

use super::scene::{Scene, pipelines};
use crate::gpu::Room;
use crate::{SmoothingOptions, SmoothingView, ViewMesh, Remesher as _, tests::shape};
use silhouette_testing::{gpu_or_skip, views};

#[test]
fn debug() {
    let Some(gpu) = gpu_or_skip("debug") else { return };
    let mut method = shape("icosphere:1", SmoothingOptions::default());
    let mut scene = Scene::new(gpu, &pipelines(gpu), &method, Room::for_mesh(&method));
    let camera = views::three_quarter(method.shading_mesh().mesh(), views::PERSPECTIVE, [256; 2]);
    let frame = scene.frame(&camera);
    let mut out = ViewMesh::default();
    method.remesh(&SmoothingView::from_camera(&camera), &mut out);
    let s = &scene.renderer.buffers().settings;
    println!("{s:?} {:?}", Room::for_mesh(&method));
    let t = crate::gpu::tables::Tables::new(&method);
    println!("tables {:?}", &t.words[600..620]);
    println!("owners {:?}", &t.words[480..500]);
    println!("vis {:?}", &frame.state[..42]);
    println!("params {:?}", frame.state[s.parameters_at as usize..s.sampling_at as usize].iter().map(|u| f32::from_bits(*u)).collect::<Vec<_>>());
    println!("seg {:?}", &frame.state[s.segments_at as usize..s.segment_data_at as usize]);
    println!("sums {:?}", frame.sums);
    println!("{} {}", frame.triangles.len(), out.triangles.len());
    println!("{:?}", &frame.triangles);
}
