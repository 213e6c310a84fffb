//! The page: one template for all papers, charts inline, everything that a user named escaped.

use crate::paper::Reproduction;
use crate::picture::Picture;
use crate::table::{Cell, Column, Comparable, Ours, Printed, Row, Table};
use minijinja::{Environment, Value, context};

/// Name of the template; its ending makes the engine escape values for HTML.
const TEMPLATE: &str = "index.html";

/// The page of a reproduction. It asks nothing of the network: its own policy forbids it.
///
/// # Errors
/// Those of the template engine, which the template gives no reason for.
pub fn render(reproduction: &Reproduction) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    environment.add_template(TEMPLATE, include_str!("template.html"))?;
    let Reproduction { paper, profile, machine, adapter, program, measured } = reproduction;
    let charts = measured.charts.iter().map(|chart| {
        let svg = Value::from_safe_string(chart.svg.clone());
        context! { title => chart.title, file_name => chart.file_name, svg => svg }
    });
    let pictures = measured.pictures.iter().map(|Picture { file_name, title, image }| {
        context! { file_name => *file_name, title => title, width => image.width, height => image.height }
    });
    environment.get_template(TEMPLATE)?.render(context! {
        title => paper.source.title,
        citation => paper.citation(),
        about => paper.about,
        reading => paper.reading.to_vec(),
        profile => profile.name(),
        setting => &measured.setting,
        machine => machine,
        adapter => adapter,
        program => program,
        is_debug => cfg!(debug_assertions),
        notes => &measured.notes,
        pictures => pictures.collect::<Vec<_>>(),
        charts => charts.collect::<Vec<_>>(),
        tables => measured.tables.iter().map(table_section).collect::<Vec<_>>(),
        columns => meanings(&measured.tables),
        style => Value::from_safe_string(include_str!("page.css").to_owned()),
    })
}

fn table_section(table: &Table) -> Value {
    let columns = table.columns.iter().map(|column| context! { title => column.title, unit => column.unit });
    let is_printed = table.rows.iter().any(Row::is_printed);
    let rows = table.rows.iter().map(|row| {
        let cells = table.columns.iter().zip(&row.cells).map(|(column, cell)| cell_value(column, cell));
        context! {
            label => &row.label,
            cells => cells.collect::<Vec<_>>(),
            remark => row.remark,
            is_tinted => is_printed && !row.is_printed(),
        }
    });
    context! {
        heading => table.heading(),
        about => &table.about,
        columns => columns.collect::<Vec<_>>(),
        remark_title => table.remark_title,
        rows => rows.collect::<Vec<_>>(),
        has_tint => is_printed && !table.rows.iter().all(Row::is_printed),
        incomparable => table.incomparable(),
    }
}

fn cell_value(column: &Column, cell: &Cell) -> Value {
    let range = match cell.ours {
        Some(Ours::Range(range)) => column.range_text(range),
        _ => None,
    };
    let paper = cell.paper.as_ref().map(|Printed { value, comparable }| {
        let star = if *comparable == Comparable::Yes { "" } else { " *" };
        format!("paper {}{star}", column.text(*value))
    });
    let ours = cell.ours.map_or_else(|| "–".to_owned(), |ours| column.text(ours.middle()));
    context! { ours => ours, range => range, paper => paper, note => &cell.note }
}

/// What the columns of all tables mean, each metric once.
fn meanings(tables: &[Table]) -> Vec<Value> {
    let mut columns: Vec<&Column> = Vec::new();
    for column in tables.iter().flat_map(|table| &table.columns) {
        if !columns.iter().any(|known| known.metric == column.metric) {
            columns.push(column);
        }
    }
    let value = |column: &Column| {
        context! { title => column.title, unit => column.unit, metric => column.metric, meaning => column.meaning }
    };
    columns.into_iter().map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::tests::reproduction;

    #[test]
    fn what_others_named_is_escaped_and_nothing_is_fetched() {
        let page = render(&reproduction()).unwrap();
        for escaped in ["a &lt;processor&gt;", "&lt;b&gt;mesh", "another &lt;machine&gt;", "A. &lt;Author&gt;"] {
            assert!(page.contains(escaped), "{escaped}");
        }
        assert!(!page.contains("<b>mesh") && page.contains("default-src 'none'"));
        for needle in ["url(", "@import", "<script", "://"] {
            assert!(!page.contains(needle), "{needle}");
        }
        assert_eq!(page.matches("src=").count(), 1, "the picture beside the page");
        assert!(page.contains("src=\"picture.png\"") && page.contains("a &lt;picture&gt;"));
    }

    #[test]
    fn cells_show_ours_the_range_and_the_paper() {
        let page = render(&reproduction()).unwrap();
        for text in ["2.00", "1.00 to 3.00", "paper 2.50<", "paper 20 *", "&lt; 0.01", "as printed", "* time: another"]
        {
            assert!(page.contains(text), "{text}");
        }
        assert_eq!(page.matches("<tr class=\"ours\">").count(), 1, "the row that the paper lacks");
        assert_eq!(page.matches("<dt>").count(), 2, "a meaning per metric");
        assert!(page.contains("the model is not among these meshes") && page.contains("<svg></svg>"));
    }
}
