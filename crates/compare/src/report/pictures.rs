//! Files of pictures: each picture once, however many cells drew it.

use super::summary::CellSummary;
use crate::runner::PictureSet;
use silhouette_render::Image;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// The files of all pictures of a report.
#[derive(Debug)]
pub(super) struct PictureFiles<'a> {
    sets: &'a [PictureSet],
    /// What is written, in the order of first use. Paths hold no text of a user's.
    pub files: Vec<(String, &'a Image)>,
    /// For each set, which files hold what was drawn, the truth and the difference.
    places: Vec<[usize; 3]>,
}

impl<'a> PictureFiles<'a> {
    /// Finds pictures that are the same, byte for byte. O(bytes).
    pub fn of(sets: &'a [PictureSet]) -> Self {
        let mut known: HashMap<(u32, &[u8]), usize> = HashMap::new();
        let mut files: Vec<(String, &Image)> = Vec::new();
        let mut place = |index: usize, method: &str, what: &str, image: &'a Image| match known
            .entry((image.width, image.rgba.as_slice()))
        {
            Entry::Occupied(found) => *found.get(),
            Entry::Vacant(free) => {
                files.push((format!("images/{index:03}-{method}-{what}.png"), image));
                *free.insert(files.len() - 1)
            }
        };
        let places = sets.iter().enumerate().map(|(index, set)| {
            [("drawn", &set.drawn), ("truth", &set.truth), ("difference", &set.difference)]
                .map(|(what, image)| place(index, &set.method, what, image))
        });
        let places = places.collect();
        Self { sets, files, places }
    }

    /// The pictures of the cell in this row of the results, and the paths of what was drawn, the truth and the difference;
    /// nothing where the cell has none.
    pub fn of_row(&self, row: usize) -> Option<(&'a PictureSet, [&str; 3])> {
        let index = row.checked_sub(1)?;
        let places = self.places.get(index)?;
        Some((self.sets.get(index)?, places.map(|place| self.files[place].0.as_str())))
    }

    /// Cells in groups that drew the same pictures, in the order of each group's first: the same bytes in the worst view, and
    /// the same scores in every view. O(cells squared).
    pub fn groups<'b, 'c>(&self, cells: &[&'b CellSummary<'c>]) -> Vec<Vec<&'b CellSummary<'c>>> {
        let mut groups: Vec<Vec<&CellSummary<'_>>> = Vec::new();
        for &cell in cells {
            let is_same = |group: &&mut Vec<&CellSummary<'_>>| self.are_same(group[0], cell);
            match groups.iter_mut().find(is_same) {
                Some(group) => group.push(cell),
                None => groups.push(vec![cell]),
            }
        }
        groups
    }

    fn are_same(&self, one: &CellSummary<'_>, other: &CellSummary<'_>) -> bool {
        let places = |cell: &CellSummary<'_>| self.places.get(cell.row - 1);
        let scores = |cell: &CellSummary<'_>| {
            cell.cell.views.iter().map(|view| (view.frame, view.metrics, view.errors)).collect::<Vec<_>>()
        };
        one.cell.pen == other.cell.pen
            && places(one).is_some_and(|place| Some(place) == places(other))
            && scores(one) == scores(other)
    }
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::super::tests::comparison;
    use super::*;
    use crate::metrics::PictureKind;

    #[test]
    fn each_picture_is_written_once() {
        let mut comparison = comparison();
        let files = PictureFiles::of(&comparison.pictures);
        let truth = "images/000-brute-force-truth.png";
        let [drawn, difference] = ["drawn", "difference"].map(|what| format!("images/001-image-precision-{what}.png"));
        assert_eq!(files.of_row(2).unwrap().1, [&drawn, truth, &difference]);
        assert_eq!(files.files.len(), 7, "one truth for three cells");
        assert!(files.of_row(0).is_none() && files.of_row(9).is_none());

        comparison.pictures[1].drawn = comparison.pictures[0].drawn.clone();
        let files = PictureFiles::of(&comparison.pictures);
        assert_eq!(files.of_row(2).unwrap().1, ["images/000-brute-force-drawn.png", truth, &difference]);
        // As many bytes in another shape are another picture.
        comparison.pictures[1].drawn.width = 4;
        assert_eq!(PictureFiles::of(&comparison.pictures).files.len(), 7);
    }

    #[test]
    fn cells_share_pictures_only_where_every_view_scores_the_same() {
        let mut comparison = comparison();
        comparison.cells[1] = comparison.cells[0].clone();
        comparison.cells[1].method = "cluster-cones".to_owned();
        comparison.pictures[1] = comparison.pictures[0].clone();
        let sizes = |comparison: &crate::Comparison| {
            let files = PictureFiles::of(&comparison.pictures);
            let meshes = summarise(&comparison.cells);
            let groups = files.groups(&meshes[0].of_kind(PictureKind::Lines));
            groups.iter().map(Vec::len).collect::<Vec<_>>()
        };
        assert_eq!(sizes(&comparison), [2]);
        comparison.pictures[1].drawn.rgba[3] = 7;
        assert_eq!(sizes(&comparison), [1, 1], "another picture");
        comparison.pictures[1] = comparison.pictures[0].clone();
        comparison.cells[1].views[0] = crate::record::tests::view(5, 7.0);
        assert_eq!(sizes(&comparison), [1, 1], "another score");
    }
}
