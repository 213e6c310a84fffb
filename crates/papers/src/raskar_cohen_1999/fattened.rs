//! The ink of fattening as printed around a convex mesh, computed from the law without a device.
//!
//! A convex mesh lies on the inner side of the plane of each of its faces, and so does the eye for a back face. A ray that
//! meets the mesh therefore leaves it before it meets that plane: of fattened back faces there is to be seen exactly what lies
//! outside of the front faces in the picture. The law is [`fatten::push`](push); what it yields is cut at the planes between
//! which the camera draws.

use silhouette_core::glam::{DVec2, DVec3};
use silhouette_core::view::Camera;
use silhouette_core::{FaceFacings, FaceId, TriangleMesh};
use silhouette_image_precision::fatten::{FattenLaw, FattenedEdge, push};

/// The pixels of a picture whose centres fattened back faces cover and front faces do not, as `[x, y]`, row by row. Empty for
/// a mesh without triangles. O(F + pixels covered).
pub fn ink(mesh: &TriangleMesh, camera: &Camera, width_px: f64) -> Vec<[u32; 2]> {
    let Some(bounds) = mesh.bounds() else { return Vec::new() };
    let range = camera.clip_range(&bounds);
    let focal_px = camera.pixels_per_unit(1.0);
    let facings = FaceFacings::new(mesh, &camera.viewpoint());
    let to_view = camera.view_matrix();
    let [width, height] = camera.size();
    let mut covered = vec![Covered::No; width as usize * height as usize];
    for (face, triangle) in mesh.triangles().iter().enumerate() {
        let corners = triangle.map(|vertex| to_view.transform_point3(mesh.positions()[vertex as usize].as_dvec3()));
        let is_front = facings.is_front(FaceId::from_usize(face));
        let polygons = if is_front { vec![corners.to_vec()] } else { fan(corners, width_px, focal_px) };
        for polygon in polygons {
            let near = clipped(&polygon, |point| -point.z - range.near);
            let points: Vec<DVec2> = clipped(&near, |point| point.z + range.far)
                .into_iter()
                .map(|point| camera.view_to_pixel(point).pixel)
                .collect();
            for_each_centre(&points, camera.size(), |x, y| {
                let pixel = &mut covered[y as usize * width as usize + x as usize];
                match (is_front, *pixel) {
                    (true, _) => *pixel = Covered::ByFront,
                    (false, Covered::No) => *pixel = Covered::ByBack,
                    _ => {}
                }
            });
        }
    }
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    pixels.zip(covered).filter(|&(_, covered)| covered == Covered::ByBack).map(|(pixel, _)| pixel).collect()
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Covered {
    No,
    ByBack,
    ByFront,
}

/// The paper's six triangles about the middle of a triangle, whose edges the printed law pushes. In the camera's frame.
fn fan(corners: [DVec3; 3], width_px: f64, focal_px: f64) -> Vec<Vec<DVec3>> {
    let [a, b, c] = corners;
    let middle = (a + b + c) / 3.0;
    let Some(normal) = (b - a).cross(c - a).try_normalize() else { return Vec::new() };
    let pushed = [[a, b], [b, c], [c, a]].into_iter().flat_map(|[from, to]| {
        let along = (to - from).normalize_or_zero();
        let edge = FattenedEdge { middle: 0.5 * (from + to), along, normal };
        let by = push(&edge, width_px, focal_px, FattenLaw::AsPrinted).unwrap_or(0.0);
        [from, to].map(|end| end + along.cross(normal) * by)
    });
    let ring: Vec<DVec3> = pushed.collect();
    (0..6).map(|at| vec![middle, ring[at], ring[(at + 1) % 6]]).collect()
}

/// The part of a convex polygon where `inside` is not negative; linear in the point.
fn clipped(polygon: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (at, &from) in polygon.iter().enumerate() {
        let to = polygon[(at + 1) % polygon.len()];
        let [begin, end] = [from, to].map(&inside);
        if begin >= 0.0 {
            kept.push(from);
        }
        if (begin >= 0.0) != (end >= 0.0) {
            kept.push(from.lerp(to, begin / (begin - end)));
        }
    }
    kept
}

/// Calls `visit` with each pixel whose centre a convex polygon covers.
fn for_each_centre(points: &[DVec2], [width, height]: [u32; 2], mut visit: impl FnMut(u32, u32)) {
    // Pixels whose centres lie from `low` on and before `high`.
    let centres = |low: f64, high: f64, count: u32| {
        let [begin, end] = [low, high].map(|at| (at - 0.5).ceil().clamp(0.0, f64::from(count)) as u32);
        begin..end
    };
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
    };
    let [top, bottom] = ends(&mut points.iter().map(|point| point.y));
    for y in centres(top, bottom, height) {
        let level = f64::from(y) + 0.5;
        let sides = points.iter().zip(points.iter().cycle().skip(1));
        let crossings = sides.filter(|(from, to)| (from.y <= level) != (to.y <= level));
        let mut crossings = crossings.map(|(from, to)| from.x + (to.x - from.x) * (level - from.y) / (to.y - from.y));
        let [left, right] = ends(&mut crossings);
        centres(left, right, width).for_each(|x| visit(x, y));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_covers_the_centres_inside_of_it() {
        let covered = |points: &[[f64; 2]]| {
            let mut pixels = Vec::new();
            let points: Vec<DVec2> = points.iter().copied().map(DVec2::from_array).collect();
            for_each_centre(&points, [8, 8], |x, y| pixels.push([x, y]));
            pixels
        };
        assert_eq!(covered(&[[1.0, 2.0], [3.0, 2.0], [3.0, 4.0], [1.0, 4.0]]), [[1, 2], [2, 2], [1, 3], [2, 3]]);
        assert_eq!(covered(&[[0.0, 0.0], [0.0, 3.0], [3.0, 0.0]]), [[0, 0], [1, 0], [0, 1]], "half-open diagonal");
        assert!(covered(&[]).is_empty() && covered(&[[1.1, 1.1], [1.2, 1.1], [1.1, 1.2]]).is_empty());
        assert_eq!(covered(&[[-9.0, -9.0], [90.0, -9.0], [90.0, 90.0], [-9.0, 90.0]]).len(), 64, "cut to the picture");
    }

    #[test]
    fn polygons_are_cut_where_they_leave_the_inside() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let half = clipped(&square, |point| 1.0 - point.x);
        assert_eq!(half.len(), 4);
        assert!(half.iter().all(|point| point.x <= 1.0));
        assert!(clipped(&square, |_| -1.0).is_empty() && clipped(&square, |_| 1.0) == square);
    }
}
