use silhouette_core::weld::weld_exact;
use silhouette_testing::real_meshes;

/// Every mesh in the folder that SILHOUETTES_MODELS names loads, and welding does not change its shape.
#[test]
fn real_models_load() {
    for (name, mesh) in real_meshes("real_models_load") {
        let bounds = mesh.bounds().unwrap_or_else(|| panic!("{name} has no face"));
        assert!(bounds.radius > 0.0, "{name} is a point");
        let welded = weld_exact(&mesh);
        assert_eq!(welded.mesh.face_count(), mesh.face_count(), "{name}");
        assert_eq!(welded.mesh.bounds(), Some(bounds), "{name}");
    }
}
