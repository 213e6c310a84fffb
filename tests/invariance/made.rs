//! Curves of smoothed silhouettes, and silhouette textures baked on the CPU.

use crate::invariance::change::{Change, changes, on_grid};
use glam::DVec3;
use half::f16;
use silhouette_compare::registry::Registry;
use silhouette_core::method::OptionValues;
use silhouette_core::{NoProgress, SilhouetteCurves, TriangleMesh, Viewpoint};
use silhouette_testing::directions::spread;
use silhouette_testing::edits::mapped;
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::seen_from;
use silhouette_testing::{builtin, with_threads};
use silhouette_texture::{Bake, BakeOptions, Hull, SilhouetteTexture, VolumeSize};

/// Chains, closed ones, pieces, and the length of chords in the unit of the unchanged mesh.
type Measures = ([usize; 3], f64);

fn curves(method: &str, change: &Change, viewpoint: &Viewpoint) -> SilhouetteCurves {
    let registry = Registry::builtin();
    let entry = registry.find(method).unwrap();
    let options = OptionValues::defaults(entry.info().options);
    let mut method = entry.prepare(&prepared(change.mesh.clone()), &options, &NoProgress).unwrap();
    let mut curves = SilhouetteCurves::default();
    method.curves().unwrap().extract_curves(&change.viewpoint(viewpoint), &mut curves);
    curves
}

fn measures(change: &Change, curves: &SilhouetteCurves) -> Measures {
    let closed = curves.iter().filter(|chain| chain.closed).count();
    let chords = curves.pieces().iter().map(|piece| piece.point(0.0).distance(piece.point(1.0)));
    let length: f64 = chords.sum();
    ([curves.len(), closed, curves.pieces().len()], length / f64::from(change.scale))
}

fn are_like((one, length): Measures, (other, other_length): Measures) -> bool {
    one == other && (length - other_length).abs() <= 1e-4 * length
}

const METHODS: [&str; 3] = ["smoothing", "interpolated-contours", "boundary-curve"];

fn cases() -> impl Iterator<Item = (&'static str, TriangleMesh, Viewpoint)> {
    ["icosphere:2", "torus:24,16", "blob:600"].into_iter().flat_map(|name| {
        let mesh = mapped(&builtin(name), on_grid);
        let view = |direction: DVec3| seen_from(on_grid((direction * 3.3).as_vec3()));
        spread(3).map(view).map(move |viewpoint| (name, mesh.clone(), viewpoint))
    })
}

#[test]
fn curves_do_not_depend_on_the_place_of_a_mesh() {
    for method in METHODS {
        for (name, mesh, viewpoint) in cases() {
            let none = Change::none(&mesh);
            let expected = measures(&none, &curves(method, &none, &viewpoint));
            assert!(expected.0[2] > 10, "{method}, {name}: {expected:?}");
            for change in changes(&mesh) {
                let found = measures(&change, &curves(method, &change, &viewpoint));
                assert!(are_like(expected, found), "{method}, {name}, {}: {expected:?}, {found:?}", change.name);
            }
        }
    }
}

#[test]
fn curves_do_not_depend_on_the_number_of_threads() {
    for method in METHODS {
        for (name, mesh, viewpoint) in cases() {
            let of = |threads| with_threads(threads, || curves(method, &Change::none(&mesh), &viewpoint));
            assert!(of(1) == of(2), "{method}, {name}");
        }
    }
}

#[test]
fn curves_of_another_view_are_told() {
    for method in METHODS {
        let (_, mesh, viewpoint) = cases().last().unwrap();
        let none = Change::none(&mesh);
        let of = |viewpoint: &Viewpoint| measures(&none, &curves(method, &none, viewpoint));
        assert!(!are_like(of(&viewpoint), of(&seen_from([0.3, 3.0, 0.4]))), "{method}");
    }
}

fn bake(object: &TriangleMesh, scale: f32) -> SilhouetteTexture {
    let hull = Hull::trusted(mapped(&builtin("icosphere:1"), |p| on_grid(p * 1.75) * scale));
    let size = VolumeSize { width: 48, height: 48, azimuths: 8, pages: 1 };
    Bake::new(object, &hull, BakeOptions { size, ..BakeOptions::default() }).run(&NoProgress, None).unwrap().0
}

/// Steps from one 16-bit float above 0 to another.
fn steps_between(one: f16, other: f16) -> u16 {
    one.to_bits().abs_diff(other.to_bits())
}

#[test]
fn bakes_do_not_depend_on_order_unit_and_threads() {
    for name in ["torus:24,16", "blob:600", "cube"] {
        let object = mapped(&builtin(name), |p| on_grid(p * 0.9));
        let expected = with_threads(1, || bake(&object, 1.0));
        let again = with_threads(2, || bake(&object, 1.0));
        assert!(
            expected.parts().angles == again.parts().angles && expected.parts().gaps == again.parts().gaps,
            "{name}"
        );
        assert!(expected.parts().colors == again.parts().colors, "{name}");
        for change in changes(&object).filter(|change| ["order", "smaller", "larger"].contains(&change.name)) {
            let found = bake(&change.mesh, change.scale);
            let (expected, found) = (expected.parts(), found.parts());
            assert!(expected.angles == found.angles, "{name}, {}: angles", change.name);
            // A ray that grazes an edge is as long as either face says; on another side of a tie it is a step longer.
            let steps = |(one, other): (&_, &_)| steps_between(*one, *other);
            let most = expected.gaps.iter().zip(&found.gaps).map(steps).max().unwrap();
            assert!(most <= u16::from(change.name == "order"), "{name}, {}: gaps {most} steps apart", change.name);
            assert!(expected.centers == found.centers, "{name}, {}: middles", change.name);
        }
    }
}

#[test]
fn bakes_of_another_object_are_told() {
    let of = |size: f32| bake(&mapped(&builtin("blob:600"), |p| on_grid(p * size)), 1.0);
    assert!(of(0.9).parts().angles != of(0.91).parts().angles);
}
