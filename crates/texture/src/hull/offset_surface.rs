//! The offset surface: all points at a given distance from the object that can be reached from outside.
//!
//! The object may be any triangles: open, of several components, non-manifold. The distance is unsigned, so that a sheet gets a
//! surface around both sides; parts closer than twice the offset share one, others get a component each. Cavities that the
//! offset closes, and the inner side of closed surfaces, have none.
//!
//! Distances are sampled on a body-centred cubic lattice, whose tetrahedra are cut where they change sides (A. Doi and A. Koide,
//! "An Efficient Method of Triangulating Equi-Valued Surfaces by Using Tetrahedral Cells", IEICE Transactions 1991): every
//! surface is a closed manifold, whatever the object. Lattice and distances are computed in 64 bits; vertices are rounded once.

use crate::hull::lattice::{Lattice, Node, Nodes};
use crate::hull::layered::Layered;
use crate::hull::outside::not_outside;
use glam::UVec3;
use rayon::prelude::*;
use silhouette_core::glam;
use silhouette_core::mesh::Bounds;
use silhouette_core::{Cancelled, Progress, TriangleMesh, glam::DVec3};
use silhouette_rays::MeshHierarchy;

/// Side of a lattice cube as a share of the offset. The side is the diameter of a tetrahedron. As it is less than the offset,
/// any tetrahedron with a point of the object is inside altogether, and the surface encloses the object.
pub const CELL: f64 = 0.8;

/// Most nodes of a lattice, each of which takes 2 bits of memory.
pub const MAX_NODES: u64 = 1 << 27;

/// Most faces of a surface.
pub const MAX_FACES: usize = 1 << 23;

/// Least and most share of a lattice edge at which it is cut. Keeps vertices near a node apart.
const CUT: [f64; 2] = [0.05, 0.95];

/// Distances that a task measures before it asks again: some milliseconds.
const DISTANCES_BETWEEN_CHECKS: usize = 1024;

/// Why there is no surface at an offset.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OffsetError {
    /// Its lattice or surface would be beyond [`MAX_NODES`] or [`MAX_FACES`], or have more faces than asked for.
    #[error("an offset of {0} is too small a share of the object's size: its surface would take too many faces")]
    TooFine(f64),
    /// A vertex would have a coordinate that is not a finite 32-bit float.
    #[error("an offset of {0} reaches beyond the 32-bit floats")]
    TooFar(f64),
    /// The work was stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// The surface at a distance from a mesh of the given bounds, wound counter-clockwise seen from outside. A closed manifold;
/// at 32-bit rounding (an offset of a few steps of the largest coordinate), vertices may coincide.
///
/// Each vertex lies on a lattice edge from a point closer than `offset` to one that is not, so that its distance to the mesh is
/// within [`CELL`] times the offset of it, and far closer where the surface is smooth. The same bits for any number of
/// threads. O(nodes / 1000 + faces) distances.
///
/// # Errors
/// [`OffsetError`]; at most `most_faces` faces are made, and [`MAX_FACES`].
pub fn offset_surface(
    mesh: &MeshHierarchy,
    bounds: &Bounds,
    offset: f64,
    most_faces: usize,
    progress: &dyn Progress,
) -> Result<TriangleMesh, OffsetError> {
    let lattice = Lattice::around(bounds, offset, CELL * offset, MAX_NODES).ok_or(OffsetError::TooFine(offset))?;
    let inside = not_outside(&lattice.within(mesh, offset, progress)?, progress)?;
    let size = lattice.size();
    let of_layer = |z: u32| {
        progress.check()?;
        let mut triangles = Vec::new();
        // The outermost have none.
        if z > 0 && z < size.z - 1 {
            (1..size.y - 1).for_each(|y| cut_row(&lattice, &inside, y, z, &mut triangles));
        }
        Ok(triangles)
    };
    let layers: Vec<Vec<[Cut; 3]>> = (0..size.z).into_par_iter().map(of_layer).collect::<Result<_, Cancelled>>()?;
    if layers.iter().map(Vec::len).sum::<usize>() > most_faces.min(MAX_FACES) {
        return Err(OffsetError::TooFine(offset));
    }
    let cuts = Layered::of(&lattice, &layers, |[inner, _]: Cut| inner, |triangle| *triangle, progress)?;
    let numbered: Vec<Vec<[u32; 3]>> = layers
        .par_iter()
        .map(|triangles| {
            progress.check()?;
            Ok(triangles.iter().map(|triangle| triangle.map(|cut| cuts.number(cut))).collect())
        })
        .collect::<Result<_, Cancelled>>()?;
    let places = places(&lattice, mesh, offset, &cuts, progress)?;
    TriangleMesh::new(places, numbered.concat()).map_err(|_| OffsetError::TooFar(offset))
}

/// A lattice edge that is cut: the numbers of its inner and its outer node.
type Cut = [u32; 2];

/// Where edges are cut: the distances at their ends are interpolated linearly.
fn places(
    lattice: &Lattice,
    mesh: &MeshHierarchy,
    offset: f64,
    cuts: &Layered<Cut>,
    progress: &dyn Progress,
) -> Result<Vec<glam::Vec3>, Cancelled> {
    let nodes = Layered::of(lattice, &cuts.layers, |node: u32| node, |cut| *cut, progress)?;
    // No tetrahedron is longer than a cube.
    let farthest = offset * (1.0 + 2.0 * CELL);
    let distance =
        |&number: &u32| mesh.nearest(lattice.place(lattice.node(number)), farthest).map_or(farthest, |at| at.distance);
    let of_layer = |nodes: &Vec<u32>| {
        let mut distances = Vec::with_capacity(nodes.len());
        for nodes in nodes.chunks(DISTANCES_BETWEEN_CHECKS) {
            progress.check()?;
            distances.extend(nodes.iter().map(distance));
        }
        Ok(distances)
    };
    let distances: Vec<Vec<f64>> = nodes.layers.par_iter().map(of_layer).collect::<Result<_, Cancelled>>()?;
    let distances = distances.concat();
    let end = |number: u32| {
        let place: DVec3 = lattice.place(lattice.node(number));
        (place, distances[nodes.number(number) as usize])
    };
    let place = |&[inner, outer]: &Cut| {
        let ((from, near), (to, far)) = (end(inner), end(outer));
        let share = ((offset - near) / (far - near)).clamp(CUT[0], CUT[1]);
        from.lerp(to, share).as_vec3()
    };
    let of_layer = |cuts: &Vec<Cut>| {
        progress.check()?;
        Ok(cuts.iter().map(place).collect())
    };
    let places: Vec<Vec<glam::Vec3>> = cuts.layers.par_iter().map(of_layer).collect::<Result<_, Cancelled>>()?;
    Ok(places.concat())
}

/// Cuts the tetrahedra at the corners of a row. Those of a corner lie around the three edges that leave it along the axes; four
/// middles are around each.
fn cut_row(lattice: &Lattice, inside: &Nodes, y: u32, z: u32, triangles: &mut Vec<[Cut; 3]>) {
    for x in cubes_with_a_change(inside, y, z) {
        let cube = UVec3::new(x, y, z);
        for axis in 0..3 {
            let [along, next, after] = [0, 1, 2].map(|step| UVec3::AXES[(axis + step) % 3]);
            let corners = [cube, cube + along].map(|cube| Node { is_middle: false, cube });
            // Counter-clockwise around the edge.
            let around = [cube - next - after, cube - after, cube, cube - next];
            for at in 0..4 {
                let middles = [around[at], around[(at + 1) % 4]].map(|cube| Node { is_middle: true, cube });
                cut([corners[0], corners[1], middles[0], middles[1]], lattice, inside, triangles);
            }
        }
    }
}

/// The corners of a row for which not all nodes of their tetrahedra are on the same side.
fn cubes_with_a_change(inside: &Nodes, y: u32, z: u32) -> impl Iterator<Item = u32> {
    let corners = [inside.row(false, y, z), inside.row(false, y + 1, z), inside.row(false, y, z + 1)];
    let middles = [(y, z), (y - 1, z), (y, z - 1), (y - 1, z - 1)].map(|(y, z)| inside.row(true, y, z));
    (0..corners[0].len()).flat_map(move |word| {
        let next = corners[0][word] >> 1 | corners[0].get(word + 1).map_or(0, |next| next << 63);
        let (mut all, mut any) = (next, next);
        for row in corners {
            (all, any) = (all & row[word], any | row[word]);
        }
        for row in middles {
            let previous = row[word] << 1 | if word == 0 { 0 } else { row[word - 1] >> 63 };
            (all, any) = (all & row[word] & previous, any | row[word] | previous);
        }
        let mut change = any & !all;
        std::iter::from_fn(move || {
            let bit = (change != 0).then(|| change.trailing_zeros())?;
            change &= change - 1;
            Some(word as u32 * 64 + bit)
        })
    })
}

/// Cuts a tetrahedron whose last three nodes run counter-clockwise seen from the first, reversed for those beyond it.
fn cut(nodes: [Node; 4], lattice: &Lattice, inside: &Nodes, triangles: &mut Vec<[Cut; 3]>) {
    let is_inside = nodes.map(|node| inside.has(node));
    let number = |node: usize| lattice.number(nodes[node]);
    let between = |inner: usize, outer: usize| [number(inner), number(outer)];
    // Even permutations that begin with a node, or with two.
    const FIRST: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]];
    const PAIRS: [[usize; 4]; 6] = [[0, 1, 2, 3], [2, 3, 0, 1], [0, 2, 3, 1], [3, 1, 0, 2], [0, 3, 1, 2], [1, 2, 0, 3]];
    match is_inside.iter().filter(|&&is_inside| is_inside).count() {
        1 => {
            for [a, b, c, d] in FIRST.into_iter().filter(|order| is_inside[order[0]]) {
                triangles.push([between(a, b), between(a, c), between(a, d)]);
            }
        }
        2 => {
            for [a, b, c, d] in PAIRS.into_iter().filter(|order| is_inside[order[0]] && is_inside[order[1]]) {
                let [ac, ad, bd, bc] = [between(a, c), between(a, d), between(b, d), between(b, c)];
                triangles.extend([[ac, ad, bd], [ac, bd, bc]]);
            }
        }
        3 => {
            for [a, b, c, d] in FIRST.into_iter().filter(|order| !is_inside[order[0]]) {
                triangles.push([between(b, a), between(d, a), between(c, a)]);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;
    use silhouette_core::inspect::{Inspection, inspect};
    use silhouette_core::{NoProgress, Topology, shapes};
    use silhouette_testing::progress::Cancelling;
    use silhouette_testing::strategies::soup;
    use silhouette_testing::threads::with_threads;
    use silhouette_testing::{edits, zoo};

    fn surface(mesh: &TriangleMesh, offset: f64) -> TriangleMesh {
        offset_surface(&MeshHierarchy::new(mesh), &mesh.bounds().unwrap(), offset, MAX_FACES, &NoProgress).unwrap()
    }

    fn inspected(mesh: &TriangleMesh) -> Inspection {
        inspect(mesh, &Topology::new(mesh))
    }

    fn assert_closed_manifold(mesh: &TriangleMesh) {
        let found = inspected(mesh);
        assert!(found.is_closed && found.is_manifold && found.is_consistently_wound, "{found:?}");
    }

    /// In any unit of length, and where 32-bit floats are a thousandth of the radius apart.
    #[test]
    fn the_surface_of_a_ball_is_a_ball() {
        let ball = shapes::by_name("icosphere:5").unwrap();
        for (scale, origin) in [(1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e4)] {
            let placed = edits::transformed(&ball, scale, DVec3::splat(origin));
            let surface = surface(&placed, 0.2 * scale);
            let found = inspected(&surface);
            assert_eq!((found.euler_characteristic, found.components.len()), (2, 1), "scale {scale}, origin {origin}");
            let volume = found.components[0].volume.unwrap() / scale.powi(3);
            assert!((volume / (1.2_f64.powi(3) * 4.0 / 3.0 * std::f64::consts::PI) - 1.0).abs() < 0.02, "{volume}");
            assert_closed_manifold(&surface);
            for position in surface.positions() {
                let radius = (position.as_dvec3() - origin).length() / scale;
                // Rounding at the origin of 1e4 is about 1e-3; interpolation and faceting below 1 % of the offset, but for
                // the least share at which an edge is cut.
                assert!((radius - 1.2).abs() < 0.2 * CELL * CUT[0] + 3e-3, "{radius}");
            }
        }
    }

    #[test]
    fn every_shape_gets_a_closed_manifold_at_its_distance() {
        for (name, mesh) in zoo::all() {
            let offset = 0.1 * mesh.bounds().unwrap().radius;
            let surface = surface(&mesh, offset);
            assert_closed_manifold(&surface);
            let hierarchy = MeshHierarchy::new(&mesh);
            for position in surface.positions() {
                let distance = hierarchy.nearest(position.as_dvec3(), f64::INFINITY).unwrap().distance;
                assert!((distance - offset).abs() <= CELL * offset * 1.0001, "{name}: {distance} for {offset}");
            }
        }
    }

    #[test]
    fn parts_share_a_surface_where_they_are_closer_than_twice_the_offset() {
        let ball = shapes::by_name("icosphere:3").unwrap();
        let pair = |gap: f32| edits::joined(&[&ball, &edits::moved(&ball, Vec3::X * (2.0 + gap))]);
        for (gap, components) in [(0.1, 1), (1.0, 2)] {
            let found = inspected(&surface(&pair(gap), 0.2));
            assert_eq!((found.components.len(), found.euler_characteristic), (components, 2 * components as i64));
        }
        let torus = inspected(&surface(&shapes::by_name("torus:60,40").unwrap(), 0.1));
        assert_eq!((torus.components.len(), torus.euler_characteristic), (1, 0));
    }

    #[test]
    fn the_inside_of_a_closed_surface_has_none_and_a_sheet_has_both_sides() {
        let ball = shapes::by_name("icosphere:4").unwrap();
        let inner = edits::mapped(&ball, |position| position * 0.4);
        let nested = inspected(&surface(&edits::joined(&[&ball, &inner]), 0.1));
        assert_eq!((nested.components.len(), nested.euler_characteristic), (1, 2));
        let face = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
        let around = inspected(&surface(&face, 0.05));
        assert_eq!((around.components.len(), around.euler_characteristic), (1, 2));
        // Twice the area, half a cylinder around each side, and a ball in all at the corners.
        let expected =
            2.0 * 0.5 + std::f64::consts::PI * 0.05 * (2.0 + 2.0_f64.sqrt()) + 4.0 * std::f64::consts::PI * 0.0025;
        assert!((around.components[0].area / expected - 1.0).abs() < 0.05, "{}", around.components[0].area);
    }

    #[test]
    fn offsets_that_are_too_fine_or_too_far_are_refused() {
        let ball = shapes::by_name("icosphere:1").unwrap();
        let refused = |mesh: &TriangleMesh, offset: f64, most: usize| {
            offset_surface(&MeshHierarchy::new(mesh), &mesh.bounds().unwrap(), offset, most, &NoProgress).unwrap_err()
        };
        assert_eq!(refused(&ball, 1e-6, MAX_FACES), OffsetError::TooFine(1e-6));
        assert_eq!(refused(&ball, 0.1, 100), OffsetError::TooFine(0.1));
        let vast = edits::mapped(&ball, |position| position * 3e38);
        assert_eq!(refused(&vast, 1e38, MAX_FACES), OffsetError::TooFar(1e38));
    }

    #[test]
    fn threads_do_not_change_a_bit() {
        let blob = shapes::by_name("blob:3000").unwrap();
        let [one, four] = [1, 4].map(|count| with_threads(count, || surface(&blob, 0.05)));
        assert_eq!(one, four);
    }

    /// Each of its steps asks in each layer, so that none is long whatever the number of faces; cancelled in any, it stops.
    #[test]
    fn every_step_asks_and_stops() {
        let blob = shapes::by_name("blob:3000").unwrap();
        let (hierarchy, bounds) = (MeshHierarchy::new(&blob), blob.bounds().unwrap());
        let offset = 0.05;
        let layers = Lattice::around(&bounds, offset, CELL * offset, MAX_NODES).unwrap().size().z;
        let stopped_at = |poll: u32| {
            let cancelling = Cancelling::at_poll(u64::from(poll));
            offset_surface(&hierarchy, &bounds, offset, MAX_FACES, &cancelling)
        };
        for steps in 0..6 {
            assert_eq!(stopped_at(steps * (layers - 2)), Err(OffsetError::Cancelled(Cancelled)), "{steps}");
        }
        assert!(stopped_at(u32::MAX).is_ok());
    }

    proptest! {
        #[test]
        fn any_triangles_get_a_closed_manifold(mesh in soup(12), offset in 0.2_f64..2.0) {
            prop_assume!(mesh.face_count() > 0);
            assert_closed_manifold(&surface(&mesh, offset));
        }
    }
}
