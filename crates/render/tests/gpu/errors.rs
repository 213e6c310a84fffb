//! Errors of the device come back as values, and a device that was not lost stays usable.

use crate::scenes::WHITE;
use silhouette_gpu::TargetFormats;
use silhouette_render::{AdapterChoice, DEFAULT_FORMATS, Gpu, GpuError, Load, Target};
use silhouette_testing::gpu_or_skip;

/// A device that a test may lose, or leave errors on, without another test noticing.
fn own_gpu(test: &str) -> Option<Gpu> {
    gpu_or_skip(test).map(|_| Gpu::new(AdapterChoice::from_env().unwrap()).unwrap())
}

fn bad_shader(gpu: &Gpu) -> wgpu::ShaderModule {
    gpu.device().create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("bad"),
        source: wgpu::ShaderSource::Wgsl("fn f() -> f32 { return nothing; }".into()),
    })
}

#[test]
fn a_bad_shader_is_a_validation_error() {
    let Some(gpu) = gpu_or_skip("a_bad_shader_is_a_validation_error") else { return };
    let error = gpu.scoped(|| bad_shader(gpu)).unwrap_err();
    assert!(matches!(&error, GpuError::Validation(text) if text.contains("nothing")), "{error}");
    assert!(gpu.scoped(|| ()).is_ok());
}

#[test]
fn a_pass_that_is_recorded_wrongly_is_a_validation_error() {
    let Some(gpu) = gpu_or_skip("a_pass_that_is_recorded_wrongly_is_a_validation_error") else { return };
    let target = Target::new(gpu, [4, 4], DEFAULT_FORMATS).unwrap();
    let error = gpu.draw(&target, Load::Clear(WHITE), |pass| pass.draw(0..3, 0..1)).unwrap_err();
    assert!(matches!(error, GpuError::Validation(_)), "no pipeline is set: {error}");
    gpu.draw(&target, Load::Clear(WHITE), |_| {}).unwrap();
    assert_eq!(target.read_color(gpu).unwrap().pixel(3, 3), [255; 4]);
}

#[test]
fn an_error_outside_of_a_scope_is_kept_until_asked_for() {
    let Some(gpu) = own_gpu("an_error_outside_of_a_scope_is_kept_until_asked_for") else { return };
    bad_shader(&gpu);
    assert!(matches!(gpu.check(), Err(GpuError::Validation(_))));
    assert!(gpu.check().is_ok());
}

#[test]
fn a_lost_device_is_an_error_from_then_on() {
    let Some(gpu) = own_gpu("a_lost_device_is_an_error_from_then_on") else { return };
    let target = Target::new(&gpu, [4, 4], DEFAULT_FORMATS).unwrap();
    gpu.draw(&target, Load::Clear(WHITE), |_| {}).unwrap();
    gpu.device().destroy();
    let lost = |error: GpuError| assert!(matches!(error, GpuError::Lost(_)), "{error}");
    lost(gpu.draw(&target, Load::Clear(WHITE), |_| {}).unwrap_err());
    lost(target.read_color(&gpu).unwrap_err());
    lost(target.read_depth(&gpu).unwrap_err());
    lost(Target::new(&gpu, [4, 4], DEFAULT_FORMATS).unwrap_err());
}

#[test]
fn impossible_targets_are_refused_before_they_are_made() {
    let Some(gpu) = gpu_or_skip("impossible_targets_are_refused_before_they_are_made") else { return };
    let limit = gpu.adapter().max_texture_px;
    for size in [[limit + 1, 1], [1, u32::MAX], [0, 5]] {
        let error = Target::new(gpu, size, DEFAULT_FORMATS).unwrap_err();
        assert!(matches!(error, GpuError::Size { .. }), "{error}");
    }
    for samples in [0, 2, 8] {
        let error = Target::new(gpu, [4, 4], TargetFormats { samples, ..DEFAULT_FORMATS }).unwrap_err();
        assert!(matches!(error, GpuError::Samples { .. }), "{error}");
    }
    let Some(small) = own_gpu("impossible_targets_are_refused_before_they_are_made") else { return };
    let small = small.with_memory_budget(8 * 100);
    assert!(Target::new(&small, [10, 10], DEFAULT_FORMATS).is_ok());
    let error = Target::new(&small, [10, 11], DEFAULT_FORMATS).unwrap_err();
    assert!(matches!(error, GpuError::OverBudget { bytes: 880, budget: 800 }), "{error}");
}

#[test]
fn what_cannot_be_read_back_says_so() {
    let Some(gpu) = gpu_or_skip("what_cannot_be_read_back_says_so") else { return };
    let target = Target::new(gpu, [4, 4], TargetFormats { samples: 4, ..DEFAULT_FORMATS }).unwrap();
    assert!(matches!(target.read_depth(gpu), Err(GpuError::MultisampledDepth { samples: 4 })));
    let color = wgpu::TextureFormat::R32Float;
    let target = Target::new(gpu, [4, 4], TargetFormats { color, ..DEFAULT_FORMATS }).unwrap();
    assert!(matches!(target.read_color(gpu), Err(GpuError::ColorFormat(_))));
}

/// A texture within all limits of which no machine has the memory: an error that says what to do, and the device goes on.
#[test]
fn memory_that_is_not_there_is_an_error_and_the_device_goes_on() {
    let Some(gpu) = gpu_or_skip("memory_that_is_not_there_is_an_error_and_the_device_goes_on") else { return };
    let limits = gpu.device().limits();
    let side = limits.max_texture_dimension_2d;
    let size = wgpu::Extent3d { width: side, height: side, depth_or_array_layers: limits.max_texture_array_layers };
    let texture = |size| {
        gpu.scoped(|| {
            gpu.device().create_texture(&wgpu::TextureDescriptor {
                label: Some("all there is"),
                size,
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::Rgba32Float,
                usage: wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            })
        })
    };
    let error = texture(size).map(drop).unwrap_err();
    assert!(matches!(error, GpuError::OutOfMemory), "{error}");
    assert!(error.to_string().contains("use a smaller size"), "{error}");
    gpu.check().unwrap();
    texture(wgpu::Extent3d { width: 4, height: 4, depth_or_array_layers: 1 }).unwrap();
}

/// A shader that is no WGSL, and a pipeline whose entry point is missing: an error that names them, and the device goes on.
#[test]
fn a_shader_that_fails_is_an_error_and_the_device_goes_on() {
    let Some(gpu) = gpu_or_skip("a_shader_that_fails_is_an_error_and_the_device_goes_on") else { return };
    let pipeline = |wgsl: &'static str, entry: &'static str| {
        gpu.scoped(|| {
            let module = gpu.device().create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("a caller's own"),
                source: wgpu::ShaderSource::Wgsl(wgsl.into()),
            });
            gpu.device().create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("a caller's own"),
                layout: None,
                module: &module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        })
    };
    let good = "@compute @workgroup_size(1) fn run() {}";
    for (wgsl, entry) in [
        ("@compute fn run( {", "run"),
        ("@compute @workgroup_size(1) fn run() { let a: f32 = 1u; }", "run"),
        (good, "walk"),
    ] {
        let error = pipeline(wgsl, entry).map(drop).unwrap_err();
        assert!(matches!(&error, GpuError::Validation(text) if text.contains("a caller's own")), "{error}");
        gpu.check().unwrap();
    }
    pipeline(good, "run").unwrap();
}
