//! Every method on devices that have less than this adapter, and on one that is lost: a picture, or an error that says what to do.

use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle, Ground, pictures_of, render_method};
use silhouette_compare::registry::Registry;
use silhouette_core::{NoProgress, PreparedMesh};
use silhouette_render::{AdapterChoice, Gpu, GpuError};
use silhouette_testing::prepare::{cheap_options, prepared};
use silhouette_testing::views::three_quarter;
use silhouette_testing::{builtin, gpu_or_skip};
use std::collections::BTreeMap;
use std::io::Write as _;
use std::sync::Arc;

const SIZE: [u32; 2] = [96, 64];

fn style() -> FrameStyle {
    FrameStyle { size: SIZE, pen_width_px: 2.0, samples: 1, ground: Ground::Paper }
}

fn mesh() -> Arc<PreparedMesh> {
    prepared(builtin("torus:16,12"))
}

/// A device of its own with less, or nothing where there is no adapter.
fn lesser(test: &str, lower: impl Fn(&mut wgpu::Limits)) -> Option<Gpu> {
    gpu_or_skip(test)?;
    let mut limits = wgpu::Limits::defaults();
    lower(&mut limits);
    Some(Gpu::lesser(AdapterChoice::from_env().unwrap(), wgpu::Features::empty(), &limits).unwrap())
}

/// Whether each method draws on a device; fails where one panics, or is refused by wgpu instead of by itself.
fn outcomes(gpu: &Gpu, what: &str) -> BTreeMap<&'static str, Result<(), String>> {
    let (mesh, mut outcomes) = (mesh(), BTreeMap::new());
    let camera = three_quarter(mesh.mesh(), silhouette_testing::views::PERSPECTIVE, SIZE);
    for entry in Registry::builtin().entries() {
        let info = entry.info();
        if pictures_of(entry.capabilities()).next().is_none() {
            continue;
        }
        let drawn = render_method(gpu, entry, &cheap_options(info.options), &mesh, &camera, style(), &NoProgress);
        let outcome = drawn.map(|rendered| assert_eq!([rendered.image.width, rendered.image.height], SIZE));
        let outcome = outcome.map_err(|error| {
            let defect = matches!(error, DrawError::Gpu(GpuError::Validation(_) | GpuError::Internal(_)));
            assert!(!defect, "{what}: {}: {error}", info.name);
            error.to_string()
        });
        gpu.check().unwrap_or_else(|error| panic!("{what}: {}: {error}", info.name));
        outcomes.insert(info.name, outcome);
    }
    outcomes
}

/// What WebGPU promises on any device is enough for every method, with no optional feature at all.
#[test]
fn what_every_device_has_is_enough() {
    let Some(gpu) = lesser("what_every_device_has_is_enough", |_| {}) else { return };
    assert!(!gpu.adapter().timestamps, "an optional feature");
    for (method, outcome) in outcomes(&gpu, "defaults") {
        assert_eq!(outcome, Ok(()), "{method}");
    }
}

/// What a device has less of, and which methods are to say so.
type Case = (&'static str, fn(&mut wgpu::Limits), &'static [&'static str]);

/// No 3-D texture, buffer or picture of the size: the methods that need one say so and what to choose, the others draw.
#[test]
fn what_does_not_fit_is_refused_by_name() {
    let test = "what_does_not_fit_is_refused_by_name";
    let cases: [Case; 3] = [
        ("3-D textures", |limits| limits.max_texture_dimension_3d = 4, &["texture"]),
        ("buffers", |limits| limits.max_buffer_size = 1024, &["brute-force", "fine-mesh"]),
        ("bindings", |limits| limits.max_storage_buffer_binding_size = 1024, &[]),
    ];
    for (what, lower, expected) in cases {
        let Some(gpu) = lesser(test, lower) else { return };
        let outcomes = outcomes(&gpu, what);
        for (method, outcome) in &outcomes {
            writeln!(std::io::stderr(), "{what}: {method}: {outcome:?}").unwrap();
        }
        for method in expected {
            let refusal = outcomes[method].as_ref().unwrap_err();
            assert!(refusal.contains(char::is_numeric), "{what}: {method}: {refusal}");
        }
    }
    let Some(gpu) = lesser(test, |limits| limits.max_texture_dimension_2d = 48) else { return };
    for (method, outcome) in outcomes(&gpu, "pictures") {
        let refusal = outcome.expect_err("a picture of 96 pixels on a device of 48");
        assert!(refusal.contains("48"), "{method}: {refusal}");
    }
}

/// A device that goes while a method draws: an error from then on, and another device draws the same again.
#[test]
fn a_device_that_is_lost_in_the_middle_is_an_error() {
    let test = "a_device_that_is_lost_in_the_middle_is_an_error";
    let mesh = mesh();
    let camera = three_quarter(mesh.mesh(), silhouette_testing::views::PERSPECTIVE, SIZE);
    for entry in Registry::builtin().entries() {
        let info = entry.info();
        for kind in pictures_of(entry.capabilities()) {
            let Some(gpu) = lesser(test, |_| {}) else { return };
            let method = entry.prepare(&mesh, &cheap_options(info.options), &NoProgress).unwrap();
            let mut drawing = Drawing::new(&gpu, &mesh, method, kind, style()).unwrap();
            drawing.draw(&gpu, &camera).unwrap();
            gpu.device().destroy();
            let lost = |error: DrawError| {
                assert!(matches!(error, DrawError::Gpu(GpuError::Lost(_))), "{}: {error}", info.name);
                assert!(error.to_string().contains("run it again"), "{error}");
            };
            lost(drawing.draw(&gpu, &camera).unwrap_err());
            lost(drawing.picture(&gpu).unwrap_err());
            let again = entry.prepare(&mesh, &cheap_options(info.options), &NoProgress).unwrap();
            let made = Drawing::new(&gpu, &mesh, again, kind, style());
            lost(made.map(|_| ()).expect_err("nothing can be made on a lost device"));
        }
    }
}
