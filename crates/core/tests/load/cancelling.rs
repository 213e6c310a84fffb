use silhouette_core::Progress;
use silhouette_core::load::{Format, load_with_progress, read};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Cancels once so many steps are reported; keeps what it is told.
struct Until {
    steps: AtomicU64,
    limit: u64,
    stages: Mutex<Vec<(String, u64)>>,
}

impl Until {
    fn new(limit: u64) -> Self {
        Self { steps: AtomicU64::new(0), limit, stages: Mutex::new(Vec::new()) }
    }
}

impl Progress for Until {
    fn stage(&self, name: &str, total: u64) {
        self.stages.lock().unwrap().push((name.to_owned(), total));
    }

    fn advance(&self, steps: u64) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.steps.load(Ordering::Relaxed) >= self.limit
    }
}

/// A million bytes or more of each format that is read row by row.
fn large_files() -> [(Format, Vec<u8>); 4] {
    let vertices = "0.5 0.5 0.5\n".repeat(100_000);
    let ply = "ply\nformat ascii 1.0\nelement vertex 100000\nproperty float x\nproperty float y\nproperty float z\n\
               element face 1\nproperty list uchar int vertex_index\nend_header\n";
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    [
        (Format::Obj, "v 0.5 0.5 0.5\n".repeat(100_000) + "f 1 2 3\n"),
        (Format::Off, format!("OFF\n100000 1 0\n{vertices}3 0 1 2\n")),
        (Format::Ply, format!("{ply}{vertices}3 0 1 2\n")),
        (Format::Stl, format!("solid\n{}endsolid\n", facet.repeat(15_000))),
    ]
    .map(|(format, text)| (format, text.into_bytes()))
}

#[test]
fn every_byte_is_reported() {
    for (format, bytes) in large_files() {
        let progress = Until::new(u64::MAX);
        read(format, "large", &bytes, &progress).unwrap();
        let total = bytes.len() as u64;
        assert_eq!(progress.steps.into_inner(), total, "{format}");
        assert_eq!(progress.stages.into_inner().unwrap(), [("parsing".to_owned(), total)]);
    }
}

#[test]
fn parsing_stops_soon_after_it_is_told_to() {
    for (format, bytes) in large_files() {
        let progress = Until::new(400_000);
        let error = read(format, "large", &bytes, &progress).unwrap_err();
        assert!(error.is_cancelled(), "{error}");
        assert!(progress.steps.into_inner() < 1_000_000, "{format}");
    }
}

#[test]
fn loading_stops_before_parsing_when_told_while_reading() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(&path, "v 0 0 0\nf 1 1 1\n").unwrap();
    let progress = Until::new(1);
    assert!(load_with_progress(&path, &progress).unwrap_err().is_cancelled());
    assert_eq!(progress.stages.into_inner().unwrap(), [("reading".to_owned(), 16)]);
}
