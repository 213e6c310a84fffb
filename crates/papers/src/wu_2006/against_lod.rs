//! The map of who wins: the texture against levels of detail, by projected size and bytes.

use super::baked::{Hulled, size};
use super::drawn::{Views, frame_style};
use super::equal_area::{Level, coarsest, levels};
use super::equal_bytes::of_bytes;
use super::printed::AZIMUTHS;
use super::subjects::Subject;
use super::timed::time;
use crate::chart::map::{Field, Panel};
use crate::chart::{Chart, map};
use crate::drawings::drawing;
use crate::error::Cause;
use crate::table::{Cell, Column, Row, Table};
use silhouette_baselines::{LodMesh, LodMeshOptions};
use silhouette_compare::drawing::{Drawing, Ground};
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::registry::Entry;
use silhouette_core::Progress;
use silhouette_core::method::Method;
use silhouette_render::Gpu;
use silhouette_texture::{BakeOptions, Texture};

/// Samples per pixel of both: what a soft edge needs.
const SAMPLES: u32 = 4;

/// A hull has at most a vertex for so many texels, so that its blocks have 8 texels along a side.
const TEXELS_PER_VERTEX: u32 = 64;

/// What is compared.
#[derive(Debug, Clone, Copy)]
pub struct Extent {
    /// Texels along a side of textures.
    pub sides: &'static [u32],
    /// Distances, over that from which the bounding sphere fits the picture.
    pub distances: &'static [f64],
    /// Views for outlines.
    pub views: u32,
    /// Views for times.
    pub rounds: u32,
}

/// One place on the map. Pairs are of texture and levels of detail.
#[derive(Debug, Clone, Copy)]
struct Place {
    side: u32,
    distance: f64,
    covered_px: f64,
    /// At equal bytes; NaN where no chain is so small.
    bytes: [f64; 2],
    xor: [f64; 2],
    ms: [f64; 2],
    /// The level whose wrong area is no larger than that of the texture: faces, bytes from it on, milliseconds.
    level_faces: usize,
    level_bytes: f64,
    level_ms: f64,
}

impl Place {
    fn error_ratio(&self) -> f64 {
        self.xor[1] / self.xor[0]
    }

    fn time_ratio(&self) -> f64 {
        self.ms[1] / self.ms[0]
    }

    fn level_bytes_ratio(&self) -> f64 {
        self.level_bytes / self.bytes[0]
    }

    fn level_time_ratio(&self) -> f64 {
        self.level_ms / self.ms[0]
    }

    fn winners(&self) -> &'static str {
        let (error, time) = (self.error_ratio(), self.time_ratio());
        match (error > 1.0, time > 1.0) {
            _ if error.is_nan() => "no chain is so small",
            (true, true) => "error: texture, time: texture",
            (true, false) => "error: texture, time: lod-mesh",
            (false, true) => "error: lod-mesh, time: texture",
            (false, false) => "error: lod-mesh, time: lod-mesh",
        }
    }
}

/// Measures one subject everywhere on the map.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, subject: &Subject, extent: Extent, progress: &dyn Progress) -> Result<(Table, Chart), Cause> {
    let fine = subject.mesh.mesh();
    let lod = LodMesh::prepare(&subject.mesh, &LodMeshOptions::default(), progress)?;
    let mut levels = levels(gpu, &lod, SAMPLES, progress)?;
    let from = |&distance| Ok((distance, Views::from_afar(gpu, fine, extent.views, distance, progress)?, Vec::new()));
    let mut distances = extent.distances.iter().map(from).collect::<Result<Vec<_>, Cause>>()?;
    let mut places = Vec::new();
    for &side in extent.sides {
        let mut rivals = Rivals::new(gpu, subject, &lod, side, progress)?;
        for (distance, views, known) in &mut distances {
            let xor = views.score(gpu, &mut rivals.texture, progress)?.xor;
            let index = coarsest(gpu, &mut levels, views, xor, known, progress)?;
            let level = &mut levels[index];
            let lod_xor = match &mut rivals.lod {
                Some((lod, _)) => views.score(gpu, lod, progress)?.xor,
                None => f64::NAN,
            };
            let [texture_ms, lod_ms, level_ms] =
                rivals.times(gpu, subject, level, *distance, extent.rounds, progress)?;
            places.push(Place {
                side,
                distance: *distance,
                covered_px: views.covered_px(),
                bytes: [rivals.bytes, rivals.lod.as_ref().map_or(f64::NAN, |(_, bytes)| *bytes)],
                xor: [xor, lod_xor],
                ms: [texture_ms, lod_ms],
                level_faces: level.faces,
                level_bytes: level.bytes as f64,
                level_ms,
            });
        }
    }
    Ok((table(subject, extent, &places), chart(extent, &places)))
}

/// A texture, and a chain of as many bytes.
struct Rivals {
    texture: Drawing,
    bytes: f64,
    lod: Option<(Drawing, f64)>,
}

impl Rivals {
    fn new(gpu: &Gpu, subject: &Subject, all: &LodMesh, side: u32, progress: &dyn Progress) -> Result<Self, Cause> {
        let hull_vertices = subject.hull_vertices.min(side * side / TEXELS_PER_VERTEX);
        let options = BakeOptions { size: size(side, AZIMUTHS), detail: 1, ..BakeOptions::default() };
        let baked = Hulled::new(subject, hull_vertices, progress)?.bake(options, progress)?;
        let entry: Entry = Entry::of::<Texture>().fill().into();
        let ground = Ground::Transparent;
        let texture = drawing(gpu, &baked.drawable(), &entry, "edge=coverage", frame_style(SAMPLES, ground), progress)?;
        let bytes = baked.texture.bytes();
        let lod = match of_bytes(&subject.mesh, all.bytes(), bytes, progress)? {
            Some(lod) => {
                let (taken, style) = (lod.bytes() as f64, frame_style(SAMPLES, ground));
                Some((Drawing::new(gpu, &subject.mesh, lod, PictureKind::Fill, style)?, taken))
            }
            None => None,
        };
        Ok(Self { texture, bytes: bytes as f64, lod })
    }

    /// Median milliseconds of texture, chain and level, in turn.
    fn times(
        &mut self,
        gpu: &Gpu,
        subject: &Subject,
        level: &mut Level,
        distance: f64,
        rounds: u32,
        progress: &dyn Progress,
    ) -> Result<[f64; 3], Cause> {
        let (fine, texture, level) = (subject.mesh.mesh(), &mut self.texture, &mut level.drawing);
        if let Some((lod, _)) = &mut self.lod {
            return time(gpu, fine, [texture, lod, level], distance, rounds, progress);
        }
        let [texture, level] = time(gpu, fine, [texture, level], distance, rounds, progress)?;
        Ok([texture, f64::NAN, level])
    }
}

const KB: f64 = 1000.0;

fn table(subject: &Subject, extent: Extent, places: &[Place]) -> Table {
    let whole = |title, metric, unit, meaning| Column { digits: 0, ..Column::new(title, metric, unit, meaning) };
    let percent = |title, metric, meaning| Column { digits: 3, ..Column::new(title, metric, "%", meaning) };
    let ratio = |title, metric, meaning| Column::new(title, metric, "×", meaning);
    let row = |place: &Place| {
        let values = [
            place.covered_px,
            place.bytes[0] / KB,
            place.bytes[1] / KB,
            100.0 * place.xor[0],
            100.0 * place.xor[1],
            place.error_ratio(),
            place.ms[0],
            place.ms[1],
            place.time_ratio(),
            place.level_faces as f64,
            place.level_bytes / KB,
            place.level_bytes_ratio(),
            place.level_ms,
            place.level_time_ratio(),
        ];
        let label = format!("{} × {0} texels, {} ×", place.side, place.distance);
        Row { remark: place.winners(), ..Row::new(label, values.map(Cell::one).to_vec()) }
    };
    Table {
        name: "Against levels of detail",
        subject: subject.label.clone(),
        about: format!(
            "lod-mesh draws the coarsest level within 1 pixel; rows are textures of {AZIMUTHS} azimuths, with a colour and a \
             normal per texel, and distances, over that from which all of the mesh is seen; four samples per pixel, outlines \
             over {} views, times over {}; above 1 × the texture wins",
            extent.views, extent.rounds
        ),
        columns: vec![
            whole("covered", "covered at distance", "px", "pixels that the mesh covers, averaged over views"),
            whole("texture", "bytes, texture", "kB", "bytes of the texture, hull, colours and normals included"),
            whole("lod", "bytes, lod", "kB", "bytes of all levels: positions, normals and triangles"),
            percent("texture", "wrong area, texture of these bytes", "area covered by one of texture and mesh alone"),
            percent("lod", "wrong area, lod", "the same of the levels of as many bytes"),
            ratio("lod / texture", "wrong area, lod over texture", "wrong area of the levels over that of the texture"),
            Column::new("texture", "frame, texture of these bytes", "ms", "median time of a frame of the texture"),
            Column::new("lod", "frame, lod", "ms", "median time of a frame of the levels of as many bytes"),
            ratio("lod / texture", "frame, lod over texture", "frame time of the levels over that of the texture"),
            whole("faces", "faces at equal area", "", "faces of the coarsest level with no more wrong area"),
            whole("bytes", "bytes at equal area", "kB", "bytes of that level and all coarser ones"),
            ratio("lod / texture", "bytes at equal area, lod over texture", "those bytes over the texture's"),
            Column::new("frame", "frame at equal area", "ms", "median time of a frame of that level"),
            ratio("lod / texture", "frame at equal area, lod over texture", "that time over the texture's"),
        ],
        remark_title: "at equal bytes",
        rows: places.iter().map(row).collect(),
    }
}

fn chart(extent: Extent, places: &[Place]) -> Chart {
    let (percent, kilobytes, milliseconds) = (
        |share: f64| format!("{:.2} %", 100.0 * share),
        |bytes: f64| format!("{:.0} kB", bytes / KB),
        |ms: f64| format!("{ms:.2} ms"),
    );
    let panel = |title, field: &dyn Fn(&Place) -> Field| Panel {
        title,
        columns: places.iter().take(extent.distances.len()).map(column).collect(),
        rows: places.iter().step_by(extent.distances.len()).map(texture).collect(),
        fields: places.iter().map(field).collect(),
    };
    let panels = [
        panel("Wrong area at equal bytes", &|place| Field::new(place.error_ratio(), &place.xor.map(percent))),
        panel("Frame time at equal bytes", &|place| Field::new(place.time_ratio(), &place.ms.map(milliseconds))),
        panel("Bytes at equal wrong area", &|place| {
            Field::new(place.level_bytes_ratio(), &[place.bytes[0], place.level_bytes].map(kilobytes))
        }),
        panel("Frame time at equal wrong area", &|place| {
            Field::new(place.level_time_ratio(), &[place.ms[0], place.level_ms].map(milliseconds))
        }),
    ];
    let svg = map::draw(&panels, ["levels of detail win", "the texture wins"]);
    Chart { file_name: "against-lod.svg", title: "Texture against levels of detail: texture | levels", svg }
}

fn column(place: &Place) -> [String; 2] {
    [format!("{} ×", place.distance), format!("{:.0} px", place.covered_px)]
}

fn texture(place: &Place) -> [String; 2] {
    [format!("{0} × {0} texels", place.side), format!("{:.0} kB", place.bytes[0] / KB)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXTENT: Extent = Extent { sides: &[64], distances: &[1.0, 4.0], views: 2, rounds: 1 };

    #[test]
    fn every_place_has_a_row_and_four_fields_whoever_wins() {
        let Some(gpu) = silhouette_testing::gpu_or_skip("every_place_has_a_row_and_four_fields_whoever_wins") else {
            return;
        };
        let mesh = silhouette_testing::prepare::prepared(silhouette_testing::builtin("blob:5000"));
        let (label, origin) = ("blob".to_owned(), String::new());
        let subject = Subject { label, origin, mesh, hull_vertices: 500, row: None };
        let (table, chart) = measure(gpu, &subject, EXTENT, &silhouette_core::NoProgress).unwrap();
        assert_eq!(table.rows.len(), 2);
        let value = |row: usize, metric: &str| table.values(metric).nth(row).unwrap().1;
        for row in 0..2 {
            let [texture, lod] = ["bytes, texture", "bytes, lod"].map(|metric| value(row, metric));
            assert!(lod <= texture && texture < 400.0, "{lod} of {texture} kB");
            let ratio = value(row, "wrong area, lod over texture");
            let texture_wins = table.rows[row].remark.starts_with("error: texture");
            assert_eq!(ratio > 1.0, texture_wins, "{}", table.rows[row].remark);
        }
        assert!(value(0, "covered at distance") > 10.0 * value(1, "covered at distance"));
        assert!(value(0, "faces at equal area") >= value(1, "faces at equal area"), "farther, fewer faces do");
        assert!(table.columns.iter().all(|column| table.values(column.metric).count() == 2), "no value is missing");
        assert_eq!(chart.svg.matches(" | ").count(), 4 * 2, "both values in each field");
        assert!(chart.svg.contains("64 × 64 texels") && !chart.svg.contains("NaN"));
    }

    #[test]
    fn who_wins_is_said_for_error_and_time() {
        let place = Place {
            side: 64,
            distance: 1.0,
            covered_px: 1.0,
            bytes: [2.0; 2],
            xor: [1.0, 2.0],
            ms: [2.0, 1.0],
            level_faces: 1,
            level_bytes: 1.0,
            level_ms: 1.0,
        };
        assert_eq!(place.winners(), "error: texture, time: lod-mesh");
        assert_eq!(Place { xor: [2.0, 1.0], ms: [1.0, 2.0], ..place }.winners(), "error: lod-mesh, time: texture");
        assert_eq!(Place { xor: [2.0, f64::NAN], ..place }.winners(), "no chain is so small");
    }
}
