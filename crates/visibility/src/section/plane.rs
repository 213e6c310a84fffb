//! [`SectionPlane`]: where a mesh is cut, and which side is taken away.

use silhouette_core::glam::Vec3;
use silhouette_core::orientation::height_over_plane;
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// A plane that takes away what lies on the side to which its normal points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionPlane {
    point: Vec3,
    normal: Vec3,
}

/// What is no plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected six numbers X,Y,Z,NX,NY,NZ: a point of the plane and a normal other than 0, towards what is taken away"
)]
pub struct ParseSectionPlaneError;

impl SectionPlane {
    /// The plane through a point, in object space, across a normal of any length. `None` where a number is not finite or the
    /// normal is 0.
    pub fn new(point: Vec3, normal: Vec3) -> Option<Self> {
        (point.is_finite() && normal.is_finite() && normal != Vec3::ZERO).then_some(Self { point, normal })
    }

    /// A point of the plane.
    pub const fn point(&self) -> Vec3 {
        self.point
    }

    /// The direction towards what is taken away, as it was given.
    pub const fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Distance of a place from the plane in units of the normal's inverse length, above 0 where it is taken away: exact in sign,
    /// close in value.
    #[inline]
    pub fn height(&self, place: Vec3) -> f64 {
        height_over_plane(self.point, self.normal, place)
    }

    /// The side of a place: `Greater` where it is taken away, `Equal` in the plane. Exact.
    #[inline]
    pub fn side(&self, place: Vec3) -> Ordering {
        self.height(place).partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }

    /// Where the edge between two places on different sides passes through the plane: the same bits whichever comes first.
    pub(super) fn crossing(&self, a: Vec3, b: Vec3) -> Vec3 {
        let [a, b] = if a.to_array() <= b.to_array() { [a, b] } else { [b, a] };
        let [from, to] = [a, b].map(|place| self.height(place));
        a.as_dvec3().lerp(b.as_dvec3(), from / (from - to)).as_vec3().clamp(a.min(b), a.max(b))
    }
}

impl FromStr for SectionPlane {
    type Err = ParseSectionPlaneError;

    /// Reads `X,Y,Z,NX,NY,NZ`, in the 32 bits of a mesh's coordinates, so that a vertex at the same decimal lies in the plane.
    fn from_str(text: &str) -> Result<Self, ParseSectionPlaneError> {
        let numbers: Option<Vec<f32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        let Some(&[x, y, z, nx, ny, nz]) = numbers.as_deref() else { return Err(ParseSectionPlaneError) };
        Self::new(Vec3::new(x, y, z), Vec3::new(nx, ny, nz)).ok_or(ParseSectionPlaneError)
    }
}

impl fmt::Display for SectionPlane {
    /// As it is read.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { point: Vec3 { x, y, z }, normal } = self;
        write!(f, "{x},{y},{z},{},{},{}", normal.x, normal.y, normal.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_read_and_written() {
        let plane: SectionPlane = "0, 1,-2.5,0,0,1e-3".parse().unwrap();
        assert_eq!(plane, SectionPlane::new(Vec3::new(0.0, 1.0, -2.5), Vec3::Z * 1e-3).unwrap());
        assert_eq!(plane.to_string().parse(), Ok(plane));
        for bad in [
            "",
            "1,2,3",
            "0,0,0,0,0,0",
            "0,0,0,0,0,nan",
            "inf,0,0,0,0,1",
            "0,0,0,0,0,1,2",
            "a,0,0,0,0,1",
            "0,0,0,0,0,1e99",
        ] {
            assert_eq!(bad.parse::<SectionPlane>(), Err(ParseSectionPlaneError), "{bad}");
        }
    }

    #[test]
    fn sides_are_exact() {
        let plane: SectionPlane = "0.1,0.2,0.3,1,1,1".parse().unwrap();
        let above = Vec3::new(0.3, 0.1, 0.2_f32.next_up());
        assert_eq!(plane.side(Vec3::new(0.3, 0.1, 0.2)), Ordering::Equal);
        assert_eq!((plane.side(above), plane.side(Vec3::ZERO)), (Ordering::Greater, Ordering::Less));
    }

    #[test]
    fn crossings_lie_on_the_edge_whichever_end_comes_first() {
        let plane = SectionPlane::new(Vec3::new(0.3, 0.1, 0.7), Vec3::new(-0.2, 0.9, 0.4)).unwrap();
        for (a, b) in
            [(Vec3::NEG_ONE, Vec3::new(2.0, 1.0, 0.5)), (Vec3::new(0.0, 1e6, 0.0), Vec3::new(-0.0, -1e-3, 0.0))]
        {
            let crossing = plane.crossing(a, b);
            assert_eq!(crossing.to_array().map(f32::to_bits), plane.crossing(b, a).to_array().map(f32::to_bits));
            assert!(
                plane.height(crossing).abs() <= 1e-6 * plane.height(a).abs().max(plane.height(b).abs()),
                "{crossing}"
            );
        }
    }
}
