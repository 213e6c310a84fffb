//! Pipelines, bindings and buffers, as renderers that follow this crate's convention describe them.
//!
//! Every function here calls wgpu at once and keeps nothing. Errors that depend on the mesh are returned
//! ([`storage_buffer`]); what wgpu's validation refuses, such as a bind group that does not fit its layout, goes to the device's
//! error handler, as everywhere in wgpu.
//!
//! - [`RenderStage`] describes a render pipeline as far as it differs from the simplest one; [`compute_pipeline`] makes a compute
//!   pipeline, and [`workgroups`] counts what to dispatch. [`WoundPipeline`] culls in views that mirror as in others.
//! - [`bind_layout`] with [`uniform_entry`], [`storage_entry`], [`texture_entry`] and [`storage_texture_entry`]; [`bind_group`] and [`buffers_group`].
//! - [`UniformBlock`], a uniform buffer of one Rust type; [`storage_buffer`], checked against the device's limits.

mod bindings;
mod compute_pipeline;
mod render_stage;
mod storage_buffer;
mod uniform_block;
mod workgroups;
mod wound_pipeline;

pub use bindings::{
    bind_group, bind_layout, buffers_group, storage_entry, storage_texture_entry, texture_entry, uniform_entry,
};
pub use compute_pipeline::compute_pipeline;
pub use render_stage::RenderStage;
pub use storage_buffer::storage_buffer;
pub use uniform_block::UniformBlock;
pub use workgroups::{WORKGROUP, workgroups};
pub use wound_pipeline::WoundPipeline;
