//! What this crate draws and reads back, on whatever adapter there is.

mod errors;
mod face_ids;
mod hidden_lines;
mod reference_images;
mod scenes;
mod strokes;
mod targets;
mod waiting;
