use crate::expectations::{accepted, assert_refused, assert_square, labelled, square_rows};
use silhouette_core::load::{Format::Off, Note, Place};

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
    assert_refused(Off, square("OFF\n4 1 0\n", "-3 0 1 2\n"), ", line 7", &["number of corners", "\"-3\""]);
    assert_refused(Off, square("OFF\n4 1 0\n", "4 0 1 2\n"), ", line 7", &["a vertex number", "nothing"]);
    assert_refused(Off, square("OFF\n4 1 0\n", "4000000000 0 1 2\n"), ", line 7", &["a vertex number", "nothing"]);
    assert_refused(Off, "OFF\n1 1 0\n0 1e39 0\n3 0 0 0\n", ", line 3", &["vertex 0", "1e39"]);
    assert_refused(Off, square("OFF\n4 0 0\n", ""), "", &["no faces"]);
}

#[test]
fn counts_may_stand_anywhere() {
    for header in ["OFF4 1 4\n", "OFF\n4\n1\n0\n", "OFF\n4\n\n1 # faces\n0\n", "OFF 4\n1 0\n", "4\n1\n0\n", "NOFF4 1\n"]
    {
        assert_square(&accepted(Off, square(header, "4 0 1 2 3\n")));
    }
}

#[test]
fn rows_may_be_broken_or_share_lines() {
    let text = square("OFF\n4 2 5\n", "3 0 1 2\n3 0 2 3\n");
    assert_square(&accepted(Off, text.replace('\n', "  ")));
    assert_square(&accepted(Off, text.replace(' ', "\n")));
    assert_square(&accepted(Off, text.replace("0 0 0\n1 0 0", "0 0 0 1 0 0")));
    assert_square(&accepted(Off, text.replace("1 1 0", "1 1 # and\n0")));
    assert_square(&accepted(Off, text.replace('\n', "\r")));
}

#[test]
fn no_word_of_a_stream_is_left_over() {
    let line = square("OFF 4 2 5\n", "3 0 1 2\n3 0 2 3\n").replace('\n', " ");
    assert_refused(Off, line.clone() + "3", ", line 1", &["the end of the file", "\"3\""]);
    assert_refused(Off, line.replace("4 2 5", "4 3 5"), ", line 1", &["3 faces", "at most 2"]);
    assert_refused(Off, line.replace("3 0 2 3", "3 0\n2 x"), ", line 2", &["vertex number", "\"x\""]);
}

/// A row that is too short must not take numbers from the next one, unless the whole file then comes out even.
#[test]
fn short_rows_take_nothing_from_the_next() {
    let text = square("OFF\n4 2 5\n", "3 0 1 2\n3 0 2 3\n");
    assert_refused(Off, text.replace("1 1 0", "1 1"), ", line 5", &["a coordinate", "nothing"]);
    assert_refused(Off, text.replace("3 0 1 2", "3 0 1"), ", line 7", &["a vertex number", "nothing"]);
}

#[test]
fn faces_of_one_or_two_corners_are_left_out_and_counted() {
    let loaded = labelled(Off, square("OFF\n4 4 0\n", "2 0 1\n4 0 1 2 3\n0\n1 3\n"));
    assert_square(&loaded.mesh);
    assert_eq!(loaded.notes, [Note::FewCorners { count: 3, first: Place::Line(7) }]);
}
