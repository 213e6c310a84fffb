use silhouette_core::load::{Format, load_with_progress, read};
use silhouette_testing::Cancelling;

/// A million bytes or more of each format that is read row by row.
fn large_files() -> [(Format, Vec<u8>); 4] {
    let vertices = "0.5 0.5 0.5\n0.5 1.5 0.5\n".repeat(50_000);
    let ply = "ply\nformat ascii 1.0\nelement vertex 100000\nproperty float x\nproperty float y\nproperty float z\n\
               element face 1\nproperty list uchar int vertex_index\nend_header\n";
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    [
        (Format::Obj, "v 0.5 0.5 0.5\nv 0.5 1.5 0.5\n".repeat(50_000) + "f 1 2 3\n"),
        (Format::Off, format!("OFF\n100000 1 0\n{vertices}3 0 1 2\n")),
        (Format::Ply, format!("{ply}{vertices}3 0 1 2\n")),
        (Format::Stl, format!("solid\n{}endsolid\n", facet.repeat(15_000))),
    ]
    .map(|(format, text)| (format, text.into_bytes()))
}

#[test]
fn every_byte_is_reported() {
    for (format, bytes) in large_files() {
        let progress = Cancelling::at_step(u64::MAX);
        read(format, "large", &bytes, &progress).unwrap();
        let total = bytes.len() as u64;
        assert_eq!(progress.steps(), total, "{format}");
        assert_eq!(progress.stages(), [("parsing".to_owned(), total)]);
    }
}

/// A mesh far from zero is read a second time, in 64 bits.
#[test]
fn the_second_reading_can_be_cancelled_too() {
    let far = "v 500000.25 5400000.125 0\nv 500001 5400001 1\n".repeat(50_000) + "f 1 2 3\n";
    let total = far.len() as u64;
    let progress = Cancelling::at_step(u64::MAX);
    read(Format::Obj, "far", far.as_bytes(), &progress).unwrap();
    assert_eq!(progress.stages(), [("parsing".to_owned(), total), ("parsing".to_owned(), total)]);
    let progress = Cancelling::at_step(total + 400_000);
    assert!(read(Format::Obj, "far", far.as_bytes(), &progress).unwrap_err().is_cancelled());
    assert!(progress.steps() < total + 1_000_000);
}

#[test]
fn parsing_stops_soon_after_cancellation() {
    for (format, bytes) in large_files() {
        let progress = Cancelling::at_step(400_000);
        let error = read(format, "large", &bytes, &progress).unwrap_err();
        assert!(error.is_cancelled(), "{error}");
        assert!(progress.steps() < 1_000_000, "{format}");
    }
}

#[test]
fn loading_cancelled_while_reading_stops_before_parsing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(&path, "v 0 0 0\nf 1 1 1\n").unwrap();
    let progress = Cancelling::at_step(1);
    assert!(load_with_progress(&path, &progress).unwrap_err().is_cancelled());
    assert_eq!(progress.stages(), [("reading".to_owned(), 16)]);
}

/// The JSON of a glTF document, of which the nodes alone are megabytes: cancelled in the middle, before any mesh is put together.
#[test]
fn parsing_a_gltf_document_stops_soon_after_cancellation() {
    let nodes = r#"{"name":"part","translation":[0.5,1.25,-3.5]},"#.repeat(100_000);
    let json = format!(r#"{{"asset":{{"version":"2.0"}},"nodes":[{nodes}{{}}]}}"#);
    let pieces = json.len() as u64 / (256 * 1024);
    assert!(pieces > 5);
    let read_until = |polls| read(Format::Gltf, "large", json.as_bytes(), &Cancelling::at_poll(polls));
    for polls in [0, pieces / 2, pieces, 2 * pieces] {
        let error = read_until(polls).unwrap_err();
        assert!(error.is_cancelled(), "{polls}: {error}");
    }
    // Read twice, once for transforms, and asked little more often: it is a mesh without faces.
    let read = read_until(2 * pieces + 20);
    assert!(!read.is_err_and(|error| error.is_cancelled()), "asked {pieces} times for each reading");
}
