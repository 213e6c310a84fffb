//! Places on a curve through space: numbers that are often close for points that are close to each other (G. M. Morton, "A computer
//! oriented geodetic data base and a new technique in file sequencing", 1966).

use glam::DVec3;

/// The place of a point of the cube from -1 to 1 on a curve of 2^21 steps along each axis: the bits of its coordinates in turn.
/// Coordinates outside of the cube count as on its surface, those that are no numbers as at its highest corner.
pub fn place(point: DVec3) -> u64 {
    let cell = ((point + 1.0) * f64::from(1 << 20)).min(DVec3::splat(f64::from((1 << 21) - 1))).as_u64vec3();
    spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2
}

/// Moves bit i of 21 bits to bit 3 i.
fn spread(value: u64) -> u64 {
    const STEPS: [(u32, u64); 5] = [
        (32, 0x001f_0000_0000_ffff),
        (16, 0x001f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ];
    STEPS.iter().fold(value & 0x001f_ffff, |bits, &(shift, mask)| (bits | bits << shift) & mask)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_of_coordinates_stand_in_turn() {
        for value in [0, 1, 0x0015_5555, 0x001f_ffff] {
            let expected = (0..21).fold(0_u64, |bits, bit| bits | (value >> bit & 1) << (3 * bit));
            assert_eq!(spread(value), expected, "{value:x}");
        }
        assert_eq!((place(DVec3::NEG_ONE), place(DVec3::ONE)), (0, (1 << 63) - 1));
        assert_eq!([DVec3::splat(1e30), DVec3::NAN].map(place), [place(DVec3::ONE); 2]);
        assert_eq!(place(DVec3::splat(-1e30)), 0);
        assert!(place(DVec3::splat(-0.5)) < place(DVec3::splat(0.5)), "halves of the cube follow each other");
    }
}
