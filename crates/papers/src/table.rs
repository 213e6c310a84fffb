//! Tables of a paper: what is printed and what was measured. Figures, text, page and charts are derived from them.

/// One table: the rows that share columns, of one mesh or of none.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// Which table or section of the paper, as printed there; for what the paper lacks, what the table shows.
    pub name: &'static str,
    /// The mesh that all rows are about; empty where the rows name their own.
    pub subject: String,
    /// What has to be known of the mesh, in one sentence without a full stop.
    pub about: String,
    /// The columns behind the row's label.
    pub columns: Vec<Column>,
    /// Head of the column of [remarks](Row::remark); empty where there are none.
    pub remark_title: &'static str,
    /// The rows.
    pub rows: Vec<Row>,
}

/// One column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// Its head.
    pub title: &'static str,
    /// What is measured: its name in results, unique in a table.
    pub metric: &'static str,
    /// Unit of every value; × for ratios.
    pub unit: &'static str,
    /// Digits after the decimal point, where people read it.
    pub digits: usize,
    /// What it means.
    pub meaning: &'static str,
}

/// One row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    /// What was measured: a variant, usually.
    pub label: String,
    /// One cell per column.
    pub cells: Vec<Cell>,
    /// What explains the whole row.
    pub remark: &'static str,
    /// How charts of points mark it; `None` leaves it out.
    pub mark: Option<Mark>,
}

/// A row's mark in a chart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mark {
    /// Which series it belongs to, as an index into those of the chart.
    pub series: usize,
    /// What stands beside it; often empty.
    pub label: String,
}

/// One value measured here, beside one that the paper prints.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cell {
    /// Ours; `None` where it was not measured.
    pub ours: Option<Ours>,
    /// The paper's; `None` where it prints none.
    pub paper: Option<Printed>,
    /// What a reader has to know of this value alone.
    pub note: String,
}

/// A measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ours {
    /// A single one.
    One(f64),
    /// Several, of which the median is set beside the paper's.
    Range(Range),
}

/// The range of values over views or paths, none of which is preferred.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub least: f64,
    /// Middle value; of an even number of values the mean of the two middle ones.
    pub median: f64,
    /// Largest value.
    pub most: f64,
    /// What the values are over: `twenty circles`.
    pub over: &'static str,
}

/// A printed value.
#[derive(Debug, Clone, PartialEq)]
pub struct Printed {
    /// The value.
    pub value: f64,
    /// Whether ours may be compared with it.
    pub comparable: Comparable,
}

/// Whether a value of ours may be compared with the paper's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Comparable {
    /// The same quantity of the same model, and hardware has no part in it.
    Yes,
    /// They differ in more than the method, for this reason.
    No(String),
}

impl Range {
    /// The range of finite values; `None` of no such value. O(n log n).
    pub fn of(values: impl IntoIterator<Item = f64>, over: &'static str) -> Option<Self> {
        let mut values: Vec<f64> = values.into_iter().filter(|value| value.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let (&least, &most) = (values.first()?, values.last()?);
        let median = 0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2]);
        Some(Self { least, median, most, over })
    }
}

impl Ours {
    /// The value, or the median of several.
    pub fn middle(self) -> f64 {
        match self {
            Self::One(value) => value,
            Self::Range(range) => range.median,
        }
    }
}

impl Cell {
    /// One value; not measured where it is not finite.
    pub fn one(value: f64) -> Self {
        Self { ours: value.is_finite().then_some(Ours::One(value)), ..Self::default() }
    }

    /// A range; not measured where there is none.
    pub fn range(range: Option<Range>) -> Self {
        Self { ours: range.map(Ours::Range), ..Self::default() }
    }

    /// Sets the paper's value beside ours, where there is one.
    #[must_use]
    pub fn beside(self, paper: Option<f64>, comparable: Comparable) -> Self {
        Self { paper: paper.map(|value| Printed { value, comparable }), ..self }
    }

    /// Adds a note.
    #[must_use]
    pub fn noted(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }
}

impl Row {
    /// A row without a remark or mark.
    pub fn new(label: impl Into<String>, cells: Vec<Cell>) -> Self {
        Self { label: label.into(), cells, ..Self::default() }
    }

    /// Whether the paper prints a value of it.
    pub fn is_printed(&self) -> bool {
        self.cells.iter().any(|cell| cell.paper.is_some())
    }
}

impl Table {
    /// What stands above it: `MESH: TABLE`, or `TABLE` alone.
    pub fn heading(&self) -> String {
        if self.subject.is_empty() { self.name.to_owned() } else { format!("{}: {}", self.subject, self.name) }
    }

    /// What a row is called outside of its table: `MESH, ROW`, or `ROW` alone.
    pub fn row_name(&self, row: &Row) -> String {
        if self.subject.is_empty() { row.label.clone() } else { format!("{}, {}", self.subject, row.label) }
    }

    /// Our middle value of a metric in each row, with the row; rows that lack it are omitted. O(rows + columns).
    pub fn values(&self, metric: &str) -> impl Iterator<Item = (&Row, f64)> {
        let column = self.columns.iter().position(|column| column.metric == metric);
        let value = move |row: &Row| Some(row.cells.get(column?)?.ours?.middle());
        self.rows.iter().filter_map(move |row| Some((row, value(row)?)))
    }

    /// Why values that the paper prints are not comparable, each reason once: `HEAD: REASON`.
    pub fn incomparable(&self) -> Vec<String> {
        let mut reasons = Vec::new();
        for row in &self.rows {
            for (column, cell) in self.columns.iter().zip(&row.cells) {
                let Some(Printed { comparable: Comparable::No(reason), .. }) = &cell.paper else { continue };
                let reason = format!("{}: {reason}", column.title);
                if !reasons.contains(&reason) {
                    reasons.push(reason);
                }
            }
        }
        reasons
    }
}

impl Column {
    /// A column of two digits after the decimal point.
    pub const fn new(title: &'static str, metric: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self { title, metric, unit, digits: 2, meaning }
    }

    /// A range as people read it; `None` where both ends read alike.
    pub fn range_text(&self, range: Range) -> Option<String> {
        let [least, most] = [range.least, range.most].map(|value| self.text(value));
        (least != most).then(|| format!("{least} to {most}"))
    }

    /// A value as people read it: nothing is `0`, what would round to nothing is `< 0.01`, and thousands have no digits after
    /// the point.
    pub fn text(&self, value: f64) -> String {
        let digits = if value.abs() < 1000.0 { self.digits } else { 0 };
        let text = format!("{value:.digits$}");
        let rounds_to_nothing = text.trim_matches(['0', '.', '-']).is_empty();
        match value {
            0.0 => "0".to_owned(),
            _ if rounds_to_nothing && value > 0.0 => format!("< {:.digits$}", 0.1_f64.powi(digits as i32)),
            _ => text,
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Two rows and two columns: a range and a value beside the paper's, of which one is not comparable; a row of ours.
    pub fn table() -> Table {
        let column = |title, metric, digits| Column { digits, ..Column::new(title, metric, "px", "a <meaning>") };
        let range = Range::of([3.0, 1.0, 2.0], "three views");
        let why = Comparable::No("another <machine>".to_owned());
        let printed = vec![
            Cell::range(range).beside(Some(2.5), Comparable::Yes).noted("a note"),
            Cell::one(10.0).beside(Some(20.0), why),
        ];
        let ours = vec![Cell::one(0.001), Cell::one(f64::NAN)];
        Table {
            name: "Table 1",
            subject: "<b>mesh</b>".to_owned(),
            about: "12 faces".to_owned(),
            columns: vec![column("wide", "width", 2), column("time", "frame time", 0)],
            remark_title: "why",
            rows: vec![
                Row { remark: "as printed", ..Row::new("printed row", printed) },
                Row { mark: Some(Mark { series: 0, label: "m".to_owned() }), ..Row::new("our row", ours) },
            ],
        }
    }

    #[test]
    fn a_range_knows_its_middle_and_its_ends() {
        let range = Range::of([4.0, f64::INFINITY, 1.0, 2.0, 3.0], "").unwrap();
        assert_eq!((range.least, range.median, range.most), (1.0, 2.5, 4.0));
        assert_eq!(Range::of([f64::NAN], ""), None);
        let column = table().columns[0];
        assert_eq!(column.range_text(range).as_deref(), Some("1.00 to 4.00"));
        assert_eq!(column.range_text(Range { most: 1.001, ..range }), None);
    }

    #[test]
    fn values_are_those_that_were_measured() {
        let table = table();
        let of = |metric| table.values(metric).map(|(row, value)| (row.label.as_str(), value)).collect::<Vec<_>>();
        assert_eq!(of("width"), [("printed row", 2.0), ("our row", 0.001)]);
        assert_eq!(of("frame time"), [("printed row", 10.0)]);
        assert!(of("no such metric").is_empty());
        assert_eq!(table.incomparable(), ["time: another <machine>"]);
    }

    #[test]
    fn small_values_are_not_rounded_to_nothing() {
        let [two, none] = [table().columns[0], table().columns[1]];
        assert_eq!(
            [0.0, 0.001, 0.006, 12.345, 1234.5].map(|value| two.text(value)),
            ["0", "< 0.01", "0.01", "12.35", "1234"]
        );
        assert_eq!([0.0, 0.2, 7.6].map(|value| none.text(value)), ["0", "< 1", "8"]);
    }
}
