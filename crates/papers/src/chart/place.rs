//! [`Extent`]: what marks, lines and words take of a chart, and where there is room for more words.

use silhouette_compare::plot::rounded;

/// Height of a line of small words, and the average width of one of their letters, in pixels.
const SMALL: [f64; 2] = [12.0, 6.5];

/// A rectangle that a mark or words take, in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Left and top.
    pub from: [f64; 2],
    /// Right and bottom.
    pub to: [f64; 2],
}

impl Extent {
    /// A place for words beside a mark, if possible one that is not taken.
    ///
    /// No place reaches left of `left`; where all are taken it is the one on the right.
    pub fn free_beside([x, y]: [f64; 2], words: &str, left: f64, taken: &[Self]) -> Self {
        let [height, letter] = SMALL;
        let width = letter * words.chars().count() as f64;
        let place = |left: f64, top: f64| Self {
            from: [rounded(left), rounded(top)],
            to: [rounded(left + width), rounded(top + height)],
        };
        let (middle, half) = (x - 0.5 * width, 0.5 * height);
        let places = [
            place(x + 9.0, y - half),
            place(x - 9.0 - width, y - half),
            place(middle, y + 8.0),
            place(middle, y - 9.0 - height),
            place(x - 5.0 - width, y + 6.0),
            place(x + 6.0, y - 6.0 - height),
            place(x + 6.0, y + 6.0),
            place(x - 5.0 - width, y - 6.0 - height),
            place(x - 9.0 - width, y + 14.0),
            place(x + 9.0, y - 14.0 - height),
        ];
        let is_free = |place: &&Self| place.from[0] > left && !taken.iter().any(|other| place.overlaps(other));
        *places.iter().find(is_free).unwrap_or(&places[0])
    }

    /// What a straight line takes, in small steps.
    pub fn along([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> impl Iterator<Item = Self> {
        let steps = ((to_x - x).hypot(to_y - y) / 3.0).ceil().max(1.0);
        (0..=steps as u32).map(move |step| {
            let share = f64::from(step) / steps;
            let [x, y] = [x + share * (to_x - x), y + share * (to_y - y)];
            Self { from: [x - 1.0, y - 1.0], to: [x + 1.0, y + 1.0] }
        })
    }

    /// Whether the two have a point in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.from[axis] < other.to[axis] && other.from[axis] < self.to[axis])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_avoid_what_is_there() {
        let first = Extent::free_beside([200.0, 100.0], "0.1", 0.0, &[]);
        let second = Extent::free_beside([200.0, 100.0], "0.1", 0.0, &[first]);
        assert!(!second.overlaps(&first) && first.overlaps(&first));
        let line: Vec<Extent> = Extent::along([200.0, 100.0], [300.0, 100.0]).collect();
        let beside = Extent::free_beside([200.0, 100.0], "0.1", 0.0, &line);
        assert!(line.iter().all(|bit| !beside.overlaps(bit)) && line.iter().any(|bit| first.overlaps(bit)));
        assert!(Extent::free_beside([200.0, 100.0], "0.1", 195.0, &[first]).from[0] > 195.0);
    }
}
