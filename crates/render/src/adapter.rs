//! Reading the choice of an adapter, choosing one, and describing it.

use crate::adapter_choice::AdapterChoice;
use crate::error::GpuError;
use std::fmt;

/// Environment variable read by [`AdapterChoice::from_env`].
const VARIABLE: &str = "SILHOUETTES_ADAPTER";

impl AdapterChoice {
    /// `SILHOUETTES_ADAPTER=hardware` or `software`; [`Any`](Self::Any) where it is not set.
    ///
    /// # Errors
    /// [`GpuError::AdapterVariable`] for any other value.
    pub fn from_env() -> Result<Self, GpuError> {
        std::env::var_os(VARIABLE).map_or(Ok(Self::Any), |value| Self::parse(&value.to_string_lossy()))
    }

    fn parse(value: &str) -> Result<Self, GpuError> {
        match value {
            "" | "any" => Ok(Self::Any),
            "hardware" => Ok(Self::Hardware),
            "software" => Ok(Self::Software),
            _ => Err(GpuError::AdapterVariable { value: value.to_owned() }),
        }
    }
}

/// Name, driver and limits of an adapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AdapterDescription {
    /// Name of the device.
    pub name: String,
    /// Driver and its version.
    pub driver: String,
    /// Graphics interface: `Vulkan`, `Metal`, `Dx12`.
    pub backend: String,
    /// `discrete GPU`, `integrated GPU`, `virtual GPU`, `software` or `other`.
    pub kind: String,
    /// Whether the CPU does the work: pictures are right, times say nothing about a GPU.
    pub software: bool,
    /// Whether passes can be timed on the device.
    pub timestamps: bool,
    /// Greatest width and height of a texture.
    pub max_texture_px: u32,
}

impl AdapterDescription {
    pub(crate) fn new(adapter: &wgpu::Adapter) -> Self {
        let info = adapter.get_info();
        let kind = match info.device_type {
            wgpu::DeviceType::DiscreteGpu => "discrete GPU",
            wgpu::DeviceType::IntegratedGpu => "integrated GPU",
            wgpu::DeviceType::VirtualGpu => "virtual GPU",
            wgpu::DeviceType::Cpu => "software",
            wgpu::DeviceType::Other => "other",
        };
        Self {
            name: info.name,
            driver: format!("{} {}", info.driver, info.driver_info).trim().to_owned(),
            backend: format!("{:?}", info.backend),
            kind: kind.to_owned(),
            software: info.device_type == wgpu::DeviceType::Cpu,
            timestamps: adapter.features().contains(wgpu::Features::TIMESTAMP_QUERY),
            max_texture_px: adapter.limits().max_texture_dimension_2d,
        }
    }
}

impl fmt::Display for AdapterDescription {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, driver, backend, kind, timestamps, max_texture_px, .. } = self;
        let timing = if *timestamps { "with" } else { "without" };
        write!(f, "{name} ({kind}, {backend}, {driver}), {timing} timestamps, textures to {max_texture_px} px")
    }
}

/// The best adapter that `choice` accepts; of equally good ones the first that the system lists.
pub(crate) fn choose(instance: &wgpu::Instance, choice: AdapterChoice) -> Result<wgpu::Adapter, GpuError> {
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Instance::enabled_backend_features()));
    let seen = adapters.iter().map(|adapter| adapter.get_info().name).collect::<Vec<_>>();
    let ranked = adapters.into_iter().filter_map(|adapter| {
        let rank = choice.rank(adapter.get_info().device_type)?;
        Some((rank, adapter))
    });
    let best = ranked.min_by_key(|&(rank, _)| rank);
    best.map(|(_, adapter)| adapter).ok_or(GpuError::NoAdapter { choice, seen })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hardware_comes_first_and_software_counts() {
        use wgpu::DeviceType::{Cpu, DiscreteGpu, IntegratedGpu, Other, VirtualGpu};
        let order = [DiscreteGpu, IntegratedGpu, VirtualGpu, Other, Cpu].map(|kind| AdapterChoice::Any.rank(kind));
        assert!(order.is_sorted() && order.iter().all(Option::is_some));
        assert_eq!(AdapterChoice::Hardware.rank(Cpu), None);
        assert!(AdapterChoice::Hardware.rank(Other).is_some());
        assert_eq!(AdapterChoice::Software.rank(DiscreteGpu), None);
        assert!(AdapterChoice::Software.rank(Cpu).is_some());
    }

    #[test]
    fn unknown_choices_are_refused() {
        assert_eq!(AdapterChoice::parse("software").unwrap(), AdapterChoice::Software);
        assert_eq!(AdapterChoice::parse("").unwrap(), AdapterChoice::Any);
        let message = AdapterChoice::parse("cpu").unwrap_err().to_string();
        assert!(message.contains("'cpu'") && message.contains("hardware"), "{message}");
    }
}
