//! Rows of one method on several meshes, and how its time grows.

use super::{ExtractionRow, PowerLaw};

/// Sizes that a growth is stated from: two points lie on every law.
pub const MIN_SIZES: usize = 3;

/// The rows of one method of one tool with one number of threads.
#[derive(Debug, Clone, PartialEq)]
pub struct Series<'a> {
    /// Who was measured: [`ExtractionRow::label`].
    pub label: String,
    /// Its rows by ascending number of faces, those of equal size in the order given.
    pub rows: Vec<&'a ExtractionRow>,
}

/// How time grows with faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Growth {
    /// Milliseconds over faces.
    pub law: PowerLaw,
    /// The shape whose sizes it was fitted to, as `builtin:blob`; `None`: to all meshes, so that differences between
    /// shapes are part of it.
    pub shape: Option<String>,
    /// Fewest and most faces of the meshes that it was fitted to.
    pub faces: [u64; 2],
}

/// Groups rows, in the order of each label's first row. O(rows x labels).
pub fn series(rows: &[ExtractionRow]) -> Vec<Series<'_>> {
    let mut all: Vec<Series<'_>> = Vec::new();
    for row in rows {
        let label = row.label();
        match all.iter_mut().find(|series| series.label == label) {
            Some(series) => series.rows.push(row),
            None => all.push(Series { label, rows: vec![row] }),
        }
    }
    for series in &mut all {
        series.rows.sort_by_key(|row| row.faces);
    }
    all
}

impl Series<'_> {
    /// The law of the shape of which there are most sizes, if they are [`MIN_SIZES`] or more; else that of all meshes;
    /// `None` where those are of fewer sizes too.
    pub fn growth(&self) -> Option<Growth> {
        let mut shapes: Vec<&str> = self.rows.iter().filter_map(|row| shape(&row.mesh)).collect();
        shapes.sort_unstable();
        shapes.dedup();
        let of_shape = |name: &str| -> Vec<&ExtractionRow> {
            self.rows.iter().copied().filter(|row| shape(&row.mesh) == Some(name)).collect()
        };
        let richest = shapes.into_iter().map(|name| (name, of_shape(name))).max_by_key(|(_, rows)| sizes(rows));
        let (shape, rows) = match richest {
            Some((name, rows)) if sizes(&rows) >= MIN_SIZES => (Some(name.to_owned()), rows),
            _ => (None, self.rows.clone()),
        };
        if sizes(&rows) < MIN_SIZES {
            return None;
        }
        let points: Vec<[f64; 2]> = rows.iter().map(|row| [row.faces as f64, row.median_ms]).collect();
        Some(Growth { law: PowerLaw::fit(&points)?, shape, faces: [rows[0].faces, rows[rows.len() - 1].faces] })
    }
}

/// Number of different sizes of ascending rows.
fn sizes(rows: &[&ExtractionRow]) -> usize {
    rows.chunk_by(|a, b| a.faces == b.faces).count()
}

/// `builtin:blob` of `builtin:blob:70000`, `x.obj+loop` of `x.obj+loop2`: meshes of the same shape. `None` for other files,
/// each a shape of its own.
fn shape(mesh: &str) -> Option<&str> {
    const SUBDIVIDED: &str = "+loop";
    let levels = mesh.rfind(SUBDIVIDED).map(|at| mesh.split_at(at + SUBDIVIDED.len()));
    if let Some((shape, levels)) = levels
        && levels.parse::<u32>().is_ok()
    {
        return Some(shape);
    }
    let name = mesh.strip_prefix("builtin:")?;
    let end = name.find(':').unwrap_or(name.len());
    Some(&mesh[..mesh.len() - name.len() + end])
}

#[cfg(test)]
mod tests {
    use super::super::{OURS, row};
    use super::*;

    #[test]
    fn rows_are_grouped_by_label_and_sorted_by_size() {
        let rows = [
            row(OURS, "a", "x", 90, 1.0),
            row("vtk", "a", "x", 90, 2.0),
            row(OURS, "a", "y", 10, 3.0),
            ExtractionRow { threads: 2, ..row(OURS, "a", "x", 90, 4.0) },
        ];
        let found: Vec<_> = series(&rows)
            .into_iter()
            .map(|series| (series.label, series.rows.iter().map(|row| row.median_ms).collect::<Vec<_>>()))
            .collect();
        let expected = [("a", vec![3.0, 1.0]), ("vtk: a", vec![2.0]), ("a, 2 threads", vec![4.0])];
        assert_eq!(found, expected.map(|(label, times)| (label.to_owned(), times)));
    }

    #[test]
    fn growth_is_of_one_shape_where_it_can_be() {
        let blob = |faces: u64| row(OURS, "a", &format!("builtin:blob:{faces}"), faces, (faces as f64).sqrt());
        let mut rows = vec![blob(100), blob(400), row(OURS, "a", "bunny.obj", 1600, 9000.0)];
        let mixed = series(&rows)[0].growth().unwrap();
        assert!(mixed.shape.is_none() && mixed.law.exponent > 1.0, "{mixed:?}");
        rows.push(blob(900));
        let pure = series(&rows)[0].growth().unwrap();
        assert_eq!((pure.shape.as_deref(), pure.faces), (Some("builtin:blob"), [100, 900]));
        assert!((pure.law.exponent - 0.5).abs() < 1e-12 && pure.law.r2 > 0.999);
    }

    #[test]
    fn two_sizes_are_no_growth() {
        let rows = [row(OURS, "a", "x", 10, 1.0), row(OURS, "a", "y", 10, 2.0), row(OURS, "a", "z", 20, 3.0)];
        assert_eq!(series(&rows)[0].growth(), None);
        assert_eq!(shape("builtin:gear"), Some("builtin:gear"));
        assert_eq!(shape("builtin:torus:64,32"), Some("builtin:torus"));
        assert_eq!(shape("gear.obj"), None);
        assert_eq!(shape("gear.obj+loop2"), Some("gear.obj+loop"));
        assert_eq!(shape("builtin:torus:64,32+loop0"), Some("builtin:torus:64,32+loop"));
        assert_eq!(shape("gear+loop2.obj"), None);
    }
}
