//! What is drawn: the edge mesh in each of its forms, and the others.

use crate::drawings::drawing;
use crate::error::Cause;
use silhouette_compare::NamedMesh;
use silhouette_compare::drawing::{Drawing, FrameStyle, Ground};
use silhouette_compare::registry::Registry;
use silhouette_compare::runner::DEFAULT_PEN_WIDTH_PX;
use silhouette_compare::scene::BUILTIN;
use silhouette_core::shapes::by_name;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_render::Gpu;
use std::sync::Arc;

/// A method with its options.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Drawn {
    /// What tables call it.
    pub label: &'static str,
    /// Its name in the registry.
    pub method: &'static str,
    /// Its options as words.
    pub words: &'static str,
}

/// The article's own arithmetic.
pub const AS_PRINTED: Drawn = drawn("edge mesh, as printed", "edge-mesh", "arithmetic=as-printed");

/// Every edge in one draw.
pub const VERTEX_STAGE: Drawn = drawn("edge mesh", "edge-mesh", "path=vertex-stage");

/// Drawn edges listed by a compute stage.
pub const COMPACTED: Drawn = drawn("edge mesh, compacted", "edge-mesh", "path=compacted");

/// What tables set beside each other, in their order.
pub const METHODS: [Drawn; 10] = [
    VERTEX_STAGE,
    COMPACTED,
    AS_PRINTED,
    drawn("extraction and upload", "brute-force", ""),
    drawn("image precision", "image-precision", ""),
    drawn("inverted hull", "inverted-hull", ""),
    drawn("inverted hull, split normals", "inverted-hull", "normals=split"),
    drawn("G-buffer filter, Sobel", "gbuffer-filter", "operator=sobel"),
    drawn("G-buffer filter, Roberts", "gbuffer-filter", "operator=roberts"),
    drawn("jump flood", "jump-flood", ""),
];

const fn drawn(label: &'static str, method: &'static str, words: &'static str) -> Drawn {
    Drawn { label, method, words }
}

impl Drawn {
    /// Its drawing of a mesh, `more` options added.
    ///
    /// # Errors
    /// [`Cause`]: a device that failed or cannot hold the mesh.
    pub fn drawing(
        &self,
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        more: &str,
        size: [u32; 2],
        progress: &dyn Progress,
    ) -> Result<Drawing, Cause> {
        let registry = Registry::builtin();
        let entry = registry.find(self.method)?;
        drawing(gpu, mesh, entry, &format!("{} {more}", self.words), style(size), progress)
    }
}

/// A built-in shape, with the name that the command line gives it.
///
/// # Errors
/// [`Cause`], which a shape that exists rules out.
pub fn builtin(name: &str) -> Result<NamedMesh, Cause> {
    Ok(NamedMesh { name: format!("{BUILTIN}{name}"), mesh: Arc::new(PreparedMesh::new(by_name(name)?)) })
}

/// How pictures are drawn: one sample per pixel, the pen of every comparison.
pub fn style(size: [u32; 2]) -> FrameStyle {
    FrameStyle { size, pen_width_px: DEFAULT_PEN_WIDTH_PX, samples: 1, ground: Ground::Paper }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::method::OptionValues;
    use std::collections::BTreeSet;

    #[test]
    fn every_method_exists_with_its_options_and_a_label_of_its_own() {
        let registry = Registry::builtin();
        for Drawn { label, method, words } in METHODS {
            let entry = registry.find(method).unwrap();
            assert!(OptionValues::parse(entry.info().options, words.split_whitespace()).is_ok(), "{label}");
            assert!(entry.capabilities().lines || entry.capabilities().edges, "{label}");
        }
        assert_eq!(METHODS.map(|drawn| drawn.label).iter().collect::<BTreeSet<_>>().len(), METHODS.len());
    }
}
