//! [`Polylines`]: what is drawn.

use glam::DVec3;

/// Open and closed polylines in a mesh's own space, one after another in one array. Clearing keeps the memory.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Polylines {
    points: Vec<DVec3>,
    /// For each polyline the end of its points and whether it is closed.
    ends: Vec<(usize, bool)>,
}

impl Polylines {
    /// No polylines.
    pub fn new() -> Self {
        Self::default()
    }

    /// Removes all of them.
    pub fn clear(&mut self) {
        self.points.clear();
        self.ends.clear();
    }

    /// Adds a polyline; a closed one runs back from its last point to its first, which is not repeated. Where the side
    /// matters, the front face is on its left. Points that are not finite end the line before them.
    pub fn push(&mut self, points: impl IntoIterator<Item = DVec3>, closed: bool) {
        self.points.extend(points);
        self.ends.push((self.points.len(), closed));
    }

    /// Number of polylines.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The points of each polyline, and whether it is closed.
    pub fn iter(&self) -> impl Iterator<Item = (&[DVec3], bool)> {
        let mut start = 0;
        self.ends.iter().map(move |&(end, closed)| {
            let points = &self.points[start..end];
            start = end;
            (points, closed)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polylines_come_back_as_they_were_pushed() {
        let mut lines = Polylines::new();
        lines.push([DVec3::X, DVec3::Y], false);
        lines.push([], true);
        lines.push([DVec3::Z; 3], true);
        let back: Vec<_> = lines.iter().map(|(points, closed)| (points.len(), closed)).collect();
        assert_eq!(back, [(2, false), (0, true), (3, true)]);
        lines.clear();
        assert!(lines.is_empty() && lines.iter().next().is_none());
    }
}
