//! Section 3.5 and Fig. 10: bytes, error and cost of a compressed texture, beside forms that the hardware filters.

use super::baked::Baked;
use super::drawn::frame_style;
use super::printed::{COMPRESSED_SLOWDOWN, TERMS};
use super::timed::time;
use crate::drawings::drawing;
use crate::error::Cause;
use crate::table::{Cell, Column, Comparable, Row, Table};
use silhouette_compare::drawing::Ground;
use silhouette_compare::registry::Entry;
use silhouette_core::Progress;
use silhouette_core::method::PrepareError;
use silhouette_render::Gpu;
use silhouette_texture::Texture;
use silhouette_texture::compression::{Form, compare};
use silhouette_texture::method::TextureError;

/// The forms in one table, by their bytes.
const FORMS: [Form; 9] = [
    Form::Float16,
    Form::Unorm8,
    Form::Blocks,
    Form::Azimuths(32),
    Form::Azimuths(16),
    Form::Azimuths(8),
    Form::Terms(16),
    Form::Terms(8),
    Form::Terms(4),
];

/// Measures one texture in all forms.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, baked: &Baked, rounds: u32, progress: &dyn Progress) -> Result<Table, Cause> {
    let used = baked.used()?;
    let forms =
        compare(&baked.texture, &FORMS, Some(&used)).map_err(|error| PrepareError::from(TextureError::from(error)))?;
    let entry: Entry = Entry::of::<Texture>().fill().into();
    let fine = baked.of.subject.mesh.mesh();
    let mut rows = Vec::new();
    for form in forms {
        progress.check()?;
        let terms = if let Form::Terms(terms) = form.form { Some(terms) } else { None };
        let words = if form.form == Form::Float16 { "filter=float16" } else { "" };
        let slowdown = match form.form {
            Form::Terms(_) | Form::Float16 => {
                let mesh = terms.map_or_else(|| Ok(baked.drawable()), |terms| baked.compressed(terms))?;
                let mut other = drawing(gpu, &mesh, &entry, words, frame_style(1, Ground::Paper), progress)?;
                let mut native = drawing(gpu, &baked.drawable(), &entry, "", frame_style(1, Ground::Paper), progress)?;
                let [other, native] = time(gpu, fine, [&mut other, &mut native], 1.0, rounds, progress)?;
                other / native
            }
            _ => f64::NAN,
        };
        let printed = TERMS.iter().find(|&&(count, _)| Some(count) == terms).map(|&(_, psnr_db)| psnr_db);
        let undefined = "the paper states neither the model nor the definition".to_owned();
        let slower = terms.map(|_| 0.5 * (COMPRESSED_SLOWDOWN[0] + COMPRESSED_SLOWDOWN[1]));
        rows.push(Row::new(
            form.form.to_string(),
            vec![
                Cell::one(form.bytes as f64 / f64::from(1 << 20)),
                Cell::one(form.psnr_db).beside(printed, Comparable::No(undefined)),
                Cell::one(slowdown).beside(slower, Comparable::No("the middle of 5 to 8, on another card".to_owned())),
            ],
        ));
    }
    Ok(Table {
        name: "Fig. 10, compression",
        subject: baked.of.subject.label.clone(),
        about: "PSNR of angles over the texels in use against those of 8 bits, with a peak of pi; a form without a time is not \
                drawn here"
            .to_owned(),
        columns: vec![
            Column::new("size", "bytes", "MiB", "bytes of all angles"),
            Column { digits: 1, ..Column::new("PSNR", "psnr", "dB", "of angles, peak pi") },
            Column::new("slower", "slowdown", "×", "frame time over that of 8 bits filtered by the hardware"),
        ],
        rows,
        ..Table::default()
    })
}
