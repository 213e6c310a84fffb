//! What a device bakes against what the CPU does, sample by sample.

use super::{GpuBake, GpuBakeError, GpuBakeReport};
use crate::atlas::Atlas;
use crate::bake::{AngleFormat, Bake, BakeError, BakeOptions, BakeReport, CenterRule};
use crate::hull::HullOptions;
use crate::sampling_error::{ErrorOptions, sampling_error};
use crate::silhouette_texture::{Angles, SilhouetteTexture, VisibilityRule};
use crate::{Hull, LobeRule, VisibilityFunction, VolumeSize};
use silhouette_core::shapes::Sphere;
use silhouette_core::{Cancelled, NoProgress, TriangleMesh, glam::Vec3};
use silhouette_render::Gpu;
use silhouette_testing::gpu::gpu_or_skip;
use silhouette_testing::progress::Cancelling;
use silhouette_testing::{edits, zoo};

/// An 8-bit step of the angle, as a share of pi.
const STEP: f64 = 1.0 / 255.0;

const GUTTER: u32 = 1;

struct Scene {
    object: TriangleMesh,
    hull: Hull,
    options: BakeOptions,
}

/// How two textures differ.
#[derive(Debug)]
struct Difference {
    /// Of angles, in 8-bit steps.
    mean: f64,
    largest: f64,
    /// Share of samples that differ by more than a step.
    apart: f64,
    /// Of gaps, in units of the hull's radius.
    mean_gap: f64,
}

fn options() -> BakeOptions {
    BakeOptions {
        size: VolumeSize { width: 64, height: 64, azimuths: 8, pages: 1 },
        format: AngleFormat::Float16,
        detail: 1,
        gutter: GUTTER,
        ..BakeOptions::default()
    }
}

/// A ball in a round hull.
fn ball() -> Scene {
    let object = Sphere { radius: 1.0 }.icosphere(4).unwrap();
    Scene { object, hull: Hull::trusted(Sphere { radius: 1.5 }.icosphere(1).unwrap()), options: options() }
}

/// A shape of the zoo in a round hull.
fn in_sphere(name: &str, by: f32) -> Scene {
    let object = zoo::builtin(name);
    let bounds = object.bounds().unwrap();
    let (center, radius) = (bounds.center.as_vec3(), bounds.radius as f32);
    let hull = edits::mapped(&zoo::builtin("icosphere:1"), |point| center + point * radius * by);
    Scene { object, hull: Hull::trusted(hull), options: options() }
}

/// A shape of the zoo in the smallest hull of 60 vertices.
fn in_tight_hull(name: &str) -> Scene {
    let object = zoo::builtin(name);
    let hull = Hull::enclosing(&object, &HullOptions { vertices: 60, ..HullOptions::default() }, &NoProgress).unwrap();
    Scene { object, hull, options: options() }
}

fn far_away(scene: &Scene) -> Scene {
    let moved = |mesh: &TriangleMesh| edits::mapped(mesh, |point| point + Vec3::new(300.0, -200.0, 100.0));
    Scene { object: moved(&scene.object), hull: Hull::trusted(moved(scene.hull.mesh())), options: scene.options }
}

impl Scene {
    fn by_cpu(&self) -> (SilhouetteTexture, BakeReport) {
        Bake::new(&self.object, &self.hull, self.options).run(&NoProgress, None).unwrap()
    }

    fn by_gpu(&self, gpu: &Gpu) -> (SilhouetteTexture, GpuBakeReport) {
        let bake = Bake::new(&self.object, &self.hull, self.options);
        GpuBake::new(gpu.device(), gpu.queue(), &bake).run(&NoProgress).unwrap()
    }

    /// Equation 3.
    fn error(&self, texture: &SilhouetteTexture) -> f64 {
        let visibility = VisibilityFunction::new(&self.object, &self.hull, self.options.rule);
        let options = ErrorOptions { points: 200, directions: 800, ..ErrorOptions::default() };
        sampling_error(texture, &visibility, &options, &NoProgress).unwrap().mean
    }
}

fn angles(texture: &SilhouetteTexture) -> Vec<f64> {
    match &texture.parts().angles {
        Angles::Float16(values) => values.iter().map(|value| f64::from(value.to_f32())).collect(),
        Angles::Unorm8(values) => values.iter().map(|&value| f64::from(value) * STEP).collect(),
        Angles::Terms(_) => panic!("a bake compresses nothing"),
    }
}

fn difference(a: &SilhouetteTexture, b: &SilhouetteTexture) -> Difference {
    // Texels outside blocks are 0 in both, and do not count.
    let used = Atlas::new(&a.parts().hull, a.parts().size, GUTTER).unwrap().used_texels();
    let count = (used.iter().filter(|&&used| used).count() * a.parts().size.azimuths as usize) as f64;
    let steps: Vec<f64> = angles(a).iter().zip(angles(b)).map(|(a, b)| (a - b).abs() / STEP).collect();
    let gaps = a.parts().gaps.iter().zip(&b.parts().gaps);
    Difference {
        mean: steps.iter().sum::<f64>() / count,
        largest: steps.iter().copied().fold(0.0, f64::max),
        apart: steps.iter().filter(|&&steps| steps > 1.01).count() as f64 / count,
        mean_gap: gaps.map(|(a, b)| f64::from((a.to_f32() - b.to_f32()).abs())).sum::<f64>()
            / a.parts().gaps.len() as f64,
    }
}

/// Asserts that a device bakes what the CPU does, but for single rays at borders; returns how much they differ.
fn assert_alike(gpu: &Gpu, name: &str, scene: &Scene) -> Difference {
    let ((cpu, cpu_report), (device, report)) = (scene.by_cpu(), scene.by_gpu(gpu));
    let found = difference(&cpu, &device);
    assert!(found.mean < 0.01, "{name}: {found:?}");
    assert!(found.apart < 1e-3, "{name}: {found:?}");
    assert!(found.mean_gap < 1e-3, "{name}: {found:?}");
    let (of_cpu, of_device) = (cpu_report, report.bake);
    assert_eq!(report.cpu_tiles, 0, "{name}");
    assert_eq!((of_device.samples, of_device.tiles), (of_cpu.samples, of_cpu.tiles));
    for (a, b) in [
        (of_device.rays, of_cpu.rays),
        (of_device.scans, of_cpu.scans),
        (of_device.hidden_centers, of_cpu.hidden_centers),
    ] {
        assert!(a.abs_diff(b) as f64 <= 0.01 * b as f64 + 2.0, "{name}: {of_device:?} {of_cpu:?}");
    }
    let (a, b) = (cpu.parts(), device.parts());
    assert!(a.colors == b.colors && a.normals == b.normals && a.texel_centers == b.texel_centers);
    assert!(a.centers == b.centers && a.tangents == b.tangents && a.places == b.places);
    let [of_cpu, of_device] = [&cpu, &device].map(|texture| scene.error(texture));
    assert!(of_device <= of_cpu + 1e-4, "{name}: {of_device} instead of {of_cpu}");
    found
}

#[test]
fn a_device_bakes_what_the_cpu_does() {
    let Some(gpu) = gpu_or_skip("a_device_bakes_what_the_cpu_does") else { return };
    let found = assert_alike(gpu, "ball", &ball());
    assert!(found.largest < 1.0, "nothing at a smooth border is in doubt: {found:?}");
    for (name, scene) in [
        ("torus", in_sphere("torus:40,24", 1.3)),
        ("knot", in_sphere("knot", 1.2)),
        ("gear in a wide hull", in_sphere("gear", 5.0)),
        ("blob in a tight hull", in_tight_hull("blob:3000")),
        ("torus far away", far_away(&in_sphere("torus:30,20", 1.3))),
    ] {
        assert_alike(gpu, name, &scene);
    }
}

#[test]
fn a_device_follows_every_option() {
    let Some(gpu) = gpu_or_skip("a_device_follows_every_option") else { return };
    let size = VolumeSize { width: 40, height: 40, azimuths: 8, pages: 1 };
    let common = BakeOptions { size, ..options() };
    for options in [
        BakeOptions { rule: VisibilityRule::Exterior, ..common },
        BakeOptions { lobe: LobeRule::LastExit, ..common },
        BakeOptions { lobe: LobeRule::FirstExit, ..common },
        BakeOptions { centers: CenterRule::Texel, ..common },
        BakeOptions { centers: CenterRule::AsPrinted, ..common },
        BakeOptions { format: AngleFormat::Unorm8, ..common },
        BakeOptions { detail: 3, ..common },
    ] {
        let scene = Scene { options, ..in_sphere("knot", 1.2) };
        assert_alike(gpu, &format!("{options:?}"), &scene);
    }
}

/// What the comparison would notice.
#[test]
fn another_lobe_rule_is_another_texture() {
    let Some(gpu) = gpu_or_skip("another_lobe_rule_is_another_texture") else { return };
    let scene = in_sphere("knot", 1.2);
    let other = Scene { options: BakeOptions { lobe: LobeRule::LastExit, ..options() }, ..in_sphere("knot", 1.2) };
    let found = difference(&scene.by_cpu().0, &other.by_gpu(gpu).0);
    assert!(found.apart > 0.05 && found.mean > 1.0, "{found:?}");
}

#[test]
fn a_device_bakes_the_same_twice() {
    let Some(gpu) = gpu_or_skip("a_device_bakes_the_same_twice") else { return };
    let scene = in_sphere("gear", 1.4);
    let (first, second) = (scene.by_gpu(gpu).0, scene.by_gpu(gpu).0);
    assert!(first.parts().angles == second.parts().angles && first.parts().gaps == second.parts().gaps);
}

#[test]
fn what_the_device_gives_up_is_baked_by_the_cpu() {
    let Some(gpu) = gpu_or_skip("what_the_device_gives_up_is_baked_by_the_cpu") else { return };
    let scene = in_sphere("gear", 1.4);
    let bake = Bake::new(&scene.object, &scene.hull, scene.options);
    let run = |most_steps| {
        let limited = GpuBake { most_steps, ..GpuBake::new(gpu.device(), gpu.queue(), &bake) };
        limited.run(&NoProgress).unwrap()
    };
    let (cpu, of_cpu) = scene.by_cpu();
    let (none, report) = run(0);
    assert_eq!(report.cpu_tiles, of_cpu.tiles);
    assert_eq!(report.bake.hidden_centers, of_cpu.hidden_centers);
    assert!(none.parts().angles == cpu.parts().angles && none.parts().gaps == cpu.parts().gaps);
    let (some, report) = run(1600);
    assert!(0 < report.cpu_tiles && report.cpu_tiles < of_cpu.tiles, "{report:?}");
    assert!(difference(&some, &cpu).apart < 1e-3);
}

/// On llvmpipe, which ends the loops of an invocation after 65 535 turns; elsewhere the device finds all angles itself.
#[test]
fn loops_that_a_device_ends_early_are_noticed() {
    let Some(gpu) = gpu_or_skip("loops_that_a_device_ends_early_are_noticed") else { return };
    let triangle = [[0, 1, 2]; 4000];
    let object = TriangleMesh::new(vec![Vec3::X, Vec3::Y, -Vec3::X], triangle.to_vec()).unwrap();
    let hull = Hull::trusted(edits::mapped(&zoo::builtin("icosphere:0"), |point| point * 2.5));
    let size = VolumeSize { width: 16, height: 16, azimuths: 4, pages: 1 };
    let scene = Scene { object, hull, options: BakeOptions { size, ..options() } };
    let bake = Bake::new(&scene.object, &scene.hull, scene.options);
    let unlimited = GpuBake { most_steps: u32::MAX, ..GpuBake::new(gpu.device(), gpu.queue(), &bake) };
    let (texture, _) = unlimited.run(&NoProgress).unwrap();
    let found = difference(&texture, &scene.by_cpu().0);
    assert!(found.apart < 1e-2, "{found:?}");
}

#[test]
fn a_bake_on_a_device_is_cancelled_and_refused_as_others_are() {
    let Some(gpu) = gpu_or_skip("a_bake_on_a_device_is_cancelled_and_refused_as_others_are") else { return };
    let scene = ball();
    let bake = Bake::new(&scene.object, &scene.hull, scene.options);
    let device = GpuBake::new(gpu.device(), gpu.queue(), &bake);
    // Corners of the hull, then some samples.
    let corners = 3 * scene.hull.mesh().face_count() as u64;
    for steps in [1, corners + 100] {
        let outcome = device.run(&Cancelling::at_step(steps));
        assert!(matches!(outcome, Err(GpuBakeError::Bake(BakeError::Cancelled(Cancelled)))));
    }
    let empty = zoo::empty();
    let bake = Bake::new(&empty, &scene.hull, scene.options);
    let outcome = GpuBake::new(gpu.device(), gpu.queue(), &bake).run(&NoProgress);
    assert!(matches!(outcome, Err(GpuBakeError::Bake(BakeError::NoFaces))));
}
