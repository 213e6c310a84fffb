//! One view, or several on one page (`--views`).

use super::arguments::LinesArguments;
use super::{Shown, of_finding, of_plotting, quick, smooth};
use crate::failure::Failure;
use silhouette_core::glam::DVec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::ViewPreset;
use silhouette_core::{Camera, Progress};
use silhouette_visibility::plot::{self, Drawing, PlotOptions, SheetView};
use silhouette_visibility::{LineError, LineFinder, LineOptions, Lines, Outline};
use std::time::{Duration, Instant};

/// The views that are drawn.
pub struct Views {
    cameras: Vec<Camera>,
    /// What each shows, where there are several.
    presets: Option<Vec<ViewPreset>>,
}

impl Views {
    /// The views that are asked for.
    pub fn of(arguments: &LinesArguments, bounds: &Bounds, origin: DVec3) -> Result<Self, Failure> {
        match &arguments.views.views {
            None => Ok(Self { cameras: vec![arguments.camera.camera(bounds, origin)?], presets: None }),
            Some(views) => {
                let cameras = arguments.camera.cameras(&views.0, bounds, origin)?;
                Ok(Self { cameras, presets: Some(views.0.clone()) })
            }
        }
    }

    pub fn cameras(&self) -> &[Camera] {
        &self.cameras
    }

    /// The lines of each view, and the time that preparing took. What `plots` needs is found besides what is wanted.
    pub fn find(
        &self,
        shown: &Shown,
        arguments: &LinesArguments,
        plots: bool,
        progress: &dyn Progress,
    ) -> Result<(Duration, Vec<Lines>), Failure> {
        let started = Instant::now();
        let wanted = arguments.line_options();
        // Of masks the outline shows nothing.
        let outline = if wanted.outline { shown.drawn.clone() } else { None };
        let mut outline = outline.map(|drawn| LineFinder::new(drawn, progress)).transpose()?;
        let mut finder: Option<LineFinder> = None;
        let mut prepare = Duration::ZERO;
        let mut all = Vec::new();
        for camera in &self.cameras {
            let mut wanted = wanted.clone();
            wanted.outline &= outline.is_none();
            let scene = if arguments.smooth {
                let surfaces;
                (surfaces, wanted) = smooth::scene(&shown.meshes, camera, &wanted, progress)?;
                let is_mask = shown.parts.masked_files(&shown.meshes)?;
                let curves =
                    surfaces.curves().iter().filter(|curve| !is_mask[curve.object as usize]).cloned().collect();
                surfaces.with_curves(curves).map_err(Failure::input)?
            } else {
                shown.masked_scene()?
            };
            let mut lines = if arguments.quick {
                let (prepared, lines) = quick::find(&scene, &shown.names, camera, &wanted, progress)?;
                prepare += prepared;
                lines
            } else {
                let kept = finder.take().filter(|_| !arguments.smooth);
                let mut ready = kept.map_or_else(|| LineFinder::new(scene, progress), Ok)?;
                if all.is_empty() {
                    prepare = started.elapsed();
                }
                let found = find(&mut ready, camera, &wanted, plots && arguments.bridges_gaps(), progress);
                finder = Some(ready);
                found.map_err(|error| of_finding(&shown.names, error))?
            };
            if let Some(finder) = &mut outline {
                let found: Result<Outline, _> = finder.outline(camera, progress);
                lines.outline = found.map_err(|error| of_finding(&shown.names, error))?;
            }
            all.push(lines);
        }
        Ok((prepare, all))
    }

    /// The lines as strokes on a page.
    pub fn plot(
        &self,
        lines: &[Lines],
        arguments: &LinesArguments,
        options: &PlotOptions,
        progress: &dyn Progress,
    ) -> Result<Drawing, Failure> {
        let Some(presets) = &self.presets else { return plot::plot(&lines[0], options, progress).map_err(of_plotting) };
        let views = presets.iter().zip(lines).map(|(&preset, lines)| SheetView { preset, lines });
        let views: Vec<SheetView<'_>> = views.collect();
        plot::plot_views(&views, arguments.views.angle(), options, progress).map_err(of_plotting)
    }
}

/// The lines of a view, with what hides just behind one layer where gaps are to be bridged, unless that is too much.
fn find(
    finder: &mut LineFinder,
    camera: &Camera,
    wanted: &LineOptions,
    bridges_gaps: bool,
    progress: &dyn Progress,
) -> Result<Lines, LineError> {
    if bridges_gaps && wanted.max_invisibility == 0 {
        let deeper = LineOptions { max_invisibility: 1, ..wanted.clone() };
        match finder.find(camera, &deeper, progress) {
            Err(LineError::TooManyPieces) => {}
            found => return found,
        }
    }
    finder.find(camera, wanted, progress)
}
