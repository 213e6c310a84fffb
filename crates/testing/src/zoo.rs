//! Built-in and defective meshes, by property.
//!
//! Every family of built-in shapes is there, each mesh small enough for brute force: at most 12 000 faces, most of them about 2000.

use crate::edits::{joined, keeping, moved, with_triangles};
use silhouette_core::TriangleMesh;
use silhouette_core::glam::Vec3;
use silhouette_core::shapes::by_name;

/// A mesh and what it is called in messages.
pub type Specimen = (&'static str, TriangleMesh);

/// A built-in shape, by its name on the command line with its arguments: `torus:40,24`.
pub fn builtin(name: &str) -> TriangleMesh {
    by_name(name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Closed, manifold, consistently wound: convex and not, smooth and with creases, of genus 0 and above, of one and of two
/// components.
pub fn closed() -> Vec<Specimen> {
    let mut closed = builtins([
        "cube",
        "icosphere:3",
        "uv-sphere:40,20",
        "ellipsoid:40,20",
        "cylinder",
        "cone",
        "torus:40,24",
        "knot",
        "gear",
        "ring",
        "blob:3000",
    ]);
    let second = moved(&builtin("torus:24,16"), Vec3::new(0.3, 1.1, 0.2));
    closed.push(("two tori", joined(&[&builtin("torus:30,20"), &second])));
    closed
}

/// Consistently wound, with edges of one and of two faces: one boundary loop, and many, two of which meet in a vertex.
pub fn with_boundary() -> Vec<Specimen> {
    let mut open = builtins(["grid:20,14"]);
    open.push(("blob with holes", keeping(&builtin("blob:2000,0.5"), |face| face % 37 != 0)));
    open
}

/// Closed meshes and those with a boundary: all that are consistently wound and have at most two faces at each edge.
pub fn edge_manifold() -> Vec<Specimen> {
    [closed(), with_boundary()].concat()
}

/// Meshes of which each breaks a rule: edges of three and four faces, neighbours wound against each other, faces listed twice,
/// faces without area.
pub fn defective() -> Vec<Specimen> {
    let cube = builtin("cube");
    let twice = [cube.triangles(), cube.triangles()].concat();
    let torus = builtin("torus:16,12");
    // To each true face one along an edge and back, and one that is a point.
    let flat = torus.triangles().iter().flat_map(|&[a, b, c]| [[a, b, a], [c, c, c], [a, b, c]]).collect();
    let mut defective = builtins(["moebius"]);
    defective.extend([
        ("finned blob", finned_blob()),
        ("book", book(3)),
        ("cube listed twice", with_triangles(&cube, twice)),
        ("torus with faces without area", with_triangles(&torus, flat)),
    ]);
    defective
}

/// All of the above.
pub fn all() -> Vec<Specimen> {
    [edge_manifold(), defective()].concat()
}

/// No vertex and no face.
pub fn empty() -> TriangleMesh {
    TriangleMesh::new(Vec::new(), Vec::new()).unwrap()
}

/// A blob of 600 faces with one more, face 600, on an edge of face 300, and with face 100 turned over.
pub fn finned_blob() -> TriangleMesh {
    let mesh = builtin("blob:600");
    let (mut positions, mut triangles) = (mesh.positions().to_vec(), mesh.triangles().to_vec());
    let [a, b, _] = triangles[300];
    positions.push(positions[a as usize] * 1.4);
    triangles.push([a, b, positions.len() as u32 - 1]);
    triangles[100].swap(0, 1);
    TriangleMesh::new(positions, triangles).unwrap()
}

/// `pages` triangles around the edge from vertex 0 to vertex 1, all of which run along it from 0 to 1.
pub fn book(pages: u32) -> TriangleMesh {
    let page = |index: u32| {
        let (sin, cos) = (f64::from(index) * std::f64::consts::TAU / f64::from(pages)).sin_cos();
        Vec3::new(cos as f32, 0.5, sin as f32)
    };
    let positions = [Vec3::ZERO, Vec3::Y].into_iter().chain((0..pages).map(page)).collect();
    TriangleMesh::new(positions, (0..pages).map(|index| [0, 1, 2 + index]).collect()).unwrap()
}

fn builtins<const COUNT: usize>(names: [&'static str; COUNT]) -> Vec<Specimen> {
    names.into_iter().map(|name| (name, builtin(name))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::Topology;
    use silhouette_core::inspect::{Inspection, inspect};
    use silhouette_core::shapes::BUILTINS;

    fn inspected((name, mesh): Specimen) -> (&'static str, Inspection) {
        (name, inspect(&mesh, &Topology::new(&mesh)))
    }

    #[test]
    fn each_set_has_its_property() {
        for (name, found) in closed().into_iter().map(inspected) {
            assert!(found.is_closed && found.is_manifold && found.is_consistently_wound, "{name}: {found:?}");
        }
        for (name, found) in with_boundary().into_iter().map(inspected) {
            assert!(found.boundary_edges > 0 && found.is_consistently_wound, "{name}: {found:?}");
            assert!(found.defects.non_manifold_edges.is_empty(), "{name}: {found:?}");
        }
        for (name, found) in defective().into_iter().map(inspected) {
            let has_area = found.defects.zero_area_faces.is_empty() && found.defects.repeated_vertex_faces.is_empty();
            assert!(!(found.is_manifold && found.is_consistently_wound && has_area), "{name}: {found:?}");
        }
    }

    #[test]
    fn every_family_of_shapes_is_there_and_small() {
        let all = all();
        // The machine room has more faces than brute force is quick for.
        for shape in BUILTINS.iter().filter(|shape| shape.name != "machine-room") {
            let is_of_family = |(name, _): &Specimen| name.split(':').next() == Some(shape.name);
            assert!(all.iter().any(is_of_family), "no {}", shape.name);
        }
        for (name, mesh) in &all {
            assert!((1..=12_000).contains(&mesh.face_count()), "{name}: {} faces", mesh.face_count());
        }
        let distinct: std::collections::BTreeSet<_> = all.iter().map(|(name, _)| name).collect();
        assert_eq!(distinct.len(), all.len());
    }
}
