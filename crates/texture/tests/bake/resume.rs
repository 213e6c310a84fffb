//! The same bytes for any number of threads, and after interruptions of any kind.

use silhouette_core::glam::Vec3;
use silhouette_core::{FaceId, NoProgress, TriangleMesh};
use silhouette_testing::pace::Pace;
use silhouette_testing::progress::Cancelling;
use silhouette_testing::random::Random;
use silhouette_testing::threads::with_threads;
use silhouette_testing::{edits, zoo};
use silhouette_texture::checkpoint::CheckpointError;
use silhouette_texture::{
    AngleFormat, Bake, BakeError, BakeOptions, BakeReport, CenterRule, Hull, SilhouetteTexture, VolumeSize,
};
use std::path::Path;

struct Scene {
    object: TriangleMesh,
    hull: Hull,
    options: BakeOptions,
}

fn colors(face: FaceId, weights: Vec3) -> [u8; 4] {
    [face.get() as u8, (weights.x * 255.0) as u8, 7, 255]
}

fn scene(format: AngleFormat, centers: CenterRule) -> Scene {
    let object = zoo::builtin("torus");
    let by = object.bounds().unwrap().radius as f32 * 1.2;
    let hull = edits::mapped(&zoo::builtin("icosphere:1"), |point| point * by * 1.3);
    let size = VolumeSize { width: 60, height: 60, azimuths: 8, pages: 1 };
    Scene {
        object,
        hull: Hull::trusted(hull),
        options: BakeOptions { size, format, centers, ..BakeOptions::default() },
    }
}

impl Scene {
    fn bake(&self) -> Bake<'_> {
        Bake::new(&self.object, &self.hull, self.options).with_colors(&colors)
    }

    fn run(&self, checkpoint: Option<&Path>) -> (SilhouetteTexture, BakeReport) {
        self.bake().run(&NoProgress, checkpoint).unwrap()
    }
}

fn assert_same(a: &SilhouetteTexture, b: &SilhouetteTexture) {
    let (a, b) = (a.parts(), b.parts());
    assert!(a.angles == b.angles && a.gaps == b.gaps && a.colors == b.colors && a.normals == b.normals);
    assert!(a.centers == b.centers && a.tangents == b.tangents && a.texel_centers == b.texel_centers);
    assert_eq!(a.places, b.places);
}

#[test]
fn any_number_of_threads_bakes_the_same() {
    for centers in [CenterRule::Vertex, CenterRule::Texel] {
        let scene = scene(AngleFormat::Unorm8, centers);
        let (one, report) = with_threads(1, || scene.run(None));
        for threads in [2, 5] {
            let (other, again) = with_threads(threads, || scene.run(None));
            assert_same(&one, &other);
            assert_eq!(report, again);
        }
    }
}

/// Cancelled at random checks again and again, with other numbers of threads, and the file cut at a random byte in between.
#[test]
fn an_interrupted_bake_ends_with_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random::new(11);
    for (format, centers) in [(AngleFormat::Unorm8, CenterRule::Vertex), (AngleFormat::Float16, CenterRule::Texel)] {
        let scene = scene(format, centers);
        let pace = Pace::begin();
        let (whole, report) = scene.bake().run(&pace, None).unwrap();
        let (_, _, checks) = pace.end();
        for round in 0..2 {
            let path = folder.path().join(format!("{format:?}-{round}"));
            let mut interruptions = 0;
            let (resumed, resumed_report) = loop {
                let progress = Cancelling::at_poll(random.below(checks as usize) as u64);
                match with_threads(1 + random.below(4), || scene.bake().run(&progress, Some(&path))) {
                    Ok(done) => break done,
                    Err(BakeError::Cancelled(_)) => interruptions += 1,
                    Err(error) => panic!("{error}"),
                }
                assert!(interruptions < 1000);
                if path.exists() && random.one_in(3) {
                    let length = path.metadata().unwrap().len();
                    let kept = length - random.below(length as usize / 3 + 1) as u64;
                    std::fs::OpenOptions::new().write(true).open(&path).unwrap().set_len(kept).unwrap();
                }
            };
            assert!(interruptions > 0);
            assert_same(&whole, &resumed);
            assert!(resumed_report.restored_tiles > 0);
            assert_eq!(BakeReport { restored_tiles: 0, ..resumed_report }, report);
        }
    }
}

/// A damaged record, and all after it, are baked again.
#[test]
fn a_damaged_checkpoint_is_not_believed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("checkpoint");
    let scene = scene(AngleFormat::Unorm8, CenterRule::Vertex);
    let (whole, report) = scene.run(Some(&path));
    let bytes = std::fs::read(&path).unwrap();
    let mut random = Random::new(5);
    for _ in 0..8 {
        let mut damaged = bytes.clone();
        // Beyond the header.
        let at = 20 + random.below(bytes.len() - 20);
        damaged[at] ^= 1 << random.below(8);
        std::fs::write(&path, damaged).unwrap();
        let (again, restored) = scene.run(Some(&path));
        assert_same(&whole, &again);
        assert!(restored.restored_tiles < report.tiles);
        assert_eq!(std::fs::metadata(&path).unwrap().len(), bytes.len() as u64);
    }
    let (_, all) = scene.run(Some(&path));
    assert_eq!(all.restored_tiles, all.tiles);
}

#[test]
fn a_file_of_something_else_is_refused_and_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("checkpoint");
    let scene = scene(AngleFormat::Unorm8, CenterRule::Vertex);
    let refused = |scene: &Scene| match scene.bake().run(&NoProgress, Some(&path)) {
        Err(BakeError::Checkpoint { cause, .. }) => cause,
        other => panic!("{:?}", other.map(|(_, report)| report)),
    };
    std::fs::write(&path, b"solid teapot, and thirty bytes more").unwrap();
    assert!(matches!(refused(&scene), CheckpointError::NoCheckpoint));
    assert_eq!(std::fs::read(&path).unwrap(), b"solid teapot, and thirty bytes more");

    std::fs::remove_file(&path).unwrap();
    scene.run(Some(&path));
    let before = std::fs::read(&path).unwrap();
    let mut other = self::scene(AngleFormat::Float16, CenterRule::Vertex);
    assert!(matches!(refused(&other), CheckpointError::OtherBake));
    other.options = scene.options;
    other.object = edits::moved(&scene.object, Vec3::X * 1e-3);
    assert!(matches!(refused(&other), CheckpointError::OtherBake));
    other.object = scene.object.clone();
    assert!(Bake::new(&other.object, &other.hull, other.options).run(&NoProgress, Some(&path)).is_err());
    assert_eq!(std::fs::read(&path).unwrap(), before);
    assert!(matches!(scene.bake().run(&NoProgress, Some(folder.path())), Err(BakeError::Checkpoint { .. })));
}

#[test]
fn what_cannot_be_baked_is_refused() {
    let scene = scene(AngleFormat::Unorm8, CenterRule::Vertex);
    let empty = zoo::empty();
    let run = |object: &TriangleMesh, options| Bake::new(object, &scene.hull, options).run(&NoProgress, None);
    assert!(matches!(run(&empty, scene.options), Err(BakeError::NoFaces)));
    for detail in [0, 17] {
        let options = BakeOptions { detail, ..scene.options };
        assert!(matches!(run(&scene.object, options), Err(BakeError::Detail(refused)) if refused == detail));
    }
    let size = VolumeSize { width: 8, height: 8, ..scene.options.size };
    assert!(matches!(run(&scene.object, BakeOptions { size, ..scene.options }), Err(BakeError::Atlas(_))));
    let progress = Cancelling::at_once();
    assert!(matches!(scene.bake().run(&progress, None), Err(BakeError::Cancelled(_))));
}
