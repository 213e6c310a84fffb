//! [`storage_buffer`]: buffers whose size depends on the mesh.

use crate::mesh_buffers::MeshTooLarge;

/// Least size of a buffer: wgpu binds no empty ones, and this holds one element of any list.
const LEAST_BYTES: u64 = 64;

/// A buffer of at least `bytes` bytes for storage and copies to it, and for `usage`. `label` says what it holds, in the plural, for
/// wgpu's messages and for the error's.
///
/// # Errors
/// [`MeshTooLarge`] where the device's buffers or storage bindings are smaller, before anything is allocated.
pub fn storage_buffer(
    device: &wgpu::Device,
    label: &'static str,
    bytes: u64,
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, MeshTooLarge> {
    let limits = device.limits();
    let size = checked_size(label, bytes, limits.max_storage_buffer_binding_size.min(limits.max_buffer_size))?;
    Ok(device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: usage | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    }))
}

fn checked_size(what: &'static str, bytes: u64, limit: u64) -> Result<u64, MeshTooLarge> {
    if bytes > limit { Err(MeshTooLarge { what, bytes, limit }) } else { Ok(bytes.max(LEAST_BYTES)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn buffers_are_never_empty_and_never_beyond_the_limit() {
        assert_eq!(checked_size("edges", 0, 1000), Ok(64));
        assert_eq!(checked_size("edges", 1000, 1000), Ok(1000));
        assert_eq!(checked_size("edges", 1001, 1000), Err(MeshTooLarge { what: "edges", bytes: 1001, limit: 1000 }));
    }
}
