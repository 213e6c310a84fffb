//! The equations as printed and corrected, measured: one table each.

use super::measure::MeshResult;
use super::outlines::{self, DISTANCES, LEVELS, OUTLINES};
use super::sampled::{ARCS_DEG, sampled};
use super::tangents::{RATIOS, errors_deg};
use super::{cells, lowered, residuals, rows};
use crate::error::Cause;
use crate::table::Table;
use silhouette_core::Progress;
use silhouette_smoothing::perturbation::Perturbation;
use silhouette_smoothing::sampling::Sampling;
use silhouette_smoothing::vertex_visibility::Cells;

/// Outlines of spheres first, then the equations in the order of the paper. Some seconds.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn measure(meshes: &[MeshResult], progress: &dyn Progress) -> Result<Vec<Table>, Cause> {
    progress.stage("equations", 6);
    let mut spheres = Vec::new();
    for level in LEVELS {
        let mut of_level = Vec::new();
        for (_, outline) in OUTLINES {
            let mut errors = [0.0; 3];
            for (error, distance) in errors.iter_mut().zip(DISTANCES) {
                *error = outlines::worst(level, outline, distance, progress)?;
            }
            of_level.push(errors);
        }
        spheres.push(of_level);
    }
    progress.advance(1);
    let tangents = RATIOS.map(|ratio| errors_deg(ratio, progress)).into_iter().collect::<Result<Vec<_>, _>>()?;
    progress.advance(1);
    let mut normals = Vec::new();
    for distance in residuals::DISTANCES {
        let mut worst_deg = [0.0; 5];
        for (worst, steps) in worst_deg.iter_mut().zip(residuals::STEPS) {
            *worst = residuals::worst_deg(distance, steps)?;
        }
        normals.push(worst_deg);
    }
    progress.advance(1);
    let arcs = ARCS_DEG.map(|arc| [Sampling::AsPrinted, Sampling::Guaranteed].map(|law| sampled(arc, law)));
    progress.advance(1);
    let wrong = [Cells::AsPrinted, Cells::Gnomonic].map(|cells| cells::wrong_per_million(cells, progress));
    let [printed, gnomonic] = wrong;
    progress.advance(1);
    let mut perturbed = Vec::new();
    for mesh in meshes.iter().filter(|mesh| mesh.subject.copies > 1) {
        for (law, word) in [(Perturbation::AsPrinted, "as printed"), (Perturbation::Lowered, "corrected")] {
            let result = lowered::measure(&mesh.subject, &mesh.window, law, progress)?;
            perturbed.push((format!("{}, {word}", mesh.subject.label), result));
        }
    }
    progress.advance(1);
    Ok(vec![
        rows::outlines(&spheres),
        rows::tangents(&tangents),
        rows::residuals(&normals),
        rows::sampled(&arcs),
        rows::wrong_cells([printed?, gnomonic?]),
        rows::lowered(&perturbed),
    ])
}
