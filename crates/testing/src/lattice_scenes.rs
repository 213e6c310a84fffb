//! Small random scenes at whole coordinates, where ties are the rule: closed, open, non-manifold, duplicate and touching
//! surfaces, faces seen edge-on, eyes on vertices and in the planes of faces.

use crate::random::Random;
use silhouette_core::glam::Vec3;
use silhouette_core::{Camera, Projection, TriangleMesh};

/// What a scene is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Boxes, wedges and tetrahedra, some of which touch, share sides or contain each other.
    Closed,
    /// The same, some wound inward, or with a few faces turned or left out.
    Damaged,
    /// Rectangles along planes of the lattice, which meet in T junctions.
    Sheets,
    /// Triangles between a few points.
    Shared,
    /// Triangles that share no vertex, and overlap.
    Apart,
    /// Any of these with faces listed twice, over the same vertices or over others, wound alike or not.
    Twice,
}

/// All families.
pub const FAMILIES: [Family; 6] =
    [Family::Closed, Family::Damaged, Family::Sheets, Family::Shared, Family::Apart, Family::Twice];

/// Number of scenes per family; `SILHOUETTES_ORACLE` overrides the usual one.
pub fn seeds(usual: u64) -> u64 {
    std::env::var("SILHOUETTES_ORACLE").ok().and_then(|seeds| seeds.parse().ok()).unwrap_or(usual)
}

#[derive(Default)]
struct Builder {
    positions: Vec<[i32; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Builder {
    fn push(&mut self, positions: &[[i32; 3]], triangles: &[[u32; 3]]) {
        let first = self.positions.len() as u32;
        self.positions.extend(positions);
        self.triangles.extend(triangles.iter().map(|corners| corners.map(|corner| corner + first)));
    }

    fn push_box(&mut self, low: [i32; 3], high: [i32; 3]) {
        let corner = |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 1 { high[axis] } else { low[axis] });
        let corners: Vec<[i32; 3]> = (0..8).map(corner).collect();
        const SIDES: [[u32; 4]; 6] =
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let triangles: Vec<[u32; 3]> = SIDES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        self.push(&corners, &triangles);
    }

    fn push_tetrahedron(&mut self, corners: [[i32; 3]; 4]) {
        let minus = |p: [i32; 3], q: [i32; 3]| [0, 1, 2].map(|axis| p[axis] - q[axis]);
        let [x, y, z] = [1, 2, 3].map(|corner| minus(corners[corner], corners[0]));
        let volume = (x[1] * y[2] - x[2] * y[1]) * z[0]
            + (x[2] * y[0] - x[0] * y[2]) * z[1]
            + (x[0] * y[1] - x[1] * y[0]) * z[2];
        let outward = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        let inward = outward.map(|[a, b, c]: [u32; 3]| [a, c, b]);
        if volume != 0 {
            self.push(&corners, if volume > 0 { &outward } else { &inward });
        }
    }

    fn mesh(self) -> TriangleMesh {
        let positions = self.positions.into_iter().map(|point| Vec3::from(point.map(|c| c as f32))).collect();
        TriangleMesh::new(positions, self.triangles).unwrap()
    }
}

/// A scene of a family.
pub fn scene(family: Family, random: &mut Random) -> TriangleMesh {
    let mut builder = Builder::default();
    fill(family, random, &mut builder);
    builder.mesh()
}

fn fill(family: Family, random: &mut Random, builder: &mut Builder) {
    match family {
        Family::Closed => {
            for _ in 0..1 + random.below(3) {
                if random.one_in(3) {
                    builder.push_tetrahedron([0; 4].map(|_| random.lattice_point(0..5)));
                } else {
                    let low = random.lattice_point(0..4);
                    builder.push_box(low, [0, 1, 2].map(|axis| low[axis] + random.whole(1..4)));
                }
            }
        }
        Family::Damaged => {
            fill(Family::Closed, random, builder);
            let (all, some) = (random.one_in(3), 2 + random.below(8));
            for triangle in &mut builder.triangles {
                if all || random.one_in(some) {
                    triangle.swap(1, 2);
                }
            }
            if random.one_in(2) {
                let some = 4 + random.below(8);
                builder.triangles.retain(|_| !random.one_in(some));
            }
        }
        Family::Sheets => {
            for _ in 0..2 + random.below(4) {
                let (low, axis) = (random.lattice_point(0..4), random.below(3));
                let mut corners = [low; 4];
                let sides = [random.whole(1..4), random.whole(1..4)];
                for (corner, [one, other]) in [[0, 0], [1, 0], [1, 1], [0, 1]].into_iter().enumerate() {
                    corners[corner][(axis + 1) % 3] += one * sides[0];
                    corners[corner][(axis + 2) % 3] += other * sides[1];
                }
                builder
                    .push(&corners, if random.one_in(2) { &[[0, 1, 2], [0, 2, 3]] } else { &[[2, 1, 0], [0, 3, 2]] });
            }
            if random.one_in(2) {
                weld(builder);
            }
        }
        Family::Shared => {
            let points: Vec<[i32; 3]> = (0..4 + random.below(8)).map(|_| random.lattice_point(0..5)).collect();
            let triangles: Vec<[u32; 3]> =
                (0..2 + random.below(12)).map(|_| [0; 3].map(|_| random.below(points.len()) as u32)).collect();
            builder.push(&points, &triangles);
        }
        Family::Apart => {
            for _ in 0..2 + random.below(10) {
                let corners = [0; 3].map(|_| random.lattice_point(0..5));
                builder.push(&corners, &[[0, 1, 2]]);
            }
        }
        Family::Twice => {
            fill(FAMILIES[random.below(5)], random, builder);
            for index in 0..builder.triangles.len() {
                if random.one_in(3) {
                    let [a, b, c] = builder.triangles[index];
                    let corners = [a, b, c].map(|vertex| builder.positions[vertex as usize]);
                    let turned = random.one_in(2);
                    if random.one_in(2) {
                        builder.triangles.push(if turned { [a, c, b] } else { [a, b, c] });
                    } else {
                        builder.push(&corners, if turned { &[[0, 2, 1]] } else { &[[0, 1, 2]] });
                    }
                }
            }
        }
    }
}

/// Merges vertices of one place.
fn weld(builder: &mut Builder) {
    let first = |point: &[i32; 3], all: &[[i32; 3]]| all.iter().position(|other| other == point).unwrap() as u32;
    let positions = builder.positions.clone();
    for corner in builder.triangles.iter_mut().flatten() {
        *corner = first(&positions[*corner as usize], &positions);
    }
}

/// A camera that sees ties about half the time.
pub fn camera(mesh: &TriangleMesh, random: &mut Random) -> Option<Camera> {
    const DIRECTIONS: [[i32; 3]; 5] = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 1, 1]];
    let whole = |point: [i32; 3]| Vec3::from(point.map(|c| c as f32));
    if random.one_in(2) {
        let direction = if random.one_in(4) {
            random.lattice_point(-3..4)
        } else {
            let shift = random.below(3);
            let direction = DIRECTIONS[random.below(5)];
            [0, 1, 2].map(|axis| direction[(axis + shift) % 3] * [1, -1][random.below(2)])
        };
        let (target, toward) = (Vec3::splat(2.0), whole(direction) * 4.0);
        let projection = Projection::Orthographic { height: 24.0 };
        return Camera::new(target + toward, target, toward.any_orthogonal_vector(), projection, [512, 512]).ok();
    }
    let place = |random: &mut Random| match random.below(4) {
        0 if mesh.vertex_count() > 0 => mesh.positions()[random.below(mesh.vertex_count())],
        1 if mesh.face_count() > 0 => {
            // In the plane of a face, and on its edges as likely as not.
            let corners =
                mesh.triangles()[random.below(mesh.face_count())].map(|vertex| mesh.positions()[vertex as usize]);
            corners[0]
                + (corners[1] - corners[0]) * random.whole(-2..4) as f32
                + (corners[2] - corners[0]) * random.whole(-2..4) as f32 * 0.5
        }
        _ => whole(random.lattice_point(-4..9)),
    };
    let (eye, target) = (place(random), whole(random.lattice_point(0..5)));
    let projection = Projection::Perspective { fov_y_rad: 1.4 };
    Camera::new(eye, target, (target - eye).any_orthogonal_vector(), projection, [512, 512]).ok()
}
