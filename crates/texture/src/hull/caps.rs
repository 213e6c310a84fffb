//! Caps over the holes of an open object, so that its hull does not lead through them.
//!
//! An offset surface goes through every hole wider than twice the offset and covers the inside of the object as well, which
//! takes half of the hull's vertices where nobody looks. Boundary edges that are connected get a fan of triangles to the
//! middle of their vertices, whatever their order. Only the hull is shaped by caps; what it has to enclose is the object.

use glam::DVec3;
use silhouette_core::glam;
use silhouette_core::{Cancelled, DisjointSets, Progress, Topology, TriangleMesh};
use std::collections::BTreeMap;

/// The mesh with caps over those of its holes whose boxes have no side longer than `widest`, in object units; `None` if there
/// is none. O(F log F).
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn capped(
    mesh: &TriangleMesh,
    widest: f64,
    progress: &dyn Progress,
) -> Result<Option<TriangleMesh>, Cancelled> {
    progress.check()?;
    let topology = Topology::new(mesh);
    progress.check()?;
    let edges = topology.edges().iter().filter(|&(edge, [a, b])| a != b && topology.half_edges(edge).len() == 1);
    let edges: Vec<[u32; 2]> = edges.map(|(_, &edge)| edge).collect();
    let mut connected = DisjointSets::new(mesh.vertex_count());
    for &[a, b] in &edges {
        connected.unite(a, b);
    }
    let mut holes: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
    for &edge in &edges {
        holes.entry(connected.find(edge[0])).or_default().push(edge);
    }
    let (mut positions, mut triangles) = (mesh.positions().to_vec(), mesh.triangles().to_vec());
    for hole in holes.values() {
        progress.check()?;
        let places = || hole.as_flattened().iter().map(|&vertex| mesh.positions()[vertex as usize].as_dvec3());
        let (min, max) =
            places().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), p| (min.min(p), max.max(p)));
        if (max - min).max_element() <= widest {
            let middle = positions.len() as u32;
            positions.push((places().sum::<DVec3>() / (2.0 * hole.len() as f64)).as_vec3());
            triangles.extend(hole.iter().map(|&[a, b]| [a, b, middle]));
        }
    }
    // Beyond the ids of a mesh, none is capped.
    Ok((triangles.len() > mesh.face_count()).then(|| TriangleMesh::new(positions, triangles).ok()).flatten())
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::inspect::inspect;
    use silhouette_core::{NoProgress, shapes};
    use silhouette_testing::edits::keeping;

    #[test]
    fn holes_that_are_narrow_enough_are_closed() {
        let ball = shapes::by_name("icosphere:3").unwrap();
        let holes = [3, 700];
        let open = keeping(&ball, |face| !holes.contains(&face));
        let closed = capped(&open, 0.5, &NoProgress).unwrap().unwrap();
        let found = inspect(&closed, &Topology::new(&closed));
        assert!(found.is_closed && found.euler_characteristic == 2, "{found:?}");
        assert!(capped(&open, 1e-3, &NoProgress).unwrap().is_none());
        assert!(capped(&ball, 0.5, &NoProgress).unwrap().is_none());
    }
}
