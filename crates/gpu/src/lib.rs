#![doc = include_str!("../README.md")]
//!
//! # Calls
//!
//! 1. Once per device and formats, a method makes its [pipelines](DrawsLines::pipelines); once per mesh, there are
//!    [`MeshBuffers`]; once per instance in a scene, a [renderer](DrawsLines::renderer) shares both.
//! 2. Once per frame, the application makes a [`FrameView`], from a camera or from its own matrices, and calls
//!    [`FrameRenderer::prepare`], which uploads what changed, [`FrameRenderer::encode`] with its encoder, and, in a render pass whose
//!    attachments match [`TargetFormats`], [`FrameRenderer::draw`].
//!
//! Colours are [sRGB as displayed](Color), blended premultiplied; a
//! target takes them [as linear light or as they are](TargetFormats::is_linear).
//!
//! Beside the convention lies what renderers share: [`StrokeRenderer`] for polylines and [`EdgeRenderer`] for edges found on the
//! CPU, [`FillRenderer`] for the mesh itself, [`WidthOverDepth`] for widths in any unit, [`LinePolygon`] for lines that a vertex stage expands, the [`kit`] of pipelines and
//! bindings. Positions on the device are relative to a [`LocalFrame`], so that a mesh far from the origin is drawn as sharply as
//! one at the origin.

mod camera;
pub mod color;
mod depth_law;
mod edge_renderer;
mod fill;
mod formats;
mod frame_renderer;
mod frame_view;
mod frame_view_error;
pub mod kit;
mod line_polygon;
mod local_frame;
mod mesh_binding;
mod mesh_buffers;
mod pen;
mod renderer_error;
mod strokes;
mod surface;
mod width_over_depth;

pub use camera::{CameraBinding, CameraUniform};
pub use color::Color;
pub use depth_law::DepthLaw;
pub use edge_renderer::EdgeRenderer;
pub use fill::{Cull, FillPipelines, FillRenderer, FillStyle, Shade};
pub use formats::TargetFormats;
pub use frame_renderer::{DrawsLines, FillsImage, FrameRenderer};
pub use frame_view::{FrameView, Viewport};
pub use frame_view_error::FrameViewError;
pub use line_polygon::{LinePolygon, LineShape, Rounding};
pub use local_frame::LocalFrame;
pub use mesh_binding::MeshBinding;
pub use mesh_buffers::{MeshBuffers, MeshTooLarge, POSITION_LAYOUT, PositionBufferError};
pub use pen::{Pen, PenPlacement};
pub use renderer_error::RendererError;
pub use strokes::{
    Cap, DepthScale, Hidden, Interior, Join, Polylines, Projector, SceneDepth, ScreenSegment, StrokePipelines,
    StrokeRenderer, StrokeStyle,
};
pub use surface::SurfaceUniform;
pub use width_over_depth::WidthOverDepth;
