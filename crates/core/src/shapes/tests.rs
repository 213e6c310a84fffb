use super::*;
use crate::view::Viewpoint;

fn refusal(text: &str) -> String {
    by_name(text).unwrap_err().to_string()
}

#[test]
fn names_and_arguments_are_read() {
    assert_eq!(by_name("cube"), Cuboid::default().mesh());
    assert_eq!(by_name("cube:2,2,0.02"), Cuboid { size: [2.0, 2.0, 0.02] }.mesh());
    assert_eq!(by_name("icosphere:2"), Sphere::default().icosphere(2));
    assert_eq!(by_name("uv-sphere:8,6,3"), Sphere { radius: 3.0 }.uv_mesh(8, 6));
    assert_eq!(by_name("ellipsoid:8, 6"), Ellipsoid::default().mesh(8, 6));
    assert_eq!(by_name("cylinder:9"), Cylinder::default().mesh(9));
    assert_eq!(by_name("cone:9"), Cone::default().mesh(9));
    assert_eq!(by_name("torus:9,7,2"), Torus { major_radius: 2.0, ..Torus::default() }.mesh(9, 7));
    assert_eq!(by_name("knot:3,4,80,7"), TorusKnot { p: 3, q: 4, ..TorusKnot::default() }.mesh(80, 7));
    assert_eq!(by_name("gear:5"), Gear { teeth: 5, ..Gear::default() }.mesh());
    assert_eq!(by_name("ring:9,2"), Ring { outer_radius: 2.0, ..Ring::default() }.mesh(9));
    assert_eq!(by_name("blob:1001"), Blob::default().mesh(1002));
    assert_eq!(by_name("machine-room:7"), MachineRoom { around: 7 }.mesh());
    assert_eq!(by_name("grid:2,3"), Grid::default().mesh(2, 3));
    assert_eq!(by_name("moebius:12,2"), MoebiusStrip::default().mesh(12, 2));
}

#[test]
fn face_counts_are_those_documented() {
    let counts = [("icosphere:3", 1280), ("uv-sphere:8,6", 80), ("cylinder:9", 36), ("cone:9", 18), ("torus:9,7", 126)];
    let more = [
        ("knot:2,3,50,6", 600),
        ("gear:5", 160),
        ("ring:9", 72),
        ("blob:777", 778),
        ("grid:2,3", 12),
        ("moebius:12,2", 48),
    ];
    for (text, faces) in counts.into_iter().chain(more) {
        assert_eq!(by_name(text).map(|mesh| mesh.face_count()), Ok(faces), "{text}");
    }
}

#[test]
fn defaults_of_structs_and_table_agree() {
    assert_eq!(by_name("torus"), Torus::default().mesh(64, 32));
    assert_eq!(by_name("knot"), TorusKnot::default().mesh(360, 16));
    assert_eq!(by_name("gear"), Gear::default().mesh());
    assert_eq!(by_name("ring"), Ring::default().mesh(64));
    assert_eq!(by_name("blob"), Blob::default().mesh(20_000));
    assert_eq!(by_name("machine-room"), MachineRoom::default().mesh());
    assert_eq!(by_name("grid"), Grid::default().mesh(16, 16));
    assert_eq!(by_name("moebius"), MoebiusStrip::default().mesh(64, 8));
    assert_eq!(by_name("cylinder"), Cylinder::default().mesh(64));
    assert_eq!(by_name("cone"), Cone::default().mesh(64));
    assert_eq!(by_name("ellipsoid"), Ellipsoid::default().mesh(96, 48));
    assert_eq!(by_name("uv-sphere"), Sphere::default().uv_mesh(96, 48));
    assert_eq!(by_name("icosphere"), Sphere::default().icosphere(4));
}

#[test]
fn refusals_name_the_argument_and_its_range() {
    assert_eq!(refusal("torus:2"), "torus: around cannot be 2; give a whole number from 3 to 8192");
    assert_eq!(refusal("torus:64,many"), "torus: across cannot be 'many'; give a whole number from 3 to 8192");
    assert_eq!(refusal("torus:6.5"), "torus: around cannot be '6.5'; give a whole number from 3 to 8192");
    assert_eq!(refusal("torus:-1"), "torus: around cannot be '-1'; give a whole number from 3 to 8192");
    assert_eq!(refusal("cube:nan"), "cube: size-x cannot be NaN; give a number from 0.01 to 100");
    assert_eq!(refusal("cube:"), "cube: size-x cannot be ''; give a number from 0.01 to 100");
    assert_eq!(refusal("icosphere:11"), "icosphere: level cannot be 11; give a whole number from 0 to 10");
    assert_eq!(refusal("blob:30000000"), "blob: faces cannot be 30000000; give a whole number from 6 to 20971520");
    assert_eq!(refusal("cone:9,1,1,1"), "4 arguments were given to cone[:segments,radius,height]");
    assert_eq!(
        refusal("torus:8192,8192"),
        "torus: these arguments make 134217728 faces; at most 20971520 are made, so lower around or across"
    );
    assert!(refusal("torus:8,8,1,1").contains("minor-radius must be below major-radius"));
    assert!(refusal("ring:8,1,1").contains("inner-radius must be below outer-radius"));
    assert!(refusal("knot:2,4").contains("no common factor"));
    let unknown = refusal("teapot");
    assert!(unknown.starts_with("there is no built-in shape 'teapot'; choose one of cube, icosphere,"), "{unknown}");
}

#[test]
fn no_argument_makes_more_faces_than_the_limit() {
    for shape in BUILTINS {
        // Everything at its largest: a refusal, not a mesh that does not fit in memory.
        let largest: Vec<String> = shape.arguments.iter().map(|argument| argument.max.to_string()).collect();
        let text = format!("{}:{}", shape.name, largest.join(","));
        // The two whose largest argument is the limit itself.
        if matches!(shape.name, "icosphere" | "blob") {
            continue;
        }
        match by_name(&text) {
            Ok(mesh) => assert!(mesh.face_count() as u64 <= MAX_FACES, "{text}"),
            Err(ShapeError::TooManyFaces { .. } | ShapeError::Combination { .. }) => {}
            Err(error) => panic!("{text}: {error}"),
        }
    }
}

#[test]
fn vertices_lie_on_the_surface_whose_contour_is_known() {
    let names = ["icosphere:3,1.5", "uv-sphere:24,12", "ellipsoid", "cylinder", "torus:24,12,1,0.3"];
    for name in names {
        let surface = contour_by_name(name).unwrap().unwrap();
        let mesh = by_name(name).unwrap();
        for position in mesh.positions() {
            assert!(surface.distance(position.as_dvec3()).abs() < 2e-7, "{name}: {position}");
        }
    }
    assert!(contour_by_name("gear").unwrap().is_none());
    assert!(contour_by_name("torus:1").is_err() && contour_by_name("torus:9,9,1,2").is_err());
}

#[test]
fn faces_are_front_where_the_surface_is() {
    let viewpoint = Viewpoint::Perspective { eye: Vec3::new(3.0, 2.0, 4.0) };
    for name in ["icosphere:5", "uv-sphere", "ellipsoid", "cylinder:200", "torus"] {
        let surface = contour_by_name(name).unwrap().unwrap();
        let mesh = by_name(name).unwrap();
        let mut disagree = 0;
        for triangle in mesh.triangles() {
            let [a, b, c] = triangle.map(|v| mesh.positions()[v as usize].as_dvec3());
            let flat = (b - a).cross(c - a).dot(Vec3::new(3.0, 2.0, 4.0).as_dvec3() - a) > 0.0;
            let smooth = surface.facing((a + b + c) / 3.0, &viewpoint) > 0.0;
            disagree += usize::from(flat != smooth);
        }
        // Only the row of faces that the contour crosses may differ.
        assert!(disagree * 20 < mesh.face_count(), "{name}: {disagree} of {}", mesh.face_count());
    }
}

#[test]
fn meshes_do_not_depend_on_the_number_of_threads() {
    let names = ["icosphere:4", "uv-sphere", "torus", "blob:30000", "knot", "machine-room:8"];
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| names.map(|name| by_name(name).unwrap()))
    };
    assert_eq!(with(1), with(5));
}

#[test]
fn the_table_is_usable_as_help() {
    for shape in BUILTINS {
        assert!(shape.summary.ends_with('.') && shape.summary.matches(". ").count() == 0, "{}", shape.name);
        for argument in shape.arguments {
            assert!((argument.min..=argument.max).contains(&argument.default), "{} {}", shape.name, argument.name);
        }
    }
}
