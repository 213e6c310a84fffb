use crate::expectations::{accepted, assert_refused, assert_square, square_rows};
use silhouette_core::load::Format::Off;

fn square(header: &str, faces: &str) -> String {
    header.to_owned() + &square_rows("") + faces
}

#[test]
fn headers_of_all_kinds_are_read() {
    for header in
        ["OFF\n4 1 4\n", "OFF\n4 1\n", "OFF 4 1 4\n", "4 1 4\n", "# made by hand\n\nOFF # keyword\n# counts\n4 1 0\n"]
    {
        assert_square(&accepted(Off, square(header, "4 0 1 2 3\n")));
    }
    assert_square(&accepted(Off, square("OFF\r\n4 1 4\r\n", "4 0 1 2 3\r\n")));
}

#[test]
fn further_numbers_of_a_vertex_and_a_face_are_passed_over() {
    for (keyword, extra) in
        [("COFF", " 255 0 0 255"), ("NOFF", " 0 0 1"), ("CNOFF", " 0 0 1 1 0 0 1"), ("STOFF", " .5 .5")]
    {
        let rows = square_rows("").replace('\n', &format!("{extra}\n"));
        let text = format!("{keyword}\n4 2 0\n{rows}3 0 1 2 255 0 0\n\n3 0 2 3 0.5 0.5 0.5 # blue\n");
        assert_square(&accepted(Off, text));
    }
    assert_square(&accepted(Off, square("STCNOFF\n4 1 0\n", "4 0 1 2 3\nanything may follow the last face")));
}

#[test]
fn unreferenced_vertices_are_kept() {
    let mesh = accepted(Off, square("OFF\n4 1 0\n", "3 1 2 3\n"));
    assert_eq!((mesh.vertex_count(), mesh.triangles()), (4, [[1, 2, 3]].as_slice()));
}

#[test]
fn variants_that_are_not_read_are_named() {
    assert_refused(Off, "OFF BINARY\n4 1 0\n", ", line 1", &["binary OFF", "save it as text"]);
    assert_refused(Off, "4OFF\n4 1 0\n", ", line 1", &["4OFF"]);
    assert_refused(Off, "nOFF\n3\n4 1 0\n", ", line 1", &["nOFF"]);
    assert_refused(Off, "solid x\n", ", line 1", &["keyword OFF", "\"solid\""]);
    assert_refused(Off, "# nothing else\n", ", line 1", &["keyword OFF"]);
}

#[test]
fn promises_are_checked_against_the_bytes() {
    assert_refused(Off, "OFF\n3 4294967295 0\n0 0 0\n1 0 0\n0 1 0\n", ", line 2", &["4294967295 faces"]);
    assert_refused(Off, "OFF\n4294967295 1 0\n0 0 0\n", ", line 2", &["4294967295 vertices"]);
    assert_refused(Off, "OFF\n9223372036854775807 1 0\n", ", line 2", &["9223372036854775807 vertices"]);
    assert_refused(Off, square("OFF\n4 2 0\n", "4 0 1 2 3\n"), ", line 7", &["2 faces", "at most 1"]);
    assert_refused(Off, "OFF\n-4 1 0\n", ", line 2", &["number of vertices", "\"-4\""]);
    assert_refused(Off, "OFF\n4\n", ", line 2", &["number of faces", "nothing"]);
}

#[test]
fn bad_rows_are_refused_at_their_lines() {
    assert_refused(Off, square("OFF\n4 1 0\n", "4 0 1 2 4\n"), ", line 7", &["face 0", "vertex 4", "0 to 3"]);
    assert_refused(Off, square("OFF\n4 1 0\n", "3 0 1 -1\n"), ", line 7", &["vertex -1"]);
    assert_refused(Off, square("OFF\n4 1 0\n", "2 0 1\n"), ", line 7", &["face 0 has 2 corners"]);
    assert_refused(Off, square("OFF\n4 1 0\n", "-3 0 1 2\n"), ", line 7", &["face 0 has 0 corners"]);
    assert_refused(Off, square("OFF\n4 1 0\n", "4 0 1 2\n"), ", line 7", &["a vertex number", "nothing"]);
    assert_refused(Off, square("OFF\n4 1 0\n", "4000000000 0 1 2\n"), ", line 7", &["a vertex number", "nothing"]);
    assert_refused(Off, "OFF\n1 1 0\n0 1e39 0\n3 0 0 0\n", ", line 3", &["vertex 0", "1e39"]);
    assert_refused(Off, square("OFF\n4 0 0\n", ""), "", &["no faces"]);
}
