//! What a device bakes against what the CPU does, sample by sample.

use super::{GpuBake, GpuBakeError, GpuBakeReport};
use crate::bake::{AngleFormat, Bake, BakeError, BakeOptions, BakeReport, CenterRule};
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
    largest_gap: f64,
}

fn options() -> BakeOptions {
    BakeOptions {
        size: VolumeSize { width: 96, height: 96, azimuths: 16, pages: 1 },
        format: AngleFormat::Float16,
        detail: 1,
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
        let options = ErrorOptions { points: 300, directions: 1000, ..ErrorOptions::default() };
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
    let steps: Vec<f64> = angles(a).iter().zip(angles(b)).map(|(a, b)| (a - b).abs() / STEP).collect();
    let gaps = a.parts().gaps.iter().zip(&b.parts().gaps);
    let count = steps.len() as f64;
    Difference {
        mean: steps.iter().sum::<f64>() / count,
        largest: steps.iter().copied().fold(0.0, f64::max),
        apart: steps.iter().filter(|&&steps| steps > 1.0).count() as f64 / count,
        largest_gap: gaps.map(|(a, b)| f64::from((a.to_f32() - b.to_f32()).abs())).fold(0.0, f64::max),
    }
}

#[test]
fn a_device_bakes_what_the_cpu_does() {
    let Some(gpu) = gpu_or_skip("a_device_bakes_what_the_cpu_does") else { return };
    for (name, scene) in [
        ("ball", ball()),
        ("torus", in_sphere("torus:40,24", 1.3)),
        ("knot", in_sphere("knot", 1.2)),
        ("gear", in_sphere("gear", 1.4)),
        ("blob", in_sphere("blob:3000", 1.2)),
    ] {
        let ((cpu, cpu_report), (device, report)) = (scene.by_cpu(), scene.by_gpu(gpu));
        let found = difference(&cpu, &device);
        println!("{name}: {found:?} {report:?} {cpu_report:?} {} {}", scene.error(&cpu), scene.error(&device));
    }
}
