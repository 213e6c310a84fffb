//! Paths that cannot be written to or read, and work that is cancelled.

use super::textures::SMALL;
use crate::siltex::{Metadata, Problem, read, write};
use silhouette_core::NoProgress;
use silhouette_testing::Cancelling;
use std::path::Path;

#[test]
fn a_cancelled_write_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.siltex");
    std::fs::write(&path, b"old").unwrap();
    let (mut cancelled, texture) = (0, SMALL.texture());
    for polls in 0.. {
        let progress = Cancelling::at_poll(polls);
        match write(&path, &texture, &Metadata::new(), &progress) {
            Ok(()) => {
                let length = std::fs::metadata(&path).unwrap().len();
                assert_eq!(progress.stages(), [("writing the texture".to_owned(), length)]);
                assert_eq!(progress.steps(), length);
                break;
            }
            Err(error) => {
                assert!(error.is_cancelled(), "{error}");
                assert_eq!(std::fs::read(&path).unwrap(), b"old");
                assert_eq!(folder.path().read_dir().unwrap().count(), 1);
                cancelled += 1;
            }
        }
    }
    assert!(cancelled > 20, "{cancelled}");
}

#[test]
fn bad_places_are_named_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let written = |path: &Path| {
        let error = write(path, &SMALL.texture(), &Metadata::new(), &NoProgress).unwrap_err();
        assert!(matches!(error.problem, Problem::Write(_)), "{error}");
        error.to_string()
    };
    let missing = folder.path().join("no\nfolder/a.siltex");
    let text = written(&missing);
    assert!(
        text.contains("no\\nfolder/a.siltex, silhouette texture: cannot be written") && !text.contains('\n'),
        "{text}"
    );
    written(folder.path());
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);

    let error = read(&missing).unwrap_err();
    assert!(matches!(error.problem, Problem::Missing), "{error}");
    let error = read(folder.path()).unwrap_err();
    assert!(matches!(error.problem, Problem::Read(_)), "{error}");
    let text = folder.path().join("a.siltex");
    std::fs::write(&text, b"v 0 0 0\n").unwrap();
    let error = read(&text).unwrap_err();
    assert!(
        error.to_string().ends_with("a.siltex, header: this is not a .siltex file; name one that a bake has written")
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_device_is_not_replaced() {
    let error = write(Path::new("/dev/full"), &SMALL.texture(), &Metadata::new(), &NoProgress).unwrap_err();
    assert!(matches!(error.problem, Problem::Write(_)) && Path::new("/dev/full").exists());
}

/// The system's own full disk, behind an open file.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    let mut full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let error = crate::siltex::write_to(&mut full, &SMALL.texture(), &Metadata::new(), &NoProgress).unwrap_err();
    assert!(error.to_string().contains("cannot be written (no storage space)"), "{error}");
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("a.siltex"), folder.path().join("b.siltex"));
    std::fs::write(&file, b"old").unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    write(&link, &SMALL.texture(), &Metadata::new(), &NoProgress).unwrap();
    assert!(link.is_symlink() && read(&file).is_ok());
}
