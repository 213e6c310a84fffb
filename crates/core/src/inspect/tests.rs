use super::*;
use crate::id::{FaceId, VertexId};
use crate::shapes::{self, BUILTINS, Blob};
use glam::Vec3;
use proptest::prelude::*;

fn examine(mesh: &TriangleMesh) -> Inspection {
    inspect(mesh, &Topology::new(mesh))
}

fn builtin(name: &str) -> TriangleMesh {
    shapes::by_name(name).unwrap()
}

/// `mesh` with its arrays changed.
fn edited(mesh: &TriangleMesh, edit: impl FnOnce(&mut Vec<Vec3>, &mut Vec<[u32; 3]>)) -> TriangleMesh {
    let (mut positions, mut triangles) = (mesh.positions().to_vec(), mesh.triangles().to_vec());
    edit(&mut positions, &mut triangles);
    TriangleMesh::new(positions, triangles).unwrap()
}

/// The second mesh appended to the first.
fn joined(first: &TriangleMesh, second: &TriangleMesh) -> TriangleMesh {
    edited(first, |positions, triangles| {
        let offset = positions.len() as u32;
        positions.extend(second.positions().iter().map(|p| *p + Vec3::X * 10.0));
        triangles.extend(second.triangles().iter().map(|t| t.map(|v| v + offset)));
    })
}

fn face_ids(ids: &[u32]) -> Vec<FaceId> {
    ids.iter().copied().map(FaceId::new).collect()
}

fn vertex_ids(ids: &[u32]) -> Vec<VertexId> {
    ids.iter().copied().map(VertexId::new).collect()
}

fn edge_defects(mesh: &TriangleMesh, defects: &[([u32; 2], &[u32])]) -> Vec<EdgeDefect> {
    let topology = Topology::new(mesh);
    let defect = |&([a, b], faces): &([u32; 2], &[u32])| {
        let vertices = [a, b].map(VertexId::new);
        EdgeDefect { edge: topology.find_edge(vertices[0], vertices[1]).unwrap(), vertices, faces: face_ids(faces) }
    };
    defects.iter().map(defect).collect()
}

/// An arrowhead as the fan from its second corner: face 0 folds back over face 1.
fn folded(place: impl Fn(f32, f32) -> Vec3) -> TriangleMesh {
    let positions = [(0.0, 0.0), (4.0, 4.0), (0.0, 2.0), (-4.0, 4.0)].map(|(x, y)| place(x, y)).to_vec();
    TriangleMesh::new(positions, vec![[1, 2, 3], [1, 3, 0]]).unwrap()
}

#[test]
fn faces_folded_onto_each_other_are_found() {
    let [right, up] = [Vec3::new(0.6, 0.3, -0.2), Vec3::new(-0.1, 0.7, 0.9)];
    let flat = folded(|x, y| Vec3::new(x, y, 7.0));
    let tilted = folded(|x, y| Vec3::splat(30.0) + right * x + up * y);
    for mesh in [flat, tilted] {
        assert_eq!(examine(&mesh).defects.folded_edges, edge_defects(&mesh, &[([1, 3], &[0, 1])]));
        // Turning one face over makes the winding inconsistent, and leaves the fold.
        let turned = edited(&mesh, |_, triangles| triangles[0].reverse());
        let found = examine(&turned).defects;
        assert_eq!((found.folded_edges.len(), found.inconsistent_edges.len()), (1, 1));
        // Unfolded, opened to a thin wedge, or cut along the other diagonal, there is no fold.
        for edit in [
            (|positions, _| positions[2] = 2.0 * positions[1] - positions[2] + (positions[3] - positions[1]))
                as fn(&mut Vec<Vec3>, &mut Vec<[u32; 3]>),
            |positions, _| positions[2] += Vec3::new(0.0, -0.001, 0.001),
            |_, triangles| triangles.copy_from_slice(&[[0, 1, 2], [0, 2, 3]]),
        ] {
            assert_eq!(examine(&edited(&mesh, edit)).defects.folded_edges, []);
        }
    }
}

#[test]
fn duplicates_and_slivers_are_no_folds() {
    let triangle = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(0.5, 1e-8, 0.0)];
    let mesh = TriangleMesh::new(triangle, vec![[0, 1, 2], [1, 0, 2], [0, 1, 3]]).unwrap();
    assert_eq!(examine(&mesh).defects.folded_edges, []);
    let sliver = edited(&mesh, |_, triangles| triangles[1..].rotate_left(1));
    let sliver = edited(&sliver, |_, triangles| triangles.truncate(2));
    assert_eq!(examine(&sliver).defects.folded_edges, []);
    for name in BUILTINS {
        assert_eq!(examine(&builtin(name.name)).defects.folded_edges, [], "{}", name.name);
    }
}

#[test]
fn a_cube_is_described_and_has_no_defect() {
    let found = examine(&builtin("cube"));
    assert_eq!(found.defects, Defects::default());
    assert!(found.defects.is_empty());
    assert_eq!((found.vertices, found.edges, found.faces), (8, 18, 12));
    assert!(found.is_closed && found.is_manifold && found.is_consistently_wound && found.is_orientable);
    assert_eq!((found.euler_characteristic, found.genus, found.boundary_edges), (2, Some(0), 0));
    assert_eq!(found.extent.map(|extent| (extent.min, extent.max)), Some(([-1.0; 3], [1.0; 3])));
    let lengths = found.edge_lengths.unwrap();
    assert_eq!((lengths.min, lengths.max), (2.0, 8.0_f64.sqrt()));
    assert!((lengths.total - (24.0 + 6.0 * 8.0_f64.sqrt())).abs() < 1e-12);
    assert!((found.smallest_angle.unwrap().angle_deg - 45.0).abs() < 1e-12);
    let [component] = &found.components[..] else { panic!("{:?}", found.components) };
    assert_eq!((component.area, component.volume), (24.0, Some(8.0)));
}

#[test]
fn every_builtin_is_what_its_table_says() {
    for shape in BUILTINS {
        let found = examine(&builtin(shape.name));
        let (is_closed, is_orientable) = (shape.genus.is_some(), shape.name != "moebius");
        assert_eq!((found.is_closed, found.is_orientable), (is_closed, is_orientable), "{}", shape.name);
        assert!(found.is_manifold, "{}", shape.name);
        assert_eq!(found.components.len() == 1, shape.name != "machine-room", "{}", shape.name);
        if shape.name == "machine-room" {
            let is_solid = |part: &Component| part.genus.is_some_and(|genus| genus < 2) && part.volume > Some(0.0);
            assert!(found.components.len() > 500 && found.components.iter().all(is_solid));
        } else if is_closed {
            assert_eq!(found.genus, shape.genus.map(u64::from), "{}", shape.name);
            assert!(found.components[0].volume.unwrap() > 0.0, "{} is inside out", shape.name);
        } else {
            assert_eq!(found.boundary_loops.len(), 1, "{}", shape.name);
        }
        assert_eq!(found.defects.is_empty(), is_orientable, "{}: {:?}", shape.name, found.defects.counts());
    }
}

/// Each argument at either end of its range, with few faces in the other direction.
#[test]
fn builtins_have_no_degenerate_face_at_the_ends_of_their_ranges() {
    let mut examined = 0;
    for shape in BUILTINS {
        for (index, argument) in shape.arguments.iter().enumerate() {
            for end in [argument.min, argument.max] {
                let few = |other: &shapes::ArgumentSpec| match other.kind {
                    shapes::ArgumentKind::Count => other.default.min(12.0),
                    shapes::ArgumentKind::Number => other.default,
                };
                let mut values: Vec<f64> = shape.arguments.iter().map(few).collect();
                values[index] = end;
                let words: Vec<String> = values.iter().map(ToString::to_string).collect();
                let text = format!("{}:{}", shape.name, words.join(","));
                if end > 65_536.0 || (shape.name, end as u32) == ("icosphere", 10) {
                    continue;
                }
                match shapes::by_name(&text) {
                    Ok(mesh) => {
                        let found = examine(&mesh);
                        assert_eq!(found.defects.zero_area_faces, [], "{text}");
                        assert!(found.defects.duplicate_vertices.is_empty(), "{text}");
                        assert!(found.is_manifold && found.is_closed == shape.genus.is_some(), "{text}");
                        examined += 1;
                    }
                    Err(error) => assert!(matches!(error, shapes::ShapeError::Combination { .. }), "{text}: {error}"),
                }
            }
        }
    }
    assert!(examined > 60, "{examined}");
}

#[test]
fn non_manifold_edges_are_listed_with_their_faces() {
    let mesh = edited(&builtin("cube"), |positions, triangles| {
        positions.push(Vec3::splat(3.0));
        triangles.push([1, 0, 8]);
    });
    let found = examine(&mesh);
    let at_edge: Vec<u32> =
        (0..13).filter(|&f| [0, 1].iter().all(|v| mesh.triangles()[f as usize].contains(v))).collect();
    assert_eq!(at_edge.len(), 3);
    let expected = Defects { non_manifold_edges: edge_defects(&mesh, &[([0, 1], &at_edge)]), ..Defects::default() };
    assert_eq!(found.defects, expected);
    assert_eq!((found.is_manifold, found.is_closed, found.genus), (false, false, None));
    let [boundary] = found.boundary_loops[..] else { panic!("{:?}", found.boundary_loops) };
    assert_eq!((boundary.edges, boundary.is_closed), (2, false));
}

#[test]
fn vertices_where_surfaces_touch_are_listed() {
    // Two cubes that share corner 7.
    let cube = builtin("cube");
    let mesh = edited(&cube, |positions, triangles| {
        positions.extend(cube.positions()[1..].iter().map(|p| *p + Vec3::splat(2.0)));
        triangles.extend(cube.triangles().iter().map(|t| t.map(|v| if v == 0 { 7 } else { v + 7 })));
    });
    let found = examine(&mesh);
    assert_eq!(found.defects, Defects { non_manifold_vertices: vertex_ids(&[7]), ..Defects::default() });
    let genera: Vec<_> = found.components.iter().map(|component| component.genus).collect();
    assert_eq!((genera, found.genus), (vec![Some(0), Some(0)], Some(0)));
    assert_eq!(found.components.iter().map(|component| component.vertices).sum::<usize>(), 16);
}

#[test]
fn a_surface_that_touches_itself_has_no_genus() {
    // A grid whose two opposite corners are made the same vertex.
    let mesh = edited(&builtin("grid:4,4"), |_, triangles| {
        triangles.iter_mut().flatten().filter(|v| **v == 24).for_each(|v| *v = 0);
    });
    let found = examine(&mesh);
    assert_eq!(found.defects.non_manifold_vertices, vertex_ids(&[0]));
    assert_eq!(found.defects.unreferenced_vertices, vertex_ids(&[24]));
    assert_eq!((found.components.len(), found.genus), (1, None));
    // The boundary stays in its fans, so it passes the vertex twice.
    assert_eq!(found.boundary_loops.len(), 1);
}

#[test]
fn a_reversed_face_makes_its_edges_inconsistent() {
    let mesh = edited(&builtin("cube"), |_, triangles| triangles[0].swap(1, 2));
    let found = examine(&mesh);
    let neighbours = |a: u32, b: u32| -> Vec<u32> {
        (0..12).filter(|&f| [a, b].iter().all(|v| mesh.triangles()[f as usize].contains(v))).collect()
    };
    let edges = [[0, 4], [0, 6], [4, 6]].map(|[a, b]| ([a, b], neighbours(a, b)));
    let edges: Vec<_> = edges.iter().map(|(ends, faces)| (*ends, &faces[..])).collect();
    assert_eq!(found.defects, Defects { inconsistent_edges: edge_defects(&mesh, &edges), ..Defects::default() });
    assert!(found.is_orientable && !found.is_consistently_wound && found.is_manifold);
    assert_eq!((found.genus, found.components[0].volume), (Some(0), None));
}

#[test]
fn a_moebius_strip_is_not_orientable_and_has_one_boundary() {
    let found = examine(&builtin("moebius:40,3"));
    assert!(!found.is_orientable && !found.is_closed && found.is_manifold);
    assert_eq!((found.euler_characteristic, found.genus), (0, None));
    assert_eq!(found.defects.inconsistent_edges.len(), 3);
    let [boundary] = found.boundary_loops[..] else { panic!("{:?}", found.boundary_loops) };
    assert_eq!((boundary.edges, boundary.is_closed), (80, true));
    // Without one column it is a plain band with one boundary.
    let band = edited(&builtin("moebius:40,3"), |_, triangles| triangles.truncate(6 * 39));
    let band = examine(&band);
    assert!(band.is_orientable && band.defects.is_empty() && band.genus == Some(0));
}

#[test]
fn boundaries_are_counted_and_measured() {
    let found = examine(&builtin("grid:5,3"));
    let [boundary] = found.boundary_loops[..] else { panic!("{:?}", found.boundary_loops) };
    assert_eq!((boundary.edges, boundary.is_closed, found.boundary_edges), (16, true, 16));
    assert!((boundary.length - 8.0).abs() < 1e-6, "{}", boundary.length);
    assert_eq!(found.genus, Some(0));

    // A tube: a torus cut open.
    let tube = edited(&builtin("torus:12,6"), |_, triangles| triangles.retain(|t| !t.contains(&0)));
    let mut holes = examine(&tube);
    assert_eq!((holes.boundary_loops.len(), holes.genus, holes.components[0].volume), (1, Some(1), None));
    let two = edited(&tube, |_, triangles| triangles.retain(|t| !t.contains(&30)));
    holes = examine(&two);
    assert_eq!((holes.boundary_loops.len(), holes.boundary_edges, holes.genus), (2, 12, Some(1)));
    assert_eq!(holes.defects.unreferenced_vertices, vertex_ids(&[0, 30]));
}

#[test]
fn faces_without_area_are_found_exactly() {
    let third = 1.0_f32 / 3.0;
    let collinear = [Vec3::new(third, 0.1, 7.0), Vec3::new(2.0 * third, 0.2, 14.0), Vec3::new(4.0 * third, 0.4, 28.0)];
    // One unit in the last place off the line: an area that 32-bit arithmetic does not see.
    let nearly = Vec3::new(4.0 * third, 0.4_f32.next_up(), 28.0);
    let tiny = [Vec3::ZERO, Vec3::X * f32::from_bits(1), Vec3::Y * f32::from_bits(1)];
    let huge = [Vec3::ZERO, Vec3::X * f32::MAX, Vec3::Y * f32::MAX];
    let positions: Vec<Vec3> = collinear.into_iter().chain([nearly]).chain(tiny).chain(huge).collect();
    let triangles = vec![[0, 1, 2], [0, 1, 3], [4, 5, 6], [7, 8, 9], [4, 4, 5], [7, 9, 7], [8, 8, 8]];
    let found = examine(&TriangleMesh::new(positions, triangles).unwrap());
    assert_eq!(found.defects.zero_area_faces, face_ids(&[0, 4, 5, 6]));
    assert_eq!(found.defects.repeated_vertex_faces, face_ids(&[4, 5, 6]));
    assert_eq!(found.smallest_angle.map(|smallest| smallest.face), Some(FaceId::new(1)));
}

#[test]
fn duplicate_faces_and_vertices_are_grouped() {
    let mesh = edited(&builtin("icosphere:1"), |positions, triangles| {
        let [a, b, c] = triangles[7];
        triangles.push([b, c, a]);
        triangles.push(triangles[3]);
        triangles.push([c, b, a]);
        positions.extend([positions[5], Vec3::new(0.0, 9.0, 0.0), Vec3::new(-0.0, 9.0, -0.0), positions[5]]);
    });
    let found = examine(&mesh).defects;
    assert_eq!(found.duplicate_faces, [face_ids(&[3, 81]), face_ids(&[7, 80, 82])]);
    assert_eq!(found.duplicate_vertices, [vertex_ids(&[5, 42, 45]), vertex_ids(&[43, 44])]);
    assert_eq!(found.unreferenced_vertices, vertex_ids(&[42, 43, 44, 45]));
    assert_eq!(found.non_manifold_edges.len(), 6, "{:?}", found.non_manifold_edges);
    assert_eq!(found.zero_area_faces, []);
}

#[test]
fn components_are_separate_and_genera_add_up() {
    let found = examine(&joined(&builtin("knot:2,3,60,8"), &joined(&builtin("gear"), &builtin("cube"))));
    let genera: Vec<_> = found.components.iter().map(|component| component.genus).collect();
    assert_eq!((genera, found.genus), (vec![Some(1), Some(1), Some(0)], Some(2)));
    assert_eq!(found.components[1].first_face, FaceId::new(960));
    assert!(found.defects.is_empty());
}

#[test]
fn a_surface_turned_inside_out_has_negative_volume() {
    let mesh = edited(&builtin("torus"), |_, triangles| triangles.iter_mut().for_each(|t| t.swap(0, 1)));
    let found = examine(&mesh);
    // Pappus: 2 pi^2 R r^2, from below because the mesh is inscribed.
    let smooth = 2.0 * std::f64::consts::PI.powi(2) * 0.16;
    let volume = -found.components[0].volume.unwrap();
    assert!(volume < smooth && volume > 0.98 * smooth, "{volume} {smooth}");
    assert!(found.defects.is_empty());
}

#[test]
fn an_empty_mesh_is_described() {
    let found = examine(&TriangleMesh::new(vec![], vec![]).unwrap());
    assert!(!found.is_closed && found.components.is_empty() && found.defects.is_empty());
    assert_eq!((found.genus, found.extent, found.edge_lengths, found.smallest_angle), (None, None, None, None));
}

proptest! {
    /// Euler's formula V - E + F = 2 - 2g - b survives holes: removing a vertex's star adds one boundary, a face likewise.
    #[test]
    fn eulers_formula(faces in 60_u32..600, holes in prop::collection::btree_set(0_usize..60, 0..6)) {
        let mesh = edited(&Blob::default().mesh(faces).unwrap(), |_, triangles| {
            let mut index = 0;
            triangles.retain(|_| { index += 1; !holes.contains(&(index - 1)) });
        });
        let found = examine(&mesh);
        for component in &found.components {
            if let Some(genus) = component.genus {
                prop_assert_eq!(genus, 0);
                prop_assert_eq!(component.euler_characteristic, 2 - component.boundary_loops as i64);
            }
        }
        prop_assert!(found.boundary_loops.iter().all(|boundary| boundary.is_closed));
        prop_assert_eq!(found.is_closed, holes.is_empty());
    }

    /// Arbitrary triangles over few vertices: every edge case of the walks at once. They must end, and agree with counts
    /// that are taken naively.
    #[test]
    fn any_soup_is_described(triangles in prop::collection::vec(prop::array::uniform3(0_u32..9), 0..40)) {
        let positions = (0..9).map(|i| Vec3::new(i as f32, (i * i) as f32, (i % 4) as f32)).collect();
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let topology = Topology::new(&mesh);
        let found = inspect(&mesh, &topology);
        let proper = topology.edges().iter().filter(|(_, ends)| ends[0] != ends[1]);
        let incidences: Vec<usize> = proper.map(|(edge, _)| topology.half_edges(edge).len()).collect();
        prop_assert_eq!(found.edges, incidences.len());
        prop_assert_eq!(found.boundary_edges, incidences.iter().filter(|&&count| count == 1).count());
        prop_assert_eq!(found.components.iter().map(|component| component.faces).sum::<usize>(), mesh.face_count());
        let mut keys: Vec<[u32; 3]> = mesh.triangles().iter().map(|t| { let mut t = *t; t.sort_unstable(); t }).collect();
        keys.sort_unstable();
        let repeated: usize = keys.chunk_by(|a, b| a == b).filter(|group| group.len() > 1).map(<[_]>::len).sum();
        prop_assert_eq!(found.defects.duplicate_faces.iter().map(Vec::len).sum::<usize>(), repeated);
    }
}

/// Two squares side by side, their common side listed twice, `gap` apart.
fn two_squares(gap: f32) -> TriangleMesh {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]];
    let mut positions: Vec<Vec3> = corners.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect();
    positions.extend([Vec3::new(1.0 + gap, 0.0, 0.0), Vec3::new(1.0 + gap, 1.0, 0.0)]);
    TriangleMesh::new(positions, vec![[0, 1, 2], [0, 2, 3], [6, 4, 5], [6, 5, 7]]).unwrap()
}

#[test]
fn seams_are_found_with_the_distance_that_closes_them() {
    assert_eq!(examine(&two_squares(0.0)).seams, Some(OpenSeams { distance: 0.0, edges: 2 }));
    let near = examine(&two_squares(1e-4)).seams.unwrap();
    assert_eq!(near.edges, 2);
    assert!((1e-4..1.2e-4).contains(&near.distance), "{near:?}");
    let welded = crate::weld::weld_within(&two_squares(1e-4), near.distance).unwrap().mesh;
    assert_eq!((examine(&welded).boundary_edges, examine(&welded).seams), (6, None));
    assert_eq!(examine(&two_squares(0.1)).seams, None, "a gap");
    let point = TriangleMesh::new(vec![Vec3::ONE; 3], vec![[0, 1, 2]]).unwrap();
    assert_eq!(examine(&point).seams, None, "a point has no sides");
    let needle = [[0.0, 0.0], [10.0, 0.0], [10.0, 0.0005]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let needle = TriangleMesh::new(needle.to_vec(), vec![[0, 1, 2]]).unwrap();
    assert_eq!(examine(&needle).seams, None, "the sides of one face");
    assert_eq!(examine(&builtin("cube")).seams, None);
    assert_eq!(examine(&builtin("grid:3,2")).seams, None);
}

#[test]
fn t_junctions_are_counted_across_seams_too() {
    for lifted in [0.0, 1e-6] {
        let mut positions: Vec<Vec3> = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0], [2.0, 2.0]]
            .map(|[x, y]| Vec3::new(x, y, 0.0))
            .to_vec();
        positions.push(Vec3::new(1.0, 1.0, lifted));
        let mesh = TriangleMesh::new(positions, vec![[0, 1, 2], [4, 6, 3], [6, 5, 3]]).unwrap();
        let found = examine(&mesh).t_junctions.unwrap();
        assert_eq!(found.edges, 1);
        assert!((found.largest_distance - f64::from(lifted)).abs() < 1e-12, "{found:?}");
        let healed = crate::heal::heal_t_junctions(&mesh, 2.0 * lifted).unwrap().mesh;
        assert_eq!((examine(&healed).t_junctions, examine(&healed).boundary_edges), (None, 4));
    }
    assert_eq!(examine(&builtin("grid:3,2")).t_junctions, None);
}
