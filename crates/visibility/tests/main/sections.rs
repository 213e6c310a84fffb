//! Section planes: what is cut, in which curves, and what is seen of them.

use crate::scenes::framing;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{FaceId, NoProgress, Topology, TriangleMesh, VertexId};
use silhouette_testing::edits::{joined, moved};
use silhouette_testing::random::Random;
use silhouette_testing::real_meshes::real_meshes;
use silhouette_testing::zoo::{self, builtin};
use silhouette_visibility::{
    Chain, LineFinder, LineKind, LineOptions, LineScene, Lines, SceneError, SectionPlane, SectionedMesh,
};
use std::collections::{BTreeMap, HashMap};
use std::f64::consts::PI;

fn plane(point: impl Into<Vec3>, normal: impl Into<Vec3>) -> SectionPlane {
    SectionPlane::new(point.into(), normal.into()).unwrap()
}

fn opposite(of: &SectionPlane) -> SectionPlane {
    plane(of.point(), -of.normal())
}

fn cut(mesh: &TriangleMesh, plane: &SectionPlane) -> SectionedMesh {
    SectionedMesh::whole(mesh.clone()).cut(plane).unwrap()
}

type Place = [u32; 3];

/// Places at the ends of section edges, those of no length left out.
fn segments(section: &SectionedMesh) -> Vec<[Place; 2]> {
    let place = |vertex: usize| (section.mesh.positions()[vertex] + Vec3::ZERO).to_array().map(f32::to_bits);
    let ends = section.edges.iter().map(|ends| ends.map(|end| place(end.index())));
    let mut segments: Vec<[Place; 2]> = ends.filter(|[a, b]| a != b).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    segments.sort_unstable();
    segments
}

/// Places at which an odd number of section edges ends.
fn loose_ends(section: &SectionedMesh) -> usize {
    let mut degrees: HashMap<Place, usize> = HashMap::new();
    segments(section).into_iter().flatten().for_each(|place| *degrees.entry(place).or_default() += 1);
    degrees.values().filter(|&&degree| degree % 2 == 1).count()
}

fn area(mesh: &TriangleMesh) -> f64 {
    let of = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        (b - a).cross(c - a).length() * 0.5
    };
    mesh.triangles().iter().map(of).sum()
}

/// The area that section curves enclose, which stay on the left of the faces that remain: by Stokes, from their boundary.
fn enclosed(section: &SectionedMesh, plane: &SectionPlane) -> f64 {
    let normal = plane.normal().as_dvec3().normalize();
    let is_cut = |ends: [u32; 2]| {
        let ends = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        section.edges.binary_search_by(|edge| edge.map(VertexId::get).cmp(&ends)).is_ok()
    };
    let at = |vertex: u32| section.mesh.positions()[vertex as usize].as_dvec3() - plane.point().as_dvec3();
    let sides = section.mesh.triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    // What remains has its boundary the other way round than what would close it.
    sides.filter(|&ends| is_cut(ends)).map(|[a, b]| -0.5 * at(a).cross(at(b)).dot(normal)).sum::<f64>().abs()
}

fn middle(mesh: &TriangleMesh) -> Vec3 {
    mesh.bounds().unwrap().center.as_vec3()
}

/// Along axes and aslant, through the middle and through vertices.
fn planes(mesh: &TriangleMesh, random: &mut Random) -> Vec<SectionPlane> {
    let normals = [Vec3::X, Vec3::NEG_Y, Vec3::Z, Vec3::new(1.0, 2.0, -0.5), Vec3::new(-0.3, 0.2, 1.0)];
    let vertex = |random: &mut Random| mesh.corners(FaceId::from_usize(random.below(mesh.face_count())))[0];
    normals.into_iter().flat_map(|normal| [plane(middle(mesh), normal), plane(vertex(random), normal)]).collect()
}

#[test]
fn closed_meshes_are_cut_in_closed_polygons() {
    let mut random = Random::new(7);
    let mut cuts = 0;
    let closed = zoo::closed().into_iter().map(|(name, mesh)| (name.to_owned(), mesh));
    for (name, mesh) in closed.chain(real_meshes("closed_meshes_are_cut_in_closed_polygons")) {
        let topology = Topology::new(&mesh);
        if topology.boundary_edge_count() + topology.non_manifold_edge_count() > 0 || mesh.face_count() == 0 {
            continue;
        }
        for plane in planes(&mesh, &mut random) {
            let section = cut(&mesh, &plane);
            assert_eq!(loose_ends(&section), 0, "{name} by {plane}");
            cuts += usize::from(!section.edges.is_empty());
        }
    }
    assert!(cuts > 100, "{cuts}");
}

/// Whatever the mesh: both sides of a plane are the whole, and have the section in common.
#[test]
fn both_sides_are_the_whole() {
    let mut random = Random::new(11);
    for (name, mesh) in zoo::all() {
        for plane in planes(&mesh, &mut random) {
            let in_plane = |triangle: &&[u32; 3]| {
                triangle.iter().all(|&vertex| plane.side(mesh.positions()[vertex as usize]).is_eq())
            };
            if mesh.triangles().iter().any(|triangle| in_plane(&triangle)) {
                continue;
            }
            let sides = [cut(&mesh, &plane), cut(&mesh, &opposite(&plane))];
            let (parts, whole) = (sides.iter().map(|side| area(&side.mesh)).sum::<f64>(), area(&mesh));
            assert!((parts - whole).abs() <= 1e-5 * whole, "{name} by {plane}: {parts} of {whole}");
            if sides.iter().all(|side| side.mesh.face_count() > 0) {
                let [one, other] = sides.each_ref().map(|side| {
                    let mut distinct = segments(side);
                    distinct.dedup();
                    distinct
                });
                assert_eq!(one, other, "{name} by {plane}");
            }
            for side in &sides {
                assert!(side.face_of.is_sorted() && side.face_of.len() == side.mesh.face_count());
                assert_eq!(side.mesh.positions()[..mesh.vertex_count()], *mesh.positions());
            }
        }
    }
}

#[test]
fn sections_have_the_areas_of_closed_forms() {
    let hexagon = plane(Vec3::ZERO, Vec3::ONE);
    let cube = builtin("cube");
    let side = cube.bounds().unwrap().max.x - cube.bounds().unwrap().min.x;
    let section = cut(&cube, &hexagon);
    let found = enclosed(&section, &hexagon);
    assert!((found - 0.75 * 3.0_f64.sqrt() * side * side).abs() < 1e-5, "{found}");

    // Of inscribed polygons, so that areas are a little less.
    let near =
        |found: f64, expected: f64| assert!((0.995..=1.0).contains(&(found / expected)), "{found} for {expected}");
    let sphere = builtin("icosphere:5");
    for height in [0.0, 0.5, -0.9_f32] {
        let plane = plane(Vec3::Y * height, Vec3::Y * 3.0);
        near(enclosed(&cut(&sphere, &plane), &plane), PI * (1.0 - f64::from(height).powi(2)));
    }
    let torus = builtin("torus:300,150,1,0.3");
    let around = plane(Vec3::ZERO, Vec3::Y);
    near(enclosed(&cut(&torus, &around), &around), PI * (1.3_f64.powi(2) - 0.7_f64.powi(2)));
    let across = plane(Vec3::ZERO, Vec3::X);
    near(enclosed(&cut(&torus, &across), &across), 2.0 * PI * 0.3_f64.powi(2));
}

/// A staircase of two steps, closed: its lower tread is at y = 1, from x = 1 to 2.
fn staircase() -> TriangleMesh {
    let profile = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let positions = [0.0, 1.0].into_iter().flat_map(|z| profile.map(|[x, y]| Vec3::new(x, y, z))).collect();
    let mut triangles = vec![];
    for [a, b, c] in [[0, 1, 2], [0, 2, 3], [0, 3, 5], [3, 4, 5]] {
        triangles.extend([[a, c, b], [a + 6, b + 6, c + 6]]);
    }
    for a in 0..6 {
        let b = (a + 1) % 6;
        triangles.extend([[a, b, b + 6], [a, b + 6, a + 6]]);
    }
    TriangleMesh::new(positions, triangles).unwrap()
}

#[test]
fn faces_in_the_plane_stay_with_the_solid_that_they_bound() {
    let cube = builtin("cube");
    let top = cube.bounds().unwrap().max.y as f32;
    let touching = plane(Vec3::Y * top, Vec3::Y);
    assert_eq!(cut(&cube, &touching), SectionedMesh::whole(cube.clone()));
    assert_eq!(cut(&cube, &opposite(&touching)).mesh.face_count(), 0);

    let stairs = staircase();
    for mesh in [stairs.clone(), joined(&[&stairs, &moved(&stairs, Vec3::Z * 5.0)])] {
        let solids = mesh.face_count() as f64 / stairs.face_count() as f64;
        let tread = plane(Vec3::Y, Vec3::Y);
        let (below, above) = (cut(&mesh, &tread), cut(&mesh, &opposite(&tread)));
        // The lower step keeps its tread and is open where the upper one stood; the upper one is open at its foot.
        for (side, open_area) in [(&below, 2.0 * 2.0 + 2.0 + 2.0 + 1.0), (&above, 1.0 + 4.0)] {
            assert_eq!(loose_ends(side), 0);
            assert!((enclosed(side, &tread) - solids).abs() < 1e-6, "the foot of the upper step");
            assert!((area(&side.mesh) - solids * open_area).abs() < 1e-5, "{}", area(&side.mesh));
        }
        // A plane within a rounding above or below is another matter, but no worse.
        for height in [1.0_f32.next_up(), 1.0_f32.next_down()] {
            assert_eq!(loose_ends(&cut(&mesh, &plane(Vec3::Y * height, Vec3::Y))), 0);
        }
    }
    // A sheet that lies in the plane is on neither side.
    let corners = vec![Vec3::Y, Vec3::new(1.0, 1.0, 0.0), Vec3::ONE, Vec3::new(0.0, 1.0, 1.0)];
    let sheet = TriangleMesh::new(corners, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let with_box = joined(&[&sheet, &moved(&builtin("cube"), Vec3::X * 9.0)]);
    for normal in [Vec3::Y, Vec3::NEG_Y] {
        let by = plane(Vec3::Y, normal);
        assert_eq!(cut(&sheet, &by).mesh, sheet);
        assert!(cut(&with_box, &by).face_of.starts_with(&[FaceId::new(0), FaceId::new(1)]));
    }
}

/// Edges in the plane: an octahedron is cut along its equator without a new vertex.
#[test]
fn vertices_and_edges_in_the_plane_need_no_new_vertices() {
    let positions = vec![Vec3::X, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Z, Vec3::Y, Vec3::NEG_Y];
    let around = (0..4_u32).map(|a| [a, (a + 1) % 4]);
    let triangles = around.flat_map(|[a, b]| [[b, a, 4], [a, b, 5]]).collect();
    let octahedron = TriangleMesh::new(positions, triangles).unwrap();
    let equator = plane(Vec3::ZERO, Vec3::Y);
    let section = cut(&octahedron, &equator);
    assert_eq!((section.mesh.vertex_count(), section.mesh.face_count(), section.edges.len()), (6, 4, 4));
    assert!((enclosed(&section, &equator) - 2.0).abs() < 1e-12);
    // Through two vertices and the middles of two edges.
    let aslant = plane(Vec3::ZERO, Vec3::new(1.0, 0.0, 1.0));
    let section = cut(&octahedron, &aslant);
    assert_eq!((section.mesh.vertex_count(), loose_ends(&section)), (8, 0));
}

/// A vertex may miss the plane by less than a rounding of what is cut there.
#[test]
fn no_section_edge_is_without_length() {
    for off in [1e-19, -1e-19, 1e-30, -1e-30, 4e-9, -4e-9, 0.0] {
        let equator =
            [Vec3::new(1.0, off, 0.0), Vec3::new(0.0, 0.3, 1.0), Vec3::new(-1.0, -0.2, 0.0), Vec3::new(0.0, 0.4, -1.0)];
        let positions = [&equator[..], &[Vec3::Y, Vec3::NEG_Y]].concat();
        let around = (0..4_u32).map(|a| [a, (a + 1) % 4]);
        let triangles = around.flat_map(|[a, b]| [[b, a, 4], [a, b, 5]]).collect();
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        for normal in [Vec3::Y, Vec3::NEG_Y] {
            let section = cut(&mesh, &plane(Vec3::ZERO, normal));
            assert_eq!((loose_ends(&section), segments(&section).len()), (0, section.edges.len()), "{off}");
        }
    }
    // What can be distinguished stays distinct.
    let cube = builtin("cube");
    for height in [1.0_f32.next_down(), -1.0_f32.next_down()] {
        assert!(cut(&cube, &plane(Vec3::Y * height, Vec3::Y)).mesh.vertex_count() > cube.vertex_count(), "{height}");
    }
}

#[test]
fn seams_are_cut_alike_on_both_sides() {
    for (name, mesh) in zoo::closed() {
        let corners: Vec<Vec3> = mesh.triangles().iter().flatten().map(|&v| mesh.positions()[v as usize]).collect();
        let count = corners.len() as u32;
        let soup =
            TriangleMesh::new(corners, (0..count / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect());
        let soup = soup.unwrap();
        let mut random = Random::new(3);
        for plane in planes(&mesh, &mut random) {
            let [mut joined, mut apart] = [segments(&cut(&mesh, &plane)), segments(&cut(&soup, &plane))];
            joined.dedup();
            apart.dedup();
            assert_eq!(joined, apart, "{name} by {plane}");
        }
    }
}

#[test]
fn each_plane_cuts_further() {
    let sphere = builtin("icosphere:4");
    let (one, other) = (plane(Vec3::ZERO, Vec3::X), plane(Vec3::ZERO, Vec3::new(0.1, 1.0, 0.3)));
    let half = cut(&sphere, &one);
    let quarter = half.clone().cut(&other).unwrap();
    let ratio = area(&quarter.mesh) / area(&sphere);
    let angle = one.normal().angle_between(other.normal());
    assert!((ratio - (PI - f64::from(angle)) / (2.0 * PI)).abs() < 0.01, "{ratio}");
    // Two arcs of half a circle each, which meet in two points.
    let length = |section: &SectionedMesh| -> f64 {
        let at = |end: VertexId| section.mesh.positions()[end.index()].as_dvec3();
        section.edges.iter().map(|[a, b]| at(*a).distance(at(*b))).sum()
    };
    assert!((length(&half) / (2.0 * PI) - 1.0).abs() < 0.01 && (length(&quarter) / (2.0 * PI) - 1.0).abs() < 0.01);
    assert_eq!(loose_ends(&quarter), 0);
    // The other side of a plane whose vertices lie in it exactly leaves nothing, and no edge.
    let gone = half.cut(&opposite(&one)).unwrap();
    assert!(area(&gone.mesh) < 1e-5, "{}", area(&gone.mesh));
}

#[test]
fn sections_are_seen_as_lines_of_their_own_kind() {
    let hexagon = plane(Vec3::ZERO, Vec3::ONE);
    let section = cut(&builtin("cube"), &hexagon);
    let scene = LineScene::of_meshes(&[&section.mesh]).unwrap().with_section_edges(section.edges.clone()).unwrap();
    let find = |direction: DVec3, options: &LineOptions| {
        let camera = framing(&section.mesh, direction, direction != DVec3::ONE);
        LineFinder::new(scene.clone(), &NoProgress).unwrap().find(&camera, options, &NoProgress).unwrap()
    };
    let lines = find(DVec3::new(1.0, 1.1, 0.9), &LineOptions::default());
    let counts = lines.chains.iter().fold(BTreeMap::new(), |mut counts, chain| {
        *counts.entry(chain.style.kind.name()).or_insert(0) += 1;
        counts
    });
    assert_eq!(counts.get("section"), Some(&1));
    let chain = lines.chains.iter().find(|chain| chain.style.kind == LineKind::Section).unwrap();
    // The diagonals of the faces are cut as well.
    assert!(chain.closed && chain.points.len() == 12, "{chain:?}");
    let sides = chain.points.iter().zip(chain.points.iter().cycle().skip(1)).map(|(a, b)| a.distance(*b));
    assert!((sides.sum::<f64>() - 6.0 * 2.0_f64.sqrt()).abs() < 1e-6);
    // Along the normal, three quarters of the three edges of the corner opposite are seen inside of the hexagon.
    let with_creases = LineOptions { ridge_deg: Some(30.0), valley_deg: Some(30.0), ..LineOptions::default() };
    let corner = DVec3::NEG_ONE;
    let inner = find(DVec3::ONE, &with_creases);
    let at_corner = |chain: &Chain<'_>| -> f64 {
        let pairs = chain.points.windows(2).filter(|pair| pair.contains(&corner));
        pairs.map(|pair| pair[0].distance(pair[1])).sum()
    };
    let seen: f64 = inner.chains.iter().map(|chain| at_corner(&chain)).sum();
    assert!((seen - 4.5).abs() < 1e-4, "{seen}");
    let without = find(DVec3::new(1.0, 1.1, 0.9), &LineOptions { section: false, ..LineOptions::default() });
    assert!(without.chains.iter().all(|chain| chain.style.kind != LineKind::Section));
    // From the other side the corner hides most of it.
    let behind = find(-DVec3::new(1.0, 1.1, 0.9), &LineOptions::default());
    let length = |lines: &Lines| -> f64 {
        lines.chains.iter().filter(|c| c.style.kind == LineKind::Section).map(|c| c.length_px()).sum()
    };
    assert!(length(&behind) < length(&lines), "{} of {}", length(&behind), length(&lines));
    let bad = vec![[VertexId::new(0), VertexId::new(999)]];
    assert_eq!(scene.with_section_edges(bad).unwrap_err(), SceneError::Section { edge: 0 });
}
