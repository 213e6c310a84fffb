//! [`TruthFinder`]: the steps in order.

use super::mesh_facts::{CREASE_DEG, MeshFacts};
use super::pen;
use super::samples::TrueLines;
use super::view_facts::{SeenMesh, ViewFacts};
use super::visible::{Silhouette, VisibleLine, visible_lines};
use crate::metrics::ink::Ink;
use silhouette_core::method::PrepareError;
use silhouette_core::view::Camera;
use silhouette_core::{Cancelled, FaceFacings, PreparedMesh, Progress, Quiet, SilhouetteEdges, Topology};
use silhouette_gpu::Pen;
use silhouette_visibility::{LineError, LineFinder, LineOptions, LineScene, Lines, Outline};
use std::sync::Arc;

/// Why there is no truth.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TruthError {
    /// The preparation was cancelled.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The view is too crowded to be decided, or the work was stopped.
    #[error(transparent)]
    Lines(#[from] LineError),
}

impl From<Cancelled> for TruthError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Prepare(cancelled.into())
    }
}

/// Finds the truth of any view of a mesh.
pub struct TruthFinder {
    mesh: Arc<PreparedMesh>,
    topology: Arc<Topology>,
    lines: LineFinder,
    facings: FaceFacings,
    facts: MeshFacts,
}

/// The truth of one view.
#[derive(Debug)]
pub struct Truth {
    /// The view.
    pub camera: Camera,
    /// All silhouette edges by Hall's definition, visible or not.
    pub edges: SilhouetteEdges,
    /// The visible lines, sampled.
    pub lines: TrueLines,
    /// The visible lines, a front face on their left.
    pub visible: Vec<VisibleLine>,
}

impl Truth {
    /// The visible lines as a pen draws them. O(pixels + n log n) for n segments.
    pub fn draw(&self, pen: Pen) -> Ink {
        pen::draw(&self.visible, pen, self.camera.size())
    }
}

/// The lines whose visibility the truth needs: every silhouette edge and nothing else.
pub fn silhouette_options() -> LineOptions {
    LineOptions { back_boundary: false, material: false, curves: false, ..LineOptions::default() }
}

/// Nothing for a view that is too crowded; any other error stays one.
fn unless_crowded<T>(found: Result<T, LineError>) -> Result<Option<T>, LineError> {
    match found {
        Err(LineError::TooCrowded) => Ok(None),
        found => found.map(Some),
    }
}

impl TruthFinder {
    /// Prepares for a mesh: topology and face tree. O(F log F).
    ///
    /// # Errors
    /// [`TruthError::Prepare`].
    pub fn new(mesh: &Arc<PreparedMesh>, progress: &dyn Progress) -> Result<Self, TruthError> {
        let topology: Arc<Topology> = mesh.artefact("truth", progress).map_err(PrepareError::from)?;
        Ok(Self {
            mesh: Arc::clone(mesh),
            facts: MeshFacts::new(mesh.mesh(), &topology),
            topology,
            lines: LineFinder::new(LineScene::new(Arc::clone(mesh)), progress)?,
            facings: FaceFacings::default(),
        })
    }

    /// The mesh as a camera sees it, for questions about edges and faces.
    pub fn seen<'a>(&'a self, camera: &'a Camera) -> SeenMesh<'a> {
        SeenMesh { mesh: self.mesh.mesh(), topology: &self.topology, facts: &self.facts, camera }
    }

    /// What is known to make methods err at each place of the lines of a view, and of lines that ink within `reach_px` may lie
    /// on: true lines, silhouette and boundary edges that are hidden, and creases that are seen. Those of a view that is too
    /// crowded for them are left out. O(as [`find`](Self::find)).
    ///
    /// # Errors
    /// [`TruthError`], cancelled only.
    pub fn facts(&mut self, truth: &Truth, reach_px: f64, progress: &dyn Progress) -> Result<ViewFacts, TruthError> {
        let every = LineOptions { max_invisibility: u32::MAX, back_boundary: true, ..silhouette_options() };
        let creases = LineOptions {
            silhouette: false,
            boundary: false,
            ridge_deg: Some(CREASE_DEG),
            valley_deg: Some(CREASE_DEG),
            ..silhouette_options()
        };
        let mut chains = Vec::new();
        for options in [every, creases] {
            chains.extend(unless_crowded(self.lines.find(&truth.camera, &options, &Quiet(progress)))?);
        }
        let chains: Vec<_> = chains.into_iter().map(|lines| lines.chains).collect();
        let outline = self.outline(&truth.camera, progress)?;
        Ok(ViewFacts::new(&self.seen(&truth.camera), &truth.lines, outline.as_ref(), &chains, reach_px))
    }

    /// Number of faces of the mesh that are wound inwards.
    pub fn inward_faces(&self) -> usize {
        self.facts.inward_faces()
    }

    /// Number of edges of the mesh.
    pub fn edge_count(&self) -> usize {
        self.topology.edge_count()
    }

    /// The truth of a view. O(F + S log S + crossings in the picture + length of lines).
    ///
    /// # Errors
    /// [`TruthError::Lines`].
    pub fn find(&mut self, camera: &Camera, progress: &dyn Progress) -> Result<Truth, TruthError> {
        let (edges, visible) = self.lines_down_to(0, camera, progress)?;
        Ok(Truth { camera: *camera, edges, lines: TrueLines::of(&visible), visible })
    }

    /// The outline of a view, unless that is too crowded. O(F + S log S).
    ///
    /// # Errors
    /// [`TruthError`], cancelled only.
    pub fn outline(&mut self, camera: &Camera, progress: &dyn Progress) -> Result<Option<Outline>, TruthError> {
        Ok(unless_crowded(self.lines.outline(camera, &Quiet(progress)))?)
    }

    /// All silhouette edges of a view as if nothing hid them. O(as [`find`](Self::find)).
    ///
    /// # Errors
    /// [`TruthError::Lines`].
    pub fn lines_seen_or_not(&mut self, camera: &Camera, progress: &dyn Progress) -> Result<TrueLines, TruthError> {
        Ok(TrueLines::of(&self.lines_down_to(u32::MAX, camera, progress)?.1))
    }

    /// All silhouette edges, and those of their parts that at most this many layers hide.
    fn lines_down_to(
        &mut self,
        invisibility: u32,
        camera: &Camera,
        progress: &dyn Progress,
    ) -> Result<(SilhouetteEdges, Vec<VisibleLine>), TruthError> {
        let options = LineOptions { max_invisibility: invisibility, ..silhouette_options() };
        let lines = self.find_lines(camera, &options, progress)?;
        let mesh = self.mesh.mesh();
        self.facings.classify(mesh, &camera.viewpoint());
        let edges = SilhouetteEdges::of(&self.topology, &self.facings);
        let silhouette = Silhouette { mesh, topology: &self.topology, facings: &self.facings, edges: &edges };
        let visible = visible_lines(&lines.chains, invisibility, &silhouette);
        Ok((edges, visible))
    }

    /// Exact lines of a view, of the kinds that `options` selects.
    ///
    /// # Errors
    /// [`TruthError::Lines`].
    pub fn find_lines(
        &mut self,
        camera: &Camera,
        options: &LineOptions,
        progress: &dyn Progress,
    ) -> Result<Lines, TruthError> {
        Ok(self.lines.find(camera, options, &Quiet(progress))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::{DVec3, Vec3};
    use silhouette_core::view::Framing;
    use silhouette_core::{NoProgress, TriangleMesh, shapes};
    use silhouette_gpu::PenPlacement;

    fn truth(shape: &str, direction: DVec3, size: u32) -> (Arc<PreparedMesh>, Truth) {
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap()));
        let bounds = mesh.mesh().bounds().unwrap();
        let camera = Camera::framing(&bounds, direction, Vec3::Y, Framing::Orthographic, [size; 2]).unwrap();
        let truth = TruthFinder::new(&mesh, &NoProgress).unwrap().find(&camera, &NoProgress).unwrap();
        (mesh, truth)
    }

    /// Of the sides of such a face the exact drawing may take one where facing makes another the silhouette edge.
    #[test]
    fn faces_without_area_take_no_line_from_the_truth() {
        let lattice = |p: &Vec3| (*p * 256.0).round() / 256.0;
        let torus = shapes::by_name("torus:24,16").unwrap();
        let positions: Vec<Vec3> = torus.positions().iter().map(lattice).collect();
        let (mut split, mut triangles) = (positions.clone(), Vec::new());
        for &[a, b, c] in torus.triangles() {
            let new = split.len() as u32;
            split.push(positions[a as usize].midpoint(positions[b as usize]));
            triangles.extend([[a, b, new], [b, c, new], [c, a, new]]);
        }
        let plain = TriangleMesh::new(positions, torus.triangles().to_vec()).unwrap();
        let flat = TriangleMesh::new(split, triangles).unwrap();
        let [plain, flat] = [plain, flat].map(|mesh| Arc::new(PreparedMesh::new(mesh)));
        let bounds = plain.mesh().bounds().unwrap();
        for direction in [DVec3::new(0.45, 0.3, 0.84), DVec3::new(-0.3, -0.35, 0.6), DVec3::Z, DVec3::Y] {
            let camera = Camera::framing(&bounds, direction, Vec3::X, Framing::Orthographic, [200; 2]).unwrap();
            let [expected, found] = [&plain, &flat].map(|mesh| {
                let truth = TruthFinder::new(mesh, &NoProgress).unwrap().find(&camera, &NoProgress).unwrap();
                assert!(truth.visible.iter().flat_map(|line| &line.edges).all(|&edge| truth.edges.contains(edge)));
                truth.lines.total_length_px()
            });
            assert!((found - expected).abs() < 1e-6, "from {direction}: {found} of {expected} px");
        }
    }

    #[test]
    fn a_cube_seen_from_a_corner_shows_its_hexagon() {
        let (mesh, truth) = truth("cube", DVec3::new(1.0, 1.1, 0.9), 200);
        assert_eq!((truth.edges.len(), truth.visible.len()), (6, 1));
        let line = &truth.visible[0];
        assert!(line.closed && line.points.len() == 6);
        let camera = &truth.camera;
        let topology = Topology::new(mesh.mesh());
        let lengths = truth.edges.iter().map(|edge| {
            let ends = topology.end_points(edge).map(|vertex| mesh.mesh().positions()[vertex.index()].as_dvec3());
            let [a, b] = ends.map(|end| camera.project(end).unwrap().pixel);
            a.distance(b)
        });
        assert!((truth.lines.total_length_px() - lengths.sum::<f64>()).abs() < 1e-9);
        // Front faces, and with them the inside of the outline, are on the left.
        let area: f64 = line.segments().map(|(_, [from, to])| 0.5 * from.perp_dot(to)).sum();
        assert!(area < -1e3, "counter-clockwise as seen in the picture: {area}");
        let outside = truth.draw(Pen { width_px: 3.0, placement: PenPlacement::Outside });
        let middle = line.points.iter().sum::<glam::DVec2>() / 6.0;
        let inward = line.points[0] + (middle - line.points[0]).normalize() * 2.0;
        let outward = line.points[0] - (middle - line.points[0]).normalize() * 2.0;
        assert!(outside.has_ink_within(outward, 0.5) && !outside.has_ink_within(inward, 0.1));
    }

    /// What lies behind is not drawn, and a line ends exactly where it disappears.
    #[test]
    fn a_torus_hides_a_part_of_its_own_hole() {
        let (_, truth) = truth("torus", DVec3::new(0.0, 0.35, 1.0), 400);
        let open: Vec<_> = truth.visible.iter().filter(|line| !line.closed).collect();
        assert!(!open.is_empty() && open.len() < 6, "{}", open.len());
        assert!(truth.visible.iter().any(|line| line.closed), "the outer outline");
        let drawn: usize = truth.lines.runs.iter().map(|run| run.samples.len()).sum();
        assert_eq!((drawn, truth.lines.runs.len()), (truth.lines.samples.len(), truth.visible.len()));
        let edges: std::collections::BTreeSet<_> = truth.lines.samples.iter().map(|sample| sample.edge).collect();
        assert!(edges.len() < truth.edges.len(), "some are hidden");
        assert!(edges.iter().all(|&edge| truth.edges.contains(edge)));
    }

    /// A boundary edge is a silhouette edge where its face is a front face, and nowhere else.
    #[test]
    fn a_sheet_seen_from_behind_has_no_lines() {
        let (_, front) = truth("grid", DVec3::new(0.1, 1.0, 0.2), 100);
        let (_, back) = truth("grid", DVec3::new(0.1, -1.0, 0.2), 100);
        let lengths = [&front, &back].map(|truth| truth.lines.total_length_px());
        assert_eq!(lengths.iter().filter(|&&length| length > 100.0).count(), 1, "{lengths:?}");
        assert_eq!([&front, &back].map(|truth| truth.edges.is_empty() == truth.visible.is_empty()), [true; 2]);
    }
}
