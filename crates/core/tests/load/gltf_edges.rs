//! Hard edges of the glTF extension `EXT_mesh_primitive_edge_visibility` as feature edges, and how a bad extension is refused.

use crate::expectations::{SQUARE, assert_refused, feature_edges};
use crate::gltf::Document;
use silhouette_core::load::Format::Gltf;

const PRIMITIVE: &str = ", meshes[0].primitives[0]";

const NONE: [[u32; 2]; 0] = [];

/// Codes of the square's two triangles: a silhouette between two hard sides.
const WITH_SILHOUETTE: [u8; 2] = [18, 2];

/// The same with a hard diagonal, repeated in the second triangle.
const WITH_HARD_DIAGONAL: [u8; 2] = [226, 2];

/// A square of two triangles whose primitive has the extension, not yet with any member.
struct Square {
    document: Document,
    members: Vec<String>,
    /// Members of the primitive.
    rest: String,
}

impl Square {
    fn new() -> Self {
        let mut document = Document::default();
        document.positions(&SQUARE);
        let indices = document.indices(5123, &[0, 1, 2, 0, 2, 3]);
        Self { document, members: Vec::new(), rest: format!(r#","indices":{indices}"#) }
    }

    fn with(mut self, name: &str, value: impl std::fmt::Display) -> Self {
        self.members.push(format!(r#""{name}":{value}"#));
        self
    }

    fn visibility(mut self, codes: &[u8]) -> Self {
        let accessor = self.document.indices(5121, &codes.iter().copied().map(u32::from).collect::<Vec<_>>());
        self.with("visibility", accessor)
    }

    /// Normals as signed bytes at every fourth byte.
    fn normals(mut self, count: usize) -> Self {
        let bytes: Vec<u8> = (0..count).flat_map(|_| [0, 0, 127, 0]).collect();
        let view = self.document.strided_view(&bytes, 4);
        let of_bytes = format!(r#""bufferView":{view},"componentType":5120,"count":{count},"type":"VEC3""#);
        let accessor = self.document.accessor(&of_bytes);
        self.with("silhouetteNormals", accessor)
    }

    /// Line strings with indices of a component type.
    fn lines(mut self, component: u32, indices: &[u32]) -> Self {
        let accessor = self.document.indices(component, indices);
        self.with("lineStrings", format!(r#"[{{"indices":{accessor},"material":7}}]"#))
    }

    fn document(mut self) -> Document {
        let extension =
            format!(r#""extensions":{{"EXT_mesh_primitive_edge_visibility":{{{}}}}}"#, self.members.join(","));
        self.document.mesh(0, &format!("{},{extension}", self.rest));
        self.document.extra = r#","extensionsUsed":["EXT_mesh_primitive_edge_visibility"]"#.to_owned();
        self.document
    }

    fn glb(self) -> Vec<u8> {
        self.document().glb()
    }
}

/// A square with every member of the extension that is read.
pub fn every_member() -> Document {
    Square::new().visibility(&WITH_SILHOUETTE).normals(2).lines(5123, &[0, 3, 65535, 1, 2]).document()
}

#[test]
fn hard_sides_are_feature_edges() {
    assert_eq!(feature_edges(Gltf, Square::new().visibility(&WITH_SILHOUETTE).normals(2).glb()), [[0, 1], [2, 3]]);
    let hard = Square::new().visibility(&WITH_HARD_DIAGONAL).glb();
    assert_eq!(feature_edges(Gltf, hard), [[0, 1], [0, 2], [2, 3]]);
    assert_eq!(feature_edges(Gltf, Square::new().visibility(&[0, 0]).glb()), NONE);
}

/// Codes count the sides of strips and fans in the order of the format, which is not the order in which triangles are kept.
#[test]
fn strips_and_fans_have_their_own_order_of_sides() {
    // In a strip 0 1 3 2 the second triangle is 1 2 3, in a fan 0 1 2 3 the triangles are 1 2 0 and 2 3 0.
    for (mode, corners, code, expected) in [
        (5, [0, 1, 3, 2], 3, [1, 2]),
        (5, [0, 1, 3, 2], 4, [2, 3]),
        (5, [0, 1, 3, 2], 5, [1, 3]),
        (6, [0, 1, 2, 3], 0, [1, 2]),
        (6, [0, 1, 2, 3], 1, [0, 2]),
        (6, [0, 1, 2, 3], 2, [0, 1]),
        (6, [0, 1, 2, 3], 4, [0, 3]),
    ] {
        let mut square = Square::new();
        let indices = square.document.indices(5125, &corners);
        square.rest = format!(r#","mode":{mode},"indices":{indices}"#);
        let codes = (2_u16 << (2 * code)).to_le_bytes();
        assert_eq!(feature_edges(Gltf, square.visibility(&codes).glb()), [expected], "mode {mode}, side {code}");
    }
}

#[test]
fn triangles_without_indices_have_codes() {
    let mut document = Document::default();
    document.positions(&SQUARE[..3]);
    let square = Square { document, members: Vec::new(), rest: String::new() };
    assert_eq!(feature_edges(Gltf, square.visibility(&[0b0010_0010]).glb()), [[0, 1], [0, 2]]);
}

#[test]
fn line_strings_along_edges_are_feature_edges() {
    for (component, restart) in [(5121, 255), (5123, 65535), (5125, u32::MAX)] {
        let lines = Square::new().lines(component, &[0, 1, 2, restart, 3, 2]).glb();
        assert_eq!(feature_edges(Gltf, lines), [[0, 1], [1, 2], [2, 3]], "{component}");
    }
    let off_the_edges = Square::new().lines(5121, &[1, 3, 3, 0]).glb();
    assert_eq!(feature_edges(Gltf, off_the_edges), [[0, 3]]);
    let both = Square::new().visibility(&WITH_HARD_DIAGONAL).lines(5121, &[0, 3]).glb();
    assert_eq!(feature_edges(Gltf, both), [[0, 1], [0, 2], [0, 3], [2, 3]]);
}

/// Each place of a mesh has the hard edges, mirrored or not.
#[test]
fn every_instance_has_its_edges() {
    let mut document = Square::new().visibility(&WITH_SILHOUETTE).document();
    document.nodes = vec![r#"{"mesh":0}"#.into(), r#"{"mesh":0,"scale":[-1,1,1]}"#.into()];
    assert_eq!(feature_edges(Gltf, document.glb()), [[0, 1], [2, 3], [4, 5], [6, 7]]);
}

#[test]
fn what_a_document_does_not_say_it_uses_is_passed_over() {
    let mut document = Square::new().visibility(&[1]).document();
    assert_refused(Gltf, document.glb(), PRIMITIVE, &["visibility"]);
    document.extra.clear();
    assert_eq!(feature_edges(Gltf, document.glb()), NONE);
}

/// Members that drafts of the extension had, and those of its later versions, do not stand in the way.
#[test]
fn unknown_members_are_passed_over() {
    let draft = Square::new().visibility(&WITH_SILHOUETTE).with("silhouetteMates", 99).with("extras", "[]");
    assert_eq!(feature_edges(Gltf, draft.glb()), [[0, 1], [2, 3]]);
}

/// A hard edge that is coded as 2 in both triangles, and spare bits that are not 0, leave no doubt.
#[test]
fn codes_that_break_a_rule_but_are_clear_are_taken() {
    let repeated = Square::new().visibility(&[0b1010_0010, 0b1111_0010]);
    assert_eq!(feature_edges(Gltf, repeated.glb()), [[0, 1], [0, 2], [2, 3]]);
}

#[test]
fn accessors_that_do_not_fit_are_refused() {
    let refused = |square: Square, parts: &[&str]| assert_refused(Gltf, square.glb(), PRIMITIVE, parts);
    refused(Square::new(), &["visibility or lineStrings", "nothing"]);
    refused(Square::new().with("visibility", 9), &["beyond the 2 accessors"]);
    refused(Square::new().with("visibility", 0), &["visibility of type SCALAR"]);
    refused(Square::new().with("visibility", 1), &["visibility of unsigned bytes"]);
    refused(Square::new().visibility(&[18]), &["two bits for each side", "1 bytes for 2 triangles"]);
    refused(Square::new().visibility(&[18, 2, 0]), &["two bits for each side", "3 bytes for 2 triangles"]);

    let with_silhouette = || Square::new().visibility(&WITH_SILHOUETTE);
    refused(with_silhouette().normals(3), &["two silhouetteNormals", "3 for 1 silhouettes"]);
    refused(with_silhouette().with("silhouetteNormals", 1), &["silhouetteNormals of type VEC3"]);
    refused(with_silhouette().with("silhouetteNormals", 0), &["4 for 1 silhouettes"]);
    refused(Square::new().visibility(&WITH_HARD_DIAGONAL).normals(2), &["2 for 0 silhouettes"]);

    refused(Square::new().lines(5121, &[0, 4]), &["index 4 of 4 vertices"]);
    refused(Square::new().lines(5123, &[0, 255]), &["index 255 of 4 vertices"]);
    refused(Square::new().with("lineStrings", r#"[{"indices":0}]"#), &["SCALAR"]);
    assert_refused(Gltf, Square::new().with("lineStrings", "[{}]").glb(), ", line 1", &["indices"]);
    assert_refused(Gltf, Square::new().with("visibility", "-1").glb(), ", line 1", &["EXT_mesh_primitive_edge"]);
}

#[test]
fn accessors_with_too_few_bytes_are_refused() {
    let promised = |accessor: &str| {
        let mut square = Square::new();
        let view = square.document.view(&[18, 2]);
        let index = square.document.accessor(&format!(r#""bufferView":{view},{accessor}"#));
        square.with("visibility", index).glb()
    };
    let scalar = |count: u64| format!(r#""componentType":5121,"count":{count},"type":"SCALAR""#);
    assert_eq!(feature_edges(Gltf, promised(&scalar(2))), [[0, 1], [2, 3]]);
    assert_refused(Gltf, promised(&scalar(3)), PRIMITIVE, &["an accessor", "3 bytes are needed, 2 are left"]);
    assert_refused(Gltf, promised(&scalar(u64::MAX)), PRIMITIVE, &["an accessor"]);
}
