//! What Hall prints: frames per second on a Pentium III of 650 MHz, and speed-ups over brute force.

/// The concavity levels of the table, in radians.
pub const LEVELS_RAD: [f32; 6] = [0.0, 0.01, 0.1, 0.2, 0.5, 1.0];

/// One model of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperModel {
    /// As printed.
    pub name: &'static str,
    /// Faces, as printed.
    pub faces: usize,
    /// Frames per second by brute force.
    pub brute_force_fps: f64,
    /// Frames per second by tracking, one per level.
    pub fps: [f64; 6],
    /// Speed-ups as printed, one per level.
    pub speed_ups: [f64; 6],
    /// What has to be known of its row.
    pub note: &'static str,
}

/// The bunny, the one model of the paper that is available.
pub const BUNNY: PaperModel = PaperModel {
    name: "Bunny",
    faces: 69_451,
    brute_force_fps: 4.42,
    fps: [4.98, 5.68, 11.47, 18.92, 30.48, 34.85],
    speed_ups: [1.13, 1.29, 2.60, 4.28, 6.90, 7.88],
    note: "",
};

/// The models that are not available.
pub const OTHERS: [PaperModel; 2] = [
    PaperModel {
        name: "UFO",
        faces: 19_608,
        brute_force_fps: 18.35,
        fps: [19.54, 23.18, 43.29, 57.15, 59.07, 59.15],
        speed_ups: [1.07, 1.26, 2.36, 3.12, 3.22, 3.22],
        note: "the paper's values at N = 0.5 and 1 look limited by a screen of 60 Hz",
    },
    PaperModel {
        name: "Alien",
        faces: 41_265,
        brute_force_fps: 7.73,
        fps: [8.04, 8.52, 12.15, 16.15, 21.44, 27.34],
        speed_ups: [1.04, 1.10, 1.57, 2.09, 2.77, 3.54],
        note: "",
    },
];

/// The paper's model that a mesh is: the bunny, recognised by its number of faces. Numbers of vertices differ between
/// copies of the bunny, since some hold vertices that no face uses; names can be anything.
pub fn model_of(faces: usize) -> Option<&'static PaperModel> {
    (faces == BUNNY.faces).then_some(&BUNNY)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::method::Method;
    use silhouette_tracking::Tracking;

    #[test]
    fn printed_speed_ups_are_the_ratios_of_the_printed_rates() {
        for model in [BUNNY].iter().chain(&OTHERS) {
            for (fps, speed_up) in model.fps.iter().zip(model.speed_ups) {
                let ratio = fps / model.brute_force_fps;
                assert!((ratio - speed_up).abs() < 0.011, "{}: {ratio} printed as {speed_up}", model.name);
            }
        }
    }

    #[test]
    fn the_bunny_is_recognised_by_its_faces() {
        assert_eq!(model_of(69_451).map(|model| model.name), Some("Bunny"));
        assert_eq!(model_of(69_666), None);
        assert_eq!(model_of(19_608), None, "no other model is known by a count that any mesh may have");
    }

    #[test]
    fn reports_show_the_same_rates() {
        let printed = [BUNNY].iter().chain(&OTHERS).flat_map(|model| model.fps.map(|fps| (fps, model.brute_force_fps)));
        let shown = Tracking::INFO.published.iter().flat_map(|rates| rates.rows).map(|row| (row.fps, row.against_fps));
        assert_eq!(shown.collect::<Vec<_>>(), printed.collect::<Vec<_>>());
    }
}
