//! [`GpuError`]: everything that can go wrong between here and a GPU.

use crate::adapter_choice::AdapterChoice;
use silhouette_gpu::{FrameViewError, MeshTooLarge, RendererError};

/// What went wrong on the way to the GPU or on it. Nothing here is a panic.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no acceptable adapter.
    #[error("{}", no_adapter(*choice, seen))]
    NoAdapter {
        /// What was asked for.
        choice: AdapterChoice,
        /// Names of the adapters that exist.
        seen: Vec<String>,
    },
    /// `SILHOUETTES_ADAPTER` holds something else than a choice.
    #[error("SILHOUETTES_ADAPTER is '{value}'; it may be hardware, software or any")]
    AdapterVariable {
        /// What it holds.
        value: String,
    },
    /// The adapter gave no device.
    #[error("the adapter gave no device: {0}; update its driver, or choose another with SILHOUETTES_ADAPTER=software")]
    NoDevice(wgpu::RequestDeviceError),
    /// Something was used wrongly: a defect of the caller or of this crate.
    #[error("wgpu refused: {0}; this is a defect, please report it")]
    Validation(String),
    /// The device has no memory left.
    #[error("the GPU is out of memory; use a smaller size or fewer samples")]
    OutOfMemory,
    /// The driver failed.
    #[error("the GPU driver failed: {0}; update it, or draw in software with SILHOUETTES_ADAPTER=software")]
    Internal(String),
    /// The device is gone (driver reset, unplugged, destroyed); a new [`Gpu`](crate::Gpu) is needed.
    #[error("the GPU device was lost: {0}; run it again, with fewer or smaller pictures if that repeats")]
    Lost(String),
    /// The device did not finish in time.
    #[error("the GPU did not finish within {seconds} s; use a smaller size or a simpler mesh")]
    TimedOut {
        /// How long was waited.
        seconds: u64,
    },
    /// A width or height beyond what the adapter can make, or zero.
    #[error("{width}x{height} pixels do not fit this adapter: 1x1 to {limit}x{limit} are possible")]
    Size {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
        /// Greatest width and height.
        limit: u32,
    },
    /// More memory than the budget allows. Software adapters never report that memory ran out; they are killed.
    #[error("this needs {bytes} bytes, the memory budget is {budget}; use a smaller size or fewer samples")]
    OverBudget {
        /// Bytes needed.
        bytes: u64,
        /// Bytes allowed.
        budget: u64,
    },
    /// The mesh does not fit a buffer.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// A renderer could not be made, or a view not be prepared.
    #[error(transparent)]
    Renderer(#[from] RendererError),
    /// A camera makes no view.
    #[error(transparent)]
    View(#[from] FrameViewError),
    /// Depth was asked of a target with several samples per pixel.
    #[error("depth can be used from targets with 1 sample per pixel; this one has {samples}")]
    MultisampledDepth {
        /// Samples per pixel of the target.
        samples: u32,
    },
    /// A sample count other than 1 and 4, or a supersampling outside 1 to 16.
    #[error("{samples} samples are not possible: {possible}")]
    Samples {
        /// What was asked for.
        samples: u32,
        /// What there is.
        possible: &'static str,
    },
    /// A colour format that cannot be read back as RGBA bytes.
    #[error("colour of format {0:?} cannot be read back; use Rgba8Unorm or Rgba8UnormSrgb")]
    ColorFormat(wgpu::TextureFormat),
}

impl From<wgpu::RequestDeviceError> for GpuError {
    fn from(cause: wgpu::RequestDeviceError) -> Self {
        Self::NoDevice(cause)
    }
}

impl From<wgpu::Error> for GpuError {
    fn from(error: wgpu::Error) -> Self {
        match error {
            wgpu::Error::OutOfMemory { .. } => Self::OutOfMemory,
            wgpu::Error::Validation { description, .. } => Self::Validation(description),
            wgpu::Error::Internal { description, .. } => Self::Internal(description),
        }
    }
}

fn no_adapter(choice: AdapterChoice, seen: &[String]) -> String {
    let what = match choice {
        AdapterChoice::Any => "no GPU adapter was found",
        AdapterChoice::Hardware => "no hardware GPU adapter was found",
        AdapterChoice::Software => "no software GPU adapter was found",
    };
    let there = match seen {
        [] => String::new(),
        seen => format!(" (there is {}, which SILHOUETTES_ADAPTER excludes)", seen.join(", ")),
    };
    let remedy = match choice {
        AdapterChoice::Hardware => {
            "install the GPU vendor's Vulkan driver, or accept software with SILHOUETTES_ADAPTER=any"
        }
        AdapterChoice::Any | AdapterChoice::Software => {
            "on Debian or Ubuntu run `apt-get install mesa-vulkan-drivers libvulkan1`; on other Linux systems install \
             Mesa's Vulkan drivers and the Vulkan loader; on Windows and macOS update the graphics driver"
        }
    };
    format!("{what}{there}: {remedy}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_adapter_names_the_remedy() {
        let error = GpuError::NoAdapter { choice: AdapterChoice::Any, seen: vec![] };
        assert!(error.to_string().contains("apt-get install mesa-vulkan-drivers libvulkan1"));
        let error = GpuError::NoAdapter { choice: AdapterChoice::Hardware, seen: vec!["llvmpipe".to_owned()] };
        assert!(error.to_string().contains("llvmpipe") && error.to_string().contains("SILHOUETTES_ADAPTER=any"));
    }
}
