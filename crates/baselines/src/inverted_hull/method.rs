//! [`InvertedHull`]: what the method says of itself, and its preparation.

use super::outline_normals::OutlineNormals;
use crate::line_options::line_method_options;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::option_choice;
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

option_choice! {
    /// What vertices are pushed along.
    pub enum HullNormals {
        /// The mean normal of all faces at their place, whether they share a vertex there or not.
        Welded = "welded",
        /// Each face's own normal, as render normals of a faceted mesh have it: the hull tears at hard edges.
        Split = "split",
    }
}

option_choice! {
    /// Where vertices are pushed.
    pub enum Push {
        /// In the image, by the width, along the projection of the normal.
        Image = "image",
        /// In space, along the normal, by what the width comes to at the depth of the mesh's middle: lines thin with distance,
        /// and where normals lean towards the viewer.
        World = "world",
    }
}

line_method_options! {
    /// Options of [`InvertedHull`].
    pub struct InvertedHullOptions {
        /// What vertices are pushed along: the mean normal at their place, or each face's own, which tears at hard edges.
        pub normals: HullNormals = choice("normals"),
        /// Where vertices are pushed: by the width in the image, or in space by what it comes to at the mesh's middle.
        pub push: Push = choice("push"),
    }
}

/// Outlines as engines have drawn them the longest: the mesh's back faces, pushed outwards, in ink.
///
/// O(V + F) on the CPU to prepare; O(F) per view on the device, and nothing on the CPU. 8 bytes per vertex and 12 per face, on the
/// CPU and on the device, and 16 for each place where vertices lie; nothing with `normals=split`.
///
/// Ink lies outside. It is as wide as asked where the outline is smooth. Where it turns by an angle b at a vertex, the vertex
/// moves by the width and the lines beside it are `cos(b / 2)` of the width wide: 0.71 at a right angle.
///
/// # Failures
/// A flat open mesh has no outline: its vertices are pushed along the sight line. The back of an open mesh is ink all over, and so
/// is everything from inside a closed one. Parts thinner than the push, and concave ones, show ink of the far side of the hull.
#[derive(Debug, Clone)]
pub struct InvertedHull {
    #[cfg_attr(not(feature = "gpu"), allow(dead_code, reason = "what options are for is on the device"))]
    pub(super) options: InvertedHullOptions,
    pub(super) normals: Option<Arc<OutlineNormals>>,
}

impl Method for InvertedHull {
    type Options = InvertedHullOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "inverted-hull",
        summary: "Draws the mesh's back faces once more, pushed outwards, in ink: what engines ship for outlines.",
        source: Source {
            authors: "Tomas Akenine-Möller, Eric Haines, Naty Hoffman and others",
            title: "Real-Time Rendering, 4th edition: procedural geometry silhouetting",
            venue: "CRC Press",
            year: 2018,
        },
        exact: false,
        needs: &[],
        options: InvertedHullOptions::SPECS,
        guide: MethodGuide {
            origin: "what engines ship: back faces pushed outwards",
            yields: "ink",
            accuracy: "no: as wide as asked where the outline is smooth, thinner at corners",
            cost: "O(F) on the adapter, none on the processor",
            memory: "8 bytes per vertex, 12 per face, 16 per place where vertices lie",
            choose_when: "outlines are wanted in one more draw call, meshes are closed and smooth, and line ends may \
                          open",
            limits: "flat open meshes have no lines; of closed models it missed 13 to 23 % of the lines inside of \
                     the outline",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &InvertedHullOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let is_welded = options.normals == HullNormals::Welded;
        let normals = is_welded.then(|| OutlineNormals::with_progress(mesh.mesh(), progress)).transpose()?;
        Ok(Self { options: *options, normals: normals.map(Arc::new) })
    }

    fn bytes(&self) -> usize {
        self.normals.as_ref().map_or(0, |normals| normals.bytes())
    }
}
