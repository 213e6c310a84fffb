use silhouette_core::NoProgress;
use silhouette_core::load::{Format, Problem, load, read};
use std::path::Path;

#[test]
fn formats_follow_from_the_extension_in_any_case() {
    let of = |name: &str| Format::of(Path::new(name));
    for extension in Format::EXTENSIONS {
        assert!(of(&format!("a.b{extension}")).is_some(), "{extension}");
        assert_eq!(of(&format!("a{}", extension.to_uppercase())), of(&format!("a{extension}")));
    }
    assert_eq!((of("a.glb"), of("a.gltf")), (Some(Format::Gltf), Some(Format::Gltf)));
    assert_eq!((of("obj"), of("a.fbx"), of("")), (None, None, None));
}

#[test]
fn paths_that_are_no_mesh_are_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let inside = |name: &str| folder.path().join(name);
    std::fs::create_dir(inside("folder.obj")).unwrap();
    std::fs::write(inside("empty.obj"), "").unwrap();
    std::fs::write(inside("mesh.fbx"), "x").unwrap();
    let line = |name: &str| {
        let line = load(&inside(name)).unwrap_err().to_string();
        assert!(line.starts_with(&format!("{}: ", inside(name).display())), "{line}");
        line
    };
    assert!(line("missing.obj").contains("no such file"));
    assert!(line("folder.obj").contains("a directory"));
    assert!(line("mesh.fbx").contains("\"fbx\"; rename or convert the file to one of .obj .ply .off .stl .gltf .glb"));
    assert!(line("noextension").contains("unknown extension \"\""));
    assert!(load(folder.path()).unwrap_err().to_string().contains("a directory"));
    assert!(line("empty.obj").contains("the file is empty"));
}

#[test]
fn empty_bytes_are_refused_in_every_format() {
    for format in [Format::Obj, Format::Ply, Format::Off, Format::Stl, Format::Gltf] {
        let error = read(format, "odd\nname", b"", &NoProgress).unwrap_err();
        assert!(matches!(error.problem, Problem::Empty));
        assert!(error.to_string().starts_with("odd\\nname: the file is empty"), "{error}");
    }
}
