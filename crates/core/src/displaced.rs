//! [`DisplacedViewer`]: a viewer moved infinitesimally off the place where the camera has it, so that no face is seen edge-on.
//!
//! Seen exactly along an axis, whole walls of a part are edge-on, edges cover edges, and vertices lie on edges in the
//! picture. Each such tie is the sign of a determinant that vanishes. H. Edelsbrunner and E. Muecke, "Simulation of
//! Simplicity: A Technique to Cope with Degenerate Cases in Geometric Algorithms", ACM Transactions on Graphics 9(1), 1990,
//! perturb the input by powers of an infinitesimal e and take the sign of the first coefficient that does not vanish. Here
//! the mesh stays where it is and the viewer alone is perturbed: in homogeneous coordinates, an eye `(P, 1)` or a direction
//! `(W, 0)` becomes
//!
//! ```text
//! viewer + e (C, 1) + e^2 (X, 0) + e^3 (Y, 0) + e^4 (Z, 0)
//! ```
//!
//! with the middle C of the scene and the unit vectors X, Y and Z. Whether three points turn left or right is the sign of a
//! determinant that is linear in the viewer, so its coefficients are the determinants for the viewer, for an eye at C, and
//! for views along the axes. They all vanish only for three points of one line. So, but for those, nothing is ever undecided,
//! and all answers are those of one and the same viewer in general position: contours close and layers add up.
//!
//! # Why towards the middle of the scene
//!
//! An eye moves towards C; a viewer at infinity comes back to a finite distance, straight above C. Both see the walls of a
//! convex part around C from inside, so that they are back faces: the silhouette of a box seen along an axis is the rim of
//! its near side, as people draw it. A viewer displaced sideways would see one wall of each pair, and the silhouette would
//! run along far edges there. The axes decide only where C lies in the plane as well.
//!
//! What remains are ties that no viewer can break, since things touch in space: a vertex on an edge, an edge in the plane
//! of a face. Callers decide those by what they mean.

use crate::facing::{Facing, FacingRule};
use crate::mesh::TriangleMesh;
use crate::orientation::{certain_turn, exact_turn, orientation, turn};
use crate::view::Viewpoint;
use glam::Vec3;

/// A viewer displaced infinitesimally. See the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DisplacedViewer {
    viewpoint: Viewpoint,
    toward: Vec3,
}

/// How three points turn as seen by a [`DisplacedViewer`]: a coefficient with the power of the infinitesimal before it.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Turn {
    /// The power: 0 where the viewpoint itself decides. Turns of a lower power are infinitely larger.
    pub power: u8,
    /// The first coefficient that does not vanish, within [`RELATIVE_ERROR`](crate::orientation::RELATIVE_ERROR): above 0 for a left turn. 0 for points of one
    /// line.
    pub value: f64,
}

impl Turn {
    /// Three points of one line.
    pub const NONE: Self = Self { power: u8::MAX, value: 0.0 };

    /// 1 for a left turn, -1 for a right turn, 0 for points of one line.
    #[inline]
    pub fn sign(self) -> i32 {
        i32::from(self.value > 0.0) - i32::from(self.value < 0.0)
    }

    /// Whether the viewpoint alone does not decide: the points, or the face that they span, are seen edge-on.
    #[inline]
    pub fn is_tie(self) -> bool {
        self.power > 0
    }
}

/// Two turns whose points differ in one only, as numbers of one power: what the larger power leaves of the other is 0. The
/// turn of a point between those two is affine in its place, so [`Turn::sign`] at that place is the sign of their mean.
#[inline]
pub fn of_one_power([one, other]: [Turn; 2]) -> [f64; 2] {
    let power = one.power.min(other.power);
    [one, other].map(|turn| if turn.power == power { turn.value } else { 0.0 })
}

impl DisplacedViewer {
    /// A viewer displaced towards a point, the middle of the scene.
    pub fn new(viewpoint: Viewpoint, toward: Vec3) -> Self {
        Self { viewpoint, toward }
    }

    /// A viewer displaced towards the middle of a mesh's bounds. O(V).
    pub fn of_mesh(viewpoint: Viewpoint, mesh: &TriangleMesh) -> Self {
        Self::new(viewpoint, mesh.bounds().map_or(Vec3::ZERO, |bounds| bounds.center.as_vec3()))
    }

    /// How `a b c` turns as this viewer sees it; exact in sign, O(1).
    #[inline]
    pub fn turn(&self, a: Vec3, b: Vec3, c: Vec3) -> Turn {
        match certain_turn(&self.viewpoint, a, b, c) {
            Some(value) if value != 0.0 => Turn { power: 0, value },
            _ => self.uncertain_turn(a, b, c),
        }
    }

    #[cold]
    fn uncertain_turn(&self, a: Vec3, b: Vec3, c: Vec3) -> Turn {
        if a == b || b == c || c == a {
            return Turn::NONE;
        }
        let along = |axis: Vec3| turn(&Viewpoint::Orthographic { toward_viewer: axis }, a, b, c);
        let coefficients: [&dyn Fn() -> f64; 5] = [
            &|| exact_turn(&self.viewpoint, a, b, c),
            &|| orientation(a, b, c, self.toward),
            &|| along(Vec3::X),
            &|| along(Vec3::Y),
            &|| along(Vec3::Z),
        ];
        let mut powers = coefficients.iter().zip(0..).map(|(coefficient, power)| Turn { power, value: coefficient() });
        powers.find(|turn| turn.value != 0.0).unwrap_or(Turn::NONE)
    }
}

impl FacingRule for DisplacedViewer {
    fn viewpoint(&self) -> &Viewpoint {
        &self.viewpoint
    }

    /// Front where the corners turn left. A face without area is back.
    #[cold]
    fn judge_exactly(&self, [v0, v1, v2]: [Vec3; 3]) -> Facing {
        if self.turn(v0, v1, v2).sign() > 0 { Facing::Front } else { Facing::Back }
    }
}
