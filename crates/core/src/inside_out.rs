//! Which faces have to be turned for their normals to point outwards: many methods take that for granted, and scans and exports do
//! not always keep to it.
//!
//! A *part* is what consistently wound pairs of faces join. By its volume it points outward or inward. Inward is right for the wall of a
//! cavity, a closed part inside of another: a hollow ball is two spheres, the outer one pointing outward and the inner one inward. So
//!
//! - a closed part that points the other way than the smallest closed part around it belongs to that one's solid, as a cavity or as an
//!   island in a cavity. It is inside out if and only if that part is.
//! - any other part is an object of its own, and inside out if it points inward. A closed part that points the same way as the one around
//!   it is such an object, as the works of a clock are in its case.

mod nesting;

use self::nesting::surroundings;
use crate::disjoint_sets::DisjointSets;
use crate::id::{EdgeId, FaceId};
use crate::mesh::TriangleMesh;
use crate::progress::{Cancelled, NoProgress, Progress};
use crate::topology::Topology;
use glam::{DVec3, Vec3};

/// For each face whether it belongs to a part that is wound inside out: exact for closed parts, a guess by volume for open ones.
/// O(F α(F)), and for nested parts the faces above each of them along one axis.
pub fn inside_out_faces(mesh: &TriangleMesh, topology: &Topology) -> Vec<bool> {
    inside_out_faces_with_progress(mesh, topology, &NoProgress).unwrap_or_default()
}

/// Like [`inside_out_faces`], but stops when `progress` asks to.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn inside_out_faces_with_progress(
    mesh: &TriangleMesh,
    topology: &Topology,
    progress: &dyn Progress,
) -> Result<Vec<bool>, Cancelled> {
    let parts = Parts::new(mesh, topology);
    progress.check()?;
    let verdicts = parts.verdicts(progress)?;
    Ok(parts.part_of.iter().map(|&part| verdicts[part as usize].is_inside_out).collect())
}

/// For each face six times the volume between its part and the part's centre, above 0 where faces point outwards: right for closed parts,
/// a guess for open ones, and 0 for flat ones. A part is what consistently wound pairs of faces join. O(F α(F)).
pub fn part_volumes(mesh: &TriangleMesh, topology: &Topology) -> Vec<f64> {
    let Parts { part_of, parts, .. } = Parts::new(mesh, topology);
    part_of.iter().map(|&part| parts[part as usize].certain_volume()).collect()
}

/// The parts of a mesh.
pub(crate) struct Parts<'a> {
    mesh: &'a TriangleMesh,
    /// The part of each face. Parts are numbered by their lowest face.
    part_of: Vec<u32>,
    parts: Vec<Part>,
}

/// What a part is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Verdict {
    /// Whether it is inside out.
    pub(crate) is_inside_out: bool,
    /// Whether it is the wall of a cavity.
    pub(crate) is_cavity: bool,
}

impl<'a> Parts<'a> {
    pub(crate) fn new(mesh: &'a TriangleMesh, topology: &Topology) -> Self {
        let mut sets = DisjointSets::new(mesh.face_count());
        let mut unpaired = Vec::new();
        for edge in (0..topology.edge_count()).map(EdgeId::from_usize) {
            match topology.consistent_pair(mesh, edge) {
                Some([a, b]) => sets.unite(a.get(), b.get()),
                // A side from a vertex to itself is no edge.
                None if topology.edges()[edge][0] == topology.edges()[edge][1] => {}
                None => unpaired.push(edge),
            }
        }
        let mut number = vec![u32::MAX; mesh.face_count()];
        let mut parts: Vec<Part> = Vec::new();
        let mut part_of = Vec::with_capacity(mesh.face_count());
        for face in 0..mesh.face_count() {
            let leader = sets.find(face as u32) as usize;
            if number[leader] == u32::MAX {
                number[leader] = parts.len() as u32;
                parts.push(Part::default());
            }
            part_of.push(number[leader]);
            let part = &mut parts[number[leader] as usize];
            let corners = mesh.corners(FaceId::from_usize(face));
            corners.iter().for_each(|&corner| part.extend(corner));
            let [a, b, c] = corners.map(Vec3::as_dvec3);
            let area = (b - a).cross(c - a).length();
            part.area += area;
            part.moment += area / 3.0 * (a + b + c);
        }
        for face in 0..mesh.face_count() {
            let part = &mut parts[part_of[face] as usize];
            let centre = part.moment / part.area;
            let [a, b, c] = mesh.corners(FaceId::from_usize(face)).map(|corner| corner.as_dvec3() - centre);
            let volume = a.cross(b).dot(c);
            if volume.is_finite() {
                part.volume += volume;
            }
        }
        for face in unpaired.into_iter().flat_map(|edge| topology.faces(edge)) {
            parts[part_of[face.index()] as usize].is_open = true;
        }
        Self { mesh, part_of, parts }
    }

    /// The part of a face.
    fn of(&self, face: u32) -> usize {
        self.part_of[face as usize] as usize
    }

    /// What each part is.
    pub(crate) fn verdicts(&self, progress: &dyn Progress) -> Result<Vec<Verdict>, Cancelled> {
        let around = surroundings(self, progress)?;
        let mut order: Vec<usize> = (0..self.parts.len()).collect();
        // Whatever is around a part has a larger volume.
        order.sort_by(|&one, &other| self.parts[other].volume.abs().total_cmp(&self.parts[one].volume.abs()));
        let mut verdicts = vec![Verdict { is_inside_out: false, is_cavity: false }; self.parts.len()];
        for part in order {
            let volume = self.parts[part].certain_volume();
            let outer = around[part].filter(|&outer| volume * self.parts[outer].volume < 0.0);
            let is_inside_out = outer.map_or(volume < 0.0, |outer| verdicts[outer].is_inside_out);
            // The solid of a part that points inward once all is right lies outside of it.
            verdicts[part] = Verdict { is_inside_out, is_cavity: (volume < 0.0) != is_inside_out };
        }
        Ok(verdicts)
    }

    /// How many faces are inside out, and how many parts are walls of cavities.
    pub(crate) fn count(&self, progress: &dyn Progress) -> Result<(usize, usize), Cancelled> {
        let verdicts = self.verdicts(progress)?;
        let faces = self.part_of.iter().filter(|&&part| verdicts[part as usize].is_inside_out).count();
        Ok((faces, verdicts.iter().filter(|verdict| verdict.is_cavity).count()))
    }
}

/// The mesh with the faces turned for which `is_turned` says so; ids stay as they are. O(V + F).
///
/// # Panics
/// If there are not as many answers as faces.
pub fn turned(mesh: &TriangleMesh, is_turned: &[bool]) -> TriangleMesh {
    assert_eq!(is_turned.len(), mesh.face_count(), "one answer per face");
    let triangles = mesh.triangles().iter().zip(is_turned);
    let triangles = triangles.map(|(&[a, b, c], &is_turned)| if is_turned { [a, c, b] } else { [a, b, c] }).collect();
    let turned = TriangleMesh::new(mesh.positions().to_vec(), triangles).expect("the corners are those of a mesh");
    turned.with_origin(mesh.origin())
}

/// Of a part with twice the area A, a volume below this times A^(3/2) is rounding: six times that of a ball is 0.2 times as much, of a plate
/// a thousand times as wide as thick 0.0003.
const ROUNDING: f64 = 1e-9;

#[derive(Debug, Clone, Copy)]
struct Part {
    /// The box around it.
    min: Vec3,
    max: Vec3,
    /// Whether it has an edge that does not join two of its faces, wound consistently.
    is_open: bool,
    /// Twice its area.
    area: f64,
    moment: DVec3,
    /// Six times its volume.
    volume: f64,
}

impl Default for Part {
    fn default() -> Self {
        let (min, max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        Self { min, max, is_open: false, area: 0.0, moment: DVec3::ZERO, volume: 0.0 }
    }
}

impl Part {
    fn extend(&mut self, corner: Vec3) {
        (self.min, self.max) = (self.min.min(corner), self.max.max(corner));
    }

    /// Whether it may enclose others, or be enclosed.
    fn is_solid(&self) -> bool {
        !self.is_open && self.certain_volume() != 0.0
    }

    /// Whether another could be inside of it, by their boxes and volumes.
    fn may_enclose(&self, other: &Self) -> bool {
        let holds = self.min.cmple(other.min).all() && other.max.cmple(self.max).all();
        holds && self.volume.abs() > other.volume.abs()
    }

    fn certain_volume(self) -> f64 {
        if self.volume.abs() > ROUNDING * self.area.powf(1.5) { self.volume } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    #[test]
    fn each_part_is_judged_by_itself_far_from_the_origin_too() {
        let sphere = shapes::by_name("icosphere:1").unwrap();
        let count = sphere.vertex_count() as u32;
        let mut positions: Vec<Vec3> = sphere.positions().iter().map(|p| *p + Vec3::X * 1000.0).collect();
        positions.extend(sphere.positions());
        let mut triangles = sphere.triangles().to_vec();
        triangles.extend(sphere.triangles().iter().map(|&[a, b, c]| [b + count, a + count, c + count]));
        let both = TriangleMesh::new(positions, triangles).unwrap();
        let turned = inside_out_faces(&both, &Topology::new(&both));
        let faces = sphere.face_count();
        assert!(turned[..faces].iter().all(|turned| !turned) && turned[faces..].iter().all(|turned| *turned));
        let flat = shapes::by_name("grid:3,2").unwrap();
        assert_eq!(part_volumes(&flat, &Topology::new(&flat)), [0.0; 12]);
        let mended = super::turned(&both, &turned);
        assert!(!inside_out_faces(&mended, &Topology::new(&mended)).contains(&true));
        assert_eq!(mended.triangles()[..faces], both.triangles()[..faces], "what was right stays");
    }

    /// Spheres about the origin, by their radii; those of negative radius point inward.
    fn spheres(radii: &[f32]) -> TriangleMesh {
        let sphere = shapes::by_name("icosphere:2").unwrap();
        let (mut positions, mut triangles) = (Vec::new(), Vec::new());
        for &radius in radii {
            let first = positions.len() as u32;
            positions.extend(sphere.positions().iter().map(|p| *p * radius.abs()));
            let turn = |&[a, b, c]: &[u32; 3]| if radius < 0.0 { [a, c, b] } else { [a, b, c] };
            triangles.extend(sphere.triangles().iter().map(turn).map(|triangle| triangle.map(|v| v + first)));
        }
        TriangleMesh::new(positions, triangles).unwrap()
    }

    /// For each sphere whether it is to be turned.
    fn judged(radii: &[f32]) -> Vec<bool> {
        let mesh = spheres(radii);
        let faces = inside_out_faces(&mesh, &Topology::new(&mesh));
        faces.chunks(mesh.face_count() / radii.len()).map(|sphere| sphere.iter().all(|&turned| turned)).collect()
    }

    #[test]
    fn walls_of_cavities_point_inward() {
        for (radii, expected) in [
            (&[2.0, -1.0][..], &[false, false][..]),
            (&[-1.0, 2.0], &[false, false]),
            (&[-2.0, 1.0], &[true, true]),
            // One object within another.
            (&[2.0, 1.0], &[false, false]),
            (&[-2.0, -1.0], &[true, true]),
            // An island in a cavity, right and reversed.
            (&[3.0, -2.0, 1.0], &[false; 3]),
            (&[-3.0, 2.0, -1.0], &[true; 3]),
            // Listed twice, a sphere is not inside of itself.
            (&[-1.0, -1.0], &[true, true]),
            (&[1.0, -1.0], &[false, true]),
        ] {
            assert_eq!(judged(radii), expected, "{radii:?}");
            let mesh = spheres(radii);
            let mended = turned(&mesh, &inside_out_faces(&mesh, &Topology::new(&mesh)));
            assert!(!inside_out_faces(&mended, &Topology::new(&mended)).contains(&true), "{radii:?}");
        }
        let hollow = spheres(&[2.0, -1.0]);
        assert_eq!(Parts::new(&hollow, &Topology::new(&hollow)).count(&NoProgress), Ok((0, 1)));
    }

    /// Balls beside each other in a hollow one, some in the shadow of others along any axis.
    #[test]
    fn many_cavities_are_told_from_what_is_outside() {
        let ball = shapes::by_name("icosphere:1").unwrap();
        let (mut positions, mut triangles) = (Vec::new(), Vec::new());
        let mut place = |centre: Vec3, radius: f32, is_inward: bool| {
            let first = positions.len() as u32;
            positions.extend(ball.positions().iter().map(|p| *p * radius + centre));
            let turn = |&[a, b, c]: &[u32; 3]| if is_inward { [a, c, b] } else { [a, b, c] };
            triangles.extend(ball.triangles().iter().map(turn).map(|triangle| triangle.map(|v| v + first)));
        };
        place(Vec3::ZERO, 10.0, false);
        for at in 0..27 {
            place(Vec3::new((at % 3 - 1) as f32, (at / 3 % 3 - 1) as f32, (at / 9 - 1) as f32) * 2.0, 0.5, true);
        }
        // In the box around the large ball, but not in the ball.
        place(Vec3::splat(9.0), 0.5, true);
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let turned = inside_out_faces(&mesh, &Topology::new(&mesh));
        let faces = ball.face_count();
        assert!(turned[28 * faces..].iter().all(|&turned| turned), "outside");
        assert!(turned[..28 * faces].iter().all(|&turned| !turned), "cavities");
    }
}
