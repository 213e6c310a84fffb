//! What a viewer that goes by the file draws: every silhouette edge, and no other smooth edge, up to the rounding of normals.

use crate::facts::File;
use crate::{glb, hard_edges};
use silhouette_core::glam::DVec3;
use silhouette_core::{FaceFacings, SilhouetteEdges, Topology, TriangleMesh, Viewpoint};
use silhouette_testing::{Random, zoo};

/// How far a normal may be from perpendicular to the view for its rounding to matter: stored components are within 1/65534.
const DOUBTFUL: f64 = 1e-4;

/// The edges that a viewer draws for an orthographic view, and those of which stored normals leave in doubt whether.
fn drawn(mesh: &TriangleMesh, toward_viewer: DVec3) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
    let file = File::of(&glb(mesh)).unwrap();
    let codes = file.codes().unwrap().unwrap();
    let normals = file.silhouette_normals().unwrap();
    let mut pairs = normals.as_chunks::<2>().0.iter();
    let (mut drawn, mut doubtful) = (Vec::new(), Vec::new());
    for (side, code) in codes.iter().enumerate() {
        let triangle = mesh.triangles()[side / 3];
        let (a, b) = (triangle[side % 3], triangle[(side + 1) % 3]);
        let edge = [a.min(b), a.max(b)];
        match code {
            1 => {
                let across = pairs.next().unwrap().map(|normal| DVec3::from(normal).dot(toward_viewer));
                if across.iter().any(|x| x.abs() < DOUBTFUL) {
                    doubtful.push(edge);
                } else if (across[0] > 0.0) != (across[1] > 0.0) {
                    drawn.push(edge);
                }
            }
            2 => drawn.push(edge),
            _ => {}
        }
    }
    assert_eq!(pairs.len(), 0);
    (drawn, doubtful)
}

#[test]
fn viewers_draw_the_silhouette_and_hard_edges() {
    let mut random = Random::new(17);
    let mut checked = 0;
    for (name, mesh) in zoo::edge_manifold() {
        let topology = Topology::new(&mesh);
        let is_hard = hard_edges(&mesh, &topology);
        for _ in 0..8 {
            let toward_viewer = random.vector().as_vec3();
            let viewpoint = Viewpoint::Orthographic { toward_viewer };
            let silhouette = SilhouetteEdges::of(&topology, &FaceFacings::new(&mesh, &viewpoint));
            let (drawn, doubtful) = drawn(&mesh, toward_viewer.as_dvec3().normalize());
            for edge in topology.edges().ids() {
                let pair = topology.edges()[edge];
                let expected = is_hard[edge] || silhouette.contains(edge);
                if !doubtful.contains(&pair) {
                    assert_eq!(drawn.contains(&pair), expected, "{name}: {pair:?} from {toward_viewer}");
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 1000, "{checked}");
}
