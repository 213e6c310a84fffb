//! Every file that is written has the form that glTF and the extension demand; files that are changed lack it.

use crate::facts::File;
use crate::glb;
use proptest::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::{Topology, TriangleMesh};
use silhouette_testing::{builtin, real_meshes, strategies, zoo};

fn codes(bytes: &[u8]) -> Result<Option<Vec<u8>>, String> {
    File::of(bytes)?.codes()
}

#[test]
fn files_of_the_zoo_and_of_real_meshes_have_the_form() {
    let zoo = zoo::all().into_iter().map(|(name, mesh)| (name.to_owned(), mesh));
    for (name, mesh) in zoo.chain(real_meshes("files with edges")) {
        let codes = codes(&glb(&mesh)).unwrap_or_else(|fact| panic!("{name}: not so: {fact}"));
        assert!(codes.is_some(), "{name} has edges to draw");
    }
}

/// Twelve hard edges, each in two triangles; the diagonals of the sides lie in planes.
#[test]
fn a_cube_has_hard_edges_and_hidden_diagonals() {
    let file = File::of(&glb(&builtin("cube"))).unwrap();
    let codes = file.codes().unwrap().unwrap();
    assert_eq!([0, 1, 2, 3].map(|code| codes.iter().filter(|&&c| c == code).count()), [12, 0, 12, 12]);
    assert!(file.extension()["silhouetteNormals"].is_null());
}

/// The rims of a cylinder are hard, the edges along it are silhouettes, and the diagonals of its flat sides are hidden.
#[test]
fn a_cylinder_has_rims_and_silhouettes() {
    let mesh = builtin("cylinder");
    let codes = codes(&glb(&mesh)).unwrap().unwrap();
    let count = |code| codes.iter().filter(|&&c| c == code).count();
    assert!(count(1) > 0 && count(2) > 0 && count(0) > count(1), "{:?}", [0, 1, 2, 3].map(count));
    assert_eq!(count(2), count(3), "no edge is a boundary");
}

#[test]
fn an_icosphere_is_all_silhouettes() {
    let mesh = builtin("icosphere:3");
    let codes = codes(&glb(&mesh)).unwrap().unwrap();
    let edges = Topology::new(&mesh).edge_count();
    assert_eq!(codes.iter().filter(|&&code| code == 1).count(), edges);
}

#[test]
fn what_nothing_can_be_drawn_of_has_no_extension() {
    // A side from a vertex to itself is never drawn.
    let line = |triangles| TriangleMesh::new(vec![Vec3::ZERO, Vec3::X], triangles).unwrap();
    let file = File::of(&glb(&line(vec![[0, 0, 0]]))).unwrap();
    assert_eq!((file.codes().unwrap(), file.triangles().unwrap()), (None, vec![[0, 0, 0]]));
    let empty = File::of(&glb(&zoo::empty())).unwrap();
    assert!(empty.document.get("meshes").is_none() && empty.binary.is_empty());
}

/// A control: each change breaks the fact that it aims at.
#[test]
fn changed_files_lack_the_form() {
    let good = glb(&builtin("cylinder"));
    assert!(codes(&good).unwrap().is_some());
    let with = |change: &dyn Fn(&mut File)| {
        let mut file = File::of(&good).unwrap();
        change(&mut file);
        file.codes().unwrap_err()
    };
    let visibility = File::of(&good).unwrap().extension()["visibility"].as_u64().unwrap() as usize;
    let normals = visibility + 1;
    let start = |file: &File, accessor: usize| {
        let view = file.document["accessors"][accessor]["bufferView"].as_u64().unwrap() as usize;
        file.document["bufferViews"][view]["byteOffset"].as_u64().unwrap() as usize
    };
    let name = "EXT_mesh_primitive_edge_visibility";
    let extension = ["meshes", "0", "primitives", "0", "extensions", name].join("/");
    let member =
        |file: &mut File, name: &str| file.document.pointer_mut(&format!("/{extension}/{name}")).unwrap().take();
    for (fact, change) in [
        (
            "without the extension",
            &(|file: &mut File| file.document["extensionsRequired"] = [name][..].into()) as &dyn Fn(&mut File),
        ),
        ("is listed", &|file| file.document["extensionsUsed"] = serde_json::json!([])),
        ("no other members", &|file| {
            file.document.pointer_mut(&format!("/{extension}")).unwrap()["silhouetteMates"] = 0.into();
        }),
        ("six bits", &|file| {
            let count = file.document["accessors"][visibility]["count"].as_u64().unwrap();
            file.document["accessors"][visibility]["count"] = (count - 1).into();
        }),
        ("unsigned bytes", &|file| file.document["accessors"][visibility]["componentType"] = 5120.into()),
        ("two normals", &|file| {
            let count = file.document["accessors"][normals]["count"].as_u64().unwrap();
            file.document["accessors"][normals]["count"] = (count - 1).into();
        }),
        ("silhouettes have normals", &|file| {
            member(file, "silhouetteNormals");
        }),
        ("normals are those of its triangles", &|file| {
            let at = start(file, normals);
            file.binary[at + 1] ^= 0x40;
        }),
        ("coded once", &|file| {
            let at = start(file, visibility);
            file.binary[at] ^= 0b11;
        }),
        ("not 0", &|file| {
            let at = start(file, visibility);
            let length = file.document["accessors"][visibility]["count"].as_u64().unwrap() as usize;
            file.binary[at..at + length].fill(0);
        }),
        ("bounds", &|file| file.document["accessors"][0]["max"][0] = 7.into()),
    ] {
        let broken = with(change);
        assert!(broken.contains(fact), "wanted '{fact}', but: {broken}");
    }
    assert!(File::of(&good[..good.len() - 4]).is_err());
}

proptest! {
    #[test]
    fn files_of_any_mesh_have_the_form(
        mesh in prop_oneof![strategies::closed_mesh(), strategies::open_mesh(), strategies::soup(40)],
    ) {
        if let Err(fact) = codes(&glb(&mesh)) {
            prop_assert!(false, "not so: {}", fact);
        }
    }
}
