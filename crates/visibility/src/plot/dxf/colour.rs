//! Colours and line weights as DXF knows them.

use super::super::pen::Colour;

/// The named colours, 1 to 9; 7 is white on a dark ground and black on a light one.
const NAMED: [[u8; 3]; 9] = [
    [255, 0, 0],
    [255, 255, 0],
    [0, 255, 0],
    [0, 255, 255],
    [0, 0, 255],
    [255, 0, 255],
    [255, 255, 255],
    [128, 128, 128],
    [192, 192, 192],
];

/// What stands out from the ground.
const FOREGROUND: u8 = 7;

/// Line weights in hundredths of a millimetre.
const WEIGHTS: [u16; 24] =
    [0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211];

/// The number of the nearest named colour; black is what stands out from the ground.
pub fn index(colour: Colour) -> u8 {
    if colour == Colour::BLACK {
        return FOREGROUND;
    }
    let distance = |named: &[u8; 3]| -> u32 {
        named.iter().zip(colour.0).map(|(&one, other)| u32::from(one.abs_diff(other)).pow(2)).sum()
    };
    let nearest = (1..).zip(&NAMED).min_by_key(|(_, named)| distance(named));
    nearest.map_or(FOREGROUND, |(number, _)| number)
}

/// The true colour, but of black.
pub fn true_colour(colour: Colour) -> Option<u32> {
    let [red, green, blue] = colour.0;
    (colour != Colour::BLACK).then(|| u32::from_be_bytes([0, red, green, blue]))
}

/// The line weight nearest to a width, the wider one of two.
pub fn weight(width_mm: f64) -> u16 {
    let off = |weight: u16| (f64::from(weight) - width_mm * 100.0).abs();
    WEIGHTS.into_iter().rev().min_by(|&one, &other| off(one).total_cmp(&off(other))).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pens_have_their_nearest_neighbours() {
        for (width, expected) in
            [(0.0, 0), (0.18, 18), (0.35, 35), (0.5, 50), (0.7, 70), (0.22, 20), (0.45, 50), (9.0, 211)]
        {
            assert_eq!(weight(width), expected, "{width}");
        }
        for (colour, number, rgb) in [
            ([0, 0, 0], 7, None),
            ([255, 255, 255], 7, Some(0x00ff_ffff)),
            ([250, 10, 3], 1, Some(0x00fa_0a03)),
            ([0, 0, 200], 5, Some(200)),
            ([120, 130, 125], 8, Some(0x0078_827d)),
        ] {
            assert_eq!((index(Colour(colour)), true_colour(Colour(colour))), (number, rgb), "{colour:?}");
        }
    }
}
