//! Situations in which programs that draw lines were seen to fail, rebuilt at whole coordinates: walls that end on plates,
//! boxes on boxes, edges over edges, eyes in the planes of faces. Each is compared with the exact drawing from every axis and
//! diagonal, and what must be seen of it is said besides.

use crate::exact::drawing::{check, creases_and_mesh};
use crate::exact::moved::Steps;
use crate::exact::visible::{Also, Drawing};
use glam::Vec3;
use silhouette_core::{Camera, Projection, TriangleMesh};
use silhouette_testing::builtin;
use silhouette_testing::edits::mapped;

/// A mesh in the making.
#[derive(Default)]
struct Builder {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Builder {
    fn quad(mut self, corners: [[i32; 3]; 4]) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend(corners.map(|corner| Vec3::from(corner.map(|c| c as f32))));
        self.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        self
    }

    /// A closed box whose sides share its corners.
    fn block(mut self, low: [i32; 3], high: [i32; 3]) -> Self {
        let first = self.positions.len() as u32;
        let corner =
            |index: usize| [0, 1, 2].map(|axis| (if index >> axis & 1 == 1 { high } else { low })[axis] as f32);
        self.positions.extend((0..8).map(|index| Vec3::from(corner(index))));
        for [a, b, c, d] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            self.triangles.extend([[a, b, c], [a, c, d]].map(|corners| corners.map(|corner| first + corner)));
        }
        self
    }

    fn mesh(self) -> TriangleMesh {
        TriangleMesh::new(self.positions, self.triangles).unwrap()
    }
}

fn of_triangles(points: &[[i32; 3]], triangles: &[[u32; 3]]) -> TriangleMesh {
    let positions = points.iter().map(|point| Vec3::from(point.map(|c| c as f32))).collect();
    TriangleMesh::new(positions, triangles.to_vec()).unwrap()
}

/// Six plates one behind the other and two low walls through all of them, flush with the first and the last.
fn ribs() -> TriangleMesh {
    let plates = (0..6).fold(Builder::default(), |builder, index| {
        let y = 2 * index;
        builder.quad([[0, y, 0], [6, y, 0], [6, y, 4], [0, y, 4]])
    });
    [2, 4].into_iter().fold(plates, |builder, x| builder.quad([[x, 0, 0], [x, 10, 0], [x, 10, 1], [x, 0, 1]])).mesh()
}

/// A box on a larger one, sharing a corner with it; their sides lie in common planes.
pub fn stacked() -> TriangleMesh {
    Builder::default().block([0, 0, 0], [5, 5, 1]).block([0, 0, 1], [2, 2, 2]).mesh()
}

/// Three bars on each other, of which the uppermost sticks out.
fn steps() -> TriangleMesh {
    Builder::default().block([0, 0, 0], [10, 1, 1]).block([2, 0, 1], [7, 1, 2]).block([3, 0, 2], [9, 1, 3]).mesh()
}

/// A plate, and a wall that touches it from behind.
fn end_on_sheet() -> TriangleMesh {
    Builder::default()
        .quad([[0, 0, 0], [6, 0, 0], [6, 0, 4], [0, 0, 4]])
        .quad([[2, 0, 1], [2, 4, 1], [2, 4, 3], [2, 0, 3]])
        .mesh()
}

/// A strip that rises and falls, seen edge-on in part from above.
fn ramp() -> TriangleMesh {
    let points = [[1, 0, 0], [2, 0, 0], [3, 0, 0], [1, 1, 1], [2, 1, 0], [3, 1, 1], [2, 2, 1], [3, 2, 1]];
    let triangles = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [3, 4, 6], [4, 5, 7], [4, 7, 6]];
    of_triangles(&points, &triangles)
}

/// Three triangles, one of which lies in a plane with the eye at 2 0 1.
fn in_the_plane_of_an_eye() -> TriangleMesh {
    let points = [[2, 1, 1], [2, 2, 0], [3, 1, 1], [3, 1, 2], [3, 2, 0], [3, 2, 1]];
    of_triangles(&points, &[[0, 3, 2], [1, 5, 4], [0, 2, 5]])
}

/// A ball of 80 faces at whole coordinates, many of whose faces lie in planes through the middle of others.
fn rough_ball() -> TriangleMesh {
    mapped(&builtin("icosphere:1"), |p| (p * 2.3).round())
}

pub fn two_cubes_in_line() -> TriangleMesh {
    Builder::default().block([0, 0, 0], [1, 1, 1]).block([0, 0, 3], [1, 1, 4]).mesh()
}

/// Two triangles that cross in the picture and share a corner by its place alone.
pub fn crossing_triangles() -> TriangleMesh {
    let points = [[0, 2, 2], [2, 1, 0], [1, 0, 2], [0, 2, 2], [0, 0, 0], [2, 0, 0]];
    of_triangles(&points, &[[0, 1, 2], [3, 4, 5]])
}

pub fn all() -> [(&'static str, TriangleMesh); 9] {
    [
        ("ribs", ribs()),
        ("stacked", stacked()),
        ("steps", steps()),
        ("end on a sheet", end_on_sheet()),
        ("ramp", ramp()),
        ("in the plane of an eye", in_the_plane_of_an_eye()),
        ("rough ball", rough_ball()),
        ("two cubes in line", two_cubes_in_line()),
        ("crossing triangles", crossing_triangles()),
    ]
}

/// Along all axes and diagonals: an orthographic camera, and an eye at a whole distance.
fn cameras(mesh: &TriangleMesh) -> Vec<Camera> {
    let bounds = mesh.bounds().unwrap();
    let (middle, reach) = (bounds.center.round().as_vec3(), bounds.radius.ceil() as f32 + 1.0);
    let direction = |index: i32| Vec3::from([index % 3 - 1, index / 3 % 3 - 1, index / 9 - 1].map(|c| c as f32));
    let views = (0..27).map(direction).filter(|toward| *toward != Vec3::ZERO).flat_map(|toward| {
        let projections =
            [Projection::Orthographic { height: f64::from(4.0 * reach) }, Projection::Perspective { fov_y_rad: 2.9 }];
        projections.map(|projection| {
            Camera::new(middle + toward * reach, middle, toward.any_orthogonal_vector(), projection, [512; 2]).unwrap()
        })
    });
    views.collect()
}

#[test]
fn situations_are_drawn_exactly_from_every_axis_and_diagonal() {
    for (name, mesh) in all() {
        let mut stretches = 0;
        for camera in cameras(&mesh) {
            for also in [Also::default(), creases_and_mesh()] {
                stretches += check(name, &mesh, &camera, Steps::WHOLE, also).1.stretches;
            }
        }
        eprintln!("{name}: {stretches} stretches");
        assert!(stretches > 100, "{name}: {stretches}");
    }
}

/// The layers in front of an edge between two places, which has to be of one stretch.
fn invisibility(mesh: &TriangleMesh, drawing: &Drawing, ends: [[i32; 3]; 2]) -> u32 {
    let places = ends.map(|end| Vec3::from(end.map(|c| c as f32)));
    let is_between = |vertices: &[u32; 2]| {
        let at = vertices.map(|vertex| mesh.positions()[vertex as usize]);
        at == places || at == [places[1], places[0]]
    };
    let (_, (_, stretches)) = drawing.iter().find(|(vertices, _)| is_between(vertices)).expect("drawn");
    assert_eq!(stretches.len(), 1, "{ends:?}");
    stretches[0].invisibility
}

fn along(mesh: &TriangleMesh, toward: Vec3) -> Camera {
    let is_along = |camera: &Camera| {
        matches!(camera.projection(), Projection::Orthographic { .. })
            && (camera.eye() - camera.target()).normalize() == toward
    };
    cameras(mesh).into_iter().find(is_along).unwrap()
}

#[test]
fn the_end_of_a_wall_is_hidden_behind_the_plate_that_it_touches() {
    let (ribs, sheet) = (ribs(), end_on_sheet());
    for (mesh, end, hidden_from) in [
        (&ribs, [[2, 0, 0], [2, 0, 1]], Vec3::NEG_Y),
        (&ribs, [[4, 10, 0], [4, 10, 1]], Vec3::Y),
        (&sheet, [[2, 0, 1], [2, 0, 3]], Vec3::NEG_Y),
    ] {
        let of = |toward| {
            let camera = along(mesh, toward);
            let (drawing, _) = check("wall", mesh, &camera, Steps::WHOLE, creases_and_mesh());
            invisibility(mesh, &drawing, end)
        };
        assert!(of(hidden_from) > 0, "{end:?}");
    }
    let from_behind = check("wall", &sheet, &along(&sheet, Vec3::Y), Steps::WHOLE, Also::default()).0;
    assert_eq!(invisibility(&sheet, &from_behind, [[2, 0, 1], [2, 0, 3]]), 0, "seen from the wall's own side");
}

#[test]
fn edges_of_a_ramp_are_visible_from_above() {
    let mesh = ramp();
    let (drawing, _) = check("ramp", &mesh, &along(&mesh, Vec3::Z), Steps::WHOLE, Also::default());
    for edge in [[[2, 0, 0], [3, 0, 0]], [[3, 0, 0], [3, 1, 1]]] {
        assert_eq!(invisibility(&mesh, &drawing, edge), 0, "{edge:?}");
    }
}

#[test]
fn an_edge_is_visible_from_the_plane_of_a_face_as_from_beside_it() {
    let mesh = in_the_plane_of_an_eye();
    for beside in [-1.0, 0.0, 1.0] {
        let eye = Vec3::new(2.0 + beside / 1024.0, 0.0, 1.0);
        let projection = Projection::Perspective { fov_y_rad: 2.6 };
        let camera = Camera::new(eye, eye + Vec3::Y, Vec3::Z, projection, [512; 2]).unwrap();
        let steps = Steps { exponent: 10, bits: 13 };
        let (drawing, _) = check("plane of an eye", &mesh, &camera, steps, Also::default());
        assert_eq!(invisibility(&mesh, &drawing, [[2, 2, 0], [3, 2, 0]]), 0, "{beside}");
    }
}
