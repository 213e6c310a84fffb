//! Step 4: rings without spikes.
//!
//! A face that is seen edge-on, or two that lie on each other, are projected to a sliver as wide as rounding, which the union
//! keeps where it stands out of everything else or cuts into it.

use super::lattice::{LINES_PER_PIXEL, Point};

/// How wide a sliver may be that is none of the picture: what the union takes for one place.
const MOST_WIDTH: f64 = LINES_PER_PIXEL / (1 << 20) as f64;

/// A ring without the points at which it turns back along itself; `None` where nothing is left. O(points).
pub fn without_spikes(ring: &[Point]) -> Option<Vec<Point>> {
    let mut kept: Vec<Point> = Vec::with_capacity(ring.len());
    for &point in ring {
        kept.push(point);
        while let [.., before, tip, after] = kept[..]
            && is_spike(before, tip, after)
        {
            kept.truncate(kept.len() - 2);
            kept.push(after);
        }
        if let [.., one, other] = kept[..]
            && one == other
        {
            kept.pop();
        }
    }
    // Around the beginning.
    let (mut first, mut last) = (0, kept.len());
    while last - first >= 3 {
        if is_spike(kept[last - 2], kept[last - 1], kept[first]) {
            last -= 1;
        } else if is_spike(kept[last - 1], kept[first], kept[first + 1]) {
            first += 1;
        } else {
            break;
        }
    }
    (last - first >= 3).then(|| kept[first..last].to_vec())
}

/// Whether a ring turns back at a point, so that one of its two sides there lies on the other.
fn is_spike(before: Point, tip: Point, after: Point) -> bool {
    let away = |to: Point| [0, 1].map(|axis| (to[axis] - tip[axis]) as f64);
    let (one, other) = (away(before), away(after));
    let [of_one, of_other] = [one, other].map(|[x, y]| x.hypot(y));
    let area = one[0] * other[1] - one[1] * other[0];
    // The distance of the end of the shorter side from the line of the longer one.
    one[0] * other[0] + one[1] * other[1] >= 0.0 && area.abs() <= MOST_WIDTH * of_one.max(of_other)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: i64 = 1 << 36;

    fn ring(pixels: &[[i64; 2]]) -> Vec<Point> {
        pixels.iter().map(|[x, y]| [x * UNIT, y * UNIT]).collect()
    }

    #[test]
    fn what_turns_back_along_itself_is_left_out_wherever_the_ring_begins() {
        let square = ring(&[[0, 0], [4, 0], [4, 4], [0, 4]]);
        // Out of the second corner, there and back in steps that differ, one of them off by rounding.
        let mut spiked = ring(&[[0, 0], [4, 0], [6, 0], [9, 0], [7, 0], [4, 0], [4, 4], [0, 4]]);
        spiked[4][1] += 100;
        for start in 0..spiked.len() {
            spiked.rotate_left(1);
            let mut cleaned = without_spikes(&spiked).unwrap();
            let begin = cleaned.iter().position(|point| *point == [0, 0]).unwrap();
            cleaned.rotate_left(begin);
            assert_eq!(cleaned, square, "{start}");
        }
        assert_eq!(without_spikes(&ring(&[[0, 0], [5, 0], [3, 0]])), None);
    }

    #[test]
    fn narrow_corners_stay() {
        // A needle of a thousandth of a pixel, and a side that goes straight on.
        let mut needle = ring(&[[0, 0], [50, 0], [100, 0], [0, 0]]);
        needle[3][1] = UNIT / 1000;
        assert_eq!(without_spikes(&needle).unwrap(), needle);
    }
}
