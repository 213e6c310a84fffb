//! What an engine relies on.

use crate::COLORS;
use crate::device::Device;
use crate::frame::{Frame, Shown};

fn engine(test: &str) -> Option<Device> {
    silhouette_testing::gpu_or_skip(test)?;
    Some(Device::new().unwrap())
}

#[test]
fn shading_outside_of_lines_keeps_every_bit() {
    let Some(device) = engine("shading_outside_of_lines_keeps_every_bit") else { return };
    for color in COLORS {
        let mut frame = Frame::new(&device, color).unwrap();
        let [shading, over, lines] = [Shown::Shading, Shown::LinesOverShading, Shown::Lines]
            .map(|shown| frame.draw(&device, shown, 0.4).unwrap().texels);
        let mut outside = 0;
        for ((shaded, over), line) in shading.iter().zip(&over).zip(&lines) {
            if line[3] == 0.0 {
                assert_eq!(shaded.map(f32::to_bits), over.map(f32::to_bits), "{color:?}");
                outside += 1;
            }
        }
        let inked = lines.iter().filter(|texel| texel[3] > 0.999).count();
        assert!(outside > 100_000 && inked > 2000, "{color:?}: {outside} {inked}");
        let is_black = |texel: &&[f32; 4]| texel[..3].iter().all(|part| *part < 0.01);
        assert!(over.iter().filter(is_black).count() > 2000, "lines are drawn over the shading");
    }
}

#[test]
fn interiors_of_lines_alone_are_transparent() {
    let Some(device) = engine("interiors_of_lines_alone_are_transparent") else { return };
    for color in COLORS {
        let mut frame = Frame::new(&device, color).unwrap();
        let [shading, lines] =
            [Shown::Shading, Shown::Lines].map(|shown| frame.draw(&device, shown, 0.4).unwrap().texels);
        let on_objects = shading.iter().zip(&lines).filter(|(shaded, _)| shaded[..3].iter().any(|part| *part < 0.99));
        let (all, clear) =
            on_objects.fold((0, 0), |(all, clear), (_, line)| (all + 1, clear + i32::from(line[3] == 0.0)));
        assert!(all > 20_000 && clear * 10 > all * 7, "{color:?}: {clear} of {all}");
        assert!(lines.iter().all(|texel| texel[..3].iter().all(|part| *part == 0.0)), "black ink, premultiplied");
    }
}

#[test]
fn the_moving_object_is_drawn_where_its_buffer_says() {
    let Some(device) = engine("the_moving_object_is_drawn_where_its_buffer_says") else { return };
    let mut frame = Frame::new(&device, COLORS[1]).unwrap();
    let mut at = |seconds| frame.draw(&device, Shown::Lines, seconds).unwrap();
    let [first, again, later] = [at(0.0), at(0.0), at(0.3)];
    assert_eq!(first, again);
    let half = crate::scene::SIZE[0] as usize / 2;
    let differs_in = |left: bool| {
        let pairs = first.texels.iter().zip(&later.texels).enumerate();
        pairs
            .filter(|(at, (a, b))| (at % (2 * half) < half) == left && a.map(f32::to_bits) != b.map(f32::to_bits))
            .count()
    };
    assert!(differs_in(false) > 500 && differs_in(true) < differs_in(false) / 4, "the knot moved, the torus did not");
}
