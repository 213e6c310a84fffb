//! Where pictures of lines err, for people: a row of numbers and a sentence per cell.

use super::summary::CellSummary;
use super::tables::who;
use crate::metrics::LineErrors;
use minijinja::{Value, context};

/// Shares below this are not worth a word.
const WORTH_SAYING: f64 = 5e-4;

/// The row of a cell; nothing for one whose pictures are not of lines.
pub(super) fn row(summary: &CellSummary<'_>) -> Option<Value> {
    let errors = summary.cell.mean_errors()?;
    let e = &errors;
    let of_true = |part: f64| percent(part, e.true_px());
    Some(context! {
        who => who(summary),
        missed => of_true(e.missed_px()),
        missed_parts => [
            percent(e.missed_silhouette_px, e.true_silhouette_px),
            percent(e.missed_crease_px, e.true_crease_px),
            percent(e.missed_boundary_px, e.true_boundary_px),
            percent(e.missed_inner_px.unwrap_or(0.0), e.true_inner_px.unwrap_or(0.0)),
            percent(e.missed_inward_winding_px, e.true_inward_winding_px),
            percent(e.missed_small_faces_px, e.true_small_faces_px),
            percent(e.missed_unexplained_px, e.true_unexplained_px),
        ],
        spurious => of_true(e.spurious_px()),
        spurious_parts => [
            e.spurious_silhouette_px, e.spurious_crease_px, e.spurious_boundary_px, e.spurious_nothing_px,
            e.spurious_open_boundary_px, e.spurious_inward_winding_px, e.spurious_small_faces_px,
            e.spurious_unexplained_px,
        ].map(of_true),
        sentence => sentence(e),
    })
}

fn percent(part: f64, whole: f64) -> String {
    if whole > 0.0 { format!("{:.1}", 100.0 * part / whole) } else { "–".to_owned() }
}

/// What a method misses and draws besides, with the causes that are known, as shares of the true length.
pub fn sentence(errors: &LineErrors) -> String {
    let e = errors;
    let whole = e.true_px();
    if whole <= 0.0 {
        return "There is no true line.".to_owned();
    }
    let missed = parts(
        whole,
        e.missed_px(),
        &inside(e),
        &[
            (e.missed_open_boundary_px, "along boundary edges"),
            (e.missed_inward_winding_px, "where faces are wound inwards"),
            (e.missed_small_faces_px, "where faces are below a pixel"),
            (e.missed_unexplained_px, "without a known cause"),
        ],
    );
    let spurious = parts(
        whole,
        e.spurious_px(),
        "",
        &[
            (e.spurious_open_boundary_px, "at open boundaries"),
            (e.spurious_inward_winding_px, "where faces are wound inwards"),
            (e.spurious_small_faces_px, "where faces are below a pixel"),
            (e.spurious_unexplained_px, "without a known cause"),
        ],
    );
    let missed = missed.map_or_else(|| "Misses nothing.".to_owned(), |text| format!("Misses {text}."));
    let spurious = spurious.map_or_else(String::new, |text| format!(" Spurious ink amounts to {text}."));
    missed + &spurious
}

/// How much of what is missed lies inside of the outline, where that is known and worth a word.
fn inside(errors: &LineErrors) -> String {
    let missed = errors.missed_px();
    match errors.missed_inner_px {
        Some(inner) if inner >= 0.995 * missed => ", all inside of the outline".to_owned(),
        Some(inner) if inner >= WORTH_SAYING * errors.true_px() => {
            format!(", {} inside of the outline", shown(inner / errors.true_px()))
        }
        _ => String::new(),
    }
}

/// `54.0 % of the true length, all inside of the outline, all of it along boundary edges`, or with each share where there are several causes; nothing where it is too little to be worth a word.
fn parts(whole: f64, length: f64, inside: &str, causes: &[(f64, &str)]) -> Option<String> {
    let is_worth_saying = |length: f64| length / whole >= WORTH_SAYING;
    if let Some((_, cause)) = causes.iter().find(|(part, _)| is_worth_saying(length) && *part >= 0.995 * length) {
        return Some(format!("{} of the true length{inside}, all of it {cause}", shown(length / whole)));
    }
    let named = causes.iter().filter(|(length, _)| is_worth_saying(*length));
    let named: Vec<String> = named.map(|(length, cause)| format!("{} {cause}", shown(length / whole))).collect();
    let causes = if named.is_empty() { String::new() } else { format!(" ({})", named.join(", ")) };
    is_worth_saying(length).then(|| format!("{} of the true length{inside}{causes}", shown(length / whole)))
}

fn shown(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::*;
    use crate::record::tests::{cell, fill_cell};

    fn errors() -> LineErrors {
        LineErrors {
            true_silhouette_px: 500.0,
            true_boundary_px: 500.0,
            missed_boundary_px: 500.0,
            missed_open_boundary_px: 500.0,
            true_open_boundary_px: 500.0,
            true_unexplained_px: 500.0,
            ..LineErrors::default()
        }
    }

    #[test]
    fn a_limit_is_named_as_such() {
        assert_eq!(sentence(&errors()), "Misses 50.0 % of the true length, all of it along boundary edges.");
        let more = LineErrors {
            missed_silhouette_px: 10.0,
            missed_small_faces_px: 10.0,
            missed_inner_px: Some(400.0),
            spurious_nothing_px: 20.0,
            spurious_unexplained_px: 20.0,
            ..errors()
        };
        assert_eq!(
            sentence(&more),
            "Misses 51.0 % of the true length, 40.0 % inside of the outline (50.0 % along boundary edges, 1.0 % where faces \
             are below a pixel). Spurious ink amounts to 2.0 % of the true length, all of it without a known cause."
        );
        let inner = LineErrors { missed_inner_px: Some(500.0), ..errors() };
        assert!(
            sentence(&inner)
                .starts_with("Misses 50.0 % of the true length, all inside of the outline, all of it along")
        );
        let nothing = LineErrors { true_crease_px: 9.0, ..LineErrors::default() };
        assert_eq!(
            (sentence(&nothing), sentence(&LineErrors::default())),
            ("Misses nothing.".to_owned(), "There is no true line.".to_owned(),)
        );
    }

    #[test]
    fn lines_have_a_row_and_fills_have_none() {
        let mut lines = cell("a", "m", 1.0, 1.0);
        lines.views[0].errors = Some(errors());
        let cells = [lines, fill_cell("a", "n", 1.0, 0.0)];
        let meshes = summarise(&cells);
        let row = row(&meshes[0].cells[0]).unwrap();
        assert_eq!(row.get_attr("missed").unwrap().to_string(), "50.0");
        let parts = row.get_attr("missed_parts").unwrap();
        let shown: Vec<String> = parts.try_iter().unwrap().map(|part| part.to_string()).collect();
        assert_eq!(shown, ["0.0", "–", "100.0", "–", "–", "–", "0.0"]);
        assert!(super::row(&meshes[0].cells[1]).is_none());
    }
}
