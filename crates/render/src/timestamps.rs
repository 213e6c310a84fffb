//! [`Timestamps`]: when a pass begins and ends on the device.

/// Bytes of the two values.
const BYTES: u64 = 16;

/// Two timestamp queries with their buffers, allocated once per device.
#[derive(Debug)]
pub(crate) struct Timestamps {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
    ns_per_tick: f64,
}

impl Timestamps {
    pub(crate) fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let buffer = |label, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: BYTES,
                usage: usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        Self {
            queries: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("pass begin and end"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
            resolved: buffer("timestamps", wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
            readable: buffer("timestamps to read", wgpu::BufferUsages::MAP_READ),
            ns_per_tick: f64::from(queue.get_timestamp_period()),
        }
    }

    pub(crate) fn writes(&self) -> wgpu::RenderPassTimestampWrites<'_> {
        wgpu::RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    /// Copies the two values into [`readable`](Self::readable).
    pub(crate) fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, BYTES);
    }

    /// The buffer to map once the submission is done.
    pub(crate) fn readable(&self) -> &wgpu::Buffer {
        &self.readable
    }

    /// Milliseconds between the two values, from the content of [`readable`](Self::readable).
    pub(crate) fn elapsed_ms(&self, bytes: &[u8]) -> f64 {
        let mut ticks = bytes.chunks_exact(8).map(|value| u64::from_le_bytes(std::array::from_fn(|i| value[i])));
        let [begin, end] = [ticks.next().unwrap_or(0), ticks.next().unwrap_or(0)];
        end.saturating_sub(begin) as f64 * self.ns_per_tick * 1e-6
    }
}
