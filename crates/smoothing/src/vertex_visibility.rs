//! Section III-B, second half: a vertex is *visible* where its normal points to the viewer or across, N . D >= 0, decided for
//! whole clusters of vertices at once.
//!
//! Visible says nothing of what lies in front. Each shading vertex has one such bit per view, from which everything else is
//! derived, so that neighbours never disagree.
//!
//! For parallel projection, normals are points on the sphere S²; for an eye E, the planes (N, -N . V) are points on S³, and the
//! vertex is visible where (E, 1) . (N, -N . V) >= 0. Points are sorted into a hierarchy of cells; where all corners of a cell
//! agree, all vertices in it do. Cells whose answer is that of the last view cost nothing more.
//!
//! Departures:
//!
//! 1. Cells between circles of longitude and latitude, which the paper uses, are not spherically convex: their side towards
//!    the equator bulges beyond the great circle through two corners, so that corners may agree on what the inside does not.
//!    Here a cell is a box of a gnomonic chart, the central projection onto the faces of a cube, whose sides are great
//!    circles; the printed cells stay available ([`Cells::AsPrinted`]).
//! 2. Each cell is shrunk to the box of its points.
//! 3. Far from the origin all planes fall together on S³; positions are taken relative to the centre of the mesh and in units
//!    of its radius.

mod chart;
mod clusters;

pub use clusters::VertexClusters;

silhouette_core::option_choice! {
    /// How vertices are clustered to decide their visibility.
    pub enum Cells {
        /// By boxes of gnomonic charts, whose corners decide them.
        Gnomonic = "gnomonic",
        /// By cells between circles of longitude and latitude, as printed: now and then a vertex gets the wrong sign.
        AsPrinted = "as-printed",
        /// Not at all: every vertex is tested.
        None = "none",
    }
}

use crate::eye::Eye;
use crate::shading_mesh::ShadingMesh;
use silhouette_core::glam::{DVec3, Vec3};

/// Decides which shading vertices are visible, view after view.
#[derive(Debug, Clone)]
pub struct VertexVisibility {
    centre: DVec3,
    radius: f64,
    is_visible: Vec<bool>,
    /// For parallel projection and for an eye, each built when first needed.
    clusters: (Option<VertexClusters<3>>, Option<VertexClusters<4>>),
    cells: Cells,
    was_perspective: Option<bool>,
}

impl VertexVisibility {
    /// At first everything is visible, as a vertex without a normal always is. O(V).
    pub fn new(mesh: &ShadingMesh, cells: Cells) -> Self {
        let bounds = mesh.mesh().bounds();
        let (centre, radius) = bounds.map_or((DVec3::ZERO, 1.0), |bounds| (bounds.center, bounds.radius));
        Self {
            centre,
            radius: if radius > 0.0 { radius } else { 1.0 },
            is_visible: vec![true; mesh.positions().len()],
            clusters: (None, None),
            cells,
            was_perspective: None,
        }
    }

    /// Decides every vertex for a view; yields how many vertices and how many cells were tested. O(V), less where cells are
    /// decided as a whole; the first view of a kind builds its clusters, O(V log V).
    pub fn classify(&mut self, mesh: &ShadingMesh, eye: Eye) -> Tested {
        if self.cells == Cells::None {
            for (is_visible, (&position, &normal)) in
                self.is_visible.iter_mut().zip(mesh.positions().iter().zip(mesh.normals()))
            {
                *is_visible = visible(position, normal, eye);
            }
            return Tested { vertices: self.is_visible.len() as u64, cells: 0 };
        }
        let is_perspective = eye.position().is_some();
        let is_stale = self.was_perspective != Some(is_perspective);
        self.was_perspective = Some(is_perspective);
        let relative = |position: Vec3| (position.as_dvec3() - self.centre) / self.radius;
        let normals = mesh.normals();
        let test = |vertex: u32| visible(mesh.positions()[vertex as usize], normals[vertex as usize], eye);
        if is_perspective {
            let clusters = self.clusters.1.get_or_insert_with(|| {
                let plane = |(&position, &normal): (&Vec3, &Vec3)| {
                    let normal = normal.as_dvec3();
                    normal.extend(-normal.dot(relative(position))).to_array()
                };
                let planes: Vec<_> = mesh.positions().iter().zip(normals).map(plane).collect();
                VertexClusters::new(&planes, self.cells)
            });
            let eye = (eye.toward(self.centre) / self.radius).extend(1.0).to_array();
            clusters.decide(eye, is_stale, test, &mut self.is_visible)
        } else {
            let clusters = self.clusters.0.get_or_insert_with(|| {
                let normals: Vec<_> = normals.iter().map(|normal| normal.as_dvec3().to_array()).collect();
                VertexClusters::new(&normals, self.cells)
            });
            clusters.decide(eye.toward(DVec3::ZERO).to_array(), is_stale, test, &mut self.is_visible)
        }
    }

    /// Whether each shading vertex is visible in the view last classified.
    pub fn is_visible(&self) -> &[bool] {
        &self.is_visible
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let (ortho, perspective) = &self.clusters;
        self.is_visible.len()
            + ortho.as_ref().map_or(0, VertexClusters::bytes)
            + perspective.as_ref().map_or(0, VertexClusters::bytes)
    }
}

/// What a classification looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tested {
    /// Vertices whose own sign was computed.
    pub vertices: u64,
    /// Cells whose corners were.
    pub cells: u64,
}

/// The definition: N . D >= 0.
#[inline]
pub fn visible(position: Vec3, normal: Vec3, eye: Eye) -> bool {
    normal.as_dvec3().dot(eye.toward(position.as_dvec3())) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shading_normals::NormalWeights;
    use silhouette_core::view::Viewpoint;
    use silhouette_core::{NoProgress, PreparedMesh, TriangleMesh, shapes};
    use silhouette_testing::directions::spread;

    fn shading(mesh: TriangleMesh) -> ShadingMesh {
        ShadingMesh::new(&PreparedMesh::new(mesh), 75.0, NormalWeights::Sphere, "test", &NoProgress).unwrap()
    }

    fn eyes(centre: Vec3, radius: f32) -> Vec<Eye> {
        let directions: Vec<_> = spread(40).collect();
        let parallel = directions.iter().map(|&d| Viewpoint::Orthographic { toward_viewer: d.as_vec3() });
        let near = directions.iter().zip([1.05_f32, 2.0, 1e3].iter().cycle());
        let near = near.map(|(&d, &r)| Viewpoint::Perspective { eye: centre + d.as_vec3() * r * radius });
        parallel.chain(near).map(Eye::from).collect()
    }

    #[test]
    fn clusters_decide_as_the_definition_does_in_any_order_of_views() {
        for (name, offset) in [("knot", 0.0), ("gear", 0.0), ("icosphere:4", 1e4_f32), ("blob:8000", 0.0)] {
            let mesh = shapes::by_name(name).unwrap();
            let moved = mesh.positions().iter().map(|p| *p + Vec3::splat(offset)).collect();
            let mesh = shading(TriangleMesh::new(moved, mesh.triangles().to_vec()).unwrap());
            let [mut clustered, mut plain] =
                [Cells::Gnomonic, Cells::None].map(|cells| VertexVisibility::new(&mesh, cells));
            let bounds = mesh.mesh().bounds().unwrap();
            let (mut tested, mut views) = (0, 0);
            for eye in eyes(bounds.center.as_vec3(), bounds.radius as f32) {
                tested += clustered.classify(&mesh, eye).vertices;
                plain.classify(&mesh, eye);
                assert!(clustered.is_visible() == plain.is_visible(), "{name}");
                views += 1;
            }
            let share = tested as f64 / (views * mesh.positions().len()) as f64;
            assert!(share < 0.7, "{name}: clusters left {share} of the vertices to test");
        }
    }

    /// The side of a printed cell that lies towards the equator bulges beyond the great circle through its corners.
    #[test]
    fn printed_cells_decide_some_vertices_wrongly() {
        let mesh = shading(shapes::by_name("icosphere:5").unwrap());
        let [mut printed, mut plain] = [Cells::AsPrinted, Cells::None].map(|cells| VertexVisibility::new(&mesh, cells));
        let mut wrong = 0;
        for direction in spread(4000) {
            let eye = Eye::from(Viewpoint::Orthographic { toward_viewer: direction.as_vec3() });
            printed.classify(&mesh, eye);
            plain.classify(&mesh, eye);
            wrong += printed.is_visible().iter().zip(plain.is_visible()).filter(|(a, b)| a != b).count();
        }
        let share = wrong as f64 / (4000 * mesh.positions().len()) as f64;
        assert!((1e-7..1e-3).contains(&share), "{wrong} wrong signs, {share}");
    }

    #[test]
    fn coherent_views_test_no_vertex_twice_for_nothing() {
        let mesh = shading(shapes::by_name("icosphere:5").unwrap());
        let mut visibility = VertexVisibility::new(&mesh, Cells::Gnomonic);
        let eye = Eye::from(Viewpoint::Perspective { eye: Vec3::new(0.3, 0.4, 3.0) });
        let first = visibility.classify(&mesh, eye);
        let again = visibility.classify(&mesh, eye);
        assert_eq!(first, again);
        assert!(first.vertices < mesh.positions().len() as u64 / 4, "{first:?}");
        assert_eq!(allocation_counter::measure(|| assert_eq!(visibility.classify(&mesh, eye), first)).count_total, 0);
    }
}
