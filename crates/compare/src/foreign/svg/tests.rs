use super::*;

const FRAME: Frame = Frame { size: [100, 50], pen_width_px: 2.0 };

fn document(attributes: &str, body: &str) -> String {
    format!("<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" {attributes}>\n{body}\n</svg>\n")
}

fn drawn(attributes: &str, body: &str) -> (Vec<Polyline>, Vec<String>) {
    read(document(attributes, body).as_bytes(), FRAME).unwrap()
}

/// The lines of a body in pixels.
fn lines(body: &str) -> Vec<Polyline> {
    drawn("", &format!("<g stroke=\"black\">{body}</g>")).0
}

fn refused(attributes: &str, body: &str) -> String {
    read(document(attributes, body).as_bytes(), FRAME).unwrap_err().to_string()
}

fn points(points: &[[f64; 2]]) -> Vec<DVec2> {
    points.iter().copied().map(DVec2::from).collect()
}

fn are_near(found: &[DVec2], expected: &[[f64; 2]]) -> bool {
    found.len() == expected.len() && found.iter().zip(points(expected)).all(|(one, other)| one.distance(other) < 1e-9)
}

#[test]
fn every_shape_is_a_line() {
    let found = lines(
        "<line x1='1' y1='2' x2='30' y2='40'/><polyline points='1,2 3 4-5 6'/><polygon points='1 1 9 1 9 9'/>\
         <path d='m10 10 h20 v5 z M 1 1 L 2 2'/><rect x='2' y='3' width='10' height='20'/>",
    );
    let expected: [(&[[f64; 2]], bool); 6] = [
        (&[[1.0, 2.0], [30.0, 40.0]], false),
        (&[[1.0, 2.0], [3.0, 4.0]], false),
        (&[[1.0, 1.0], [9.0, 1.0], [9.0, 9.0]], true),
        (&[[10.0, 10.0], [30.0, 10.0], [30.0, 15.0]], true),
        (&[[1.0, 1.0], [2.0, 2.0]], false),
        (&[[2.0, 3.0], [12.0, 3.0], [12.0, 23.0], [2.0, 23.0]], true),
    ];
    assert_eq!(found.len(), expected.len());
    for (line, (points, closed)) in found.iter().zip(expected) {
        assert_eq!(line.closed, closed, "{line:?}");
        // The polyline leaves the picture on its way to (-5, 6).
        assert!(are_near(&line.points[..points.len()], points), "{line:?}");
    }
}

#[test]
fn curves_and_circles_become_chords_that_keep_to_them() {
    let circle = lines("<circle cx='50' cy='25' r='20'/>");
    let half = lines("<path d='M30 25 A20 20 0 0 1 70 25 A20 20 0 0 1 30 25 Z'/>");
    let ellipse = lines("<ellipse cx='5' cy='2.5' rx='1' ry='2' transform='matrix(20 0 0 10 -50 0)'/>");
    // Arcs become cubics, which stray by 3e-4 of the radius.
    for (found, within) in [(circle, 0.011), (half, 0.02), (ellipse, 0.011)] {
        assert!(found.len() == 1 && found[0].closed);
        for pair in found[0].points.windows(2) {
            for place in [pair[0], pair[0].midpoint(pair[1])] {
                assert!((place.distance(DVec2::new(50.0, 25.0)) - 20.0).abs() < within, "{place}");
            }
        }
    }
    let quadratic = lines("<path d='M10 10 Q50 90 90 10'/>");
    let cut = |place: &DVec2| (place.x - 10.0) / 80.0;
    let on_curve = |t: f64| 10.0 + 2.0 * t * (1.0 - t) * 80.0;
    assert!(quadratic[0].points.iter().all(|place| (place.y - on_curve(cut(place))).abs() < 1e-6));
}

#[test]
fn transforms_and_view_boxes_place_lines() {
    let line = "<g stroke='black' transform='translate(10 5)'><g transform='scale(2)'><line x2='5' y2='3'/></g></g>";
    let at = |attributes: &str| drawn(attributes, line).0[0].points.clone();
    assert!(are_near(&at(""), &[[10.0, 5.0], [20.0, 11.0]]));
    assert!(are_near(&at("width='100' height='50'"), &[[10.0, 5.0], [20.0, 11.0]]));
    assert!(are_near(&at("viewBox='0 0 100 50'"), &[[10.0, 5.0], [20.0, 11.0]]));
    assert!(are_near(&at("viewBox='-10 0 200 100' width='100px'"), &[[10.0, 2.5], [15.0, 5.5]]));
    // In millimetres, twice as large, and with a box that does not fill the page.
    assert!(are_near(&at("width='100mm' height='50mm' viewBox='0 0 100 50'"), &[[10.0, 5.0], [20.0, 11.0]]));
    assert!(are_near(&at("width='100' height='50' viewBox='0 0 50 50'"), &[[35.0, 5.0], [45.0, 11.0]]));
    let stretched = at("width='100' height='50' viewBox='0 0 50 50' preserveAspectRatio='none'");
    assert!(are_near(&stretched, &[[20.0, 5.0], [40.0, 11.0]]));
    let notes = |attributes: &str| drawn(attributes, line).1;
    assert!(notes("viewBox='0 0 100 50'").is_empty() && notes("width='100px' height='50px'").is_empty());
    assert_eq!(notes("width='200' height='100'"), ["is 200 x 100 units, and is scaled to the view's 100 x 50 pixels"]);
}

#[test]
fn only_what_is_stroked_and_shown_is_drawn() {
    let line = |attributes: &str| format!("<line x1='5' y1='5' x2='9' y2='9' {attributes}/>");
    let count =
        |body: String| read(document("", &(body + &line("stroke='red'"))).as_bytes(), FRAME).unwrap().0.len() - 1;
    for hidden in [
        "",
        "stroke='none'",
        "style='stroke:none'",
        "stroke='black' style='stroke: none'",
        "stroke='black' display='none'",
        "stroke='black' visibility='hidden'",
        "stroke='black' opacity='0'",
        "stroke='black' style='stroke-opacity:0'",
        "stroke='black' stroke-width='0.0'",
        "stroke='white'",
        "stroke='#fff'",
        "stroke='currentColor' color='white'",
        "color='#fff' style='stroke: currentColor'",
    ] {
        assert_eq!(count(line(hidden)), 0, "{hidden}");
    }
    for shown in
        ["stroke='#123'", "style='stroke:rgb(9,9,9)'", "stroke='url(#gradient)'", "stroke='black' opacity='.5'"]
    {
        assert_eq!(count(line(shown)), 1, "{shown}");
    }
    let held = |outer: &str, inner: &str| count(format!("<g {outer}>{}</g>", line(inner)));
    assert_eq!(held("color='white' stroke='currentColor'", ""), 0);
    assert_eq!(held("color='white'", "stroke='currentColor' color='currentColor'"), 0);
    assert_eq!(held("color='white' stroke='currentColor'", "color='red'"), 1);
    assert_eq!(held("", "stroke='currentColor'"), 1);
    assert_eq!(count(format!("<g display='none'><g stroke='black'>{}</g></g>", line(""))), 0);
    assert_eq!(count(format!("<defs>{0}</defs><clipPath>{0}</clipPath><mask>{0}</mask>", line("stroke='red'"))), 0);
    let sheet = "<style>.pen { stroke: #000 } g.off > line { display: none } #a { stroke: none !important }</style>";
    assert_eq!(count(format!("{sheet}{}", line("class='thin pen'"))), 1);
    assert_eq!(count(format!("{sheet}<g class='off'>{}</g>", line("class='pen'"))), 0);
    assert_eq!(count(format!("{sheet}{}", line("id='a' style='stroke:red'"))), 0);
    let root = drawn("style='stroke:red' transform='translate(1)'", &line(""));
    assert!(are_near(&root.0[0].points, &[[6.0, 5.0], [10.0, 9.0]]));
    let clipped = drawn("", &format!("<g stroke='red' clip-path='url(#a)'>{}</g>", line("mask='none'")));
    assert_eq!(clipped.1, ["1 of its elements are clipped or masked; they count as if they were not"]);
    assert_eq!(count(format!("<switch><foreignObject/><g stroke='red'>{}</g></switch>", line(""))), 1);
    // What other programs add of their own is skipped.
    let foreign = "<x:view xmlns:x='http://example.org'><line stroke='red' x2='9' y2='9'/></x:view>";
    assert_eq!(count(foreign.to_owned()), 0);
}

#[test]
fn dashes_and_white_strokes_are_noted() {
    let (lines, notes) = drawn(
        "",
        "<g stroke='black'><path d='M1 1 9 9' stroke-dasharray='2 1'/><path d='M1 1 9 9' stroke-dasharray='none'/>\
         <path d='M1 1 9 9' stroke='white'/></g>",
    );
    assert_eq!((lines.len(), notes.len()), (2, 2));
    assert!(notes[0].starts_with("1 of its strokes are dashed") && notes[1].starts_with("1 of its strokes are white"));
}

#[test]
fn what_does_not_fit_is_named_with_its_line() {
    let body = |element: &str| refused("", &format!("<g stroke='black'>\n{element}\n</g>"));
    assert_eq!(body("<polyline points='1 2 3'/>"), "line 4: points: 3 numbers; give an x and a y for each point");
    for (element, place) in [
        ("<polyline points='1 2 nan 4'/>", "line 4: points: "),
        ("<path d='M1 2 L nan 4'/>", "line 4: d: "),
        ("<path d='M1 2 L 3 4 L 1e999 4'/>", "line 4: d: "),
        ("<line x1='NaN'/>", "line 4: x1: "),
        ("<line x1='10%'/>", "line 4: x1: 10% depends on something else"),
        ("<circle r='1e308' transform='scale(9e9)'/>", "line 4: r: inf, inf is no finite number"),
        ("<line x2='1' transform='spin(3)'/>", "line 4: transform: "),
        ("<use href='#a'/>", "line 4: <use> is not read; write its lines themselves"),
        ("<svg><line/></svg>", "line 4: <svg> is not read"),
    ] {
        let message = body(element);
        assert!(message.starts_with(place), "{message}");
    }
    assert!(
        refused("width='210mm' height='297mm'", "").contains("but the view is 100 x 50 pixels; draw it at that size")
    );
    assert!(refused("viewBox='0 0 50 100'", "").starts_with("is 50 x 100 units, but the view"));
    assert!(refused("viewBox='0 0 0 100'", "").starts_with("line 2: viewBox: "));
    assert!(
        refused("", "<rect width='9' height='9'/>")
            .contains("none of its 1 shapes has a stroke that shows on white; stroke what is a line, or give")
    );
    let text = |text: &str| read(text.as_bytes(), FRAME).unwrap_err().to_string();
    assert_eq!(text("<html/>"), "line 1: <html> is no SVG document");
    assert!(text("<svg>\n<g>\n</svg>").starts_with("line 3, column "));
    assert!(read(b"<svg>\n\xff</svg>", FRAME).unwrap_err().to_string().starts_with("line 2: is no UTF-8"));
}

#[test]
fn documents_cannot_grow_beyond_their_bytes() {
    let bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n<svg>&b;</svg>";
    assert!(read(bomb.as_bytes(), FRAME).unwrap_err().to_string().contains("entities are not read"));
    let doctype = "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/svg11.dtd\">\n<svg/>";
    assert_eq!(read(doctype.as_bytes(), FRAME).unwrap(), (vec![], vec![]));
    let deep = "<g>".repeat(100_000) + &"</g>".repeat(100_000);
    assert!(refused("", &deep).contains("deeper than 128 groups"));
    let rules: String = (0..2000).map(|at| format!(".a{at}{{stroke:red}}")).collect();
    assert!(refused("", &format!("<style>{rules}</style>")).contains("more than 1000 rules"));
    let nodes = "<g/>".repeat(MAX_NODES as usize + 1);
    assert!(refused("", &nodes).contains("nodes limit"), "{}", refused("", &nodes));
}
