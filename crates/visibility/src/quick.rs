//! [`QuickLineFinder`]: visible lines by looking at a picture of face ids instead of deciding exactly.
//!
//! The edges drawn are those of [`LineFinder`](crate::LineFinder). Each is projected and sampled once a pixel of the picture
//! of ids. At a sample three pixels are asked, the one that it lies in and one to either side of the edge, and it is visible
//! where any of them lets it through: one that shows nothing, a face at the edge, or a face that the sample is not behind. A
//! visible silhouette edge has something farther on its outer side; a hidden one lies behind all three. That a picture of ids
//! tells which lines are visible is an old idea; Northrup and Markosian (Artistic silhouettes: a hybrid approach, NPAR 2000)
//! draw the ids of edges as well.
//!
//! What this gets wrong: where a line appears and disappears, by about a pixel; and hidden lines that run within a pixel of the
//! contour before them, which are drawn. On a fine mesh the silhouette is full of those. To ask that a face at the edge be seen
//! would draw few of them, but miss half of what is visible, as the faces there are narrower than a pixel.

use crate::frame::{ClippedEdge, PictureFrame};
use crate::join::join;
use crate::line_error::LineError;
use crate::lines::{LineStats, Lines};
use crate::options::LineOptions;
use crate::outline::Outline;
use crate::pieces::Piece;
use crate::scene::{Extent, LineScene};
use crate::select::Selector;
use crate::stroke::{OwnFaces, Stroke, Strokes};
use crate::unpaired::UnpairedEdges;
use crate::viewed_mesh::ViewedMesh;
use rayon::prelude::*;
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::{Camera, Cancelled, DisplacedViewer, FaceId, Progress, Topology, TriangleMesh, Viewpoint};
use std::sync::Arc;
use std::time::Instant;

/// A sample is behind a face only if it is farther behind its plane than this share of the scene's largest coordinate: a few
/// roundings of a face that passes through the edge.
const PLANE_TOLERANCE: f64 = 1e-9;

/// Who asks for artefacts.
const NAME: &str = "quick visible lines";

/// Which face is seen at each pixel of a picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FaceIds {
    size: [u32; 2],
    values: Vec<u32>,
}

/// A picture of face ids whose size and values do not fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{values} face ids do not fill a picture of {} x {} pixels", size[0], size[1])]
pub struct FaceIdsError {
    /// Width and height.
    pub size: [u32; 2],
    /// Number of values.
    pub values: usize,
}

impl FaceIds {
    /// A picture from its values, row by row from the top left: 0 where nothing is seen, otherwise the face's id plus one. Its
    /// width and height may be multiples of the camera's; the larger, the closer to exact.
    ///
    /// # Errors
    /// [`FaceIdsError`].
    pub fn new(size: [u32; 2], values: Vec<u32>) -> Result<Self, FaceIdsError> {
        let fits = u64::from(size[0]) * u64::from(size[1]) == values.len() as u64 && !values.is_empty();
        if fits { Ok(Self { size, values }) } else { Err(FaceIdsError { size, values: values.len() }) }
    }

    /// Width and height.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The face seen at the pixel that holds a point, or at the border's pixel nearest to a point outside.
    pub fn face_at(&self, point: DVec2) -> Option<FaceId> {
        let last = DVec2::from(self.size.map(|side| f64::from(side - 1)));
        let pixel = point.floor().clamp(DVec2::ZERO, last);
        let value = self.values[pixel.y as usize * self.size[0] as usize + pixel.x as usize];
        value.checked_sub(1).map(FaceId::new)
    }
}

/// Finds the visible lines of any view of a scene, given a picture of its face ids.
pub struct QuickLineFinder {
    scene: LineScene,
    topology: Arc<Topology>,
    unpaired: Arc<UnpairedEdges>,
    extent: Extent,
    selector: Selector,
}

impl QuickLineFinder {
    /// Prepares a scene: topology and unpaired edges. O(F).
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(scene: LineScene, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (topology, unpaired) = (scene.mesh().artefact(NAME, progress)?, scene.mesh().artefact(NAME, progress)?);
        let extent = scene.extent();
        Ok(Self { scene, topology, unpaired, extent, selector: Selector::default() })
    }

    /// The lines of a view whose face ids are `ids`: visible parts only, whatever invisibility is asked for, and mesh edges
    /// only. The time that it took to draw the ids is not part of the result's. O(F + length of edges in pixels of `ids`).
    ///
    /// # Errors
    /// [`LineError::Cancelled`].
    pub fn find(
        &mut self,
        camera: &Camera,
        options: &LineOptions,
        ids: &FaceIds,
        progress: &dyn Progress,
    ) -> Result<Lines, LineError> {
        let mut stats = LineStats::default();
        let started = Instant::now();
        progress.check()?;
        let viewpoint = camera.viewpoint();
        let mesh = self.scene.mesh().mesh();
        let viewer = DisplacedViewer::new(viewpoint, self.extent.center());
        let view = ViewedMesh { mesh, topology: &self.topology, unpaired: &self.unpaired, viewer };
        self.selector.find_silhouette(mesh, &self.topology, &viewer);
        let strokes = self.selector.strokes(&self.scene, &view, &[], options);
        stats.extract = started.elapsed();

        let started = Instant::now();
        progress.check()?;
        let frame = PictureFrame::new(camera, self.extent.reach());
        let clipped: Vec<_> = strokes.strokes.par_iter().map(|stroke| frame.clip(stroke.ends, 0.0)).collect();
        stats.project = started.elapsed();

        let started = Instant::now();
        let scale = DVec2::from(ids.size.map(f64::from)) / frame.size();
        let eye = IdEye { mesh, ids, viewpoint, tolerance: self.extent.reach() * PLANE_TOLERANCE };
        let sampler = Sampler { eye, strokes: &strokes, frame, scale };
        let sampled: Vec<Vec<Piece>> = clipped
            .par_iter()
            .enumerate()
            .map(|(index, edge)| edge.as_ref().map_or_else(Vec::new, |edge| sampler.pieces(index as u32, edge)))
            .collect();
        let pieces = sampled.concat();
        stats.decide = started.elapsed();

        let started = Instant::now();
        let chains = join(&self.scene, &strokes, &pieces, &frame);
        stats.chain = started.elapsed();
        stats.edges = strokes.strokes.len() as u64;
        stats.pieces = pieces.len() as u64;
        let origin = self.scene.mesh().mesh().origin();
        Ok(Lines { camera: *camera, chains, outline: Outline::default(), origin, stats })
    }
}

/// Looks at the picture of ids.
#[derive(Clone, Copy)]
struct IdEye<'a> {
    mesh: &'a TriangleMesh,
    ids: &'a FaceIds,
    viewpoint: Viewpoint,
    /// Distance from a plane that counts as none.
    tolerance: f64,
}

impl IdEye<'_> {
    /// Whether the face seen at a pixel of the ids lets a point on an edge through, `own` being the faces at the edge.
    fn lets_through(&self, pixel: DVec2, point: DVec3, own: OwnFaces<'_>) -> bool {
        let Some(face) = self.ids.face_at(pixel).filter(|face| face.index() < self.mesh.face_count()) else {
            return true;
        };
        if own.contains(face) {
            return true;
        }
        let [a, b, c] = self.mesh.corners(face).map(Vec3::as_dvec3);
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { return true };
        let toward_viewer = match self.viewpoint {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - a,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
        };
        let above = (point - a).dot(normal) * normal.dot(toward_viewer).signum();
        above >= -self.tolerance
    }
}

struct Sampler<'a> {
    eye: IdEye<'a>,
    strokes: &'a Strokes,
    frame: PictureFrame,
    /// Pixels of the ids a pixel of the camera.
    scale: DVec2,
}

impl Sampler<'_> {
    /// The visible pieces of a stroke, cut midway between samples.
    fn pieces(&self, index: u32, clipped: &ClippedEdge) -> Vec<Piece> {
        let stroke = &self.strokes.strokes[index as usize];
        let [from, to] = clipped.pixels.map(|pixel| pixel * self.scale);
        let length = from.distance(to);
        if !length.is_finite() {
            // An edge through the eye has no place in the picture.
            return Vec::new();
        }
        // It is clipped to the picture, so this is at most the picture's diagonal.
        let count = length.ceil().max(1.0);
        let sideways = (to - from).try_normalize().map_or(DVec2::ZERO, DVec2::perp);
        let [near, far] = clipped.range.map(|t| self.frame.map(stroke.at(t)).w);
        // One over depth is affine in the picture.
        let parameter = |share: f64| {
            let in_space = share * near / ((1.0 - share) * far + share * near);
            clipped.range[0] + (clipped.range[1] - clipped.range[0]) * in_space
        };
        let mut pieces: Vec<Piece> = Vec::new();
        let mut was_visible = false;
        for sample in 0..count as u32 {
            let share = (f64::from(sample) + 0.5) / count;
            let is_visible = self.is_visible(stroke, from.lerp(to, share), sideways, stroke.at(parameter(share)));
            let end = if f64::from(sample) + 1.0 < count {
                parameter((f64::from(sample) + 1.0) / count)
            } else {
                clipped.range[1]
            };
            match pieces.last_mut() {
                Some(piece) if is_visible && was_visible => piece.range[1] = end,
                _ if is_visible => {
                    let begin = if sample == 0 { clipped.range[0] } else { parameter(f64::from(sample) / count) };
                    pieces.push(Piece { stroke: index, invisibility: 0, range: [begin, end] });
                }
                _ => {}
            }
            was_visible = is_visible;
        }
        pieces
    }

    fn is_visible(&self, stroke: &Stroke, pixel: DVec2, sideways: DVec2, point: DVec3) -> bool {
        let own = self.strokes.own_faces(stroke);
        [DVec2::ZERO, sideways, -sideways].iter().any(|&offset| self.eye.lets_through(pixel + offset, point, own))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kind::LineKind;
    use silhouette_core::view::Projection;
    use silhouette_core::{NoProgress, PreparedMesh};

    const SIZE: u32 = 200;

    fn camera() -> Camera {
        let projection = Projection::Orthographic { height: 4.0 };
        Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, projection, [SIZE; 2]).unwrap()
    }

    /// A large triangle at depth 0, and a small one at depth `z` that reaches beyond the large one on the right.
    fn finder(z: f32) -> QuickLineFinder {
        let positions = vec![
            Vec3::new(-1.5, -1.5, 0.0),
            Vec3::new(0.5, -1.5, 0.0),
            Vec3::new(0.5, 1.5, 0.0),
            Vec3::new(-0.5, -0.2, z),
            Vec3::new(1.5, -0.2, z),
            Vec3::new(1.5, 0.2, z),
        ];
        let mesh = TriangleMesh::new(positions, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        QuickLineFinder::new(LineScene::new(Arc::new(PreparedMesh::new(mesh))), &NoProgress).unwrap()
    }

    /// The ids that a rasteriser would draw, by brute force.
    fn ids(finder: &QuickLineFinder, scale: u32) -> FaceIds {
        let mesh = finder.scene.mesh().mesh();
        let side = SIZE * scale;
        let value = |x: u32, y: u32| {
            let at = |pixel: u32| (f64::from(pixel) + 0.5) / f64::from(side) * 4.0 - 2.0;
            let point = DVec2::new(at(x), -at(y));
            let holds = |face: &[Vec3; 3]| {
                let [a, b, c] = face.map(|corner| corner.as_dvec3().truncate());
                [(a, b), (b, c), (c, a)].iter().all(|&(p, q)| (q - p).perp_dot(point - p) >= 0.0)
            };
            let faces = [0, 1].map(|face| mesh.corners(FaceId::new(face)));
            let nearest = [0, 1]
                .into_iter()
                .filter(|&face| holds(&faces[face]))
                .max_by(|&one, &other| faces[one][0].z.total_cmp(&faces[other][0].z));
            nearest.map_or(0, |face| face as u32 + 1)
        };
        let values = (0..side).flat_map(|y| (0..side).map(move |x| (x, y))).map(|(x, y)| value(x, y)).collect();
        FaceIds::new([side; 2], values).unwrap()
    }

    fn length_px(finder: &mut QuickLineFinder, ids: &FaceIds) -> f64 {
        let lines = finder.find(&camera(), &LineOptions::default(), ids, &NoProgress).unwrap();
        assert!(lines.chains.iter().all(|chain| chain.style.kind == LineKind::Boundary));
        lines.chains.iter().map(|chain| chain.length_px()).sum()
    }

    #[test]
    fn what_lies_behind_is_left_out_and_what_lies_before_is_not() {
        let px = f64::from(SIZE) / 4.0;
        let large = (2.0 + 3.0 + 13.0_f64.sqrt()) * px;
        let small = (2.0 + 0.4 + 4.16_f64.sqrt()) * px;
        // Of the small one's long sides, a half is behind the large one.
        let visible = small - (1.0 + 1.04_f64.sqrt()) * px;
        for scale in [1, 2] {
            let mut behind = finder(-1.0);
            let ids_behind = ids(&behind, scale);
            let length = length_px(&mut behind, &ids_behind);
            assert!((length - large - visible).abs() < 3.0, "{length} instead of {}", large + visible);
            let mut before = finder(1.0);
            let ids_before = ids(&before, scale);
            let hidden = 2.0 * 0.1 * px;
            let length = length_px(&mut before, &ids_before);
            assert!((length - large - small + hidden).abs() < 3.0, "{length} instead of {}", large + small - hidden);
        }
        // The control: a picture that shows nothing hides nothing.
        let nothing = FaceIds::new([SIZE; 2], vec![0; (SIZE * SIZE) as usize]).unwrap();
        assert!((length_px(&mut finder(-1.0), &nothing) - large - small).abs() < 1e-6);
    }

    #[test]
    fn ids_of_the_wrong_size_or_mesh_are_no_panic() {
        assert!(FaceIds::new([3, 3], vec![0; 8]).is_err() && FaceIds::new([0, 3], Vec::new()).is_err());
        let foreign = FaceIds::new([2, 2], vec![u32::MAX; 4]).unwrap();
        assert!(length_px(&mut finder(0.5), &foreign) > 100.0);
    }
}
