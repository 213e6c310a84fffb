//! Stores and their merging, on cells that nobody measured.

use super::key::{Key, MethodKey};
use super::merge::{MergeError, merge};
use super::store::{CellStore, StoreError};
use crate::options::OptionSettings;
use crate::record::tests as sample;
use crate::registry::Registry;
use crate::runner::{CompareConfig, LeftOut, NamedMesh, Outcome, PictureSet, Subject};
use crate::scene::Profile;
use silhouette_core::{PreparedMesh, shapes};
use silhouette_render::Image;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// What each cell took.
const TOOK: Duration = Duration::from_millis(1500);

const METHODS: [&str; 2] = ["brute-force", "tracking"];

/// A key of two methods on two meshes.
fn key(second_mesh: &str) -> Key {
    let mut scene = Profile::Quick.scene();
    scene.select(&METHODS.map(str::to_owned));
    let config = CompareConfig::new(scene, &Registry::builtin()).unwrap();
    let subject = |name: &str, shape: &str| Subject {
        mesh: NamedMesh { name: name.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) },
        truth: None,
    };
    Key::of(&config, &[subject("a", "cube"), subject("b", second_mesh)])
}

fn outcome(index: usize) -> Outcome {
    let (mesh, method) = (["a", "b"][index / 2], METHODS[index % 2]);
    if index == 3 {
        return Outcome::LeftOut(LeftOut { mesh: mesh.into(), method: method.into(), reason: "open".into() });
    }
    // A number of which the shortest text is long.
    let cell = sample::cell(mesh, method, 1.0 / 3.0, 0.1 + 0.2 + index as f64 * 1e-17);
    let image = |value: u8| Image { width: 2, height: 1, rgba: vec![value; 8] };
    let pictures = PictureSet {
        mesh: mesh.to_owned(),
        method: method.to_owned(),
        options: OptionSettings::default(),
        picture: cell.picture,
        frame: 5,
        drawn: image(1),
        truth: image(2),
        difference: image(index as u8),
    };
    Outcome::Measured { cell: Box::new(cell), pictures: Box::new(pictures) }
}

fn store(folder: &Path, cells: &[usize]) -> CellStore {
    let store = CellStore::open(folder, key("cube")).unwrap();
    for &cell in cells {
        store.put(cell, &sample::run(), TOOK, &outcome(cell)).unwrap();
    }
    store
}

#[test]
fn shards_merge_to_what_one_process_yields() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let registry = Registry::builtin();
    let whole = merge(&[store(&at("whole"), &[0, 1, 2, 3])], &registry).unwrap();
    let shards = [store(&at("first"), &[0, 2]), store(&at("second"), &[1, 3])];
    let merged = merge(&shards, &registry).unwrap();
    assert_eq!(merged.cells, whole.cells);
    assert_eq!((&merged.runs, &merged.left_out, &merged.scene), (&whole.runs, &whole.left_out, &whole.scene));
    assert_eq!(merged.cells.len(), 3);
    for (index, (cell, pictures)) in merged.cells.iter().zip(&merged.pictures).enumerate() {
        let Outcome::Measured { cell: expected, pictures: drawn } = outcome(index) else { panic!() };
        assert_eq!(*cell, *expected, "to the last bit");
        assert_eq!(pictures.difference, drawn.difference);
    }
    // Both shards may share a folder.
    let shared = store(&at("first"), &[1, 3]);
    assert_eq!((shared.count(), merge(&[shared], &registry).unwrap().cells), (4, whole.cells));
}

#[test]
fn runs_on_two_machines_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(folder.path(), &[0, 1]);
    let elsewhere = crate::machine::RunDescription { cpu: "another".to_owned(), ..sample::run() };
    for cell in [2, 3] {
        store.put(cell, &elsewhere, TOOK, &outcome(cell)).unwrap();
    }
    let merged = merge(&[store], &Registry::builtin()).unwrap();
    assert_eq!(merged.runs, [sample::run(), elsewhere]);
    assert_eq!(merged.cells.iter().map(|cell| cell.run).collect::<Vec<_>>(), [0, 0, 1]);
}

#[test]
fn missing_cells_and_other_comparisons_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let registry = Registry::builtin();
    let some = store(&folder.path().join("some"), &[0, 2]);
    let error = merge(&[some], &registry).unwrap_err();
    assert!(matches!(error, MergeError::Missing { missing: 2, cells: 4, .. }), "{error}");
    assert!(error.to_string().contains("tracking on a"), "{error}");
    // A mesh of the same name that holds something else.
    let other = CellStore::open(&folder.path().join("other"), key("torus")).unwrap();
    let some = CellStore::existing(&folder.path().join("some")).unwrap();
    assert!(matches!(merge(&[some, other], &registry), Err(MergeError::Different { .. })));
    assert!(matches!(merge(&[], &registry), Err(MergeError::Nothing)));
}

#[test]
fn a_folder_of_something_else_is_refused_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("photo.jpg"), "mine").unwrap();
    assert!(matches!(CellStore::open(folder.path(), key("cube")), Err(StoreError::NotOurs { .. })));
    assert!(matches!(CellStore::existing(folder.path()), Err(StoreError::NotOurs { .. })));
    assert!(matches!(CellStore::existing(&folder.path().join("none")), Err(StoreError::Missing { .. })));
    let file = folder.path().join("a file");
    std::fs::write(&file, "no folder").unwrap();
    assert!(matches!(CellStore::existing(&file), Err(StoreError::NotOurs { .. })));
    assert_eq!(folder.path().read_dir().unwrap().count(), 2, "the photo and the file");

    let kept = tempfile::tempdir().unwrap();
    store(kept.path(), &[0]);
    let error = CellStore::open(kept.path(), key("torus")).unwrap_err();
    assert!(matches!(error, StoreError::OtherKey { .. }) && error.to_string().contains("meshes"), "{error}");
    let mut methods = key("cube");
    methods.methods.push(MethodKey { name: "image-precision".into(), options: OptionSettings::default() });
    assert!(matches!(CellStore::open(kept.path(), methods), Err(StoreError::OtherKey { .. })));
    assert!(CellStore::open(kept.path(), key("cube")).unwrap().holds(0));
}

#[test]
fn a_process_that_was_killed_leaves_no_half_of_a_cell() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(folder.path(), &[0]);
    // Killed after its pictures and before its numbers, and in the middle of a file.
    std::fs::write(folder.path().join("0001-drawn.png"), "half").unwrap();
    std::fs::write(folder.path().join(".cell-x.part"), "half").unwrap();
    assert!(!store.holds(1) && store.count() == 1);
    store.put(1, &sample::run(), TOOK, &outcome(1)).unwrap();
    assert_eq!(store.read(1).unwrap().took, TOOK);
    // A cell whose picture was lost is no cell.
    std::fs::remove_file(folder.path().join("0001-truth.png")).unwrap();
    assert!(!store.holds(1));
    store.put(1, &sample::run(), TOOK, &outcome(1)).unwrap();
    assert!(store.holds(1) && store.read(1).is_ok());
    // A file that is damaged afterwards names itself.
    std::fs::write(folder.path().join("0000.json"), "{").unwrap();
    let error = store.read(0).unwrap_err();
    assert!(matches!(error, StoreError::Damaged { .. }) && error.to_string().contains("0000.json"), "{error}");
    std::fs::copy(folder.path().join("0001.json"), folder.path().join("0002.json")).unwrap();
    assert!(matches!(store.read(2), Err(StoreError::Damaged { .. })), "the file of another cell");
}

#[test]
fn what_a_killed_process_was_writing_is_in_nobody_s_way() {
    let folder = tempfile::tempdir().unwrap();
    let cells = folder.path().join("cells");
    std::fs::create_dir(&cells).unwrap();
    std::fs::write(cells.join(".cell-abc.part"), "half").unwrap();
    let store = store(&cells, &[0]);
    store.remove().unwrap();
    assert!(!cells.exists());
}

#[test]
fn processes_that_begin_at_once_share_a_directory() {
    let folder = tempfile::tempdir().unwrap();
    for round in 0..20 {
        let cells = folder.path().join(round.to_string());
        std::thread::scope(|scope| {
            for cell in 0..4 {
                let cells = &cells;
                scope.spawn(move || store(cells, &[cell]));
            }
        });
        assert_eq!(CellStore::existing(&cells).unwrap().count(), 4);
    }
}

#[test]
fn a_store_is_removed_without_what_is_not_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let cells = folder.path().join("cells");
    store(&cells, &[0, 1, 2, 3]).remove().unwrap();
    assert!(!cells.exists());
    let with_note = store(&cells, &[0, 3]);
    std::fs::write(cells.join("note.txt"), "mine").unwrap();
    with_note.remove().unwrap();
    assert_eq!(cells.read_dir().unwrap().count(), 1);
}

#[test]
fn digests_tell_keys_apart() {
    assert_eq!(key("cube").digest(), key("cube").digest());
    assert_ne!(key("cube").digest(), key("torus").digest());
    let text = serde_json::to_string(&key("cube")).unwrap();
    assert_eq!(serde_json::from_str::<Key>(&text).unwrap(), key("cube"));
}

#[test]
fn added_cells_lie_within_their_comparison_and_go_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let base = store(&folder.path().join("cells"), &[0, 1]);
    let mut scene = Profile::Quick.scene();
    scene.select(&["tracking".to_owned()]);
    scene.set("tracking.concavity=0.7", &Registry::builtin()).unwrap();
    let config = CompareConfig::new(scene, &Registry::builtin()).unwrap();
    let key = base.key().with_methods(&config);
    assert_eq!((key.cells(), &key.meshes), (2, &base.key().meshes));
    assert_ne!(key.digest(), base.key().digest());

    let nested = base.nested(key.clone()).unwrap();
    nested.put(0, &sample::run(), TOOK, &outcome(1)).unwrap();
    // A later process finds what an earlier one kept.
    let again = base.nested(key).unwrap();
    assert!(again.holds(0) && !again.holds(1));
    let kept = again.read(0).unwrap();
    assert_eq!((kept.took, kept.run), (TOOK, sample::run()));
    assert_eq!(base.count(), 2, "they are no cells of the comparison itself");

    // A process was killed before it wrote a key.
    std::fs::create_dir(base.folder().join("refined-deadbeef")).unwrap();
    std::fs::write(base.folder().join("refined-deadbeef/.cell-x.part"), "half").unwrap();
    base.remove().unwrap();
    assert!(folder.path().read_dir().unwrap().next().is_none());
}
