//! The page: template embedded, chart inline, everything that a user named escaped.

use super::measure::{MeshResult, Reproduction};
use super::table::{COLUMNS, cells, describe, printed_rows};
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
    let printed = printed_rows(reproduction).into_iter().map(|(label, paper, ours)| {
        let ours = ours.map_or_else(|| "–".to_owned(), |ours| format!("{ours:.3}"));
        context! { label => label, paper => format!("{paper:.3}"), ours => ours }
    });
    environment.get_template(TEMPLATE)?.render(context! {
        profile => reproduction.profile.name(),
        machine => &reproduction.machine,
        adapter => &reproduction.adapter,
        program => &reproduction.program,
        is_debug => cfg!(debug_assertions),
        printed => printed.collect::<Vec<_>>(),
        columns => columns.collect::<Vec<_>>(),
        meshes => reproduction.meshes.iter().map(section).collect::<Vec<_>>(),
        chart => Value::from_safe_string(chart.to_owned()),
        style => Value::from_safe_string(PAGE_STYLE.to_owned()),
    })
}

fn section(mesh: &MeshResult) -> Value {
    let rows = mesh.variants.iter().chain(&mesh.shuffled).map(|result| {
        let variant = result.variant;
        context! { label => variant.label, cells => cells(mesh, result), expected => variant.expected }
    });
    context! { name => &mesh.name, about => describe(mesh), rows => rows.collect::<Vec<_>>() }
}

#[cfg(test)]
mod tests {
    use super::super::chart::variants;
    use super::super::measure::{MeshResult, tests::of_one_mesh};
    use super::super::variants::VARIANTS;
    use super::*;

    #[test]
    fn the_page_shows_every_variant_of_every_mesh_and_fetches_nothing() {
        let test = "the_page_shows_every_variant_of_every_mesh_and_fetches_nothing";
        let Some(reproduction) = of_one_mesh(test) else { return };
        let mesh = reproduction.meshes[0].clone();
        let meshes = vec![mesh.clone(), MeshResult { name: "another".to_owned(), ..mesh }];
        let reproduction = &Reproduction { machine: "a <processor>".to_owned(), meshes, ..reproduction };
        let page = render(reproduction, &variants(reproduction)).unwrap();
        for variant in VARIANTS {
            let row = format!("<td>{}</td>", variant.label);
            assert_eq!(page.matches(&row).count(), reproduction.meshes.len(), "{}", variant.label);
        }
        assert!(page.contains("a &lt;processor&gt;") && page.contains("<svg") && page.contains("default-src 'none'"));
        for needle in ["src=", "url(", "@import", "<script"] {
            assert!(!page.contains(needle), "{needle}");
        }
    }
}
