//! Waiting for the device leaves it to other threads, and survives what they do meanwhile.

use silhouette_render::{DEFAULT_FORMATS, Gpu, Load, Target};
use silhouette_testing::{gpu_or_skip, skipped};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

const TEST: &str = "a_device_that_is_waited_for_can_be_used";

/// Clears a target many times in one submission and waits for it. Meanwhile another thread does what needs the device's resources for
/// itself alone, as presenting a frame of a window does. How long both took, the longest time of the other thread.
fn waited(gpu: &Gpu, target: &Target, passes: u32) -> [Duration; 2] {
    let is_done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let other = scope.spawn(|| {
            let mut longest = Duration::ZERO;
            while !is_done.load(Ordering::Relaxed) {
                let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
                    label: None,
                    size: 4,
                    usage: wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                let start = Instant::now();
                buffer.destroy();
                longest = longest.max(start.elapsed());
                std::thread::sleep(Duration::from_millis(1));
            }
            longest
        });
        let start = Instant::now();
        let clear = |encoder: &mut wgpu::CommandEncoder| {
            for _ in 0..passes {
                let ops = wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::RED), store: wgpu::StoreOp::Store };
                let view = target.color_view();
                let color_attachments =
                    &[Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })];
                drop(
                    encoder.begin_render_pass(&wgpu::RenderPassDescriptor { color_attachments, ..Default::default() }),
                );
            }
        };
        let drawn = gpu.draw_after(target, Load::Keep, clear, |_| {});
        is_done.store(true, Ordering::Relaxed);
        drawn.unwrap();
        [start.elapsed(), other.join().unwrap()]
    })
}

#[test]
fn a_device_that_is_waited_for_can_be_used() {
    let Some(gpu) = gpu_or_skip(TEST) else { return };
    let target = Target::new(gpu, [2048, 2048], DEFAULT_FORMATS).unwrap();
    let mut passes = 64;
    while passes <= 1 << 14 {
        let [all, longest] = waited(gpu, &target, passes);
        if all > Duration::from_secs(1) {
            assert!(longest < all / 2, "{longest:?} of {all:?}: the device is kept from other threads");
            return;
        }
        passes *= 4;
    }
    skipped(TEST, "the adapter clears faster than a wait can be seen");
}

/// A thread that waits on busy cores beside another one that submits and polls, as a window does: the device is not taken for lost
/// because the other one found the queue empty.
#[test]
fn a_queue_that_another_thread_finds_empty_is_no_lost_device() {
    let Some(gpu) = gpu_or_skip("a_queue_that_another_thread_finds_empty") else { return };
    let target = Target::new(gpu, [1024, 1024], DEFAULT_FORMATS).unwrap();
    let is_done = AtomicBool::new(false);
    let goes_on = || !is_done.load(Ordering::Relaxed);
    std::thread::scope(|scope| {
        // They take the cores from a thread that is between two steps of a wait.
        let cores = std::thread::available_parallelism().map_or(2, std::num::NonZero::get);
        for _ in 0..2 * cores {
            scope.spawn(|| while goes_on() {});
        }
        scope.spawn(|| {
            while goes_on() {
                gpu.queue().submit([]);
                gpu.device().poll(wgpu::PollType::Poll).unwrap();
            }
        });
        let drawn = (0..400).try_for_each(|_| gpu.draw(&target, Load::Clear([1.0; 4]), |_| {}).map(drop));
        is_done.store(true, Ordering::Relaxed);
        drawn.unwrap();
    });
    gpu.check().unwrap();
}
