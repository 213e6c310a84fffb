//! Origins: from where the 32-bit positions of a mesh count, in the coordinates of its file.
//!
//! Positions have 24 significant bits. Around x = 5,400,000, where a survey's coordinates lie, they are 0.5 apart: a chimney of
//! 0.6 m is lost. Positions of such a mesh therefore count from an origin close to it ([`TriangleMesh::origin`]); that of all other
//! meshes is zero. [`load`](crate::load) sets it, whatever derives a mesh from another keeps it, whoever writes coordinates for
//! people or other programs adds it ([`TriangleMesh::in_file`]), and meshes that are used together must have the same
//! ([`common_origin`]). `docs/decisions/0015-origins-of-meshes.md` has the reasons.

use crate::mesh::TriangleMesh;
use glam::{DVec3, Vec3};

/// How far from zero the coordinates of an axis may lie, as a multiple of the mesh's largest extent, before they count from another
/// origin. Rounding to 24 bits then moves no vertex by more than 64 x 2^-24 of the extent, four millionths.
pub(crate) const FARTHEST: f64 = 64.0;

/// The origin for coordinates between `min` and `max`: zero along each axis on which no coordinate is farther from zero than 64 times the
/// largest extent; otherwise the middle, rounded to a multiple of the least power of two that is not below this extent. So coordinates
/// of 32 bits stay what they are, to the last bit, when it is subtracted from them.
pub fn origin_between(min: DVec3, max: DVec3) -> DVec3 {
    let extent = (max - min).max_element();
    let step = if extent > 0.0 { extent.log2().ceil().exp2() } else { f64::MIN_POSITIVE };
    let along = |axis: usize| {
        let middle = 0.5 * (min[axis] + max[axis]);
        let is_far = min[axis].abs().max(max[axis].abs()) > FARTHEST * extent;
        // A single point is its own origin.
        if !is_far {
            0.0
        } else if extent > 0.0 {
            (middle / step).round() * step
        } else {
            middle
        }
    };
    DVec3::new(along(0), along(1), along(2))
}

/// An origin that all these meshes can have: that of the first, unless together they lie far from it. Zero without a face. O(F).
pub fn common_origin<'a>(meshes: impl IntoIterator<Item = &'a TriangleMesh>) -> DVec3 {
    let boxes: Vec<(DVec3, DVec3, DVec3)> = meshes
        .into_iter()
        .filter_map(|mesh| mesh.bounds().map(|bounds| (mesh.origin(), bounds.min, bounds.max)))
        .collect();
    let Some(&(first, ..)) = boxes.first() else { return DVec3::ZERO };
    let relative = boxes.iter().map(|&(origin, min, max)| (origin - first + min, origin - first + max));
    let union = relative.reduce(|(min, max), (low, high)| (min.min(low), max.max(high)));
    first + union.map_or(DVec3::ZERO, |(min, max)| origin_between(min, max))
}

/// Half the distance of neighbouring 32-bit numbers at the mesh's largest coordinate: by how much rounding moves a position, at most. 0
/// without a face.
pub fn largest_rounding(mesh: &TriangleMesh) -> f64 {
    mesh.bounds().map_or(0.0, |bounds| {
        // A position's coordinate, of 32 bits.
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element() as f32;
        let next = largest.next_up();
        let step = if next.is_finite() { next - largest } else { largest - largest.next_down() };
        f64::from(step) / 2.0
    })
}

/// A position that counts from `origin`, in the coordinates of the file: the shortest decimal numbers that are this position when they
/// are read, so that most come out as they are written in the file.
pub fn in_file(origin: DVec3, position: Vec3) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|axis| shortest(origin[axis], position[axis])))
}

/// Most decimals that 64-bit numbers of any use hold.
const DECIMALS: i32 = 15;

#[expect(clippy::float_cmp, reason = "the same position, to the last bit")]
fn shortest(origin: f64, offset: f32) -> f64 {
    if origin == 0.0 {
        return offset.to_string().parse().unwrap_or_else(|_| offset.into());
    }
    let exact = origin + f64::from(offset);
    let rounded = (0..=DECIMALS).map(|decimals| {
        let scale = 10_f64.powi(decimals);
        (exact * scale).round() / scale
    });
    let mut same = rounded.filter(|number| (number - origin) as f32 == offset);
    same.next().unwrap_or(exact)
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "equal to the last bit is what is promised")]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn box_at(middle: [f64; 3], extent: f64) -> DVec3 {
        let (middle, half) = (DVec3::from_array(middle), DVec3::splat(extent / 2.0));
        origin_between(middle - half, middle + half)
    }

    #[test]
    fn only_what_is_far_counts_from_elsewhere() {
        assert_eq!(box_at([60.0, -60.0, 0.0], 1.0), DVec3::ZERO);
        assert_eq!(box_at([500_003.2, 5_400_001.0, 2.0], 10.0), DVec3::new(500_000.0, 5_400_000.0, 0.0));
        assert_eq!(box_at([0.0, 0.0, 100.0], 1.0), DVec3::new(0.0, 0.0, 100.0));
        assert_eq!(box_at([7.0; 3], 0.0), DVec3::splat(7.0), "a point is its own origin");
        assert_eq!(box_at([3e38; 3], 1e38), DVec3::ZERO);
    }

    #[test]
    fn meshes_of_one_region_share_the_origin_of_the_first() {
        let at = |origin: DVec3, x: f32| {
            let positions = [Vec3::ZERO, Vec3::X, Vec3::Y].map(|p| p + Vec3::X * x);
            TriangleMesh::new(positions.to_vec(), vec![[0, 1, 2]]).unwrap().with_origin(origin)
        };
        let (near, far) = (at(DVec3::X * 1e6, 0.0), at(DVec3::X * 1_000_002.0, 1.0));
        let origin = common_origin([&near, &far]);
        assert_eq!(origin, near.origin());
        assert_eq!(far.relative_to(origin).unwrap().positions()[0], Vec3::X * 3.0);
        assert_eq!(common_origin([&at(DVec3::ZERO, 0.0), &near]), DVec3::ZERO, "no origin is close to both");
        assert_eq!(common_origin([&at(DVec3::ZERO, 0.0), &at(DVec3::ZERO, 2.0)]), DVec3::ZERO);
        assert_eq!(common_origin([]), DVec3::ZERO);
        assert_eq!(largest_rounding(&far), 2.0 * f64::from(f32::EPSILON) / 2.0);
    }

    proptest! {
        /// What a file of 32 bits says stays what it is.
        #[test]
        fn numbers_of_32_bits_lose_nothing(far in -1e7_f32..1e7, steps in prop::collection::vec(0_u32..4096, 2..9)) {
            prop_assume!(far.abs() > 1.0);
            let all: Vec<f64> = steps.iter().map(|&step| f64::from(f32::from_bits(far.to_bits() + step))).collect();
            let (min, max) = all.iter().fold((f64::MAX, f64::MIN), |(min, max), &x| (min.min(x), max.max(x)));
            let origin = origin_between(DVec3::splat(min), DVec3::splat(max)).x;
            for x in all {
                prop_assert_eq!(origin + f64::from((x - origin) as f32), x);
                prop_assert_eq!(in_file(DVec3::splat(origin), Vec3::splat((x - origin) as f32)).x as f32, x as f32);
            }
        }

        #[test]
        fn decimals_of_a_file_come_back(whole in -9_999_999_i64..9_999_999, thousandths in 0_i64..1000, near in -20_i64..20) {
            let number = (whole * 1000 + thousandths) as f64 / 1000.0;
            let origin = (whole + near) as f64;
            let offset = (number - origin) as f32;
            prop_assert_eq!(in_file(DVec3::splat(origin), Vec3::splat(offset)).x, number);
        }

        #[test]
        fn without_an_origin_they_are_those_of_32_bits(number in prop::num::f32::NORMAL | prop::num::f32::SUBNORMAL) {
            let shown = in_file(DVec3::ZERO, Vec3::splat(number)).x;
            prop_assert_eq!(shown as f32, number);
            prop_assert_eq!(shown.to_string(), number.to_string());
        }
    }
}
