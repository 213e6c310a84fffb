//! [`Smoothing`]: the whole method on the CPU.

use crate::concavity::{blocking_plane, is_concave};
use crate::curves::CurveWalker;
use crate::eye::{Eye, SmoothingView};
use crate::feature_polylines::{FeaturePolyline, feature_polylines};
use crate::feature_samples::FeatureSamples;
use crate::feature_segments::FeatureSegments;
use crate::options::{Invisible, SmoothingOptions};
use crate::perturbation::{Perturbation, Perturber};
use crate::published::PUBLISHED;
use crate::remeshing::{Curves, LocalRemeshing};
use crate::sampling::segments;
use crate::shading_mesh::ShadingMesh;
use crate::silhouette_segments::SilhouetteSegments;
use crate::silhouette_triangles::{SilhouetteTriangle, silhouette_triangles};
use crate::vertex_visibility::VertexVisibility;
use crate::view_mesh::{MakesTriangles, Remesher, ViewMesh, reach};
use silhouette_core::glam::DVec3;
use silhouette_core::method::{ExtractionStats, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    ExtractsCurves, Method, MethodGuide, MethodInfo, MethodOptions, PreparedMesh, Progress, SilhouetteCurves, Topology,
    Viewpoint,
};
use std::sync::Arc;

/// Silhouettes of a coarse mesh as smooth curves, and the mesh re-meshed around them. See the [crate].
///
/// O(V + F) per view for classification and output, O(S) for curves, S being the number of silhouette triangles.
#[derive(Debug, Clone)]
pub struct Smoothing {
    fixed: Arc<Fixed>,
    visibility: VertexVisibility,
    triangles: Vec<SilhouetteTriangle>,
    silhouette: SilhouetteSegments,
    samples: FeatureSamples,
    counts: Vec<u32>,
    remeshing: LocalRemeshing,
    perturber: Perturber,
    walker: CurveWalker,
}

/// What does not depend on the view.
#[derive(Debug)]
struct Fixed {
    options: SmoothingOptions,
    mesh: ShadingMesh,
    polylines: Vec<FeaturePolyline>,
    features: FeatureSegments,
}

impl Method for Smoothing {
    type Options = SmoothingOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "smoothing",
        summary: "Hermite curves through the triangles that the silhouette crosses, and the mesh re-meshed around them.",
        source: Source {
            authors: "Lu Wang, Changhe Tu, Wenping Wang, Xiangxu Meng, Bin Chan, Dongming Yan",
            title: "Silhouette Smoothing for Real-time Rendering of Mesh Surfaces",
            venue: "IEEE Transactions on Visualization and Computer Graphics 14(3)",
            year: 2008,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: SmoothingOptions::SPECS,
        guide: MethodGuide {
            origin: "Wang et al. 2008, corrected",
            yields: "smooth curves; a filled image, re-meshed where the silhouette runs",
            accuracy: "no: a sphere of 80 faces is off by 0.0004 radii, with about 150 triangles",
            cost: "O(V + F) to classify vertices and copy faces, O(S) for curves; one thread, 170 to 450 ns per \
                   silhouette triangle",
            memory: "150 to 220 bytes per face",
            choose_when: "a coarse mesh should have a smooth outline, for one view at a time",
            limits: "gains little on simplified scans, whose normals are guesses, and loses on some; silhouettes \
                     that lie within one face are missed; rounded valleys may be taken for smooth curves",
        },
        published: PUBLISHED,
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &SmoothingOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let mesh = ShadingMesh::new(mesh, options.crease_deg, options.normals, Self::INFO.name, progress)?;
        progress.check()?;
        let polylines = feature_polylines(mesh.mesh(), mesh.topology(), mesh.features(), options.corner_deg);
        let features =
            FeatureSegments::new(mesh.mesh(), mesh.topology(), mesh.features(), &polylines, options.tangents);
        progress.check()?;
        let perturber = Perturber::new(&mesh, options.perturbation, progress)?;
        Ok(Self {
            visibility: VertexVisibility::new(&mesh, options.cells),
            triangles: Vec::new(),
            silhouette: SilhouetteSegments::default(),
            samples: FeatureSamples::default(),
            counts: Vec::new(),
            remeshing: LocalRemeshing::default(),
            perturber,
            walker: CurveWalker::default(),
            fixed: Arc::new(Fixed { options: *options, mesh, polylines, features }),
        })
    }

    fn bytes(&self) -> usize {
        self.fixed.mesh.bytes()
            + self.fixed.features.bytes()
            + self.visibility.bytes()
            + self.silhouette.bytes()
            + self.samples.bytes()
            + self.remeshing.bytes()
            + self.perturber.bytes()
            + size_of_val(self.triangles.as_slice())
            + size_of_val(self.counts.as_slice())
    }
}

impl Smoothing {
    /// Its options.
    pub fn options(&self) -> &SmoothingOptions {
        &self.fixed.options
    }

    /// The mesh with its shading normals.
    pub fn shading_mesh(&self) -> &ShadingMesh {
        &self.fixed.mesh
    }

    /// The smoothed feature edges.
    pub fn features(&self) -> &FeatureSegments {
        &self.fixed.features
    }

    /// The chains of its feature edges.
    #[cfg(feature = "gpu")]
    pub(crate) fn polylines(&self) -> &[FeaturePolyline] {
        &self.fixed.polylines
    }

    /// Pieces of each segment of the view last sampled.
    #[cfg(all(test, feature = "gpu"))]
    pub(crate) fn counts(&self) -> &[u32] {
        &self.counts
    }

    /// Visibility, silhouette triangles, silhouette points and segments of a view. Yields what was looked at; the results are
    /// read by [`silhouette`](Self::silhouette).
    pub fn find_silhouette(&mut self, eye: Eye) -> ExtractionStats {
        let Fixed { options, mesh, features, .. } = &*self.fixed;
        self.perturber.clear();
        let tested = self.visibility.classify(mesh, eye);
        silhouette_triangles(mesh.triangles(), self.visibility.is_visible(), &mut self.triangles);
        self.silhouette.find(mesh, features, &self.triangles, eye, options.newton_steps, options.segments);
        ExtractionStats {
            faces_tested: mesh.triangles().len() as u64,
            edges_tested: self.silhouette.points().len() as u64,
            nodes_visited: tested.cells,
            exact_fallbacks: 0,
        }
    }

    /// The silhouette of the view last found.
    pub fn silhouette(&self) -> &SilhouetteSegments {
        &self.silhouette
    }

    /// Adaptive sampling: how finely the curves of the view last found are sampled.
    pub fn sample(&mut self, view: &SmoothingView) {
        let Fixed { options, mesh, features, .. } = &*self.fixed;
        self.counts.clear();
        for segment in self.silhouette.segments() {
            let normals = segment.points.map(|point| self.silhouette.points()[point as usize].normal);
            self.counts.push(segments(&segment.curve, normals, view, options.tolerance_px, options.sampling));
        }
        let is_visible = self.visibility.is_visible();
        self.samples.find(mesh, features, &self.silhouette, is_visible, view, options.tolerance_px);
    }

    /// Finds the vertices that would hide concave silhouette segments, and where [`local_remeshing`](Self::local_remeshing) puts
    /// them. Yields how many segments are concave.
    pub fn perturb(&mut self, eye: Eye) -> usize {
        let Fixed { options, mesh, .. } = &*self.fixed;
        if options.perturbation == Perturbation::Off {
            return 0;
        }
        let mut concave = 0;
        for segment in self.silhouette.segments() {
            let ends = segment.points.map(|point| &self.silhouette.points()[point as usize]);
            if is_concave(ends)
                && let Some(plane) = blocking_plane(segment, ends, eye)
            {
                self.perturber.push(segment.triangle.face, plane);
                concave += 1;
            }
        }
        self.perturber.find(mesh);
        concave
    }

    /// Local re-meshing: replaces `out`, which has to be empty or as the last call left it, by the triangles of the view last
    /// sampled, with the vertices that were perturbed. With an eye, triangles of invisible parts that it sees from behind are left
    /// out; see [`remeshing`](crate::remeshing) for when that shows.
    pub fn local_remeshing(&mut self, left_out_from: Option<Eye>, out: &mut ViewMesh) {
        let Fixed { mesh, features, .. } = &*self.fixed;
        let curves = Curves {
            mesh,
            features,
            samples: &self.samples,
            silhouette: &self.silhouette,
            counts: &self.counts,
            moved: self.perturber.moved(),
            left_out_from,
        };
        self.remeshing.remesh(&curves, out);
    }

    /// Makes the triangles that are drawn for a view, which are fewer than those of [`Remesher::remesh`] by the option `invisible`.
    pub fn drawn(&self) -> DrawnSmoothing {
        let mesh = &self.fixed.mesh;
        let reach = reach(mesh.mesh()).max(self.fixed.features.reach());
        let ball = mesh.mesh().bounds().map(|bounds| (bounds.center, bounds.radius + reach));
        DrawnSmoothing { ball: ball.filter(|_| self.may_leave_out()), smoothing: self.clone() }
    }

    /// Whether there are views in which parts may be left out.
    pub(crate) fn may_leave_out(&self) -> bool {
        self.fixed.options.invisible == Invisible::LeftOut && self.fixed.mesh.is_closed()
    }

    fn remesh_leaving_out(&mut self, view: &SmoothingView, left_out_from: Option<Eye>, out: &mut ViewMesh) {
        self.find_silhouette(view.eye());
        self.sample(view);
        self.perturb(view.eye());
        self.local_remeshing(left_out_from, out);
    }
}

impl Remesher for Smoothing {
    fn remesh(&mut self, view: &SmoothingView, out: &mut ViewMesh) -> bool {
        self.remesh_leaving_out(view, None, out);
        true
    }
}

/// Makes the triangles of [`Smoothing`] that are drawn; see [`Smoothing::drawn`].
#[derive(Debug, Clone)]
pub struct DrawnSmoothing {
    smoothing: Smoothing,
    /// What holds the surface in any view; `None` where nothing is ever left out.
    ball: Option<(DVec3, f64)>,
}

impl Remesher for DrawnSmoothing {
    fn remesh(&mut self, view: &SmoothingView, out: &mut ViewMesh) -> bool {
        let is_whole = self.ball.is_some_and(|(center, radius)| view.holds(center, radius));
        self.smoothing.remesh_leaving_out(view, is_whole.then(|| view.eye()), out);
        true
    }
}

impl MakesTriangles for Smoothing {
    type Remesher = Self;

    fn remesher(&self) -> Self {
        self.clone()
    }
}

impl ExtractsCurves for Smoothing {
    fn extract_curves(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteCurves) -> ExtractionStats {
        let eye = Eye::from(*viewpoint);
        let stats = self.find_silhouette(eye);
        let Fixed { mesh, features, polylines, .. } = &*self.fixed;
        out.clear();
        self.walker.silhouette(mesh, &self.silhouette, out);
        self.walker.features(mesh, features, polylines, &self.silhouette, self.visibility.is_visible(), out);
        stats
    }
}
