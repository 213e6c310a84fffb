//! A map of errors by view direction: the sphere of directions as two hemispheres in an equal-area projection.

use super::text::{in_unit, shown_unit};
use crate::metrics::table::MetricSpec;
use crate::plot::rounded;
use crate::record::{CameraRecord, Cell};
use glam::DVec3;
use svg::node::element::{Circle, Group, Line, Rectangle, Text, Title};
use svg::{Document, Node};

/// Radius of a hemisphere in units of the picture.
const RADIUS: f64 = 64.0;
/// Middles of the two hemispheres.
const MIDDLES: [[f64; 2]; 2] = [[80.0, 84.0], [224.0, 84.0]];
const SIZE: [f64; 2] = [304.0, 206.0];
/// Colours from no error to the largest.
const RAMP: [[u8; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// From the middle of the mesh towards the eye, in the mesh's space, of unit length: paths look at the middle.
pub(super) fn direction(camera: &CameraRecord) -> DVec3 {
    let vector = |[x, y, z]: [f32; 3]| DVec3::new(f64::from(x), f64::from(y), f64::from(z));
    (vector(camera.eye) - vector(camera.target)).normalize_or_zero()
}

/// The largest angle between two of a cell's scored views, in degrees. O(views squared).
pub(super) fn reach_deg(cell: &Cell) -> f64 {
    let directions: Vec<DVec3> = cell.views.iter().map(|view| direction(&view.camera)).collect();
    let pairs =
        directions.iter().enumerate().flat_map(|(at, one)| directions[at..].iter().map(move |other| (one, other)));
    pairs.map(|(one, other)| one.dot(*other).clamp(-1.0, 1.0).acos()).fold(0.0, f64::max).to_degrees()
}

/// The map of a cell's scored views, coloured by a metric from 0 to its largest value; nothing where it has no value.
pub(super) fn map(cell: &Cell, metric: &MetricSpec) -> Option<String> {
    let value = |view: &crate::record::View| (metric.value)(&view.metrics).filter(|value| value.is_finite());
    let views: Vec<_> = cell.views.iter().filter_map(|view| Some((view, value(view)?))).collect();
    let largest = views.iter().map(|(_, value)| *value).reduce(f64::max)?;
    let unit = shown_unit(metric.unit);
    let label = format!(
        "{} by view direction: {} views, up to {} {unit}",
        metric.title,
        views.len(),
        in_unit(metric.unit, largest)
    );
    let mut map = Document::new()
        .set("viewBox", (0, 0, SIZE[0], SIZE[1]))
        .set("class", "map")
        .set("role", "img")
        .set("aria-label", label);
    for (middle, axes) in MIDDLES.into_iter().zip([["+z", "+x"], ["−z", "−x"]]) {
        map.append(hemisphere(middle, axes));
    }
    for (view, value) in &views {
        let share = if largest > 0.0 { value / largest } else { 0.0 };
        let [x, y] = project(direction(&view.camera)).map(rounded);
        let title = format!("frame {}: {} {unit}", view.frame, in_unit(metric.unit, *value));
        let dot = Circle::new().set("cx", x).set("cy", y).set("r", 5).set("fill", color(share)).set("class", "view");
        map.append(dot.add(Title::new(title)));
    }
    map.append(scale(&[format!("0 {unit}"), format!("{} {unit}", in_unit(metric.unit, largest))]));
    Some(map.to_string())
}

/// Where a direction is on the map: Lambert's azimuthal projection of the hemisphere around +z or −z, which keeps areas, seen
/// from outside with y upwards.
fn project(direction: DVec3) -> [f64; 2] {
    let is_behind = direction.z < 0.0;
    let [middle_x, middle_y] = MIDDLES[usize::from(is_behind)];
    let across = direction.truncate().normalize_or_zero() * (1.0 - direction.z.abs()).max(0.0).sqrt() * RADIUS;
    let right = if is_behind { -across.x } else { across.x };
    [middle_x + right, middle_y - across.y]
}

fn color(share: f64) -> String {
    let place = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let step = (place as usize).min(RAMP.len() - 2);
    let [r, g, b]: [u8; 3] = std::array::from_fn(|channel| {
        let [from, to] = [RAMP[step], RAMP[step + 1]].map(|color| f64::from(color[channel]));
        (from + (to - from) * (place - step as f64)).round() as u8
    });
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// An empty hemisphere with the axes that point towards the reader and to the right.
fn hemisphere([x, y]: [f64; 2], [towards, right]: [&str; 2]) -> Group {
    let line = |dx: f64, dy: f64| Line::new().set("x1", x - dx).set("y1", y - dy).set("x2", x + dx).set("y2", y + dy);
    let text =
        |words: &str, x: f64, y: f64, anchor: &str| Text::new(words).set("x", x).set("y", y).set("text-anchor", anchor);
    Group::new()
        .add(Circle::new().set("cx", x).set("cy", y).set("r", RADIUS).set("class", "ground"))
        .add(line(RADIUS, 0.0))
        .add(line(0.0, RADIUS))
        .add(text("+y", x, y - RADIUS - 5.0, "middle"))
        .add(text(right, x + RADIUS - 4.0, y - 4.0, "end"))
        .add(text(&format!("seen from {towards}"), x, y + RADIUS + 15.0, "middle"))
}

/// What the colours mean.
fn scale([low, high]: &[String; 2]) -> Group {
    let (left, width, steps) = (88.0, 128.0, 16);
    let top = SIZE[1] - 18.0;
    let text = |words: &str, x: f64, anchor: &str| {
        Text::new(words).set("x", x).set("y", top + 10.0).set("text-anchor", anchor)
    };
    let mut group = Group::new().add(text(low, left - 6.0, "end")).add(text(high, left + width + 6.0, "start"));
    for step in 0..steps {
        let share = f64::from(step) / f64::from(steps - 1);
        let x = left + width * f64::from(step) / f64::from(steps);
        let width = width / f64::from(steps);
        let part = Rectangle::new().set("x", x).set("y", top).set("width", width).set("height", 12);
        group.append(part.set("fill", color(share)));
    }
    group
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::PictureKind;
    use crate::record::tests::{cell, view};

    fn looking_from(eye: [f32; 3]) -> CameraRecord {
        CameraRecord { eye, ..view(0, 0.0).camera }
    }

    #[test]
    fn the_projection_keeps_areas() {
        // Of a hemisphere, the cap around its middle with half its area ends where z is 1/2.
        let radius = |z: f64| {
            let [x, y] = project(DVec3::new((1.0 - z * z).sqrt(), 0.0, z));
            (x - MIDDLES[0][0]).hypot(y - MIDDLES[0][1]) / RADIUS
        };
        for z in [0.0, 0.25, 0.5, 0.9, 1.0] {
            let (on_map, on_sphere) = (radius(z).powi(2), 1.0 - z);
            assert!((on_map - on_sphere).abs() < 1e-12, "{z}: {on_map} {on_sphere}");
        }
    }

    #[test]
    fn what_is_seen_from_the_right_is_on_the_right_of_both_halves() {
        let place = |x: f64, y: f64, z: f64| project(DVec3::new(x, y, z).normalize());
        let [front, back] = [place(0.1, 0.2, 1.0), place(0.1, 0.2, -1.0)];
        assert!(front[0] > MIDDLES[0][0] && front[1] < MIDDLES[0][1], "right and up: {front:?}");
        assert!(back[0] < MIDDLES[1][0] && back[1] < MIDDLES[1][1], "from behind, +x is on the left: {back:?}");
    }

    #[test]
    fn dots_are_coloured_by_their_error_and_the_scale_is_stated() {
        let mut cell = cell("a", "m", 1.0, 0.0);
        cell.views.push(view(15, 2.0));
        cell.views[1].camera = looking_from([0.0, 0.0, -3.0]);
        let map = map(&cell, PictureKind::Lines.leading_metric()).unwrap();
        assert_eq!(map.matches("class=\"view\"").count(), 2);
        for words in ["frame 5: 0.00 px", "frame 15: 2.00 px", "2.00 px</text>".replace("</text>", "").as_str()] {
            assert!(map.contains(words), "{words}: {map}");
        }
        assert!(map.contains(&color(0.0)) && map.contains(&color(1.0)));
        assert_eq!((color(0.0), color(1.0)), ("#440154".to_owned(), "#fde725".to_owned()));
        assert!((reach_deg(&cell) - 180.0).abs() < 1e-6);
        cell.views.clear();
        assert!(super::map(&cell, PictureKind::Lines.leading_metric()).is_none());
    }

    #[test]
    fn a_camera_at_its_target_has_no_direction() {
        assert_eq!(direction(&looking_from([0.0; 3])), DVec3::ZERO);
    }
}
