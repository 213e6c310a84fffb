//! Smoothing groups and line elements of OBJ files as feature edges.

use crate::expectations::{feature_edges, square_rows};
use proptest::prelude::*;
use silhouette_core::load::Format::Obj;
use std::collections::{BTreeMap, BTreeSet};

const NONE: [[u32; 2]; 0] = [];

/// A square with the vertices 0 to 3, and rows.
fn square(rows: &str) -> Vec<[u32; 2]> {
    feature_edges(Obj, square_rows("v ") + rows)
}

/// The six sides of a cube as quadrilaterals, each behind its own row.
fn cube(rows: [&str; 6]) -> Vec<[u32; 2]> {
    let vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    let sides = ["4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"];
    let faces = rows.iter().zip(sides).map(|(row, side)| format!("{row}\nf {side}\n"));
    feature_edges(Obj, vertices.to_owned() + &faces.collect::<String>())
}

#[test]
fn edges_between_smoothing_groups_are_sharp() {
    assert_eq!(square("s 1\nf 1 2 3\ns 2\nf 1 3 4\n"), [[0, 2]]);
    let bottom = [[0, 1], [0, 3], [1, 2], [2, 3]];
    assert_eq!(cube(["s 1", "s 2", "", "", "", ""]), bottom, "all but the bottom are in group 2");
    assert_eq!(cube(["s 1", "s 2", "s 3", "s 4", "s 5", "s 6"]).len(), 12, "no diagonal is an edge of a cube");
    assert_eq!(cube(["s 7", "s 1", "", "", "", "s 7"]).len(), 6, "an L of two sides");
}

#[test]
fn every_side_of_a_flat_face_is_sharp_and_none_of_its_diagonals() {
    let top_and_bottom = [[0, 1], [0, 3], [1, 2], [2, 3], [4, 5], [4, 7], [5, 6], [6, 7]];
    assert_eq!(cube(["s off", "", "s 1", "", "", ""]), top_and_bottom);
    assert_eq!(cube(["s 0", "", "s 1", "", "", ""]), top_and_bottom);
    assert_eq!(cube(["", "", "s 1", "", "", ""]), top_and_bottom, "without s a face is flat");
    assert_eq!(cube(["s off", "s off", "s off", "s off", "s off", "s 1"]).len(), 12, "flat faces are in no group");
}

#[test]
fn one_group_says_nothing() {
    assert_eq!(square("f 1 2 3\nf 1 3 4\n"), NONE);
    for row in ["s off", "s 0", "s 1", "s 30", "s 1 # all"] {
        assert_eq!(cube([row, "", row, "", row, ""]), NONE, "{row}");
    }
    assert_eq!(square("s 1\ns off\nf 1 2 3\nf 1 3 4\ns 1\n"), NONE, "no face is in group 1");
}

#[test]
fn rows_that_name_no_group_change_none() {
    assert_eq!(square("s 1\nf 1 2 3\ns\ns smooth\ns -1\ns 99999999999\ns # 2\nf 1 3 4\n"), NONE);
}

#[test]
fn lines_along_edges_are_sharp() {
    let faces = "f 1 2 3\nf 1 3 4\n";
    assert_eq!(square(&format!("{faces}l 3 1\n")), [[0, 2]]);
    assert_eq!(square(&format!("{faces}l 1/1 2/2 3/3 4/4 1/1\nl 2 1\n")), [[0, 1], [0, 3], [1, 2], [2, 3]]);
    assert_eq!(square(&format!("{faces}l -4 -2 # a diagonal\n")), [[0, 2]]);
    assert_eq!(square(&format!("l 4 3\n{faces}")), [[2, 3]], "faces may follow");
    assert_eq!(feature_edges(Obj, format!("l 1 2\n{}{faces}", square_rows("v "))), [[0, 1]], "vertices too");
    assert_eq!(square(&format!("{faces}s 1\nl 1 2\n")), [[0, 1]], "groups of lines are no groups of faces");
    assert_eq!(square("s 1\nf 1 2 3\ns 2\nf 1 3 4\nl 1 2 3 1\n"), [[0, 1], [0, 2], [1, 2]]);
}

#[test]
fn lines_that_are_no_edges_are_passed_over() {
    for row in
        ["l 2 4", "l 1", "l", "l 1 1", "l 1 5", "l 9 8", "l 0 1", "l -5 1", "l 1 x 2", "l 1 99999999999999999999"]
    {
        assert_eq!(square(&format!("f 1 2 3\nf 1 3 4\n{row}\n")), NONE, "{row}");
    }
    assert_eq!(square("f 1 2 3\nf 1 3 4\nl 2 4 3 9 1 2\n"), [[0, 1], [2, 3]], "the rest of the line counts");
    assert_eq!(square("f 1 1 3\nf 1 3 4\ns 1\nf 1 2 3\nl 1 1\n"), [[0, 2], [0, 3], [2, 3]]);
}

/// A polygon of a file: its smoothing group and its corners.
type Polygon = (u32, Vec<u32>);

/// The definition, side by side through an ordered map: the oracle.
fn by_definition(polygons: &[Polygon], lines: &[Vec<u32>]) -> Vec<[u32; 2]> {
    let pair = |a: u32, b: u32| [a.min(b), a.max(b)];
    let (mut groups_at, mut edges) = (BTreeMap::<_, BTreeSet<u32>>::new(), BTreeSet::new());
    for (group, corners) in polygons {
        for (rank, &corner) in corners.iter().enumerate() {
            groups_at.entry(pair(corner, corners[(rank + 1) % corners.len()])).or_default().insert(*group);
        }
        for ends in corners[1..].windows(2) {
            edges.extend([pair(corners[0], ends[0]), pair(ends[0], ends[1]), pair(ends[1], corners[0])]);
        }
    }
    let groups: BTreeSet<u32> = polygons.iter().map(|(group, _)| *group).collect();
    let mut sharp = BTreeSet::new();
    if groups.len() > 1 {
        let is_sharp = |groups: &BTreeSet<u32>| groups.contains(&0) || groups.len() > 1;
        sharp.extend(groups_at.into_iter().filter(|(_, groups)| is_sharp(groups)).map(|(side, _)| side));
    }
    let pieces = lines.iter().flat_map(|line| line.windows(2)).map(|ends| pair(ends[0], ends[1]));
    sharp.extend(pieces.filter(|piece| edges.contains(piece)));
    sharp.into_iter().filter(|[a, b]| a != b).collect()
}

proptest! {
    #[test]
    fn any_file_says_what_the_definition_says(
        polygons in prop::collection::vec((0..3_u32, prop::collection::vec(0..8_u32, 3..7)), 1..12),
        lines in prop::collection::vec(prop::collection::vec(0..8_u32, 0..5), 0..4),
    ) {
        let words = |vertices: &[u32]| vertices.iter().map(|vertex| format!(" {}", vertex + 1)).collect::<String>();
        let vertices: String = (0..8).map(|x| format!("v {x} 0 0\n")).collect();
        let faces: String = polygons.iter().map(|(group, corners)| format!("s {group}\nf{}\n", words(corners))).collect();
        let rows: String = lines.iter().map(|line| format!("l{}\n", words(line))).collect();
        prop_assert_eq!(feature_edges(Obj, vertices + &faces + &rows), by_definition(&polygons, &lines));
    }
}
