//! Writes the pictures behind the tables as files, to look at them.

use crate::cell::{Aspect, Found};
use crate::matrix::aspects;
use crate::pictures::picture;
use crate::row::Row;
use crate::truth::Truth;
use silhouette_compare::registry::Registry;
use silhouette_gpu::PenPlacement;
use silhouette_render::{Gpu, Image};
use std::error::Error;
use std::path::Path;

/// Writes what each method draws at each extreme as `ROW-METHOD-ASPECT.png`, and beside it the truth as `ROW-truth-ASPECT.png`.
/// Yields what was refused, or has no truth, one line each.
///
/// # Errors
/// What the file system says.
pub fn write_pictures(gpu: &Gpu, rows: &[Row], folder: &Path) -> Result<Vec<String>, Box<dyn Error + Send + Sync>> {
    std::fs::create_dir_all(folder)?;
    let registry = Registry::builtin();
    let mut refused = Vec::new();
    for row in rows {
        let mut save = |what: &str, made: Result<Image, Found>| -> Result<(), Box<dyn Error + Send + Sync>> {
            match made {
                Ok(image) => image.save_png(&folder.join(format!("{}-{what}.png", file_stem(row.name))))?,
                Err(found) => refused.push(format!("{}, {what}: {}", row.name, found.text)),
            }
            Ok(())
        };
        let scene = match (row.scene)() {
            Ok(scene) => scene,
            Err(found) => {
                save("scene", Err(found))?;
                continue;
            }
        };
        let truth = Truth::new(&scene);
        let pen = truth.pen(PenPlacement::Centred);
        save("truth-lines", pen.map(|ink| ink.to_picture()).map_err(Found::fault))?;
        save("truth-fill", truth.fill(gpu).map(|fill| fill.image().clone()).map_err(Found::fault))?;
        for entry in registry.entries() {
            for aspect in aspects(entry).into_iter().filter(|aspect| aspect.is_drawn()) {
                let what = format!("{}-{}", entry.info().name, aspect.name());
                save(&what, picture(gpu, entry, &truth, aspect == Aspect::Fill))?;
            }
        }
    }
    Ok(refused)
}

/// The name of a row as part of a file name.
fn file_stem(name: &str) -> String {
    let kept = |letter: char| if letter.is_alphanumeric() || letter == '.' { letter } else { '-' };
    name.chars().map(kept).collect()
}
