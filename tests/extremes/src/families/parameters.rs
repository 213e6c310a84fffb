//! Options at their least and greatest values, and beyond.

use crate::cell::Aspect::{Curves, Fill, Lines};
use crate::cell::Outcome::{Differs, Empty, Refused};
use crate::meshes::torus;
use crate::row::{Row, Who};
use crate::scene::Scene;

fn with(options: &'static [&'static str]) -> Scene {
    Scene::of(torus()).with_options(options.iter().copied())
}

fn row(name: &'static str, input: &'static str, options: &'static [&'static str]) -> Row {
    Row::new(name, input, move || with(options)).about_options()
}

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        row("azimuths 1", "an angular resolution of 1", &["azimuths=1"]).expect(Who::All, Refused, ""),
        row("size 1", "a spatial resolution of 1 x 1", &["size=1"]).expect(Who::All, Refused, ""),
        row(
            "least texture",
            "the least resolutions that there are: 3 azimuths, 8 x 8 texels, a hull of 4 vertices",
            &["azimuths=3", "size=8", "hull-vertices=4"],
        )
        .expect_of(
            Fill,
            &["texture"],
            Differs,
            "a tetrahedron with three angles for each of 64 texels shows little of a torus",
        )
        .expect_of(Lines, &["texture-lines"], Differs, "as `texture`")
        .expect_of(Fill, &["normal-map-hull"], Refused, ""),
        row("tolerance 0", "curves that polylines may not stray from", &["tolerance=0"]).expect(Who::All, Refused, ""),
        row("concavity 3.2", "no concave edge is searched for new loops", &["concavity=3.2"]),
        row("scale 1", "back faces that are not moved", &["variant=scale", "scale=1"]).expect_of(
            Lines,
            &["image-precision"],
            Empty,
            "back faces that stay where they are lie behind the front faces",
        ),
        row("scale 0", "back faces moved into the eye", &["variant=scale", "scale=0"]).expect(Who::All, Refused, ""),
        row("pull 0", "back faces that are pulled by nothing", &["variant=fixed-pull", "pull=0"]).expect_of(
            Lines,
            &["image-precision"],
            Empty,
            "back faces that stay where they are lie behind the front faces",
        ),
        row("width NaN", "a width that is no number", &["width=nan"]).expect(Who::All, Refused, ""),
        row("width -1", "a width below 0", &["width=-1"]).expect(Who::All, Refused, ""),
        row("width 1001", "a width beyond the greatest", &["width=1001"]).expect(Who::All, Refused, ""),
        row("level 0", "triangles that are not divided", &["level=0", "halvings=0"]),
        row("crease 0", "every edge is a feature edge", &["crease=0"]).expect_of(
            Curves,
            &["interpolated-contours"],
            Empty,
            "no normal is interpolated across features",
        ),
        row("max-error 0", "no error is allowed to simplified levels", &["max-error=0"]),
    ]
}
