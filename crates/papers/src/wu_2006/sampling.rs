//! Sections 3.2 and 3.3: what the definitions that the paper leaves open, and those it prints, cost in Eq. 3; and whether the
//! unsampled function is exact.

use super::baked::Hulled;
use crate::error::Cause;
use crate::table::{Cell, Column, Row, Table};
use silhouette_core::Progress;
use silhouette_texture::lookup::AzimuthRule;
use silhouette_texture::sampling_error::{ErrorOptions, SamplingError, sampling_error};
use silhouette_texture::{AngleFormat, BakeOptions, CenterRule, LobeRule, SilhouetteTexture, VisibilityFunction};

/// Eq. 3 of a texture.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn error_of(
    hulled: &Hulled,
    texture: &SilhouetteTexture,
    azimuths: AzimuthRule,
    progress: &dyn Progress,
) -> Result<SamplingError, Cause> {
    let visibility = VisibilityFunction::new(hulled.subject.mesh.mesh(), &hulled.hull, texture.parts().rule);
    let options = ErrorOptions { azimuths, ..ErrorOptions::default() };
    Ok(sampling_error(texture, &visibility, &options, progress)?)
}

/// Variants of one bake: their words, and what differs.
fn variants() -> [(&'static str, BakeOptions, AzimuthRule); 8] {
    let options = BakeOptions::default();
    let aligned = AzimuthRule::Aligned;
    [
        ("corrected, 8 bits", options, aligned),
        ("16-bit floats", BakeOptions { format: AngleFormat::Float16, ..options }, aligned),
        ("half a texel off, as printed", options, AzimuthRule::AsPrinted),
        (
            "own centres baked, interpolated ones drawn, as printed",
            BakeOptions { centers: CenterRule::AsPrinted, ..options },
            aligned,
        ),
        ("own centres baked and drawn", BakeOptions { centers: CenterRule::Texel, ..options }, aligned),
        ("first exit from the lobe", BakeOptions { lobe: LobeRule::FirstExit, ..options }, aligned),
        ("last exit from the lobe", BakeOptions { lobe: LobeRule::LastExit, ..options }, aligned),
        (
            "outer outlines alone (Eq. 1)",
            BakeOptions { rule: silhouette_texture::VisibilityRule::Exterior, ..options },
            aligned,
        ),
    ]
}

/// Bakes all variants.
///
/// # Errors
/// [`Cause`]: cancelled, or a size that does not fit the hull.
pub fn measure(hulled: &Hulled, options: BakeOptions, progress: &dyn Progress) -> Result<Table, Cause> {
    let mut rows = Vec::new();
    for (label, variant, azimuths) in variants() {
        let baked = hulled.bake(BakeOptions { size: options.size, ..variant }, progress)?;
        let SamplingError { mean, standard_error, excess, missing, shown } =
            error_of(hulled, &baked.texture, azimuths, progress)?;
        let shares = [mean, standard_error, excess, missing, shown];
        rows.push(Row::new(label, shares.map(|share| Cell::one(100.0 * share)).to_vec()));
    }
    let percent = |title, metric, meaning| Column { digits: 3, ..Column::new(title, metric, "%", meaning) };
    let size = options.size;
    Ok(Table {
        name: "Section 3.3, sampling",
        subject: hulled.subject.label.clone(),
        about: format!("Eq. 3 over the hull; {} x {} texels, {} azimuths", size.width, size.height, size.azimuths),
        columns: vec![
            percent("VF error", "sampling error", "directions in which texture and function differ, of the sphere"),
            percent("±", "standard error", "standard error of that mean"),
            percent("excess", "excess", "of it, directions that should not show the mesh"),
            percent("missing", "missing", "of it, directions that should"),
            percent("shown", "shown", "directions that show the mesh"),
        ],
        rows,
        ..Table::default()
    })
}
