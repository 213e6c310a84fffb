//! Lines become strokes on a page, and files that other programs read.

mod dashes;
mod files;
mod formats;
mod scans;
mod scene;
mod steps;
mod strokes;
