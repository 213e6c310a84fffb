//! [`Gpu`]: a device whose errors come back as values.

use crate::adapter::{self, AdapterDescription};
use crate::adapter_choice::AdapterChoice;
use crate::depth_readback::DepthReader;
use crate::error::GpuError;
use crate::timestamps::Timestamps;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::{Duration, Instant};

/// Bytes that one target, or one read-back, may take unless [`Gpu::with_memory_budget`] says otherwise: room for a
/// 16384 x 16384 image with depth and its read-back.
pub const DEFAULT_MEMORY_BUDGET: u64 = 4 << 30;

/// Features that are used where the adapter has them: to time submissions, and for methods that draw the adapter's own lines.
const WANTED_FEATURES: wgpu::Features = wgpu::Features::TIMESTAMP_QUERY
    .union(wgpu::Features::TIMESTAMP_QUERY_INSIDE_ENCODERS)
    .union(wgpu::Features::POLYGON_MODE_LINE);

/// How long a submit may take. On a software adapter the largest reference tile takes seconds; more is a hang.
const TIMEOUT: Duration = Duration::from_secs(300);

/// How long one call waits. `poll` holds a lock all the while that a window on the same device needs to present a frame.
const WAIT_SLICE: Duration = Duration::from_millis(2);

/// After so many panics of `poll` in one wait, the device is taken for lost.
const PANICS_OF_A_LOST_DEVICE: u32 = 8;

/// A headless device with its queue. Every call that can fail returns a [`GpuError`], for errors of the device as well.
#[derive(Debug)]
pub struct Gpu {
    instance: wgpu::Instance,
    opened: wgpu::Adapter,
    adapter: AdapterDescription,
    device: wgpu::Device,
    queue: wgpu::Queue,
    failure: Arc<Failure>,
    memory_budget: u64,
    pub(crate) timestamps: Option<Mutex<Timestamps>>,
    pub(crate) depth_reader: OnceLock<DepthReader>,
}

/// What the device reported outside of any error scope.
#[derive(Debug, Default)]
struct Failure {
    first_error: Mutex<Option<GpuError>>,
    lost: Mutex<Option<String>>,
}

impl Gpu {
    /// Opens the best adapter that `choice` accepts, without a window. 30 to 60 ms.
    ///
    /// Vulkan, Metal and Direct3D 12 are tried; OpenGL is not, as its adapters lack what the methods use.
    ///
    /// # Errors
    /// [`GpuError::NoAdapter`] with the remedy, or [`GpuError::NoDevice`].
    pub fn new(choice: AdapterChoice) -> Result<Self, GpuError> {
        Self::open(choice, |adapter| (adapter.features(), adapter.limits()))
    }

    /// The same with a device that has no more than these features and limits, whatever the adapter has: what an application meets
    /// on a lesser one.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn lesser(choice: AdapterChoice, features: wgpu::Features, limits: &wgpu::Limits) -> Result<Self, GpuError> {
        Self::open(choice, |adapter| (adapter.features() & features, adapter.limits().or_worse_values_from(limits)))
    }

    /// Opens an adapter with those of [`WANTED_FEATURES`] and the limits that `allowed` yields.
    fn open(
        choice: AdapterChoice,
        allowed: impl FnOnce(&wgpu::Adapter) -> (wgpu::Features, wgpu::Limits),
    ) -> Result<Self, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
        let instance = wgpu::Instance::new(descriptor);
        let adapter = adapter::choose(&instance, choice)?;
        let (features, limits) = allowed(&adapter);
        let features = features & WANTED_FEATURES;
        let mut description = AdapterDescription::new(&adapter);
        description.timestamps &= features.contains(wgpu::Features::TIMESTAMP_QUERY);
        description.max_texture_px = limits.max_texture_dimension_2d;
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("silhouettes"),
            required_features: features,
            required_limits: limits,
            ..Default::default()
        }))?;

        let failure = Arc::new(Failure::default());
        let on_error = Arc::clone(&failure);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            lock(&on_error.first_error).get_or_insert(error.into());
        }));
        let on_loss = Arc::clone(&failure);
        device.set_device_lost_callback(move |reason, message| {
            lock(&on_loss.lost).get_or_insert(format!("{reason:?}: {message}"));
        });
        let mut gpu = Self {
            instance,
            opened: adapter,
            adapter: description,
            device,
            queue,
            failure,
            memory_budget: DEFAULT_MEMORY_BUDGET,
            timestamps: None,
            depth_reader: OnceLock::new(),
        };
        if gpu.adapter.timestamps {
            gpu.timestamps = Some(Mutex::new(gpu.scoped(|| Timestamps::new(&gpu.device, &gpu.queue))?));
        }
        Ok(gpu)
    }

    /// The same device with another memory budget, in bytes, for each target and each read-back.
    #[must_use]
    pub fn with_memory_budget(mut self, bytes: u64) -> Self {
        self.memory_budget = bytes;
        self
    }

    /// What was opened.
    pub fn adapter(&self) -> &AdapterDescription {
        &self.adapter
    }

    /// The adapter itself, and the instance that it is of: what a window's surface is made with, on the same device.
    pub fn wgpu_adapter(&self) -> (&wgpu::Instance, &wgpu::Adapter) {
        (&self.instance, &self.opened)
    }

    /// The device.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// Its queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// `Err` with what the device reported since the last check outside of [`scoped`](Self::scoped), or once it is lost.
    ///
    /// # Errors
    /// The first error reported; [`GpuError::Lost`] from the loss on.
    pub fn check(&self) -> Result<(), GpuError> {
        if let Some(message) = lock(&self.failure.lost).as_ref() {
            return Err(GpuError::Lost(message.clone()));
        }
        lock(&self.failure.first_error).take().map_or(Ok(()), Err)
    }

    /// Runs `create` and returns its result, or the first error that the device reported meanwhile on this thread.
    /// After a loss devices create dead objects silently, so that is asked too.
    ///
    /// # Errors
    /// As [`check`](Self::check), plus what happened in `create`.
    pub fn scoped<T>(&self, create: impl FnOnce() -> T) -> Result<T, GpuError> {
        self.check()?;
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let value = create();
        let validation = pollster::block_on(validation.pop());
        let internal = pollster::block_on(internal.pop());
        let memory = pollster::block_on(memory.pop());
        self.check()?;
        memory.or(internal).or(validation).map_or(Ok(value), |error| Err(error.into()))
    }

    /// Waits until a submission is done. Other threads use the device meanwhile.
    pub(crate) fn wait(&self, submission: &wgpu::SubmissionIndex) -> Result<(), GpuError> {
        self.check()?;
        let deadline = Instant::now() + TIMEOUT;
        let wait = wgpu::PollType::Wait { submission_index: Some(submission.clone()), timeout: Some(WAIT_SLICE) };
        let mut panics = 0;
        loop {
            match catch_unwind(AssertUnwindSafe(|| self.device.poll(wait.clone()))) {
                Ok(Ok(_)) => return self.check(),
                Ok(Err(wgpu::PollError::Timeout)) if Instant::now() < deadline => {}
                Ok(Err(wgpu::PollError::Timeout)) => return Err(GpuError::TimedOut { seconds: TIMEOUT.as_secs() }),
                // A lost device drops what is submitted to it, so that there is nothing to wait for.
                Ok(Err(wgpu::PollError::WrongSubmissionIndex(..))) => break,
                // `poll` panics each time once the device is lost. It may also panic once on a sound device, where another thread
                // finds the queue empty just after this one's time was up: the assertion then compares with a fence read before.
                Err(_) => {
                    self.check()?;
                    panics += 1;
                    if panics == PANICS_OF_A_LOST_DEVICE {
                        break;
                    }
                }
            }
        }
        lock(&self.failure.lost).get_or_insert_with(|| "it dropped a submission".to_owned());
        self.check()
    }

    /// Has what is done by now take effect, without waiting.
    pub(crate) fn look(&self) -> Result<(), GpuError> {
        // A lost device panics here as in `wait`, which then says so.
        let _ = catch_unwind(AssertUnwindSafe(|| self.device.poll(wgpu::PollType::Poll)));
        self.check()
    }

    /// `Err` where `bytes` exceed the memory budget.
    pub(crate) fn check_budget(&self, bytes: u64) -> Result<(), GpuError> {
        let budget = self.memory_budget;
        if bytes > budget { Err(GpuError::OverBudget { bytes, budget }) } else { Ok(()) }
    }

    /// `Err` where a texture of this size cannot exist.
    pub(crate) fn check_size(&self, [width, height]: [u32; 2]) -> Result<(), GpuError> {
        let limit = self.device.limits().max_texture_dimension_2d;
        let fits = |side| (1..=limit).contains(&side);
        if fits(width) && fits(height) { Ok(()) } else { Err(GpuError::Size { width, height, limit }) }
    }
}

/// A panic of another thread while it held the lock leaves a whole value behind: they are replaced, never edited.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
