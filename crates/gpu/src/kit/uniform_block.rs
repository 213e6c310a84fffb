//! [`UniformBlock`]: a uniform buffer of one Rust type.

use bytemuck::Pod;
use std::marker::PhantomData;

/// A uniform buffer that holds one `T`, laid out as its WGSL twin. Its content is zero until the first write.
#[derive(Debug)]
pub struct UniformBlock<T> {
    buffer: wgpu::Buffer,
    holds: PhantomData<fn(T)>,
}

impl<T: Pod> UniformBlock<T> {
    /// Allocates the buffer. `T` is not empty, and at most as large as the device's uniform bindings (64 KiB by default).
    pub fn new(device: &wgpu::Device, label: &str) -> Self {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: size_of::<T>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { buffer, holds: PhantomData }
    }

    /// Replaces the content, for submissions from the next one on.
    pub fn write(&self, queue: &wgpu::Queue, value: &T) {
        queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(value));
    }

    /// The buffer as a resource of a bind group.
    pub fn binding(&self) -> wgpu::BindingResource<'_> {
        self.buffer.as_entire_binding()
    }
}
