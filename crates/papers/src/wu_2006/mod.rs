//! H. Wu, L.-Y. Wei, X. Wang and B. Guo, "Silhouette Texture", Eurographics Symposium on Rendering 2006: Table 1, and the figures
//! with numbers.
//!
//! 1. `printed`: what the paper prints. `subjects`: meshes and their hulls. `baked`: a subject with its texture.
//! 2. `drawn`: pictures and what they score. `timed`: frames of several methods in turn.
//! 3. `table_one`: Table 1. `sampling`: sections 3.2 and 3.3. `compressed`: Fig. 10. `distances`: Fig. 11. `magnified`: Fig. 12.
//!    `outlines`: Figs. 6, 13 and 14. `lines`: Fig. 15.
//! 4. `against_lod`, with the cargo feature `simplify`: the map of who wins against levels of detail, at equal bytes
//!    (`equal_bytes`) and at equal wrong area (`equal_area`).

#[cfg(feature = "simplify")]
mod against_lod;
mod baked;
mod compressed;
mod distances;
mod drawn;
#[cfg(feature = "simplify")]
mod equal_area;
#[cfg(feature = "simplify")]
mod equal_bytes;
mod lines;
mod magnified;
mod outlines;
mod printed;
mod sampling;
mod subjects;
mod table_one;
mod timed;

use self::baked::{Baked, Hulled, size};
use self::drawn::frame_style;
use self::printed::{AZIMUTHS, SIDE};
use self::table_one::Measurement;
use crate::drawings::drawing;
use crate::error::{Cause, PaperError};
use crate::paper::{Measured, Paper, Run};
use silhouette_baselines::FineMesh;
use silhouette_compare::Profile;
use silhouette_compare::drawing::Ground;
use silhouette_compare::registry::Entry;
use silhouette_core::Method;
use silhouette_texture::lookup::AzimuthRule;
use silhouette_texture::{BakeOptions, Texture};

/// The paper.
pub static PAPER: Paper = Paper {
    name: "silhouette-texture",
    source: Texture::INFO.source,
    about: "The paper's sampling errors, PSNR and frame rates stand beside ours, and beside what it shows as pictures only: how \
            far outlines are from those of the fine mesh, by hull and by resolution.",
    reading: &[
        "Hulls are ours: a simplified offset surface of the smallest offset for which it is proved to enclose the mesh. The paper \
         states their vertices and not how far from the mesh they are, on which every value depends.",
        "A file named after a model of the paper gets a hull of as many vertices as there, and is simplified to the paper's vertices \
         where it has more. With the quick profile textures have 128 x 128 texels, with the full one 512 x 512 as in the paper.",
        "Of Fig. 10 the paper states neither the model nor how PSNR is defined.",
    ],
    default_meshes: &subjects::DEFAULT_MESHES,
    needs_gpu: true,
    measure,
};

/// How much is measured.
struct Extent {
    side: u32,
    /// Texels along a side of textures of which there are many.
    many_side: u32,
    views: u32,
    rounds: u32,
    #[cfg(feature = "simplify")]
    against_lod: against_lod::Extent,
}

impl Extent {
    fn of(profile: Profile) -> Self {
        let rounds = if profile == Profile::Full { 9 } else { 3 };
        #[cfg(feature = "simplify")]
        let against_lod = match profile {
            Profile::Quick => against_lod::Extent { sides: &[64, 96], distances: &[1.0, 4.0, 16.0], views: 3, rounds },
            Profile::Full => against_lod::Extent {
                sides: &[64, 128, 256, 512],
                distances: &[1.0, 2.0, 4.0, 8.0, 16.0],
                views: 20,
                rounds,
            },
        };
        let (side, many_side, views) = match profile {
            Profile::Quick => (128, 96, 4),
            Profile::Full => (SIDE, SIDE / 2, 20),
        };
        Self {
            side,
            many_side,
            views,
            rounds,
            #[cfg(feature = "simplify")]
            against_lod,
        }
    }
}

fn measure(run: &Run<'_>) -> Result<Measured, PaperError> {
    let (gpu, progress, extent) = (run.gpu()?, run.progress, Extent::of(run.profile));
    let options = |side| BakeOptions { size: size(side, AZIMUTHS), ..BakeOptions::default() };
    let mut measurements: Vec<Measurement> = Vec::new();
    for subject in subjects::subjects(run.meshes) {
        let measured = || -> Result<Measurement, Cause> {
            let hulled = Hulled::new(&subject, subject.hull_vertices, progress)?;
            let baked = hulled.bake(options(extent.side.max(subject.least_side())), progress)?;
            let error = sampling::error_of(&hulled, &baked.texture, AzimuthRule::Aligned, progress)?;
            Ok(Measurement { frame_ms: frames(run, &baked, &extent)?, baked, error })
        };
        measurements.push(measured().map_err(PaperError::of::<Cause>(&subject.label))?);
    }
    let all: Vec<&Baked> = measurements.iter().map(|measurement| &measurement.baked).collect();
    let Some(&first) = all.first() else { return Err(Cause::NoMesh.into()) };
    let of_first = PaperError::of::<Cause>(&first.of.subject.label);
    let mut measured = Measured {
        setting: format!("{0} x {0} pixels, frames by all methods in turn in the same run", drawn::SIDE_PX),
        tables: vec![table_one::table_one(&gpu.adapter().name, &measurements)],
        ..Measured::default()
    };
    let figures = || -> Result<_, Cause> {
        let outlines = outlines::by_subject(gpu, &all, extent.views, progress)?;
        let sampling = sampling::measure(&first.of, options(extent.many_side), progress)?;
        let compressed = compressed::measure(gpu, first, extent.rounds, progress)?;
        let (hulls, pictures, mut notes) =
            outlines::by_hull(gpu, &first.of.subject, extent.views, options(extent.many_side), progress)?;
        let (resolution, left_out) = outlines::by_resolution(gpu, &first.of, extent.views, extent.side, progress)?;
        notes.extend(left_out);
        let magnified = magnified::measure(gpu, first, progress)?;
        let lines = lines::measure(gpu, first, extent.views, progress)?;
        Ok((vec![outlines, sampling, compressed, magnified, hulls, resolution, lines], pictures, notes))
    };
    let (tables, pictures, notes) = figures().map_err(of_first)?;
    measured.tables.extend(tables);
    measured.pictures = pictures;
    measured.notes = notes;
    #[cfg(feature = "simplify")]
    {
        let against_lod = against_lod::measure(gpu, &first.of.subject, extent.against_lod, progress);
        let (table, chart) = against_lod.map_err(of_first)?;
        measured.tables.push(table);
        measured.charts.push(chart);
    }
    for baked in &all {
        let label = &baked.of.subject.label;
        let distances = distances::measure(gpu, baked, extent.rounds, progress);
        measured.tables.push(distances.map_err(PaperError::of::<Cause>(label))?);
    }
    Ok(measured)
}

/// Frames of mesh and texture, in the paper's window.
fn frames(run: &Run<'_>, baked: &Baked, extent: &Extent) -> Result<[f64; 2], Cause> {
    let (gpu, progress, mesh) = (run.gpu()?, run.progress, baked.drawable());
    let [fine, texture]: [Entry; 2] = [Entry::of::<FineMesh>().fill().into(), Entry::of::<Texture>().fill().into()];
    let mut fine = drawing(gpu, &mesh, &fine, "", frame_style(1, Ground::Paper), progress)?;
    let mut texture = drawing(gpu, &mesh, &texture, "", frame_style(1, Ground::Paper), progress)?;
    timed::time(gpu, baked.of.subject.mesh.mesh(), [&mut fine, &mut texture], 1.0, extent.rounds, progress)
}
