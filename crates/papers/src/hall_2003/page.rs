//! The page: template embedded, chart inline, everything that a user named escaped.

use super::circles::{CIRCLE, STEP_DEG};
use super::measure::{MeshResult, Reproduction};
use super::printed::{BUNNY, model_of};
use super::table::{COLUMNS, cells, counted_ranges, describe};
use super::timed::ROUNDS;
use crate::PAGE_STYLE;
use minijinja::{Environment, Value, context};

/// Name of the template; its ending makes the engine escape values for HTML.
const TEMPLATE: &str = "index.html";

/// The page of a reproduction with its chart, which is SVG. It asks nothing of the network: its own policy forbids it.
///
/// # Errors
/// The template engine's, which the template gives no reason for.
pub fn render(reproduction: &Reproduction, chart: &str) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    environment.add_template(TEMPLATE, include_str!("template.html"))?;
    let columns = COLUMNS.iter().map(|column| {
        context! { title => column.title, unit => column.unit, meaning => column.meaning }
    });
    environment.get_template(TEMPLATE)?.render(context! {
        profile => reproduction.profile.name(),
        frames => reproduction.frames,
        step => STEP_DEG,
        distance => CIRCLE.distance_radii.to_string(),
        below => (-CIRCLE.elevation_deg).to_string(),
        rounds => ROUNDS,
        machine => &reproduction.machine,
        program => &reproduction.program,
        is_debug => cfg!(debug_assertions),
        has_bunny => reproduction.meshes.iter().any(|mesh| mesh.faces == BUNNY.faces),
        columns => columns.collect::<Vec<_>>(),
        meshes => reproduction.meshes.iter().map(section).collect::<Vec<_>>(),
        chart => Value::from_safe_string(chart.to_owned()),
        style => Value::from_safe_string(PAGE_STYLE.to_owned()),
    })
}

fn section(mesh: &MeshResult) -> Value {
    let rows = mesh.variants.iter().map(|result| {
        let in_paper = result.variant.paper_column().is_some();
        context! { label => result.variant.label(), cells => cells(mesh, result), in_paper => in_paper }
    });
    context! {
        name => &mesh.name,
        about => describe(mesh),
        model => model_of(mesh.faces).map(|model| model.name),
        counted_ranges => counted_ranges(mesh),
        rows => rows.collect::<Vec<_>>(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::chart::trade;
    use super::super::measure::tests::reproduction;
    use super::super::variants::Variant;
    use super::*;

    fn page(reproduction: &Reproduction) -> String {
        render(reproduction, &trade(reproduction)).unwrap()
    }

    #[test]
    fn the_page_shows_every_variant_of_every_mesh_and_the_chart() {
        let page = page(reproduction());
        for variant in Variant::all() {
            assert!(page.matches(&format!("<td>{}</td>", variant.label())).count() == 2, "{}", variant.label());
        }
        assert!(page.contains("<svg") && page.contains("</svg>"));
        assert!(page.contains("69451"));
    }

    #[test]
    fn names_are_escaped_and_nothing_is_fetched() {
        let page = page(&Reproduction { machine: "a <processor>".to_owned(), ..reproduction().clone() });
        assert!(page.contains("a &lt;processor&gt;"));
        assert!(!page.contains("<b>blob") && page.contains("&lt;b&gt;blob"));
        assert!(page.contains("default-src 'none'"));
        for needle in ["src=", "url(", "@import", "<script"] {
            assert!(!page.contains(needle), "{needle}");
        }
    }

    #[test]
    fn the_bunny_is_marked_as_the_papers_model() {
        let mut flown = reproduction().clone();
        flown.meshes[0].faces = BUNNY.faces;
        assert!(page(&flown).contains("the paper's Bunny") && !page(&flown).contains("is not among these meshes"));
        assert!(page(reproduction()).contains("is not among these meshes"));
    }
}
