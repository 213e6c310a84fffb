//! Charts of the sphere in N dimensions: how a point becomes N - 1 coordinates in which cells are boxes.

/// A chart of the sphere S^(N - 1).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chart {
    /// Central projection onto a face of the cube: the coordinate of largest size is the face's, `is_negative` its sign.
    Gnomonic {
        /// Axis of the face.
        axis: usize,
        /// On which side of the origin the face lies.
        is_negative: bool,
    },
    /// Angles: the first from -π to π, all others from 0 to π, as longitude and latitude are.
    Angles,
}

/// The coordinates of a point, N - 1 of them; the last place is 0.
pub type Coordinates<const N: usize> = [f64; N];

impl Chart {
    /// The face of the cube that a point projects onto. A point of no length is put on the first.
    pub fn gnomonic_at<const N: usize>(point: &[f64; N]) -> Self {
        let axis = (0..N).fold(0, |best, axis| if point[axis].abs() > point[best].abs() { axis } else { best });
        Self::Gnomonic { axis, is_negative: point[axis] < 0.0 }
    }

    /// Where a point stands in the chart.
    pub fn coordinates<const N: usize>(self, point: &[f64; N]) -> Coordinates<N> {
        let mut coordinates = [0.0; N];
        match self {
            Self::Gnomonic { axis, .. } => {
                let height = point[axis].abs();
                let others = (0..N).filter(|&other| other != axis);
                for (place, other) in coordinates.iter_mut().zip(others) {
                    *place = if height > 0.0 { point[other] / height } else { 0.0 };
                }
            }
            Self::Angles => {
                coordinates[0] = point[1].atan2(point[0]);
                let mut radius = point[0].hypot(point[1]);
                for place in 1..N - 1 {
                    coordinates[place] = radius.atan2(point[place + 1]);
                    radius = radius.hypot(point[place + 1]);
                }
            }
        }
        coordinates
    }

    /// A point, of any length above 0, at the coordinates.
    pub fn point<const N: usize>(self, coordinates: &Coordinates<N>) -> [f64; N] {
        let mut point = [0.0; N];
        match self {
            Self::Gnomonic { axis, is_negative } => {
                point[axis] = if is_negative { -1.0 } else { 1.0 };
                let others = (0..N).filter(|&other| other != axis);
                others.zip(coordinates).for_each(|(other, &place)| point[other] = place);
            }
            Self::Angles => {
                let mut radius = 1.0;
                for place in (1..N - 1).rev() {
                    point[place + 1] = radius * coordinates[place].cos();
                    radius *= coordinates[place].sin();
                }
                point[0] = radius * coordinates[0].cos();
                point[1] = radius * coordinates[0].sin();
            }
        }
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction<const N: usize>(point: &[f64; N]) -> [f64; N] {
        let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
        point.map(|x| x / length)
    }

    fn check<const N: usize>(point: [f64; N]) {
        for chart in [Chart::gnomonic_at(&point), Chart::Angles] {
            let back = chart.point(&chart.coordinates(&point));
            let off = direction(&back).iter().zip(direction(&point)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-12, "{chart:?} {point:?} {back:?}");
        }
    }

    #[test]
    fn points_come_back_from_their_coordinates() {
        for i in 0..200_u32 {
            let [a, b, c, d] = [1.0, 2.3, 3.1, 4.7].map(|rate| (rate * f64::from(i) + 0.3 * rate).sin());
            check([a, b, c]);
            check([a, b, c, d]);
        }
    }
}
