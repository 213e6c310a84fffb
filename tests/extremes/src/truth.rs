//! [`Truth`]: what the methods are measured against in one scene, found when first asked for.

use crate::scene::Scene;
use silhouette_compare::metrics::{FilledPicture, Ink};
use silhouette_compare::truth::fill::FillTruth;
use silhouette_compare::truth::{TrueLines, Truth as ViewTruth, TruthFinder};
use silhouette_core::{NoProgress, PreparedMesh, SilhouetteEdges, Topology};
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_render::Gpu;
use silhouette_testing::integers::IntegerMesh;
use silhouette_testing::prepare::artefact;
use std::cell::OnceCell;
use std::sync::Arc;

/// The truth of a scene.
pub struct Truth<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The mesh where it is in the world.
    pub placed: Arc<PreparedMesh>,
    view: OnceCell<Result<(ViewTruth, TrueLines), String>>,
    edges: OnceCell<SilhouetteEdges>,
    fill: OnceCell<Result<FilledPicture, String>>,
}

impl<'a> Truth<'a> {
    /// Nothing is found yet.
    pub fn new(scene: &'a Scene) -> Self {
        let (view, edges, fill) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Self { scene, placed: scene.placed(), view, edges, fill }
    }

    /// The silhouette edges, by integers alone.
    pub fn edges(&self) -> &SilhouetteEdges {
        self.edges.get_or_init(|| {
            let topology: Arc<Topology> = artefact(&self.placed);
            IntegerMesh::new(self.placed.mesh(), topology).silhouette_edges(&self.scene.camera.viewpoint())
        })
    }

    fn view(&self) -> Result<&(ViewTruth, TrueLines), String> {
        let found = self.view.get_or_init(|| {
            let find = || {
                let mut finder = TruthFinder::new(&self.placed, &NoProgress)?;
                let truth = finder.find(&self.scene.camera, &NoProgress)?;
                let all = finder.lines_seen_or_not(&self.scene.camera, &NoProgress)?;
                Ok((truth, all))
            };
            find().map_err(|error: silhouette_compare::truth::TruthError| error.to_string())
        });
        found.as_ref().map_err(Clone::clone)
    }

    /// The visible lines.
    ///
    /// # Errors
    /// What the truth says where there is none.
    pub fn lines(&self) -> Result<&TrueLines, String> {
        Ok(&self.view()?.0.lines)
    }

    /// All lines, as if nothing hid them.
    ///
    /// # Errors
    /// What the truth says where there is none.
    pub fn all_lines(&self) -> Result<&TrueLines, String> {
        Ok(&self.view()?.1)
    }

    /// The visible lines as a pen draws them.
    ///
    /// # Errors
    /// What the truth says where there is none.
    pub fn pen(&self, placement: PenPlacement) -> Result<Ink, String> {
        Ok(self.view()?.0.draw(Pen { width_px: self.scene.pen_px, placement }))
    }

    /// The filled picture.
    ///
    /// # Errors
    /// What the device says where there is none.
    pub fn fill(&self, gpu: &Gpu) -> Result<&FilledPicture, String> {
        let found = self.fill.get_or_init(|| {
            let truth = FillTruth::new(gpu, self.placed.mesh());
            truth.and_then(|mut truth| truth.find(gpu, &self.scene.camera)).map_err(|error| error.to_string())
        });
        found.as_ref().map_err(Clone::clone)
    }
}
