//! PDF, DXF and HP-GL, read back by small readers of their own.

use crate::scene::{Drawn, any_lines, drawn, lines_of, orthographic};
use proptest::prelude::*;
use silhouette_core::NoProgress;
use silhouette_core::glam::DVec2;
use silhouette_visibility::plot::{Colour, Drawing, Hidden, Length, Page, PlotOptions, Sheet, Unit, plot};
use silhouette_visibility::{LineKind, Outline};
use std::collections::BTreeMap;
use std::io;

fn square(low: f64, high: f64) -> Vec<DVec2> {
    [[low, low], [low, high], [high, high], [high, low]].map(DVec2::from).to_vec()
}

/// Straight and smooth, open and closed, visible and hidden lines, on a filled outline with a hole.
fn everything(unit: Unit) -> Drawing {
    let all: [Drawn; 4] = [
        drawn(LineKind::Silhouette, &[[10.0, 90.0], [10.0, 40.0], [50.0, 10.0], [90.0, 40.0], [90.0, 90.0]]).closed(),
        drawn(LineKind::Ridge, &[[10.0, 40.0], [90.0, 40.0]]).hidden(2),
        drawn(LineKind::Curve, &[[30.0, 50.0], [40.0, 80.0], [50.0, 50.0]]).closed().bent(),
        drawn(LineKind::Section, &[[20.0, 20.0], [35.0, 60.0], [80.0, 70.0]]).bent(),
    ];
    let mut lines = lines_of(orthographic(), &all);
    lines.outline = Outline::of_regions([vec![square(5.0, 95.0), square(40.0, 60.0).into_iter().rev().collect()]]);
    let mut options =
        PlotOptions { unit, hidden: Hidden::Solid, fill: Some(Colour([250, 240, 10])), ..PlotOptions::default() };
    options.pens.of_mut(LineKind::Silhouette).colour = Colour([255, 0, 1]);
    options.pens.of_hidden_mut(LineKind::Ridge).width = Length::mm(0.22);
    plot(&lines, &options, &NoProgress).unwrap()
}

fn text(write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

/// Length of each layer in millimetres.
fn lengths(drawing: &Drawing) -> BTreeMap<String, f64> {
    let mm = Length::new(1.0, drawing.placement.unit).to(Unit::Mm);
    drawing.layers.iter().map(|layer| (layer.name.id(), layer.paths.length() * mm)).collect()
}

fn assert_near(found: &BTreeMap<String, f64>, expected: &BTreeMap<String, f64>, tolerance: f64) {
    assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
    for (layer, length) in found {
        assert!((length / expected[layer] - 1.0).abs() < tolerance, "{layer}: {length} for {}", expected[layer]);
    }
}

/// The groups of a DXF file.
fn groups(text: &str) -> Vec<(u16, &str)> {
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len() % 2, 0, "a code and a value each");
    lines.chunks(2).map(|pair| (pair[0].parse().unwrap(), pair[1])).collect()
}

/// What begins with a group 0, up to the next one.
fn objects<'a>(groups: &[(u16, &'a str)]) -> Vec<Vec<(u16, &'a str)>> {
    let mut objects: Vec<Vec<(u16, &str)>> = Vec::new();
    for &group in groups {
        match (group.0, objects.last_mut()) {
            (0, _) | (_, None) => objects.push(vec![group]),
            (_, Some(object)) => object.push(group),
        }
    }
    objects
}

fn values<'a>(object: &[(u16, &'a str)], code: u16) -> Vec<&'a str> {
    object.iter().filter(|group| group.0 == code).map(|group| group.1).collect()
}

fn places(object: &[(u16, &str)]) -> Vec<DVec2> {
    let numbers = |code| values(object, code).into_iter().map(|value| value.parse::<f64>().unwrap());
    numbers(10).zip(numbers(20)).map(|(x, y)| DVec2::new(x, y)).collect()
}

/// Length of a polyline or of a spline of Bezier pieces.
fn length_of(object: &[(u16, &str)]) -> f64 {
    let mut points = places(object);
    if object[0].1 == "SPLINE" {
        let at = |piece: &[DVec2], t: f64| {
            let s = 1.0 - t;
            piece[0] * (s * s * s)
                + piece[1] * (3.0 * s * s * t)
                + piece[2] * (3.0 * s * t * t)
                + piece[3] * (t * t * t)
        };
        let control = points;
        points = (0..control.len() / 3)
            .flat_map(|piece| (0..=200).map(move |step| (piece, f64::from(step) / 200.0)))
            .map(|(piece, t)| at(&control[3 * piece..3 * piece + 4], t))
            .collect();
    } else if values(object, 70) == ["1"] {
        points.push(points[0]);
    }
    points.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

#[test]
fn dxf_holds_layers_pens_and_paths_in_millimetres() {
    for unit in [Unit::Mm, Unit::Px] {
        let drawing = everything(unit);
        let file = text(|out| drawing.write_dxf(out));
        let groups = groups(&file);
        let variable = |name: &str| groups[groups.iter().position(|group| *group == (9, name)).unwrap() + 1].1;
        assert_eq!([variable("$ACADVER"), variable("$INSUNITS")], ["AC1018", "4"]);
        assert_eq!(groups.last(), Some(&(0, "EOF")));
        let objects = objects(&groups);
        let layers: Vec<_> = objects.iter().filter(|object| object[0].1 == "LAYER").collect();
        let named: BTreeMap<&str, &Vec<(u16, &str)>> =
            layers.iter().map(|layer| (values(layer, 2)[0], *layer)).collect();
        assert_eq!(values(named["silhouette-visible"], 420), [0x00ff_0001.to_string()]);
        assert_eq!((values(named["ridge-hidden"], 370), values(named["ridge-hidden"], 62)), (vec!["20"], vec!["7"]));
        assert_eq!(values(named["section-visible"], 370), ["70"]);

        let mut found: BTreeMap<String, f64> = BTreeMap::new();
        for object in objects.iter().filter(|object| matches!(object[0].1, "LWPOLYLINE" | "SPLINE")) {
            *found.entry(values(object, 8)[0].to_owned()).or_default() += length_of(object);
            if object[0].1 == "SPLINE" {
                let numbers = [72, 73].map(|code| values(object, code)[0].parse::<usize>().unwrap());
                assert_eq!(numbers, [values(object, 40).len(), values(object, 10).len()]);
                assert_eq!(numbers[0], numbers[1] + 3 + 1);
            } else {
                assert_eq!(values(object, 90)[0].parse::<usize>().unwrap(), values(object, 10).len());
            }
        }
        // Lengths of curves are measured along 16 chords each.
        assert_near(&found, &lengths(&drawing), 1e-3);
        let inside = |place: &DVec2| place.cmpge(DVec2::ZERO).all() && place.cmple(DVec2::new(210.001, 297.001)).all();
        let drawn: Vec<DVec2> =
            objects.iter().filter(|object| object[0].1 == "LWPOLYLINE").flat_map(|o| places(o)).collect();
        assert!(drawn.iter().all(inside));
        // The roof is above: y points up.
        let silhouette = objects.iter().find(|object| values(object, 8) == ["silhouette-visible"]).unwrap();
        let corners = places(silhouette);
        let highest = corners.iter().map(|corner| corner.y).fold(0.0, f64::max);
        assert_eq!(corners.iter().filter(|corner| corner.y > highest - 1.0).count(), 1, "{corners:?}");
        let hatch = objects.iter().find(|object| object[0].1 == "HATCH").unwrap();
        assert_eq!((values(hatch, 91), values(hatch, 93), values(hatch, 8)), (vec!["2"], vec!["4", "4"], vec!["fill"]));
    }
}

/// A handle names one thing, what refers to another names one that is there, and the next free one is above all.
#[test]
fn dxf_handles_are_consistent() {
    let file = text(|out| everything(Unit::Mm).write_dxf(out));
    let groups = groups(&file);
    let code = |object: &[(u16, &str)]| if object[0].1 == "DIMSTYLE" { 105 } else { 5 };
    let after_header = groups.iter().position(|group| *group == (2, "TABLES")).unwrap();
    let objects = objects(&groups[after_header..]);
    let mut handles: Vec<u32> = objects
        .iter()
        .flat_map(|object| values(object, code(object)))
        .map(|handle| u32::from_str_radix(handle, 16).unwrap())
        .collect();
    let count = handles.len();
    handles.sort_unstable();
    handles.dedup();
    assert_eq!(handles.len(), count);
    let seed = groups.iter().position(|group| *group == (9, "$HANDSEED")).unwrap() + 1;
    assert_eq!(u32::from_str_radix(groups[seed].1, 16).unwrap(), handles.last().unwrap() + 1);
    for owner in objects.iter().flat_map(|object| values(object, 330)) {
        let owner = u32::from_str_radix(owner, 16).unwrap();
        assert!(owner == 0 || handles.binary_search(&owner).is_ok(), "{owner:X}");
    }
}

/// The objects of a PDF file, found by its table of places.
fn pdf_objects(file: &[u8]) -> Vec<String> {
    let find = |needle: &[u8], from: usize| {
        from + file[from..].windows(needle.len()).position(|window| window == needle).unwrap()
    };
    let rfind = |needle: &[u8]| file.windows(needle.len()).rposition(|window| window == needle).unwrap();
    let ascii = |from: usize, to: usize| std::str::from_utf8(&file[from..to]).unwrap();
    assert!(file.starts_with(b"%PDF-1.7") && file.trim_ascii_end().ends_with(b"%%EOF"));
    let start = rfind(b"startxref");
    let table: usize = ascii(start + 9, rfind(b"%%EOF")).trim().parse().unwrap();
    let mut rows = ascii(table, find(b"trailer", table)).lines();
    assert_eq!(rows.next(), Some("xref"));
    let count: usize = rows.next().unwrap().strip_prefix("0 ").unwrap().trim().parse().unwrap();
    let rows: Vec<&str> = rows.collect();
    assert_eq!(rows.len(), count);
    let objects = (1..count).map(|number| {
        let place: usize = rows[number][..10].parse().unwrap();
        let head = format!("{number} 0 obj");
        assert!(file[place..].starts_with(head.as_bytes()), "object {number} lies at {place}");
        String::from_utf8_lossy(&file[place + head.len()..find(b"endobj", place)]).into_owned()
    });
    objects.collect()
}

#[test]
fn pdf_holds_a_page_of_the_size_with_groups_of_paths() {
    for unit in [Unit::Mm, Unit::Px] {
        let drawing = everything(unit);
        let mut file = Vec::new();
        drawing.write_pdf("Häuser (2)", &mut file).unwrap();
        let objects = pdf_objects(&file);
        let page = objects.iter().find(|object| object.contains("/Type /Page\n")).unwrap();
        let sides = page.split("/MediaBox [").nth(1).unwrap().split(']').next().unwrap();
        let sides: Vec<f64> = sides.split_whitespace().map(|side| side.parse().unwrap()).collect();
        assert!(
            (sides[2] - 210.0 * 72.0 / 25.4).abs() < 1e-4 && (sides[3] - 297.0 * 72.0 / 25.4).abs() < 1e-4,
            "{sides:?}"
        );
        assert!(sides[..2] == [0.0; 2] && !page.contains("UserUnit"));
        let names = objects.iter().filter(|object| object.contains("/Type /OCG"));
        let names: Vec<&str> = names.map(|group| group.split('(').nth(1).unwrap().split(')').next().unwrap()).collect();
        assert_eq!(
            names,
            ["fill", "23 ridge hidden", "7 curve visible", "1 silhouette visible", "9 section visible", "40 outline"]
        );

        let content = objects.iter().find(|object| object.contains("stream")).unwrap();
        let operators: Vec<&str> = content.lines().filter_map(|line| line.split_whitespace().last()).collect();
        let count = |wanted: &str| operators.iter().filter(|operator| **operator == wanted).count();
        let paths: usize = drawing.layers.iter().map(|layer| layer.paths.len()).sum();
        assert_eq!((count("BDC"), count("EMC"), count("S"), count("f*")), (6, 6, paths, 1));
        assert_eq!((count("c"), count("w")), (5, 5), "five curves, five pens");
        let widths: Vec<&str> = content.lines().filter_map(|line| line.strip_suffix(" w")).collect();
        assert_eq!(widths, ["0.22", "0.5", "0.5", "0.7", "0.7"]);
    }
}

#[test]
fn pages_beyond_what_pdf_readers_take_have_larger_units() {
    let lines = lines_of(orthographic(), &[drawn(LineKind::Mesh, &[[1.0, 2.0], [9.0, 70.0]])]);
    let sheet = Sheet { page: "9000x300".parse::<Page>().unwrap(), ..Sheet::default() };
    let drawing = plot(&lines, &PlotOptions { sheet: Some(sheet), ..PlotOptions::default() }, &NoProgress).unwrap();
    let mut file = Vec::new();
    drawing.write_pdf("long", &mut file).unwrap();
    let page = pdf_objects(&file).into_iter().find(|object| object.contains("/MediaBox")).unwrap();
    let unit: f64 = page.split("/UserUnit ").nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
    assert!(page.contains("/MediaBox [0 0 14400 ") && (unit * 14400.0 - 9000.0 * 72.0 / 25.4).abs() < 0.1, "{page}");
}

/// Length of what each pen draws, in millimetres, and whether every coordinate is on the page.
fn hpgl_lengths(file: &str) -> (Vec<f64>, bool) {
    let (mut lengths, mut at, mut on_page) = (Vec::new(), DVec2::ZERO, true);
    for command in file.split(';').map(str::trim).filter(|command| !command.is_empty()) {
        let (name, values) = command.split_at(2);
        let numbers: Vec<f64> =
            values.split(',').filter(|v| !v.is_empty()).map(|v| v.parse::<i64>().unwrap() as f64).collect();
        match name {
            "IN" => assert!(lengths.is_empty()),
            "SP" => lengths.push(0.0),
            "PU" | "PD" => {
                assert_eq!(numbers.len() % 2, 0);
                for place in numbers.chunks(2).map(|pair| DVec2::new(pair[0], pair[1])) {
                    on_page &= place.min_element() >= 0.0 && place.x <= 210.0 * 40.0 && place.y <= 297.0 * 40.0;
                    if name == "PD" {
                        *lengths.last_mut().unwrap() += at.distance(place) / 40.0;
                    }
                    at = place;
                }
            }
            other => panic!("{other}"),
        }
    }
    (lengths, on_page)
}

#[test]
fn hpgl_draws_each_layer_with_its_own_pen() {
    for unit in [Unit::Mm, Unit::Px] {
        let drawing = everything(unit);
        let file = text(|out| drawing.write_hpgl(out));
        assert!(file.starts_with("IN;\nSP1;\nPU") && file.ends_with("PU;SP0;\n"), "{file}");
        let (lengths, on_page) = hpgl_lengths(&file);
        // Pen 0 is none.
        assert!(on_page && lengths.len() == drawing.layers.len() + 1 && lengths[drawing.layers.len()] == 0.0);
        let mm = Length::new(1.0, unit).to(Unit::Mm);
        for (layer, length) in drawing.layers.iter().zip(lengths) {
            assert!((length / (layer.paths.length() * mm) - 1.0).abs() < 2e-3, "{}: {length}", layer.name);
        }
    }
}

#[test]
fn a_fill_lies_beneath_all_layers_in_svg() {
    let drawing = everything(Unit::Mm);
    let file = text(|out| drawing.write_svg("x", out));
    let groups: Vec<&str> = file.split("<g ").skip(1).collect();
    assert!(
        groups[0].contains("id=\"fill\"") && groups[0].contains("fill=\"#faf00a\" stroke=\"none\""),
        "{}",
        groups[0]
    );
    assert!(groups[0].contains("fill-rule=\"evenodd\"") && groups[0].matches('Z').count() == 2);
    assert_eq!(groups.len(), 1 + drawing.layers.len());
    let filled = drawing.fill.unwrap();
    let outline = drawing.layers.iter().find(|layer| layer.name.id() == "outline").unwrap();
    assert!((filled.paths.length() - outline.paths.length()).abs() < 1e-9);
}

#[test]
fn what_is_not_asked_for_is_not_filled_and_not_outlined() {
    let mut lines = lines_of(orthographic(), &[drawn(LineKind::Mesh, &[[1.0, 2.0], [9.0, 70.0]])]);
    let options = PlotOptions { fill: Some(Colour([255; 3])), outline: false, ..PlotOptions::default() };
    assert_eq!(plot(&lines, &options, &NoProgress).unwrap().fill, None, "nothing is covered");
    lines.outline = Outline::of_regions([vec![square(5.0, 95.0)]]);
    let drawing = plot(&lines, &options, &NoProgress).unwrap();
    assert!(drawing.fill.is_some() && drawing.layers.len() == 1);
    assert_eq!(plot(&lines, &PlotOptions::default(), &NoProgress).unwrap().fill, None);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// Whatever is drawn, the files can be read, and are the same bytes again.
    #[test]
    fn any_drawing_is_written_whole(lines in any_lines()) {
        let drawing = plot(&lines, &PlotOptions { hidden: Hidden::Solid, ..PlotOptions::default() }, &NoProgress).unwrap();
        let dxf = text(|out| drawing.write_dxf(out));
        let groups = groups(&dxf);
        let entities = objects(&groups).into_iter().filter(|object| matches!(object[0].1, "LWPOLYLINE" | "SPLINE"));
        let mut found: BTreeMap<String, f64> = BTreeMap::new();
        for object in entities {
            *found.entry(values(&object, 8)[0].to_owned()).or_default() += length_of(&object);
        }
        let expected = lengths(&drawing);
        for (layer, length) in &expected {
            // Three decimals a point.
            let points = drawing.layers.iter().find(|other| other.name.id() == *layer).unwrap().paths.point_count();
            prop_assert!((found[layer] - length).abs() < 1e-3 * length + 3e-3 * points as f64, "{layer}");
        }
        let pdf = |_| { let mut file = Vec::new(); drawing.write_pdf("x", &mut file).unwrap(); file };
        let [one, other] = [0, 1].map(pdf);
        prop_assert_eq!(pdf_objects(&one).len(), 5 + drawing.layers.len());
        prop_assert!(one == other && dxf == text(|out| drawing.write_dxf(out)));
        prop_assert!(hpgl_lengths(&text(|out| drawing.write_hpgl(out))).1);
    }
}
