//! The camera options that every command shares.

use crate::failure::Failure;
use clap::{Args, Parser};
use glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, Framing, Projection, ViewPreset, Viewpoint};

/// Field of view where none is given.
const DEFAULT_FOV_DEG: f64 = 40.0;

/// From where the mesh is seen. Default: a three-quarter view that frames the mesh.
#[derive(Debug, Clone, PartialEq, Args)]
#[command(next_help_heading = "Camera")]
pub struct CameraArguments {
    /// Where the eye is, in the mesh's own coordinates; by default as far along --view as the mesh needs to fit
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = vector)]
    eye: Option<Vec3>,
    /// The point looked at [default: the middle of the mesh]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = vector)]
    target: Option<Vec3>,
    /// The direction that points up in the picture [default: 0,1,0]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = vector)]
    up: Option<Vec3>,
    /// Vertical field of view in degrees [default: 40]
    #[arg(long, value_name = "DEG", value_parser = field_of_view, conflicts_with = "ortho")]
    fov: Option<f64>,
    /// Orthographic view of this height in the mesh's units, or 'fit'
    #[arg(long, value_name = "HEIGHT", value_parser = ortho_height)]
    ortho: Option<OrthoHeight>,
    /// A named view, used where no --eye is given
    #[arg(long, value_name = "NAME", default_value = "three-quarter", value_parser = preset, conflicts_with = "eye")]
    view: ViewPreset,
    /// Size of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x1024", value_parser = size)]
    size: [u32; 2],
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum OrthoHeight {
    Fit,
    Units(f64),
}

/// A command line without options.
#[derive(Debug, Parser)]
struct NoOptions {
    #[command(flatten)]
    camera: CameraArguments,
}

impl CameraArguments {
    /// Whether no option says anything but what it is without them.
    pub fn is_default(&self) -> bool {
        *self == NoOptions::parse_from([""]).camera
    }

    /// The camera for a mesh with these bounds.
    pub fn camera(&self, bounds: &Bounds) -> Result<Camera, Failure> {
        let fov_y_rad = self.fov.unwrap_or(DEFAULT_FOV_DEG).to_radians();
        let framing = match self.ortho {
            Some(_) => Framing::Orthographic,
            None => Framing::Perspective { fov_y_rad },
        };
        let framed = |direction: DVec3, up| Camera::framing(bounds, direction, up, framing, self.size);
        let (preset_direction, preset_up) = self.view.directions();
        let fitted = framed(preset_direction, preset_up)?;
        let projection = match self.ortho {
            Some(OrthoHeight::Units(height)) => Projection::Orthographic { height },
            _ => fitted.projection(),
        };
        let target = self.target.unwrap_or(fitted.target());
        let eye = match self.eye {
            Some(eye) => eye,
            None => fitted.eye() + (target - fitted.target()),
        };
        // The middle of the mesh is only a default: an eye exactly there looks along -z instead.
        let target = if eye == target && self.target.is_none() { target - Vec3::Z } else { target };
        let up = self.up.unwrap_or_else(|| self.default_up(preset_up, target - eye));
        Ok(Camera::new(eye, target, up, projection, self.size)?)
    }

    /// What facing depends on. Unlike a camera, an eye on the target is no obstacle.
    pub fn viewpoint(&self, bounds: &Bounds) -> Result<Viewpoint, Failure> {
        match (self.eye, self.ortho) {
            (Some(eye), None) => Ok(Viewpoint::Perspective { eye }),
            _ => Ok(self.camera(bounds)?.viewpoint()),
        }
    }

    /// The preset's up, or z where an eye of the user's own looks along it.
    fn default_up(&self, preset_up: Vec3, forward: Vec3) -> Vec3 {
        let along = forward.normalize_or_zero().cross(preset_up).length_squared() < 1e-6;
        if self.eye.is_some() && along { Vec3::NEG_Z } else { preset_up }
    }
}

/// Three finite numbers separated by commas.
fn vector(text: &str) -> Result<Vec3, String> {
    let numbers: Vec<f32> = text
        .split(',')
        .map(|number| number.trim().parse().ok().filter(|value: &f32| value.is_finite()))
        .collect::<Option<_>>()
        .ok_or("expected three numbers such as 1,2.5,-3")?;
    <[f32; 3]>::try_from(numbers).map(Vec3::from).map_err(|_| "expected three numbers such as 1,2.5,-3".to_owned())
}

fn field_of_view(text: &str) -> Result<f64, String> {
    let degrees = text.parse().ok().filter(|&degrees: &f64| degrees > 0.0 && degrees < 180.0);
    degrees.ok_or_else(|| "expected a field of view above 0 and below 180 degrees".to_owned())
}

fn ortho_height(text: &str) -> Result<OrthoHeight, String> {
    match text {
        "fit" => Ok(OrthoHeight::Fit),
        number => {
            number.parse().map(OrthoHeight::Units).map_err(|_| "expected a height such as 2.5, or 'fit'".to_owned())
        }
    }
}

fn preset(text: &str) -> Result<ViewPreset, String> {
    let known = || ViewPreset::NAMED.map(|(name, _)| name).join(", ");
    let found = ViewPreset::NAMED.iter().find(|(name, _)| *name == text);
    found.map(|&(_, preset)| preset).ok_or_else(|| format!("expected one of {}", known()))
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides.ok_or_else(|| "expected width and height such as 1024x768".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::{Arguments, Command};
    use clap::Parser;

    fn parse(options: &[&str]) -> CameraArguments {
        let words = ["silhouettes", "extract", "builtin:cube"].iter().chain(options);
        match Arguments::try_parse_from(words).unwrap().command {
            Command::Extract(arguments) => arguments.camera,
            other => panic!("{other:?}"),
        }
    }

    const BOUNDS: Bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.8 };

    #[test]
    fn the_eye_decides_the_viewpoint_even_on_the_target() {
        let arguments = parse(&["--eye", "-1,2.5,0"]);
        assert_eq!(arguments.viewpoint(&BOUNDS).unwrap(), Viewpoint::Perspective { eye: Vec3::new(-1.0, 2.5, 0.0) });
        assert_eq!(parse(&["--eye", "0,0,0"]).viewpoint(&BOUNDS).unwrap(), Viewpoint::Perspective { eye: Vec3::ZERO });
        assert!(parse(&["--eye", "0,0,0"]).camera(&BOUNDS).is_ok());
        assert!(parse(&["--eye", "0,9,0"]).camera(&BOUNDS).is_ok(), "looks along the default up");
        assert!(parse(&["--eye", "0,9,0", "--target", "0,9,0"]).camera(&BOUNDS).is_err());
    }

    #[test]
    fn orthographic_views_point_towards_the_viewer() {
        let arguments = parse(&["--ortho", "3", "--view", "top"]);
        let Viewpoint::Orthographic { toward_viewer } = arguments.viewpoint(&BOUNDS).unwrap() else { panic!() };
        assert!(toward_viewer.normalize().distance(Vec3::Y) < 1e-6);
        assert_eq!(arguments.camera(&BOUNDS).unwrap().projection(), Projection::Orthographic { height: 3.0 });
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        for bad in ["1,2", "1,2,3,4", "a,b,c", "1,2,inf", ""] {
            assert!(vector(bad).is_err(), "{bad}");
        }
        assert!(
            size("12").is_err() && size("ax2").is_err() && preset("sideways").is_err() && ortho_height("x").is_err()
        );
    }
}
