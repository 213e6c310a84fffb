//! Pictures that stand beside the tables.

use silhouette_render::Image;

/// A picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Its file, a PNG.
    pub file_name: &'static str,
    /// What it shows.
    pub title: String,
    /// The picture.
    pub image: Image,
}
