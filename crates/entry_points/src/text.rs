//! [`text`].

use crate::{check_line, check_message};
use silhouette_compare::registry::Registry;
use silhouette_compare::scene::Scene;
use silhouette_compare::scene::cells::choices;
use silhouette_core::method::OptionValues;
use silhouette_core::shapes::{by_name, contour_by_name};
use silhouette_visibility::SectionPlane;
use silhouette_visibility::plot::{Colour, Length, Page, Unit};
use std::fmt::Display;
use std::sync::OnceLock;

/// Longest name of a shape that is built, not only read: `NAME:123`, so that shapes stay small.
const SHORT_NAME: usize = 16;

/// Reads a text: the first byte says what the rest is, which is passed over where it is no UTF-8.
///
/// | byte | text |
/// |---|---|
/// | `c` | the words of a command line, one a line |
/// | `t` | a scene in TOML; then its cells are made |
/// | `m` | options of all methods, `name=value`, one a line |
/// | `l` | a length, a page, a colour, a section plane |
/// | `b` | a built-in shape with its arguments |
///
/// An error says something, that of a command line on one line. What is read and can be printed is read again as the same.
pub fn text(bytes: &[u8]) -> bool {
    let Some((kind, rest)) = bytes.split_first() else { return false };
    let Ok(text) = std::str::from_utf8(rest) else { return false };
    match kind {
        b'c' => {
            let checked = silhouettes::check(text.lines().map(Into::into), registry());
            checked.inspect_err(|line| check_line(line)).is_ok()
        }
        b't' => scene(text),
        b'm' => options(text),
        b'l' => values(text),
        b'b' => shape(text),
        _ => false,
    }
}

fn registry() -> &'static Registry {
    static REGISTRY: OnceLock<Registry> = OnceLock::new();
    REGISTRY.get_or_init(Registry::builtin)
}

fn is_accepted<T, E: Display>(result: Result<T, E>) -> bool {
    result.map_err(|error| check_message(&error.to_string())).is_ok()
}

fn scene(text: &str) -> bool {
    match Scene::parse(text, "fuzzed".to_owned()) {
        Ok(scene) => is_accepted(choices(&scene, registry())),
        Err(fault) => is_accepted::<(), _>(Err(fault)),
    }
}

fn options(text: &str) -> bool {
    let mut accepted = false;
    for entry in registry().entries() {
        let specs = entry.info().options;
        match OptionValues::parse(specs, text.lines()) {
            Ok(values) => {
                let again = OptionValues::parse(specs, values.to_string().split_whitespace());
                assert_eq!(again.as_ref(), Ok(&values), "{}", entry.info().name);
                accepted = true;
            }
            Err(error) => check_message(&error.to_string()),
        }
    }
    accepted
}

fn values(text: &str) -> bool {
    let length = Length::parse(text, Unit::Mm);
    if let Ok(length) = length {
        assert!([Unit::Mm, Unit::Px].into_iter().all(|unit| !length.to(unit).is_nan()), "{text}");
    }
    let page = text.parse::<Page>();
    if let Ok(page) = page {
        assert!(page.size(Unit::Mm).into_iter().all(|side| side > 0.0), "{text}");
    }
    let plane = text.parse::<SectionPlane>();
    if let Ok(plane) = plane {
        assert!(plane.point().is_finite() && plane.normal().is_finite(), "{text}");
    }
    let [length, page, plane] = [is_accepted(length), is_accepted(page), is_accepted(plane)];
    let colour = is_accepted(text.parse::<Colour>());
    length || page || plane || colour
}

fn shape(text: &str) -> bool {
    let contour = is_accepted(contour_by_name(text).map(drop));
    if text.len() > SHORT_NAME || text.bytes().filter(u8::is_ascii_digit).count() > 3 {
        return contour;
    }
    is_accepted(by_name(text))
}
