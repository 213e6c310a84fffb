//! [`LodMesh`]: levels of detail, chosen by their projected error.

use crate::lod_chain::{LodLevel, chain};
use crate::shading::Shading;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

silhouette_core::method_options! {
    /// Options of [`LodMesh`].
    pub struct LodMeshOptions {
        /// Error that a level may have in the image: the coarsest level within it is drawn, or the finest where none is.
        pub max_error: f64 = number("max-error", 0.0..=10000.0 "pixels", default 1.0, sweep log 0.25..=16.0),
        /// Most faces of the finest level, where memory is to be limited; 0 keeps the mesh itself.
        pub faces: u32 = whole("faces", 0..=1000000000, default 0),
        /// How faces look: lit from the viewer's upper left, or in one grey.
        pub shading: Shading = choice("shading"),
        /// Brightness of the surface, sRGB as displayed: 0 is black, 1 white.
        pub grey: f64 = number("grey", 0.0..=1.0, default 1.0),
    }
}

/// A chain of meshes, each with half the faces of the one before, of which each view draws the coarsest whose error stays
/// within a bound in pixels: what an engine would draw instead of a method with a finer outline than its mesh.
///
/// A level's error is the largest distance from a vertex of the mesh to the level's surface
/// ([`LodLevel::error`]), projected at the nearest depth of the mesh's bounding box. It bounds neither the distance of
/// points inside faces nor that of outlines, which differ by more where the surface curves away from the view: the comparison
/// measures those. Levels replace each other at once, without a transition.
///
/// Preparation simplifies, in O(F log F) expected; a view chooses in O(levels) and draws O(faces of the level) on the device.
/// Levels are those of the mesh that was prepared: positions that change later are not followed.
#[derive(Debug, Clone)]
pub struct LodMesh {
    pub(crate) options: LodMeshOptions,
    pub(crate) levels: Arc<[LodLevel]>,
}

impl LodMesh {
    /// Its levels, at least one, the finest first.
    pub fn levels(&self) -> &[LodLevel] {
        &self.levels
    }

    /// The index of the level for a view in which a unit of the mesh's space covers at most `px_per_unit` pixels: the coarsest
    /// whose error is within the option `max-error`, or 0, the finest, where none is.
    pub fn level_at(&self, px_per_unit: f64) -> usize {
        level_at(&self.levels, px_per_unit, self.options.max_error)
    }
}

/// [`LodMesh::level_at`] of these levels within `max_error_px`.
pub(crate) fn level_at(levels: &[LodLevel], px_per_unit: f64, max_error_px: f64) -> usize {
    levels.iter().rposition(|level| level.error * px_per_unit <= max_error_px).unwrap_or(0)
}

impl Method for LodMesh {
    type Options = LodMeshOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "lod-mesh",
        summary: "Draws the coarsest of a chain of simplified meshes whose error stays within a bound in pixels.",
        source: Source {
            authors: "James H. Clark",
            title: "Hierarchical geometric models for visible surface algorithms",
            venue: "Communications of the ACM 19 (10)",
            year: 1976,
        },
        exact: false,
        needs: &[],
        options: LodMeshOptions::SPECS,
        guide: MethodGuide {
            origin: "Clark 1976; levels by meshoptimizer",
            yields: "a filled image, its error in pixels bounded at the vertices",
            accuracy: "no: a vertex of the mesh is at most `max-error` pixels away",
            cost: "O(levels), then O(faces of the level) on the adapter",
            memory: "about 28 bytes per face of the finest level, all levels together",
            choose_when: "most views are far away, and you want what engines do: fewer triangles there",
            limits: "near by it draws the mesh as it is: no smoother, no faster",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &LodMeshOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let most_faces = if options.faces == 0 { usize::MAX } else { options.faces as usize };
        let levels = chain(mesh.mesh(), most_faces, progress)?.into();
        Ok(Self { options: *options, levels })
    }

    /// Bytes of all levels as engines store them, the mesh itself included where it is one: [`LodLevel::bytes`]. Normals are
    /// counted although faces are lit by their own, as other methods' states hold normals too.
    fn bytes(&self) -> usize {
        self.levels.iter().map(LodLevel::bytes).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_testing::prepare::prepared;
    use silhouette_testing::zoo;

    #[test]
    fn levels_are_the_coarsest_within_the_bound() {
        let mesh = prepared(zoo::builtin("blob:5000"));
        let strict = LodMesh::new(&mesh, LodMeshOptions { max_error: 0.0, ..LodMeshOptions::default() }).unwrap();
        let lod = LodMesh::new(&mesh, LodMeshOptions::default()).unwrap();
        assert_eq!(strict.levels(), lod.levels());
        let mut last = 0;
        for px_per_unit in (0..24).map(|step| 4000.0 * 0.7_f64.powi(step)) {
            let index = lod.level_at(px_per_unit);
            assert!(index >= last, "levels coarsen with distance");
            last = index;
            assert!(lod.levels()[index].error * px_per_unit <= 1.0);
            assert!(lod.levels()[index + 1..].iter().all(|coarser| coarser.error * px_per_unit > 1.0));
            assert_eq!(strict.level_at(px_per_unit), 0, "no error allowed");
        }
        assert!(last > 6 && lod.level_at(0.0) == lod.levels().len() - 1);
    }

    #[test]
    fn a_limited_chain_draws_its_finest_level_where_none_is_good_enough() {
        let mesh = prepared(zoo::builtin("blob:5000"));
        let [all, limited] =
            [0, 500].map(|faces| LodMesh::new(&mesh, LodMeshOptions { faces, ..LodMeshOptions::default() }).unwrap());
        assert_eq!(limited.level_at(1e9), 0);
        assert!(limited.levels()[0].mesh.face_count() <= 500 && 4 * limited.bytes() < all.bytes());
        assert_eq!(limited.bytes(), limited.levels().iter().map(LodLevel::bytes).sum::<usize>());
    }

    #[test]
    fn an_empty_mesh_is_one_level() {
        let lod: LodMesh = silhouette_testing::prepare::method(&prepared(zoo::empty()));
        assert_eq!((lod.levels().len(), lod.level_at(100.0), lod.bytes()), (1, 0, 0));
    }

    #[test]
    fn options_out_of_range_are_refused() {
        let options = LodMeshOptions { max_error: -1.0, ..LodMeshOptions::default() };
        assert!(matches!(LodMesh::new(&prepared(zoo::empty()), options), Err(PrepareError::Option(_))));
    }
}
