//! The edges that are drawn and extracted are those of brute force, from views in face planes too.

use crate::scene::{self, PATHS, any_view, drawn, hard_views, method, words_of};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::Viewpoint;
use silhouette_core::{EdgeId, ExtractsEdges, FaceFacings, FaceId, SilhouetteEdges, Topology, TriangleMesh, VertexId};
use silhouette_edge_mesh::as_printed::is_silhouette_as_printed;
use silhouette_edge_mesh::drawn_edges::drawn_edges;
use silhouette_edge_mesh::{EdgeMesh, EdgeRecord, face_planes};
use silhouette_extraction::BruteForce;
use silhouette_gpu::DrawsLines;
use silhouette_render::{DEFAULT_FORMATS, Gpu};
use silhouette_testing::prepare::prepared;
use silhouette_testing::{builtin, gpu_or_skip, views, with_threads, zoo};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The edges of records.
fn edges_of<'a>(topology: &Topology, records: impl Iterator<Item = &'a EdgeRecord>) -> BTreeSet<EdgeId> {
    let edge = |record: &EdgeRecord| {
        let [a, b]: [VertexId; 2] = record.ends();
        topology.find_edge(a, b).unwrap()
    };
    records.map(edge).collect()
}

/// What is to be drawn: silhouette edges by brute force.
fn expected(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> BTreeSet<EdgeId> {
    let mut oracle: BruteForce = silhouette_testing::prepare::method(&prepared(mesh.clone()));
    let mut found = SilhouetteEdges::default();
    oracle.extract_edges(viewpoint, &mut found);
    found.iter().collect()
}

#[test]
fn the_drawn_edges_are_those_of_brute_force_from_every_view() {
    let Some(gpu) = gpu_or_skip("the_drawn_edges_are_those_of_brute_force_from_every_view") else { return };
    let pipelines = Arc::new(method(&builtin("cube"), &[]).pipelines(gpu.device(), DEFAULT_FORMATS).unwrap());
    let (mut drawn_in_all, mut doubtful) = (0, 0);
    for (name, mesh) in zoo::all().into_iter().filter(|(name, _)| *name != "torus with faces without area") {
        let method = method(&mesh, &[]);
        let (topology, buffers) = (Topology::new(&mesh), scene::buffers(gpu, &mesh));
        let mut renderer = method.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers).unwrap();
        for view in hard_views(&mesh) {
            let lists = drawn(gpu, &mut renderer, &view);
            let records = lists.silhouettes.iter().map(|&record| &method.records()[record as usize]);
            let viewpoint = view.viewpoint();
            assert_eq!(edges_of(&topology, records), expected(&mesh, &viewpoint), "{name} from {viewpoint:?}");
            let facings = FaceFacings::new(&mesh, &viewpoint);
            assert_eq!(
                lists,
                drawn_edges(method.records(), |face| facings.is_front(face), method.of_back_faces(false)),
                "{name}"
            );
            drawn_in_all += lists.silhouettes.len();
            doubtful += facings.doubtful_faces().count();
        }
    }
    assert!(drawn_in_all > 20_000 && doubtful > 500, "{drawn_in_all} edges drawn, {doubtful} faces in doubt");
}

#[test]
fn extraction_is_brute_force() {
    for (name, mesh) in zoo::all() {
        let prepared = prepared(mesh.clone());
        let mut ours: EdgeMesh = silhouette_testing::prepare::method(&prepared);
        let mut oracle: BruteForce = silhouette_testing::prepare::method(&prepared);
        let [mut found, mut expected] = [0, 1].map(|_| SilhouetteEdges::default());
        for viewpoint in views::hard_viewpoints(&mesh, 5) {
            ours.extract_edges(&viewpoint, &mut found);
            oracle.extract_edges(&viewpoint, &mut expected);
            assert_eq!(found, expected, "{name} from {viewpoint:?}");
        }
    }
}

/// The device decides in 32 bits, from positions in its own frame. It differs from the exact sign for the same positions only where
/// the bound of a 32-bit evaluation leaves the sign open, and so does its twin.
#[test]
fn facings_of_the_device_differ_from_exact_ones_only_within_the_bound_of_32_bits() {
    let name = "facings_of_the_device_differ_from_exact_ones_only_within_the_bound_of_32_bits";
    let Some(gpu) = gpu_or_skip(name) else { return };
    let words = ["facing=device"];
    let pipelines = Arc::new(method(&builtin("cube"), &words).pipelines(gpu.device(), DEFAULT_FORMATS).unwrap());
    let (mut faces, mut differing) = (0, 0);
    for (name, mesh) in zoo::all() {
        let method = method(&mesh, &words);
        let buffers = scene::buffers(gpu, &mesh);
        let mut renderer = method.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers).unwrap();
        let local = mesh.positions().iter().map(|position| buffers.frame().to_local(position.as_dvec3())).collect();
        let local = TriangleMesh::new(local, mesh.triangles().to_vec()).unwrap();
        for view in hard_views(&mesh) {
            let lists = drawn(gpu, &mut renderer, &view);
            let bits = words_of(gpu, renderer.facings().unwrap());
            let on_device = |face: FaceId| bits[face.index() / 32] >> (face.index() % 32) & 1 == 1;
            let viewer = buffers.frame().viewer(&view);
            let exact = if viewer.w > 0.0 {
                FaceFacings::new(&local, &Viewpoint::Perspective { eye: viewer.truncate() })
            } else {
                FaceFacings::new(&local, &Viewpoint::Orthographic { toward_viewer: viewer.truncate() })
            };
            let doubtful: BTreeSet<FaceId> = exact.doubtful_faces().collect();
            for face in (0..mesh.face_count()).map(FaceId::from_usize) {
                let twin = face_planes::is_front(local.corners(face), viewer);
                for facing in [on_device(face), twin] {
                    assert!(facing == exact.is_front(face) || doubtful.contains(&face), "{name}: face {face}");
                }
                faces += 1;
                differing += usize::from(on_device(face) != exact.is_front(face));
            }
            // Whatever the facings are, they are decided once, and the lists follow from them.
            assert_eq!(lists, drawn_edges(method.records(), on_device, method.of_back_faces(false)), "{name}");
        }
    }
    assert!(faces > 100_000 && differing > 0, "{differing} of {faces}: the hard views put signs in doubt");
}

/// An eye in the plane of the upper face of a cube, which sees the face at x = 1 alone.
const EYE_IN_PLANE: Vec3 = Vec3::new(4.0, 1.0, 0.5);

#[test]
fn the_printed_product_loses_an_edge_of_a_cube_seen_from_the_plane_of_a_face() {
    let mesh = builtin("cube");
    let method = method(&mesh, &[]);
    let normal = |face| {
        let [a, b, c]: [Vec3; 3] = mesh.corners(face);
        (b - a).cross(c - a).normalize()
    };
    let printed = method.records().iter().filter(|record| {
        let [a, b] = record.ends().map(|end| mesh.positions()[end.index()]);
        let normals = [record.first_face(), record.second_face().unwrap()].map(normal);
        let [at_a, at_b] = [a, b].map(|end| is_silhouette_as_printed(end, normals, EYE_IN_PLANE));
        assert_eq!(at_a, at_b);
        at_a
    });
    assert_eq!(printed.count(), 3);
    let facings = FaceFacings::new(&mesh, &views::seen_from(EYE_IN_PLANE));
    let ours = drawn_edges(method.records(), |face| facings.is_front(face), method.of_back_faces(false)).silhouettes;
    assert_eq!(ours.len(), 4);
    // Closed: each end belongs to two of them.
    let mut ends: Vec<VertexId> = ours.iter().flat_map(|&record| method.records()[record as usize].ends()).collect();
    ends.sort_unstable();
    assert!(ends.chunks(2).all(|pair| pair[0] == pair[1]) && ends.len() == 8);
}

/// Share of the picture of the upper edge of the face at x = 1 along which there is ink.
fn inked_along_upper_edge(gpu: &Gpu, words: &[&str]) -> f64 {
    let mesh = builtin("cube");
    let camera = views::look(EYE_IN_PLANE, Vec3::new(1.0, 0.3, 0.0), 60.0, [512; 2]);
    let image = scene::picture(gpu, &mesh, &camera, words);
    let inked = (0..200).filter(|&step| {
        let pixel = camera.project(DVec3::new(1.0, 1.0, -0.95 + 1.9 * f64::from(step) / 199.0)).unwrap().pixel;
        let near = |dx: i32, dy: i32| image.pixel((pixel.x as i32 + dx) as u32, (pixel.y as i32 + dy) as u32)[0] == 0;
        (-2..=2).any(|dx| (-2..=2).any(|dy| near(dx, dy)))
    });
    inked.count() as f64 / 200.0
}

#[test]
fn the_picture_of_a_cube_from_the_plane_of_a_face_is_closed_and_as_printed_it_is_not() {
    let name = "the_picture_of_a_cube_from_the_plane_of_a_face_is_closed_and_as_printed_it_is_not";
    let Some(gpu) = gpu_or_skip(name) else { return };
    for path in PATHS {
        let inked = inked_along_upper_edge(gpu, &[path]);
        assert!(inked > 0.999, "{path}: {inked}");
    }
    assert!(inked_along_upper_edge(gpu, &["arithmetic=as-printed"]) < 0.001);
}

#[test]
fn faces_without_area_draw_nothing_of_their_own() {
    let Some(gpu) = gpu_or_skip("faces_without_area_draw_nothing_of_their_own") else { return };
    let all = zoo::defective();
    let (_, flat) = all.iter().find(|(name, _)| *name == "torus with faces without area").unwrap();
    let clean = builtin("torus:16,12");
    for path in PATHS {
        for view in hard_views(&clean).into_iter().chain([any_view(&clean, &scene::framed(&clean, 128))]) {
            let [found, expected] = [flat, &clean].map(|mesh| scene::picture_of(gpu, mesh, &[path], &view));
            assert!(found == expected, "{path}: {} pixels differ", scene::differing(&found, &expected));
        }
    }
    // The control: a face without area is back by definition, so that brute force finds loops around those that are in front.
    let [mut flat, mut clean] =
        [flat, &clean].map(|mesh| -> (EdgeMesh, SilhouetteEdges) { (method(mesh, &[]), SilhouetteEdges::default()) });
    let viewpoint = views::seen_from(Vec3::new(2.0, 3.0, 4.0));
    for (method, edges) in [&mut flat, &mut clean] {
        method.extract_edges(&viewpoint, edges);
    }
    assert!(flat.1.len() > 2 * clean.1.len());
}

/// A sliver that closes a T-junction takes the facing of the face across its longest edge, through other slivers too.
#[test]
fn slivers_at_t_junctions_are_not_drawn() {
    let at = |x: f32, y: f32| Vec3::new(x, y, 0.0);
    // A square above the x axis and one below it whose edges on the axis end at different vertices.
    let positions =
        vec![at(0.0, 0.0), at(4.0, 0.0), at(2.0, 3.0), at(2.0, 0.0), at(1.0, 0.0), at(1.0, -2.0), at(3.0, -2.0)];
    let triangles = vec![[0, 1, 2], [0, 3, 1], [0, 4, 3], [4, 0, 5], [3, 4, 5], [3, 5, 6], [1, 3, 6]];
    let mesh = TriangleMesh::new(positions, triangles).unwrap();
    let method = method(&mesh, &[]);
    let facings = FaceFacings::new(&mesh, &views::seen_from(Vec3::new(1.0, 1.0, 5.0)));
    let drawn = drawn_edges(method.records(), |face| facings.is_front(face), method.of_back_faces(false)).silhouettes;
    let boundary = method.records().iter().filter(|record| record.second_face().is_none()).count();
    assert_eq!((drawn.len(), boundary), (5, 5), "the boundary and nothing else");
}

#[test]
fn records_are_the_same_for_any_number_of_threads() {
    let mesh = builtin("blob:40000,0.5");
    let words = ["ridge-angle=20", "valley-angle=10"];
    let records = [1, 2, 5].map(|threads| with_threads(threads, || Arc::clone(method(&mesh, &words).records())));
    assert!(records.windows(2).all(|pair| pair[0] == pair[1]) && records[0].len() == 60_000);
}
