//! Points and determinants in rational numbers.

use glam::Vec3;
use num_bigint::BigInt;
use num_rational::BigRational;

/// Homogeneous coordinates, multiplied to whole numbers.
pub type Row = [BigInt; 4];

/// A float, which is a rational number.
pub fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

/// A float times a power of two that makes it whole.
fn whole(x: f32, exponent: u32) -> BigInt {
    let product = exact(f64::from(x)) * BigRational::from(BigInt::from(1) << exponent);
    assert!(product.is_integer(), "{x} is no multiple of 2^-{exponent}");
    product.to_integer()
}

/// A point times a power of two, with weight 1.
pub fn point(p: Vec3, exponent: u32) -> Row {
    let [x, y, z] = p.to_array().map(|c| whole(c, exponent));
    [x, y, z, BigInt::from(1)]
}

/// A direction times a power of two, with weight 0.
pub fn direction(p: Vec3, exponent: u32) -> Row {
    let [x, y, z, _] = point(p, exponent);
    [x, y, z, BigInt::ZERO]
}

/// The sum of rows, each times a number.
pub fn sum<const COUNT: usize>(terms: &[(&Row, BigInt); COUNT]) -> Row {
    std::array::from_fn(|column| terms.iter().map(|(row, factor)| &row[column] * factor).sum())
}

/// The plane through three points, as the row whose product with a fourth point is six times the volume of the tetrahedron:
/// above 0 where the three run counter-clockwise as seen from the fourth.
pub fn plane([a, b, c]: [&Row; 3]) -> Row {
    let minor = |[i, j, k]: [usize; 3]| {
        &a[i] * (&b[j] * &c[k] - &b[k] * &c[j]) - &a[j] * (&b[i] * &c[k] - &b[k] * &c[i])
            + &a[k] * (&b[i] * &c[j] - &b[j] * &c[i])
    };
    [minor([1, 2, 3]), -minor([0, 2, 3]), minor([0, 1, 3]), -minor([0, 1, 2])]
}

/// The plane with its other side up.
pub fn turned(plane: &Row) -> Row {
    plane.each_ref().map(|value| -value)
}

/// How far a point lies above a plane, in the unit of [`plane`].
pub fn height(plane: &Row, point: &Row) -> BigInt {
    plane.iter().zip(point).map(|(a, b)| a * b).sum()
}

#[test]
fn four_points_enclose_a_volume_of_a_known_sign() {
    let [a, b, c, d] = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(0.25, 0.25, 0.5)].map(|p| point(p, 2));
    assert_eq!(height(&plane([&a, &b, &c]), &d), BigInt::from(4 * 4 * 2));
    assert_eq!(height(&plane([&b, &a, &c]), &d), BigInt::from(-4 * 4 * 2));
    assert_eq!(height(&plane([&a, &b, &c]), &direction(Vec3::Z, 0)), BigInt::from(16));
    assert_eq!(height(&plane([&a, &b, &d]), &d), BigInt::ZERO);
}
