//! All but the entities: header, tables, blocks and objects, as few as readers ask for.

use super::super::decimal::number;
use super::LayerRecord;
use super::colour;
use super::groups::{FIRST_HANDLE, Groups};
use silhouette_core::glam::DVec2;
use std::io;

/// The handle of the block that holds the entities.
pub const MODEL_SPACE: &str = "1F";
const PAPER_SPACE: &str = "1B";
const BLOCK_TABLE: &str = "1";
const STANDARD_STYLE: &str = "11";
const ROOT_DICTIONARY: &str = "C";

/// Groups of a record.
type Record<'a> = &'a [(u16, &'a str)];
/// A table: its name, its handle, and each record's handle and groups.
type Table<'a> = (&'a str, &'a str, &'a [(&'a str, Record<'a>)]);

/// What stands before the table of layers.
const TABLES_BEFORE: [Table<'_>; 1] = [(
    "LTYPE",
    "5",
    &[
        (
            "14",
            &[(100, "AcDbLinetypeTableRecord"), (2, "ByBlock"), (70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0")],
        ),
        (
            "15",
            &[(100, "AcDbLinetypeTableRecord"), (2, "ByLayer"), (70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0")],
        ),
        (
            "16",
            &[
                (100, "AcDbLinetypeTableRecord"),
                (2, "Continuous"),
                (70, "0"),
                (3, "Solid line"),
                (72, "65"),
                (73, "0"),
                (40, "0"),
            ],
        ),
    ],
)];

/// What stands after it.
const TABLES_AFTER: [Table<'_>; 4] = [
    (
        "STYLE",
        "3",
        &[(
            STANDARD_STYLE,
            &[
                (100, "AcDbTextStyleTableRecord"),
                (2, "Standard"),
                (70, "0"),
                (40, "0"),
                (41, "1"),
                (50, "0"),
                (71, "0"),
                (42, "2.5"),
                (3, "txt"),
                (4, ""),
            ],
        )],
    ),
    ("VIEW", "6", &[]),
    ("UCS", "7", &[]),
    ("APPID", "9", &[("12", &[(100, "AcDbRegAppTableRecord"), (2, "ACAD"), (70, "0")])]),
];

/// Everything before the entities, for a page of this size in its own unit.
pub fn head(
    groups: &mut Groups<'_>,
    [width, height]: [f64; 2],
    layers: &[LayerRecord],
    entities: usize,
) -> io::Result<()> {
    let corners = [DVec2::new(0.0, height), DVec2::new(width, 0.0)];
    // The layers' handles, too, are given out.
    let seed = FIRST_HANDLE as usize + layers.len() + entities;
    header(groups, corners, seed)?;
    groups.section("CLASSES")?;
    groups.end_section()?;
    groups.section("TABLES")?;
    viewport(groups, corners)?;
    TABLES_BEFORE.iter().try_for_each(|(name, handle, records)| table(groups, name, handle, records))?;
    layer_table(groups, layers)?;
    TABLES_AFTER.iter().try_for_each(|(name, handle, records)| table(groups, name, handle, records))?;
    dimension_styles(groups)?;
    let block = |name| [(100, "AcDbBlockTableRecord"), (2, name), (340, "0")];
    let (model, paper) = (block("*Model_Space"), block("*Paper_Space"));
    table(groups, "BLOCK_RECORD", BLOCK_TABLE, &[(MODEL_SPACE, &model), (PAPER_SPACE, &paper)])?;
    groups.end_section()?;
    groups.section("BLOCKS")?;
    self::block(groups, "*Model_Space", MODEL_SPACE, ["20", "21"])?;
    self::block(groups, "*Paper_Space", PAPER_SPACE, ["1C", "1D"])?;
    groups.end_section()
}

/// Everything after the entities.
pub fn tail(groups: &mut Groups<'_>) -> io::Result<()> {
    const GROUP_DICTIONARY: &str = "D";
    groups.section("OBJECTS")?;
    groups.put_all(&[(0, "DICTIONARY"), (5, ROOT_DICTIONARY), (330, "0"), (100, "AcDbDictionary"), (281, "1")])?;
    groups.put_all(&[(3, "ACAD_GROUP"), (350, GROUP_DICTIONARY)])?;
    groups.put_all(&[(0, "DICTIONARY"), (5, GROUP_DICTIONARY), (330, ROOT_DICTIONARY)])?;
    groups.put_all(&[(100, "AcDbDictionary"), (281, "1")])?;
    groups.end_section()?;
    groups.put(0, "EOF")
}

fn header(groups: &mut Groups<'_>, [low, high]: [DVec2; 2], seed: usize) -> io::Result<()> {
    const MILLIMETRES: &str = "4";
    groups.section("HEADER")?;
    groups.put_all(&[(9, "$ACADVER"), (1, "AC1018"), (9, "$DWGCODEPAGE"), (3, "ANSI_1252")])?;
    for (variable, place) in [("$EXTMIN", low), ("$EXTMAX", high)] {
        groups.put(9, variable)?;
        groups.put_place(10, place)?;
        groups.put(30, 0)?;
    }
    for (variable, place) in [("$LIMMIN", low), ("$LIMMAX", high)] {
        groups.put(9, variable)?;
        groups.put_place(10, place)?;
    }
    groups.put_all(&[
        (9, "$INSUNITS"),
        (70, MILLIMETRES),
        (9, "$MEASUREMENT"),
        (70, "1"),
        (9, "$LWDISPLAY"),
        (290, "1"),
    ])?;
    groups.put(9, "$HANDSEED")?;
    groups.put(5, format_args!("{seed:X}"))?;
    groups.end_section()
}

fn begin_table(groups: &mut Groups<'_>, name: &str, handle: &str, count: usize) -> io::Result<()> {
    groups.put_all(&[(0, "TABLE"), (2, name), (5, handle), (330, "0"), (100, "AcDbSymbolTable")])?;
    groups.put(70, count)
}

fn table(groups: &mut Groups<'_>, name: &str, handle: &str, records: &[(&str, Record<'_>)]) -> io::Result<()> {
    begin_table(groups, name, handle, records.len())?;
    for (own, record) in records {
        groups.put_all(&[(0, name), (5, own), (330, handle), (100, "AcDbSymbolTableRecord")])?;
        groups.put_all(record)?;
    }
    groups.put(0, "ENDTAB")
}

/// What is shown at first: the page.
fn viewport(groups: &mut Groups<'_>, [low, high]: [DVec2; 2]) -> io::Result<()> {
    const TABLE: &str = "8";
    begin_table(groups, "VPORT", TABLE, 1)?;
    groups.put_all(&[(0, "VPORT"), (5, "22"), (330, TABLE), (100, "AcDbSymbolTableRecord")])?;
    groups.put_all(&[(100, "AcDbViewportTableRecord"), (2, "*Active"), (70, "0")])?;
    groups.put_all(&[(10, "0"), (20, "0"), (11, "1"), (21, "1")])?;
    groups.put_place(12, (low + high) * 0.5)?;
    groups.put_all(&[(16, "0"), (26, "0"), (36, "1"), (17, "0"), (27, "0"), (37, "0")])?;
    groups.put_length(40, low.y - high.y)?;
    groups.put(41, number((high.x - low.x) / (low.y - high.y)))?;
    groups.put_all(&[
        (42, "50"),
        (43, "0"),
        (44, "0"),
        (50, "0"),
        (51, "0"),
        (71, "0"),
        (72, "1000"),
        (73, "1"),
        (74, "3"),
    ])?;
    groups.put(0, "ENDTAB")
}

fn layer_table(groups: &mut Groups<'_>, layers: &[LayerRecord]) -> io::Result<()> {
    const TABLE: &str = "2";
    begin_table(groups, "LAYER", TABLE, layers.len() + 1)?;
    groups.put_all(&[(0, "LAYER"), (5, "10"), (330, TABLE), (100, "AcDbSymbolTableRecord")])?;
    groups.put_all(&[(100, "AcDbLayerTableRecord"), (2, "0"), (70, "0"), (62, "7"), (6, "Continuous")])?;
    for layer in layers {
        groups.put(0, "LAYER")?;
        groups.put_handle()?;
        groups.put_all(&[(330, TABLE), (100, "AcDbSymbolTableRecord"), (100, "AcDbLayerTableRecord")])?;
        groups.put_all(&[(2, &layer.name), (70, "0")])?;
        groups.put(62, colour::index(layer.colour))?;
        if let Some(colour) = colour::true_colour(layer.colour) {
            groups.put(420, colour)?;
        }
        groups.put(6, "Continuous")?;
        groups.put(370, colour::weight(layer.width_mm))?;
    }
    groups.put(0, "ENDTAB")
}

/// The one table whose records have handles of another number.
fn dimension_styles(groups: &mut Groups<'_>) -> io::Result<()> {
    const TABLE: &str = "A";
    begin_table(groups, "DIMSTYLE", TABLE, 1)?;
    groups.put_all(&[(100, "AcDbDimStyleTable"), (0, "DIMSTYLE"), (105, "27"), (330, TABLE)])?;
    groups.put_all(&[(100, "AcDbSymbolTableRecord"), (100, "AcDbDimStyleTableRecord"), (2, "Standard"), (70, "0")])?;
    groups.put_all(&[(340, STANDARD_STYLE), (0, "ENDTAB")])
}

fn block(groups: &mut Groups<'_>, name: &str, record: &str, [begin, end]: [&str; 2]) -> io::Result<()> {
    groups.put_all(&[
        (0, "BLOCK"),
        (5, begin),
        (330, record),
        (100, "AcDbEntity"),
        (8, "0"),
        (100, "AcDbBlockBegin"),
    ])?;
    groups.put_all(&[(2, name), (70, "0"), (10, "0"), (20, "0"), (30, "0"), (3, name), (1, "")])?;
    groups.put_all(&[(0, "ENDBLK"), (5, end), (330, record), (100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockEnd")])
}
