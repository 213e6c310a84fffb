//! The methods of a mesh share hulls and textures, and draw one that was given.

use super::{BakeChoice, NormalMapHull, Texture, TextureLines, TextureOptions, Textures};
use crate::{TextureLinesOptions, VolumeSize};
use silhouette_core::prepared::Artefact;
use silhouette_core::{Method, NoProgress, PreparedMesh, TriangleMesh, shapes};
use std::sync::Arc;

fn small() -> TextureOptions {
    TextureOptions { size: 48, azimuths: 8, hull_vertices: 24, ..TextureOptions::default() }
}

fn ball() -> Arc<PreparedMesh> {
    Arc::new(PreparedMesh::new(shapes::by_name("icosphere:2").unwrap()))
}

#[test]
fn methods_that_ask_for_the_same_share_a_texture() {
    let mesh = ball();
    let texture = Texture::new(&mesh, small()).unwrap();
    let edges = TextureOptions { edge: crate::gpu::Edge::Coverage, ..small() };
    assert!(Arc::ptr_eq(Texture::new(&mesh, edges).unwrap().texture(), texture.texture()), "edges are not baked");
    let finer = Texture::new(&mesh, TextureOptions { size: 64, ..small() }).unwrap();
    assert!(!Arc::ptr_eq(finer.texture(), texture.texture()));
    let hulls = [&texture, &finer].map(|method| Arc::as_ptr(method.texture().parts().hull.mesh()));
    assert_eq!(hulls[0], hulls[1], "one hull for both");
    assert_eq!(mesh.report().len(), 1);
    assert!(texture.bytes() > 48 * 48 * 8 && finer.bytes() > texture.bytes());
}

#[test]
fn a_texture_that_was_given_is_drawn_whatever_options_say() {
    let baked = Arc::clone(Texture::new(&ball(), small()).unwrap().texture());
    let mesh = PreparedMesh::new(shapes::by_name("cube").unwrap()).with_artefact(Textures::given(Arc::clone(&baked)));
    let mesh = Arc::new(mesh);
    let texture = Texture::new(&mesh, TextureOptions::default()).unwrap();
    assert!(Arc::ptr_eq(texture.texture(), &baked));
    assert_eq!(TextureLines::new(&mesh, TextureLinesOptions::default()).unwrap().bytes(), baked.bytes());
    assert_eq!(NormalMapHull::new(&mesh, Default::default()).unwrap().bytes(), baked.bytes());
}

#[test]
fn what_cannot_be_made_is_refused_with_the_remedy() {
    let mesh = ball();
    let message = |options: TextureOptions| Texture::new(&mesh, options).unwrap_err().to_string();
    let too_small = message(TextureOptions { size: 8, ..small() });
    assert!(too_small.contains("texels"), "{too_small}");
    let too_many = message(TextureOptions { terms: 9, ..small() });
    assert!(too_many.contains("1 to 8"), "{too_many}");
    let no_extent = TriangleMesh::new(vec![Default::default(); 3], vec![[0, 1, 2]]).unwrap();
    let flat = Texture::new(&Arc::new(PreparedMesh::new(no_extent)), small()).unwrap_err().to_string();
    assert!(flat.contains("extent"), "{flat}");
}

#[test]
fn a_mesh_without_faces_has_a_texture_of_nothing() {
    let empty = TriangleMesh::new(vec![], vec![]).unwrap();
    let textures = Textures::build(&PreparedMesh::new(empty.clone()), &NoProgress).unwrap();
    let BakeChoice { options, .. } = small().bake();
    let choice = BakeChoice { hull_vertices: 24, options, terms: 0 };
    let texture = textures.get(&empty, &choice, &NoProgress).unwrap();
    assert_eq!(texture.parts().size, VolumeSize { width: 1, height: 1, azimuths: 3, pages: 1 });
    assert!(texture.parts().places.is_empty());
}
