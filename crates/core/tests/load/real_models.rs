use silhouette_core::load::{Format, load};
use std::io::Write as _;

/// Every mesh in the folder that SILHOUETTES_MODELS names loads, and welding leaves its shape alone.
#[test]
fn real_models_load() {
    let Some(folder) = std::env::var_os("SILHOUETTES_MODELS") else {
        // Straight to stderr, so that the skip shows even though the test passes.
        writeln!(std::io::stderr(), "skipped real_models_load: SILHOUETTES_MODELS names no folder").unwrap();
        return;
    };
    let mut loaded = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let Some(format) = Format::of(&path) else { continue };
        let mesh = load(&path).unwrap_or_else(|error| panic!("{error}"));
        let bounds = mesh.bounds().unwrap_or_else(|| panic!("{format} without a face"));
        assert!(bounds.radius > 0.0, "{} is a point", path.display());
        let welded = silhouette_core::weld::weld_exact(&mesh);
        assert_eq!(welded.mesh.face_count(), mesh.face_count());
        assert_eq!(welded.mesh.bounds(), Some(bounds));
        loaded += 1;
    }
    writeln!(std::io::stderr(), "loaded {loaded} real models").unwrap();
    assert!(loaded > 0, "no mesh in {}", folder.display());
}
