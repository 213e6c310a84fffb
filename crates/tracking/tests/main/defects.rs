use crate::scenes::{Scene, ordered, real_meshes};
use silhouette_core::method::{OptionError, PrepareError};
use silhouette_core::{EdgeId, FaceId, Method, NoOptions};
use silhouette_testing::prepare::prepared;
use silhouette_testing::zoo;
use silhouette_tracking::{DefectKind, ExactTracking, MeshPolicy, TrackerOptions, Tracking, TrackingOptions};

#[test]
fn defects_are_refused_by_name() {
    let scene = Scene::new("finned blob", zoo::finned_blob());
    let refusal = scene.try_tracker(TrackerOptions::default()).unwrap_err();
    let of_kind = |kind| refusal.defects.iter().filter(move |defect| defect.kind == kind);
    let fin: Vec<_> = of_kind(DefectKind::NonManifold).collect();
    assert_eq!(fin.len(), 1);
    assert!(fin[0].faces.contains(&FaceId::new(300)) && fin[0].faces.contains(&FaceId::new(600)));
    let turned: Vec<_> = of_kind(DefectKind::InconsistentWinding).collect();
    assert_eq!(turned.len(), 3);
    assert!(turned.iter().all(|defect| defect.faces.contains(&FaceId::new(100)) && defect.faces.len() == 2));
    let first = &refusal.defects[0];
    let message = refusal.to_string();
    assert!(message.contains(&format!("edge {}", first.edge)) && message.starts_with("4 edges"), "{message}");
}

#[test]
fn the_method_reports_the_refusal() {
    let mesh = prepared(zoo::finned_blob());
    let refusal = Tracking::new(&mesh, TrackingOptions::default()).unwrap_err();
    assert!(matches!(refusal, PrepareError::Mesh(_)), "{refusal}");
    assert!(refusal.to_string().ends_with("or set the option mesh=cut, which cuts it at these edges"), "{refusal}");
    // The exact mode has no options.
    let refusal = ExactTracking::new(&mesh, NoOptions).unwrap_err();
    assert!(!refusal.to_string().contains("cut") && refusal.to_string().contains("brute-force-simd"), "{refusal}");
    let cut = TrackingOptions { mesh_policy: MeshPolicy::Cut, ..TrackingOptions::default() };
    let out_of_range = Tracking::new(&mesh, TrackingOptions { audit_share: 0.0, ..cut }).unwrap_err();
    assert!(matches!(out_of_range, PrepareError::Option(OptionError::Value { name: "audit-share", .. })));
    assert!(Tracking::new(&mesh, cut).is_ok());
    let report = mesh.report();
    let asked = report.iter().filter(|artefact| artefact.asked_by.contains(Tracking::INFO.name));
    let mut needs: Vec<_> = asked.map(|artefact| artefact.name).collect();
    needs.sort_unstable();
    assert_eq!(needs, Tracking::INFO.needs);
}

/// On a mesh that was cut, tracking equals brute force on the same cut mesh, and every loop closes.
fn tracks_when_cut(scene: &Scene) {
    let mut tracker = scene.tracker(TrackerOptions { mesh_policy: MeshPolicy::Cut, ..TrackerOptions::default() });
    let mut brute_force = scene.brute_force();
    let topology = scene.table.topology();
    for view in scene.orbit(2.0, 90) {
        let expected = ordered(topology, brute_force.update(&view));
        let found = ordered(topology, tracker.update(&view));
        assert_eq!(found, expected, "{} from {view:?}", scene.name);
        let start = |half_edge| silhouette_core::loops::start_vertex(&scene.mesh, half_edge);
        for half_edges in found.iter() {
            let ends = half_edges.iter().map(|half_edge| start(half_edge.next_in_face()));
            assert!(ends.eq(half_edges[1..].iter().chain(&half_edges[..1]).map(|&next| start(next))), "{}", scene.name);
        }
    }
}

#[test]
fn cut_meshes_are_tracked_as_any_other() {
    for (name, mesh) in zoo::defective() {
        tracks_when_cut(&Scene::new(name, mesh));
    }
    for scene in real_meshes("cut_meshes_are_tracked_as_any_other") {
        if !scene.table.defects().is_empty() {
            tracks_when_cut(&scene);
        }
    }
}

#[test]
fn a_severed_edge_is_a_boundary_edge_for_each_of_its_faces() {
    let scene = Scene::new("finned blob", zoo::finned_blob());
    let topology = scene.table.topology();
    let edges: Vec<EdgeId> = scene.table.defects().iter().map(|defect| defect.edge).collect();
    let cut: usize = edges.iter().map(|&edge| topology.half_edges(edge).len()).sum();
    assert_eq!(cut, 3 + 3 * 2);
    assert_eq!(scene.edges.boundary().len(), cut + 2, "and the fin has two sides of its own");
}
