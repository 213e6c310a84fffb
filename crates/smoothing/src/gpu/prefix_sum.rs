//! [`Levels`]: running sums over any number of elements. Stages: `shaders/smoothing/prefix_sum.wgsl`.

use silhouette_gpu::kit::compute_pipeline;
use silhouette_shaders::smoothing::PREFIX_SUM;

/// Elements that a workgroup sums.
const BLOCK: u32 = 256;

/// Most workgroups along an axis.
const LONGEST_ROW: u32 = 32_768;

/// Most elements: no sum of 32 bits overflows, and three levels hold them.
pub(crate) const MOST_ELEMENTS: u32 = 1 << 23;

/// Bytes of an element: four sums.
pub(crate) const ELEMENT_BYTES: u64 = 16;

/// Where the levels begin: the elements, the totals of their blocks, and the totals of those.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Levels {
    pub level_1_at: u32,
    pub level_2_at: u32,
    /// The total of all elements.
    pub total_at: u32,
    /// Levels that are summed.
    pub count: u32,
}

impl Levels {
    /// The levels of up to [`MOST_ELEMENTS`] elements.
    pub fn new(elements: u32) -> Self {
        let blocks = elements.div_ceil(BLOCK);
        let level_1_at = elements;
        if blocks <= 1 {
            return Self { level_1_at, level_2_at: level_1_at, total_at: level_1_at, count: 1 };
        }
        let level_2_at = level_1_at + blocks;
        if blocks <= BLOCK {
            return Self { level_1_at, level_2_at, total_at: level_2_at, count: 2 };
        }
        Self { level_1_at, level_2_at, total_at: level_2_at + blocks.div_ceil(BLOCK), count: 3 }
    }

    /// Bytes of the buffer that holds them.
    pub fn bytes(&self) -> u64 {
        ELEMENT_BYTES * (u64::from(self.total_at) + 1)
    }
}

/// The stages, one per level.
#[derive(Debug)]
pub(crate) struct SumStages {
    levels: [wgpu::ComputePipeline; 3],
}

impl SumStages {
    /// `bindings` are those of stages with sums: camera and settings at 0, sums at 3.
    pub fn new(device: &wgpu::Device, bindings: &[Option<&wgpu::BindGroupLayout>]) -> Self {
        let stage = |entry| compute_pipeline(device, PREFIX_SUM, entry, bindings);
        Self { levels: ["sum_level_0", "sum_level_1", "sum_level_2"].map(stage) }
    }

    /// Sums all levels, with the groups that are bound.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, levels: &Levels) {
        let starts = [0, levels.level_1_at, levels.level_2_at, levels.total_at];
        for (level, stage) in self.levels.iter().enumerate().take(levels.count as usize) {
            let blocks = (starts[level + 1] - starts[level]).div_ceil(BLOCK);
            pass.set_pipeline(stage);
            pass.dispatch_workgroups(blocks.min(LONGEST_ROW), blocks.div_ceil(LONGEST_ROW), 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_is_summed_and_the_last_is_one_block() {
        for elements in [1, 255, 256, 257, 65_536, 65_537, 100_000, MOST_ELEMENTS] {
            let levels = Levels::new(elements);
            let starts = [0, levels.level_1_at, levels.level_2_at, levels.total_at];
            for level in 0..levels.count as usize {
                let size = starts[level + 1] - starts[level];
                assert!(size > 0 && (size <= BLOCK) == (level + 1 == levels.count as usize), "{elements}: {levels:?}");
            }
            assert_eq!(starts[levels.count as usize], levels.total_at);
        }
    }
}
