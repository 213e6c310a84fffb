//! [`AdapterChoice`]: which adapters are acceptable.

/// Which adapters are acceptable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AdapterChoice {
    /// The best there is: discrete, integrated, virtual, then software.
    #[default]
    Any,
    /// Anything but software.
    Hardware,
    /// Software only: the same picture on every machine that has the same driver.
    Software,
}

impl AdapterChoice {
    /// Rank of a kind of adapter, lowest first; `None` where the choice excludes it.
    pub(crate) fn rank(self, kind: wgpu::DeviceType) -> Option<u32> {
        let rank = match kind {
            wgpu::DeviceType::DiscreteGpu => 0,
            wgpu::DeviceType::IntegratedGpu => 1,
            wgpu::DeviceType::VirtualGpu => 2,
            wgpu::DeviceType::Other => 3,
            wgpu::DeviceType::Cpu => 4,
        };
        let accepted = match self {
            Self::Any => true,
            Self::Hardware => kind != wgpu::DeviceType::Cpu,
            Self::Software => kind == wgpu::DeviceType::Cpu,
        };
        accepted.then_some(rank)
    }
}
