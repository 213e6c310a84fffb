use crate::expectations::{SQUARE, accepted, assert_refused, assert_square, labelled, positions, refused, square_rows};
use silhouette_core::load::{Format::Ply, Note, Place, Problem};

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";

/// A header in this encoding with these rows between format and end.
fn header(encoding: &str, rows: &str) -> String {
    format!("ply\nformat {encoding} 1.0\ncomment made by hand\n{rows}obj_info none\nend_header\n")
}

/// The square as text, with one face element of these properties and rows.
fn text(properties: &str, faces: &[&str]) -> String {
    let rows = format!("element vertex 4\n{XYZ}element face {}\n{properties}", faces.len());
    header("ascii", &rows) + &square_rows("") + &faces.join("\n")
}

const QUAD: &str = "property list uchar int vertex_indices\n";

/// Numbers in the byte order of a body.
pub struct Body {
    pub bytes: Vec<u8>,
    big_endian: bool,
}

impl Body {
    pub fn new(encoding: &str) -> Self {
        Self { bytes: Vec::new(), big_endian: encoding == "binary_big_endian" }
    }

    /// Appends a number, given in little-endian order.
    pub fn put<const N: usize>(&mut self, mut little_endian: [u8; N]) {
        if self.big_endian {
            little_endian.reverse();
        }
        self.bytes.extend(little_endian);
    }
}

const BINARY: [&str; 2] = ["binary_little_endian", "binary_big_endian"];

/// The square in binary, with properties and elements around it that a mesh has no use for.
pub fn binary(encoding: &str) -> Vec<u8> {
    let rows = "element vertex 4\nproperty double x\nproperty uchar red\nproperty float y\nproperty short z\n\
                property list uint float weights\nelement material 1\nproperty list uchar double shine\nproperty char kind\n\
                element nothing 4294967295\n\
                element face 1\nproperty ushort flags\nproperty list int ushort vertex_index\nproperty list uchar float texcoord\n";
    let mut body = Body::new(encoding);
    for [x, y, z] in SQUARE {
        body.put(f64::from(x).to_le_bytes());
        body.put([0xff]);
        body.put(y.to_le_bytes());
        body.put((z as i16).to_le_bytes());
        body.put(2_u32.to_le_bytes());
        body.put([0x11; 4]);
        body.put([0x22; 4]);
    }
    body.put([2]);
    body.put([0x33; 8]);
    body.put([0x44; 8]);
    body.put([0x55]);
    body.put([0x66; 2]);
    body.put(4_i32.to_le_bytes());
    for vertex in 0..4_u16 {
        body.put(vertex.to_le_bytes());
    }
    body.put([1]);
    body.put([0x77; 4]);
    [header(encoding, rows).into_bytes(), body.bytes].concat()
}

#[test]
fn text_is_read() {
    assert_square(&accepted(Ply, text(QUAD, &["4 0 1 2 3"])));
    assert_square(&accepted(Ply, text("property list uint8 uint32 vertex_index\n", &["3 0 1 2", "3 0 2 3"])));
    assert_square(&accepted(
        Ply,
        text(QUAD, &["3 0 1 2", "", "3 0 2 3 "]).replace('\n', "\r\n").replace("face 3", "face 2"),
    ));
}

#[test]
fn binary_of_either_order_is_read_and_the_rest_skipped() {
    for encoding in BINARY {
        assert_square(&accepted(Ply, binary(encoding)));
    }
}

#[test]
fn header_lines_may_end_like_windows_lines_before_a_binary_body() {
    let bytes = binary(BINARY[0]);
    let end = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    let head = String::from_utf8(bytes[..end].to_vec()).unwrap().replace('\n', "\r\n");
    assert_square(&accepted(Ply, [head.as_bytes(), &bytes[end..]].concat()));
}

#[test]
fn list_types_of_all_widths_are_read() {
    let types = [("char", 1), ("uint8", 1), ("int16", 2), ("ushort", 2), ("int", 4), ("uint32", 4)];
    for (name, size) in types.into_iter().chain([("int64", 8), ("uint64", 8)]) {
        for encoding in BINARY {
            let rows = format!("element vertex 4\n{XYZ}element face 1\nproperty list {name} {name} vertex_indices\n");
            let mut body = Body::new(encoding);
            SQUARE.iter().flatten().for_each(|x| body.put(x.to_le_bytes()));
            for number in [4_u8, 0, 1, 2, 3] {
                match size {
                    1 => body.put([number]),
                    2 => body.put([number, 0]),
                    4 => body.put([number, 0, 0, 0]),
                    _ => body.put([number, 0, 0, 0, 0, 0, 0, 0]),
                }
            }
            assert_square(&accepted(Ply, [header(encoding, &rows).into_bytes(), body.bytes].concat()));
        }
    }
}

#[test]
fn coordinates_of_any_type_and_place_are_read() {
    let rows =
        "element vertex 3\nproperty int id\nproperty double z\nproperty uchar y\nproperty int8 x\nelement face 1\n";
    let mesh = accepted(Ply, header("ascii", &(rows.to_owned() + QUAD)) + "7 .25 2 -3\n8 1e-3 0 0\n9 0 1 0\n3 0 1 2");
    assert_eq!(positions(&mesh), [[-3.0, 2.0, 0.25], [0.0, 0.0, 0.001], [0.0, 1.0, 0.0]]);
}

#[test]
fn faces_may_stand_before_vertices() {
    let rows = format!("element face 1\n{QUAD}element vertex 4\n{XYZ}");
    assert_square(&accepted(Ply, header("ascii", &rows) + "4 0 1 2 3\n" + &square_rows("")));
}

#[test]
fn strips_alternate_restart_and_drop_their_joins() {
    let rows = format!("element vertex 6\n{XYZ}element tristrips 1\nproperty list int int vertex_indices\n");
    let vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
    let mesh = accepted(Ply, header("ascii", &rows) + vertices + "14 0 1 2 3 -1 2 3 3 4 5 -1 -1 0 1\n");
    // The second strip is 2 3 3 | 3 3 4 (joins, left out) | 3 4 5.
    assert_eq!(mesh.triangles(), [[0, 1, 2], [2, 1, 3], [3, 4, 5]]);
}

#[test]
fn promises_are_checked_against_the_bytes() {
    for encoding in ["ascii", BINARY[0], BINARY[1]] {
        let rows = format!("element vertex 4294967295\n{XYZ}element face 4294967295\n{QUAD}");
        let head = header(encoding, &rows);
        let place = if encoding == "ascii" { ", line 12".to_owned() } else { format!(", byte {}", head.len()) };
        assert_refused(Ply, head + "0 0 0\n", &place, &["4294967295 rows of \"vertex\""]);
    }
    let rows = format!("element vertex 4\n{XYZ}element face 4294967295\n{QUAD}");
    let bytes = header("ascii", &rows) + &square_rows("") + "4 0 1 2 3\n";
    assert_refused(Ply, bytes, ", line 15", &["4294967295 rows of \"face\"", "at most"]);
    assert_refused(Ply, text(QUAD, &["4 0 1 2 3"]).replace("face 1", "face 2"), ", line 16", &["2 rows", "at most 1"]);
    assert_refused(Ply, header("ascii", "element vertex -1\n"), ", line 4", &["number of rows", "\"-1\""]);
}

#[test]
fn cut_binary_files_are_refused_wherever_they_are_cut() {
    for encoding in BINARY {
        let bytes = binary(encoding);
        let end = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
        for length in end..bytes.len() {
            let error = refused(Ply, &bytes[..length]);
            assert!(matches!(error.problem, Problem::Truncated { .. } | Problem::Promise { .. }), "{length}: {error}");
            assert!(
                matches!(error.place, Some(Place::Byte(byte)) if (end..=length).contains(&(byte as usize))),
                "{error}"
            );
        }
    }
}

#[test]
fn bad_rows_are_refused_at_their_places() {
    assert_refused(Ply, text(QUAD, &["4 0 1 2 3", "3 0 1 4"]), ", line 17", &["face 1", "vertex 4", "0 to 3"]);
    assert_refused(Ply, text(QUAD, &["3 0 1 -1"]), ", line 16", &["vertex -1"]);
    assert_refused(Ply, text(QUAD, &["-3 0 1 2"]), ", line 16", &["the length of a list", "\"-3\""]);
    assert_refused(Ply, text(QUAD, &["4 0 1 2"]), ", line 16", &["a vertex number", "nothing"]);
    assert_refused(Ply, text(QUAD, &["3 0 1 2"]).replace("1 1 0", "1 1e39 0"), ", line 14", &["vertex 2", "1e39"]);
    assert_refused(Ply, text(QUAD, &["3 0 1 2"]).replace("1 1 0", "1 nan 0"), ", line 14", &["vertex 2", "nan"]);
    let mut bytes = binary(BINARY[0]);
    let start = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    bytes[start..start + 8].copy_from_slice(&1e39_f64.to_le_bytes());
    assert_refused(Ply, bytes, &format!(", byte {start}"), &["vertex 0", "32-bit float"]);
}

#[test]
fn headers_that_describe_no_mesh_are_refused() {
    let faces = format!("element face 1\n{QUAD}");
    let vertices = format!("element vertex 1\n{XYZ}");
    assert_refused(Ply, "obj\n", ", line 1", &["the word ply"]);
    assert_refused(Ply, "ply\nformat ascii 1.0\n", ", line 2", &["end_header"]);
    assert_refused(Ply, "ply\nend_header\n", "", &["format"]);
    assert_refused(Ply, header("utf8", ""), ", line 2", &["binary_little_endian", "\"utf8\""]);
    assert_refused(Ply, header("ascii", "property float x\n"), ", line 4", &["an element before"]);
    assert_refused(Ply, header("ascii", "vertices 4\n"), ", line 4", &["a header row", "vertices 4"]);
    assert_refused(
        Ply,
        header("ascii", "element vertex 4\nproperty quad x\n"),
        ", line 5",
        &["number type", "\"quad\""],
    );
    assert_refused(Ply, header("ascii", "element vertex 4\nproperty float x\n"), ", line 4", &["x, y and z"]);
    assert_refused(Ply, header("ascii", &(vertices.clone() + &vertices)), ", line 8", &["one element vertex"]);
    assert_refused(Ply, header("ascii", &faces), "", &["element vertex"]);
    assert_refused(
        Ply,
        header("ascii", &(vertices.clone() + "element face 1\nproperty int a\n")),
        ", line 8",
        &["vertex_indices"],
    );
    let float = vertices.clone() + "element face 1\nproperty list uchar float vertex_indices\n";
    assert_refused(Ply, header("ascii", &float), ", line 9", &["floating-point"]);
    assert_refused(Ply, header("ascii", &vertices) + "0 0 0\n", "", &["no faces"]);
}

#[test]
fn whole_numbers_of_64_bits_are_checked_and_rounded_once() {
    let rows = "element vertex 3\nproperty uint64 x\nproperty int64 y\nproperty float z\nelement face 1\n\
                property list uint64 uint64 vertex_indices\n";
    for encoding in BINARY {
        let file = |length: u64, corner: u64| {
            let mut body = Body::new(encoding);
            // Halfway between two 32-bit floats and a little more: by way of 64-bit floats it would be rounded to even.
            for x in [0, 1, (1_u64 << 60) + (1 << 36) + 1] {
                body.put(x.to_le_bytes());
                body.put((-3_i64).to_le_bytes());
                body.put(0_f32.to_le_bytes());
            }
            [length, 0, 1, corner].into_iter().for_each(|number| body.put(number.to_le_bytes()));
            [header(encoding, rows).into_bytes(), body.bytes].concat()
        };
        let mesh = accepted(Ply, file(3, 2));
        assert_eq!(positions(&mesh)[1..], [[1.0, -3.0, 0.0], [((1_u64 << 60) + (1 << 37)) as f32, -3.0, 0.0]]);
        assert_eq!(mesh.triangles(), [[0, 1, 2]]);
        let length = file(3, 2).len();
        assert_refused(Ply, file(3, 3), &format!(", byte {length}"), &["vertex 3", "0 to 2"]);
        assert_refused(Ply, file(3, u64::MAX), &format!(", byte {length}"), &["2^63", "18446744073709551615"]);
        assert_refused(Ply, file(u64::MAX, 2), &format!(", byte {}", length - 24), &["2^63"]);
        assert_refused(Ply, file(1 << 62, 2), &format!(", byte {}", length - 24), &["bytes are needed"]);
    }
    let rows = "property list uint64 int64 vertex_indices\n";
    assert_square(&accepted(Ply, text(rows, &["4 0 1 2 3"])));
    assert_refused(Ply, text(rows, &["4 0 1 2 18446744073709551615"]), ", line 16", &["a vertex number"]);
}

#[test]
fn rows_may_be_broken_or_share_lines() {
    let (head, body) = text(QUAD, &["3 0 1 2", "3 0 2 3"])
        .split_once("end_header\n")
        .map(|(h, b)| (h.to_owned(), b.to_owned()))
        .unwrap();
    for body in [
        body.replace("1 1 0", "1 1\n\n0"),
        body.replace('\n', " "),
        body.replace(' ', "\r\n"),
        body.replace("0\n1", "0 1"),
    ] {
        assert_square(&accepted(Ply, format!("{head}end_header\n{body}")));
    }
    let line = body.replace('\n', " ");
    assert_refused(Ply, format!("{head}end_header\n{line} 7"), ", line 12", &["the end of the file", "\"7\""]);
    assert_refused(
        Ply,
        format!("{head}end_header\n{}", body.replace("1 1 0", "1 1")),
        ", line 14",
        &["a coordinate", "nothing"],
    );
}

#[test]
fn words_behind_a_row_are_passed_over() {
    assert_square(&accepted(Ply, text(QUAD, &["3 0 1 2 255 0 0", "3 0 2 3 7"])));
}

#[test]
fn lines_may_end_as_on_old_macs() {
    assert_square(&accepted(Ply, text(QUAD, &["4 0 1 2 3"]).replace('\n', "\r")));
    // The first byte of the body is a line feed, which then belongs to no line end.
    let rows = format!("element vertex 4\n{XYZ}property uchar a\nelement face 1\n{QUAD}")
        .replace("property float x", "property uchar b\nproperty float x");
    let mut body = Body::new(BINARY[0]);
    for corner in SQUARE {
        body.put([b'\n']);
        corner.iter().for_each(|x| body.put(x.to_le_bytes()));
        body.put([0]);
    }
    body.put([4]);
    (0..4_i32).for_each(|vertex| body.put(vertex.to_le_bytes()));
    let head = header(BINARY[0], &rows);
    for end in ["\r", "\n", "\r\n"] {
        assert_square(&accepted(Ply, [head.replace('\n', end).as_bytes(), &body.bytes].concat()));
    }
}

#[test]
fn faces_of_one_or_two_corners_are_left_out_and_counted() {
    let loaded = labelled(Ply, text(QUAD, &["2 0 1", "4 0 1 2 3", "0", "1 3"]));
    assert_square(&loaded.mesh);
    assert_eq!(loaded.notes, [Note::FewCorners { count: 3, first: Place::Line(16) }]);
}
