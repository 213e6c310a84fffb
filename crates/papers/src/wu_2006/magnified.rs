//! Fig. 12: outlines where texels are far apart in the picture.

use super::baked::Baked;
use super::drawn::{SIDE_PX, camera, frame_style};
use crate::drawings::drawing;
use crate::error::Cause;
use crate::table::{Cell, Column, Row, Table};
use silhouette_compare::drawing::Ground;
use silhouette_compare::metrics::{FilledPicture, measure_fill};
use silhouette_compare::registry::Entry;
use silhouette_compare::truth::fill::FillTruth;
use silhouette_core::glam::DVec3;
use silhouette_core::view::{Camera, Projection, ViewPreset};
use silhouette_core::{Progress, TriangleMesh};
use silhouette_render::Gpu;
use silhouette_texture::Texture;

/// Pixels between texels of the hull.
const SPACINGS_PX: [f64; 5] = [1.0, 2.0, 5.0, 10.0, 20.0];

/// Outlines in windows around a point of the silhouette, smaller and smaller, so that the texels of `baked` come to lie farther
/// and farther apart.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, baked: &Baked, progress: &dyn Progress) -> Result<Table, Cause> {
    let fine = baked.of.subject.mesh.mesh();
    let entry: Entry = Entry::of::<Texture>().fill().into();
    let style = frame_style(4, Ground::Transparent);
    let mut texture = drawing(gpu, &baked.drawable(), &entry, "edge=coverage", style, progress)?;
    let mut truth = FillTruth::new(gpu, fine)?;
    let spacing = spacing(baked)?;
    let mut rows = Vec::new();
    for spacing_px in SPACINGS_PX {
        progress.check()?;
        let camera = window(fine, spacing, spacing_px)?;
        texture.draw(gpu, &camera)?;
        let metrics = measure_fill(&FilledPicture::new(texture.picture(gpu)?), &truth.find(gpu, &camera)?);
        let outline_px = metrics.boundary_chamfer_px;
        let cells = [spacing_px, outline_px, outline_px / spacing_px, 100.0 * metrics.xor_share].map(Cell::one);
        rows.push(Row::new(format!("{spacing_px:.0} pixels between texels"), cells.to_vec()));
    }
    let size = baked.texture.parts().size;
    Ok(Table {
        name: "Fig. 12, texels far apart",
        subject: baked.of.subject.label.clone(),
        about: format!("{} x {} texels, one view through smaller and smaller windows", size.width, size.height),
        columns: vec![
            Column {
                digits: 0,
                ..Column::new("spacing", "texel spacing", "px", "distance of texels on the hull in the picture")
            },
            Column::new("outline", "outline", "px", "mean distance of the outlines of texture and fine mesh"),
            Column::new("outline / spacing", "outline over spacing", "×", "the same over the distance of texels"),
            Column::new(
                "wrong area",
                "wrong area",
                "%",
                "area covered by one of texture and mesh alone, of that of the mesh",
            ),
        ],
        rows,
        ..Table::default()
    })
}

/// The distance of texels on the hull: the side of a square of a texel's mean area.
fn spacing(baked: &Baked) -> Result<f64, Cause> {
    let hull = baked.of.hull.mesh();
    let area: f64 = hull
        .triangles()
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| hull.positions()[vertex as usize].as_dvec3());
            0.5 * (b - a).cross(c - a).length()
        })
        .sum();
    let texels = baked.used()?.into_iter().filter(|&used| used).count();
    Ok((area / texels as f64).sqrt())
}

/// A view of the uppermost point of the mesh in the usual view, which is on its silhouette, through a window in which `spacing` takes so
/// many pixels.
fn window(fine: &TriangleMesh, spacing: f64, spacing_px: f64) -> Result<Camera, Cause> {
    let usual = camera(fine, ViewPreset::default().directions().0)?;
    let height = |position: DVec3| usual.project(position).map_or(f64::INFINITY, |projected| projected.pixel.y);
    let positions = || fine.positions().iter().map(|position| position.as_dvec3());
    let top = positions().min_by(|a, b| height(*a).total_cmp(&height(*b))).ok_or(Cause::EmptyMesh)?;
    let distance = usual.eye().as_dvec3().distance(top);
    let half_height = 0.5 * f64::from(SIDE_PX) * spacing / spacing_px;
    let projection = Projection::Perspective { fov_y_rad: 2.0 * (half_height / distance).atan() };
    Ok(Camera::new(usual.eye(), top.as_vec3(), usual.up(), projection, [SIDE_PX; 2])?)
}
