//! The same bits for any number of threads and after any earlier views; cancelling at any moment.

use crate::scenes::{all_lines, finder, finder_of, framing};
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::{Cancelled, FaceId, NoProgress, PreparedMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::edits::joined;
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::look;
use silhouette_testing::{Cancelling, builtin, with_threads};
use silhouette_visibility::{ChainStyle, LineError, LineFinder, LineOptions, LineScene, Lines, SegmentSource};
use std::sync::Arc;

/// A chain with its numbers as bits, so that 0 and -0 differ and a NaN equals itself.
type ChainBits = (ChainStyle, bool, Vec<[u64; 3]>, Vec<[u64; 2]>, Vec<SegmentSource>, Vec<[[u64; 2]; 2]>);

fn bits(lines: &Lines) -> (Vec<ChainBits>, Vec<Vec<[u64; 2]>>) {
    let chains = lines.chains.iter().map(|chain| {
        (
            chain.style,
            chain.closed,
            chain.points.iter().map(|point| point.to_array().map(f64::to_bits)).collect(),
            chain.pixels.iter().map(|pixel| pixel.to_array().map(f64::to_bits)).collect(),
            chain.sources.to_vec(),
            chain.handles.iter().map(|pair| pair.map(|handle| handle.to_array().map(f64::to_bits))).collect(),
        )
    });
    let polygon = |polygon: &Vec<DVec2>| polygon.iter().map(|pixel| pixel.to_array().map(f64::to_bits)).collect();
    (chains.collect(), lines.outline.rings.iter().map(polygon).collect())
}

/// Everything that is drawn without curves, hidden lines included.
pub fn options() -> LineOptions {
    let (ridge_deg, valley_deg) = (Some(30.0), Some(30.0));
    LineOptions { ridge_deg, valley_deg, mesh: true, max_invisibility: u32::MAX, ..LineOptions::default() }
}

const SHAPES: [&str; 5] = ["knot", "gear", "blob:3000", "moebius", "grid"];

#[test]
fn any_number_of_threads_yields_the_same_bits() {
    for name in SHAPES {
        let mesh = builtin(name);
        for (index, direction) in spread(3).chain([DVec3::X]).enumerate() {
            let camera = framing(&mesh, direction, index % 2 == 0);
            let find = |threads| with_threads(threads, || bits(&all_lines(&mesh, &camera, &options())));
            let alone = find(1);
            assert!(alone.0.len() > 4, "{name}: {} chains", alone.0.len());
            assert!([2, 5, 1].map(find).iter().all(|other| *other == alone), "{name} from {direction}");
        }
    }
}

/// A finder yields what a fresh one yields, whatever views and options it was asked before.
#[test]
fn earlier_views_leave_no_trace() {
    for name in SHAPES {
        let mesh = builtin(name);
        let mut finder = finder(mesh.clone());
        let cameras: Vec<_> = spread(3).map(|direction| framing(&mesh, direction, true)).collect();
        for round in 0..3 {
            for camera in cameras.iter().chain(&cameras[..1]) {
                let options = if round == 1 { LineOptions::default() } else { options() };
                let mut fresh = LineFinder::new(finder.scene().clone(), &NoProgress).unwrap();
                let expected = bits(&fresh.find(camera, &options, &NoProgress).unwrap());
                assert!(bits(&finder.find(camera, &options, &NoProgress).unwrap()) == expected, "{name}");
            }
        }
    }
}

/// What is prepared for many views, and what is learnt from them, changes nothing, where meshes pass through each other too.
#[test]
fn what_is_known_beforehand_leaves_no_trace() {
    let (knot, gear) = (builtin("knot"), builtin("gear"));
    let mesh = joined(&[&knot, &gear]);
    let scene = LineScene::new(prepared(mesh.clone()));
    let mut prepared = LineFinder::for_many_views(scene.clone(), &NoProgress).unwrap();
    let mut plain = LineFinder::new(scene.clone(), &NoProgress).unwrap();
    // From the middle of a face on, that face is left out; edges that pass through it do so all the same from elsewhere.
    for face in (0..gear.face_count()).step_by(7).map(|face| FaceId::from_usize(knot.face_count() + face)) {
        let eye = mesh.corners(face).into_iter().sum::<Vec3>() / 3.0;
        for toward in [Vec3::X, Vec3::NEG_X] {
            plain.find(&look(eye, eye + toward, 120.0, [256, 256]), &options(), &NoProgress).unwrap();
        }
    }
    for direction in spread(4) {
        let camera = framing(&mesh, direction, true);
        let mut fresh = LineFinder::new(scene.clone(), &NoProgress).unwrap();
        let [expected, of_prepared, of_plain] = [&mut fresh, &mut prepared, &mut plain]
            .map(|finder| bits(&finder.find(&camera, &options(), &NoProgress).unwrap()));
        assert!(of_prepared == expected && of_plain == expected, "from {direction}");
    }
}

/// The comparison can fail: another view has other bits.
#[test]
fn another_view_has_other_bits() {
    let mesh = builtin("knot");
    let [one, other] = [0.2, 0.200_001].map(|x| framing(&mesh, DVec3::new(x, 0.3, 1.0), true));
    assert!(bits(&all_lines(&mesh, &one, &options())) != bits(&all_lines(&mesh, &other, &options())));
}

#[test]
fn a_view_cancelled_at_any_poll_leaves_the_finder_unchanged() {
    let mesh = builtin("knot");
    let camera = framing(&mesh, DVec3::new(0.5, 0.4, 1.0), true);
    let other = framing(&mesh, DVec3::new(-1.0, 0.4, 0.2), false);
    let scene = LineScene::new(prepared(mesh));
    let options = LineOptions::default();
    let find = |finder: &mut LineFinder, camera| bits(&finder.find(camera, &options, &NoProgress).unwrap());
    let expected =
        [&camera, &other].map(|camera| find(&mut LineFinder::new(scene.clone(), &NoProgress).unwrap(), camera));
    for threads in [1, 3] {
        with_threads(threads, || {
            let mut cancelled = 0;
            loop {
                let mut finder = LineFinder::new(scene.clone(), &NoProgress).unwrap();
                // With the remains of another view in it.
                find(&mut finder, &other);
                match finder.find(&camera, &options, &Cancelling::at_poll(cancelled)) {
                    Err(error) => assert_eq!(error, LineError::Cancelled(Cancelled)),
                    Ok(lines) => {
                        assert!(bits(&lines) == expected[0]);
                        break;
                    }
                }
                assert!(find(&mut finder, &camera) == expected[0], "after a view cancelled at poll {cancelled}");
                assert!(find(&mut finder, &other) == expected[1]);
                cancelled += 1;
            }
            assert!(cancelled > 5, "polled before each stage and each part of the strokes, not {cancelled} times");
        });
    }
}

#[test]
fn preparation_cancelled_at_any_poll_can_begin_again() {
    let mesh = prepared(builtin("gear"));
    let mut cancelled = 0;
    while LineFinder::new(LineScene::new(Arc::clone(&mesh)), &Cancelling::at_poll(cancelled)).is_err() {
        cancelled += 1;
        assert!(cancelled < 10_000, "preparation never ends");
    }
    assert!(cancelled > 0, "preparation is never polled");
    let fresh = prepared(builtin("gear"));
    let camera = framing(fresh.mesh(), DVec3::new(0.5, 0.4, 1.0), true);
    let find = |mesh: &Arc<PreparedMesh>| bits(&finder_of(mesh).find(&camera, &options(), &NoProgress).unwrap());
    assert!(find(&mesh) == find(&fresh));
}
