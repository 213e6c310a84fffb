//! Figs. 6, 13 and 14: outlines of the texture and of its hull against those of the fine mesh, by hull and by resolution.

use super::baked::{Baked, Hulled, size};
use super::drawn::{Outline, Views, camera, frame_style};
use super::printed::{COARSEST_HULL, FEWER_AZIMUTHS, SIDES};
use crate::drawings::drawing;
use crate::error::Cause;
use crate::picture::Picture;
use crate::table::{Cell, Column, Row, Table};
use silhouette_compare::drawing::Ground;
use silhouette_compare::registry::Entry;
use silhouette_core::Progress;
use silhouette_core::method::PrepareError;
use silhouette_core::view::ViewPreset;
use silhouette_render::Gpu;
use silhouette_texture::{BakeOptions, CenterRule, NormalMapHull, Texture};

/// Wrong area of the texture over that of the hull; charts read it.
pub const OF_HULL: &str = "texture over hull";

/// Vertices of hulls for Fig. 13, the paper's coarsest first.
pub const HULLS: [u32; 4] = [COARSEST_HULL, 100, 500, 2000];

/// What a texture and its hull score.
#[derive(Debug, Clone, Copy)]
struct Scores {
    hull: Outline,
    hard: Outline,
    soft: Outline,
}

fn scores(gpu: &Gpu, views: &Views, baked: &Baked, progress: &dyn Progress) -> Result<Scores, Cause> {
    let mesh = baked.drawable();
    let [texture, hull]: [Entry; 2] =
        [Entry::of::<Texture>().fill().into(), Entry::of::<NormalMapHull>().fill().into()];
    let score = |entry: &Entry, words: &str, samples: u32| {
        let mut drawing = drawing(gpu, &mesh, entry, words, frame_style(samples, Ground::Transparent), progress)?;
        views.score(gpu, &mut drawing, progress)
    };
    Ok(Scores {
        hull: score(&hull, "", 4)?,
        hard: score(&texture, "edge=hard", 1)?,
        soft: score(&texture, "edge=coverage", 4)?,
    })
}

fn columns() -> Vec<Column> {
    let percent = |title, metric, meaning| Column { digits: 3, ..Column::new(title, metric, "%", meaning) };
    vec![
        percent(
            "hull",
            "wrong area, hull",
            "area covered by one of hull and mesh but not the other, of that of the mesh",
        ),
        percent("texture", "wrong area, texture", "the same of the texture, edges at whole pixels"),
        percent("soft edges", "wrong area, soft edges", "the same of the texture with edges at each of four samples"),
        Column {
            digits: 1,
            ..Column::new("soft / hull", OF_HULL, "%", "wrong area with soft edges over that of the hull")
        },
        Column::new("outline", "outline", "px", "mean distance of outlines, soft edges"),
        percent("holes", "holes", "pixels without colour inside of the mesh, of its area, soft edges"),
    ]
}

fn row(label: String, Scores { hull, hard, soft }: Scores) -> Row {
    let percent = |share: f64| Cell::one(100.0 * share);
    let cells = vec![
        percent(hull.xor),
        percent(hard.xor),
        percent(soft.xor),
        percent(soft.xor / hull.xor),
        Cell::one(soft.chamfer_px),
        percent(soft.holes),
    ];
    Row::new(label, cells)
}

/// Fig. 6 as numbers: every subject.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn by_subject(gpu: &Gpu, all: &[&Baked], views: u32, progress: &dyn Progress) -> Result<Table, Cause> {
    let mut rows = Vec::new();
    for baked in all {
        let subject = &baked.of.subject;
        let truth = Views::new(gpu, subject.mesh.mesh(), views, progress)?;
        rows.push(row(subject.label.clone(), scores(gpu, &truth, baked, progress)?));
    }
    let about = format!("512 x 512 pixels, averaged over {views} views in perspective");
    Ok(Table { name: "Fig. 6, outlines", about, columns: columns(), rows, ..Table::default() })
}

/// Fig. 13: by vertices of the hull, with centres interpolated and per texel.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn by_hull(
    gpu: &Gpu,
    subject: &super::subjects::Subject,
    views: u32,
    options: BakeOptions,
    progress: &dyn Progress,
) -> Result<(Table, Vec<Picture>, Vec<String>), Cause> {
    const FILES: [&str; HULLS.len()] = ["fig-13-22.png", "fig-13-100.png", "fig-13-500.png", "fig-13-2000.png"];
    let truth = Views::new(gpu, subject.mesh.mesh(), views, progress)?;
    let (mut rows, mut pictures, mut notes) = (Vec::new(), Vec::new(), Vec::new());
    let left_out = |vertices: u32, reason: &dyn std::fmt::Display| {
        format!("Fig. 13 leaves out a hull of {vertices} vertices: {reason}")
    };
    for (vertices, file_name) in HULLS.into_iter().zip(FILES) {
        let hulled = match Hulled::new(subject, vertices, progress) {
            Err(Cause::Prepare(PrepareError::Mesh(reason))) => {
                notes.push(left_out(vertices, &reason));
                continue;
            }
            hulled => hulled?,
        };
        let offset = hulled.offset_percent();
        for (centers, words) in [(CenterRule::Vertex, ""), (CenterRule::Texel, ", own centres")] {
            let baked = match hulled.bake(BakeOptions { centers, ..options }, progress) {
                Err(Cause::Prepare(PrepareError::Mesh(reason))) => {
                    notes.push(left_out(vertices, &reason));
                    break;
                }
                baked => baked?,
            };
            let label = format!("{vertices} vertices, {offset:.1} % away{words}");
            rows.push(row(label, scores(gpu, &truth, &baked, progress)?));
            if centers == CenterRule::Texel {
                pictures.push(picture(gpu, &baked, file_name, &format!("{vertices} vertices, own centres"), progress)?);
            }
        }
    }
    let side = options.size.width;
    let about = format!("{side} x {side} texels, {} azimuths; {views} views", options.size.azimuths);
    let label = subject.label.clone();
    let table = Table { name: "Fig. 13, hulls", subject: label, about, columns: columns(), rows, ..Table::default() };
    Ok((table, pictures, notes))
}

/// Fig. 14: by texels and azimuths.
///
/// # Errors
/// [`Cause`]: cancelled, a size that does not fit the hull, or a device that failed.
pub fn by_resolution(
    gpu: &Gpu,
    hulled: &Hulled,
    views: u32,
    most: u32,
    progress: &dyn Progress,
) -> Result<(Table, Vec<String>), Cause> {
    let truth = Views::new(gpu, hulled.subject.mesh.mesh(), views, progress)?;
    let (mut rows, mut notes) = (Vec::new(), Vec::new());
    for side in SIDES.into_iter().filter(|&side| side <= most) {
        for azimuths in FEWER_AZIMUTHS {
            let options = BakeOptions { size: size(side, azimuths), ..BakeOptions::default() };
            match hulled.bake(options, progress) {
                Ok(baked) => {
                    let label = format!("{side} x {side} texels, {azimuths} azimuths");
                    rows.push(row(label, scores(gpu, &truth, &baked, progress)?));
                }
                Err(Cause::Prepare(PrepareError::Mesh(reason))) => {
                    notes.push(format!("Fig. 14 leaves out {side} x {side} texels: {reason}"));
                    break;
                }
                Err(error) => return Err(error),
            }
        }
    }
    let about = format!("a hull of {} vertices; {views} views", hulled.hull.mesh().positions().len());
    let subject = hulled.subject.label.clone();
    let table = Table { name: "Fig. 14, resolution", subject, about, columns: columns(), rows, ..Table::default() };
    Ok((table, notes))
}

/// The texture from the three-quarter view.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn picture(
    gpu: &Gpu,
    baked: &Baked,
    file_name: &'static str,
    title: &str,
    progress: &dyn Progress,
) -> Result<Picture, Cause> {
    let entry: Entry = Entry::of::<Texture>().fill().into();
    let mut drawing =
        drawing(gpu, &baked.drawable(), &entry, "edge=coverage", frame_style(4, Ground::Paper), progress)?;
    let direction = ViewPreset::default().directions().0;
    drawing.draw(gpu, &camera(baked.of.subject.mesh.mesh(), direction)?)?;
    Ok(Picture { file_name, title: format!("{}: {title}", baked.of.subject.label), image: drawing.picture(gpu)? })
}
