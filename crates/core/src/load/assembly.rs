//! What every reader fills: positions and triangles in file order.

use super::concave::Polygons;
use super::error::{Located, Place, Problem};
use super::notes::Note;
use super::parts::{NO_PART, Part, Parts};
use super::placing::Placing;
use super::polygon::{fan, sides};
use crate::mesh::TriangleMesh;
use glam::Vec3;

/// A mesh, and what its file says about faces and edges.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelledMesh {
    /// The mesh.
    pub mesh: TriangleMesh,
    /// A number for each face, the same for faces of one material and one group; `None` where the file makes no
    /// difference between any two.
    pub labels: Option<Vec<u32>>,
    /// What the file calls its parts; `None` where it names none.
    pub parts: Option<Parts>,
    /// Edges of the mesh at which the file says that the surface is sharp, as pairs of vertex ids, lower first, sorted,
    /// each once. OBJ says so by smoothing groups (`s`), if not all faces are in the same one, and by line elements (`l`); every
    /// side of a face in group 0 (`s off`) is sharp, the face being shaded flat. glTF says so by the hard edges of the extension
    /// `EXT_mesh_primitive_edge_visibility`.
    pub feature_edges: Vec<[u32; 2]>,
    /// What the file's user should know, at most one of each kind.
    pub notes: Vec<Note>,
}

/// A mesh under construction.
pub(super) struct Assembly {
    pub(super) placing: Placing,
    pub(super) positions: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Pairs of vertices along which the surface is sharp, in any order, if they are an edge of the mesh.
    pub(super) feature_edges: Vec<[u32; 2]>,
    /// From which triangle on which label holds; 0 before the first.
    label_runs: Vec<(usize, u32)>,
    /// From which triangle on which part holds; none before the first.
    part_runs: Vec<(usize, u32)>,
    pub(super) parts: Vec<Part>,
    polygons: Polygons,
    /// How many faces had fewer than three corners, and where the first one stood.
    few_corners: Option<(u64, Place)>,
    pub(super) has_no_end: bool,
}

impl Assembly {
    /// A mesh whose positions are made so.
    pub(super) fn new(placing: Placing) -> Self {
        Self {
            placing,
            positions: Vec::new(),
            triangles: Vec::new(),
            feature_edges: Vec::new(),
            label_runs: Vec::new(),
            part_runs: Vec::new(),
            parts: Vec::new(),
            polygons: Polygons::default(),
            few_corners: None,
            has_no_end: false,
        }
    }

    /// Appends a polygon; [`Assembly::finish`] cuts it into triangles. One of fewer than three corners is left out, with a
    /// note that names its `place`.
    pub(super) fn polygon(&mut self, corners: &[u32], place: impl FnOnce() -> Place) {
        if corners.len() < 3 {
            self.few_corners.get_or_insert_with(|| (0, place())).0 += 1;
            return;
        }
        self.polygons.begin(self.triangles.len(), corners.len());
        fan(corners, &mut self.triangles);
    }

    /// Says which label the triangles have that follow.
    pub(super) fn begin_label(&mut self, label: u32) {
        if self.label_runs.last().map_or(0, |&(_, last)| last) != label {
            self.label_runs.push((self.triangles.len(), label));
        }
    }

    /// Says to which of the `parts` the triangles belong that follow.
    pub(super) fn begin_part(&mut self, part: u32) {
        self.part_runs.push((self.triangles.len(), part));
    }

    /// The finished mesh.
    pub(super) fn finish(mut self) -> Result<LabelledMesh, Located> {
        if self.triangles.is_empty() {
            return Err(Problem::NoFaces.into());
        }
        let labels = labels(&self.label_runs, self.triangles.len());
        let is_named = self.parts.iter().any(|part| !part.names.is_empty());
        let of_face = is_named.then(|| of_faces(&self.part_runs, NO_PART, self.triangles.len()));
        let parts = of_face.map(|of_face| Parts::new(self.parts, of_face));
        let crossing = self.polygons.triangulate(&self.positions, &mut self.triangles);
        let few_corners = self.few_corners.map(|(count, first)| Note::FewCorners { count, first });
        let no_end = self.has_no_end.then_some(Note::NoEnd);
        let feature_edges = edges_among(self.feature_edges, &self.triangles);
        let mesh = TriangleMesh::new(self.positions, self.triangles)?.with_origin(self.placing.origin());
        let rounded = self.placing.note(&mesh);
        let notes = [few_corners, crossing, no_end, rounded].into_iter().flatten().collect();
        Ok(LabelledMesh { mesh, labels, parts, feature_edges, notes })
    }
}

/// What holds for each of so many triangles, of runs that begin at some of them; `before` holds before the first.
fn of_faces(runs: &[(usize, u32)], before: u32, triangles: usize) -> Vec<u32> {
    let mut of_face = Vec::with_capacity(triangles);
    let mut last = before;
    for &(begin, next) in runs {
        of_face.resize(begin, last);
        last = next;
    }
    of_face.resize(triangles, last);
    of_face
}

/// The label of each triangle, if there are two.
fn labels(runs: &[(usize, u32)], triangles: usize) -> Option<Vec<u32>> {
    if runs.is_empty() {
        return None;
    }
    let labels = of_faces(runs, 0, triangles);
    let first = *labels.first()?;
    labels.iter().any(|&label| label != first).then_some(labels)
}

/// Those of some pairs of vertices that are sides of triangles, lower vertex first, sorted, each once. O(F) without pairs,
/// otherwise O((F + pairs) log pairs).
fn edges_among(mut pairs: Vec<[u32; 2]>, triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    // A face may name a vertex twice.
    pairs.retain(|[a, b]| a != b);
    pairs.iter_mut().for_each(|pair| pair.sort_unstable());
    pairs.sort_unstable();
    pairs.dedup();
    if pairs.is_empty() {
        return pairs;
    }
    let mut is_side = vec![false; pairs.len()];
    for at in triangles.iter().flat_map(|&triangle| sides(triangle)).filter_map(|side| pairs.binary_search(&side).ok())
    {
        is_side[at] = true;
    }
    let mut is_side = is_side.into_iter();
    pairs.retain(|_| is_side.next() == Some(true));
    pairs
}

/// `index` as a vertex id of a format that counts from 0.
pub(super) fn vertex_id(index: i64, face: u64, vertices: u64) -> Result<u32, Problem> {
    match u32::try_from(index) {
        Ok(id) if u64::from(id) < vertices => Ok(id),
        _ => {
            let allowed = match vertices.checked_sub(1) {
                Some(last) => format!("only 0 to {last} exist"),
                None => "there are no vertices".to_owned(),
            };
            Err(Problem::VertexOutOfRange { face, index, allowed })
        }
    }
}

/// Refuses a promise that `remaining` bytes cannot keep, each element taking `least` bytes or more. Only after this
/// may memory be reserved for the promise.
pub(super) fn check_promise(what: &str, promised: u64, least: u64, remaining: usize) -> Result<usize, Problem> {
    // The last row of a text may lack its line end.
    let possible = (remaining as u64 + 1) / least.max(1);
    if promised > possible {
        return Err(Problem::Promise { what: what.to_owned(), promised, possible });
    }
    Ok(usize::try_from(promised).unwrap_or(usize::MAX))
}
