//! Edge mesh.
#[cfg(feature = "gpu")]
pub mod as_printed;
mod builder;
#[cfg(feature = "gpu")]
mod chunks;
#[cfg(feature = "gpu")]
pub mod drawn_edges;
#[cfg(feature = "gpu")]
mod edge_buffers;
pub mod edge_record;
#[cfg(feature = "gpu")]
pub mod face_planes;
#[cfg(feature = "gpu")]
mod lines;
mod method;
pub mod oct_normal;
pub mod options;
#[cfg(feature = "gpu")]
mod pipelines;
#[cfg(feature = "gpu")]
mod renderer;
#[cfg(feature = "gpu")]
mod style;
mod zero_area;

pub use edge_record::EdgeRecord;
pub use method::{EdgeMesh, TooManyElements};
pub use options::EdgeMeshOptions;
#[cfg(feature = "gpu")]
pub use pipelines::Pipelines;
#[cfg(feature = "gpu")]
pub use renderer::Renderer;
