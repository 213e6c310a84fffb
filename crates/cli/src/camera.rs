//! The camera options that every command shares.

use crate::PROGRAM;
use crate::failure::{Failure, usage};
use clap::{Args, Parser, ValueEnum};
use glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, Framing, Projection, UpAxis, ViewPreset, Viewpoint};

/// Field of view where none is given.
const DEFAULT_FOV_DEG: f64 = 40.0;

/// From where the mesh is seen. Default: a three-quarter view that frames the mesh.
#[derive(Debug, Clone, PartialEq, Args)]
#[command(next_help_heading = "Camera")]
pub struct CameraArguments {
    /// Where the eye is, in the coordinates of the mesh's file; by default as far along --view as the mesh needs to fit. Beside --view
    /// it says how far away that view is
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    eye: Option<DVec3>,
    /// The point looked at [default: the middle of the mesh]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    target: Option<DVec3>,
    /// The direction that points up in the picture [default: the view's, or the --up-axis]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = vector)]
    up: Option<Vec3>,
    /// Vertical field of view in degrees [default: 40]
    #[arg(long, value_name = "DEG", value_parser = field_of_view, conflicts_with = "ortho")]
    fov: Option<f64>,
    /// Orthographic view of this height in the mesh's units, or 'fit'
    #[arg(long, value_name = "HEIGHT", value_parser = ortho_height)]
    ortho: Option<OrthoHeight>,
    /// A named view: three-quarter, front, back, left, right, top, bottom, iso [default: three-quarter]
    #[arg(long, value_name = "NAME", value_parser = preset)]
    view: Option<ViewPreset>,
    /// Which axis of the mesh points up in named views: z for most CAD, surveying and printing
    #[arg(long, value_enum, value_name = "AXIS", default_value_t = UpAxisArgument::Y)]
    up_axis: UpAxisArgument,
    /// Size of the picture in pixels, or the side of a square one
    #[arg(long, value_name = "WxH", default_value = "1024x1024", value_parser = size)]
    size: [u32; 2],
}

/// Which axis points up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum UpAxisArgument {
    /// Front views are from +z
    Y,
    /// Front views are from -y
    Z,
}

impl From<UpAxisArgument> for UpAxis {
    fn from(argument: UpAxisArgument) -> Self {
        match argument {
            UpAxisArgument::Y => Self::Y,
            UpAxisArgument::Z => Self::Z,
        }
    }
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
    /// The options that words stand for, as on the command line.
    ///
    /// # Errors
    /// [`Failure::Input`] says which word does not fit.
    pub fn of_words<'a>(words: impl IntoIterator<Item = &'a str>) -> Result<Self, Failure> {
        let parsed = NoOptions::try_parse_from(std::iter::once("").chain(words));
        Ok(parsed.map_err(|error| usage(&error, PROGRAM))?.camera)
    }

    /// The same for a picture of another size, in pixels.
    #[must_use]
    pub fn with_size(&self, size: [u32; 2]) -> Self {
        Self { size, ..self.clone() }
    }

    /// The vertical field of view in degrees, where one is given.
    pub fn fov_deg(&self) -> Option<f64> {
        self.fov
    }

    /// Which axis points up in named views.
    pub fn up_axis(&self) -> UpAxis {
        self.up_axis.into()
    }

    /// Width and height of the picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Whether no option says anything but what it is without them.
    pub fn is_default(&self) -> bool {
        *self == NoOptions::parse_from([""]).camera
    }

    /// The camera for a mesh with these bounds, all of which count from `origin`.
    ///
    /// # Errors
    /// [`Failure::Input`]: the options do not make a camera.
    pub fn camera(&self, bounds: &Bounds, origin: DVec3) -> Result<Camera, Failure> {
        let [eye, target] = [self.eye, self.target].map(|point| point.map(|point| (point - origin).as_vec3()));
        let fov_y_rad = self.fov.unwrap_or(DEFAULT_FOV_DEG).to_radians();
        let framing = match self.ortho {
            Some(_) => Framing::Orthographic,
            None => Framing::Perspective { fov_y_rad },
        };
        let framed = |direction: DVec3, up| Camera::framing(bounds, direction, up, framing, self.size);
        let (preset_direction, preset_up) = self.view.unwrap_or_default().directions_with(self.up_axis.into());
        let fitted = framed(preset_direction, preset_up)?;
        let projection = match self.ortho {
            Some(OrthoHeight::Units(height)) => Projection::Orthographic { height },
            _ => fitted.projection(),
        };
        let looked_at = target.unwrap_or(fitted.target());
        let eye = match (eye, self.view) {
            (Some(eye), Some(_)) => {
                let distance = eye.as_dvec3().distance(looked_at.as_dvec3());
                (looked_at.as_dvec3() + distance * preset_direction.normalize()).as_vec3()
            }
            (Some(eye), None) => eye,
            (None, _) => fitted.eye() + (looked_at - fitted.target()),
        };
        // The middle of the mesh is only a default: an eye exactly there looks along -z instead.
        let target = if eye == looked_at && target.is_none() { looked_at - Vec3::Z } else { looked_at };
        let forward = target.as_dvec3() - eye.as_dvec3();
        let up = self.up.unwrap_or_else(|| self.default_up(preset_up, forward));
        if self.up.is_some() && self.eye.is_none() && is_along(forward, up) {
            let mend = "name another, or say --up-axis z for a mesh whose z points up";
            return Err(Failure::Input(format!("camera: --up is the direction that the view looks along; {mend}")));
        }
        Ok(Camera::new(eye, target, up, projection, self.size)?)
    }

    /// Cameras for several named views of a mesh with these bounds: orthographic, of one scale, which look at its middle.
    ///
    /// # Errors
    /// As [`camera`](Self::camera).
    pub fn cameras(&self, views: &[ViewPreset], bounds: &Bounds, origin: DVec3) -> Result<Vec<Camera>, Failure> {
        let ortho = self.ortho.or(Some(OrthoHeight::Fit));
        views.iter().map(|&view| Self { view: Some(view), ortho, ..self.clone() }.camera(bounds, origin)).collect()
    }

    /// What facing depends on. Unlike a camera, an eye on the target is no obstacle.
    ///
    /// # Errors
    /// As [`camera`](Self::camera).
    pub fn viewpoint(&self, bounds: &Bounds, origin: DVec3) -> Result<Viewpoint, Failure> {
        match (self.eye.filter(|_| self.view.is_none()), self.ortho) {
            (Some(eye), None) => Ok(Viewpoint::Perspective { eye: (eye - origin).as_vec3() }),
            _ => Ok(self.camera(bounds, origin)?.viewpoint()),
        }
    }

    /// The preset's up, or that of a view from above where an eye of the user's own looks along it.
    fn default_up(&self, preset_up: Vec3, forward: DVec3) -> Vec3 {
        let from_above = ViewPreset::Top.directions_with(self.up_axis.into()).1;
        if self.eye.is_some() && is_along(forward, preset_up) { from_above } else { preset_up }
    }
}

/// Whether two directions are the same or opposite. In 64 bits: the square of a distance may not fit 32.
fn is_along(forward: DVec3, up: Vec3) -> bool {
    forward.normalize_or_zero().cross(up.as_dvec3().normalize_or_zero()).length_squared() < 1e-6
}

fn vector(text: &str) -> Result<Vec3, String> {
    Ok(point(text)?.as_vec3())
}

/// Three numbers separated by commas, finite in 32 bits.
fn point(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|number| number.trim().parse().ok().filter(|&value: &f64| (value as f32).is_finite()))
        .collect::<Option<_>>()
        .ok_or("expected three numbers such as 1,2.5,-3")?;
    <[f64; 3]>::try_from(numbers).map(DVec3::from).map_err(|_| "expected three numbers such as 1,2.5,-3".to_owned())
}

fn field_of_view(text: &str) -> Result<f64, String> {
    let degrees = text.parse().ok().filter(|&degrees: &f64| degrees > 0.0 && degrees < 180.0);
    degrees.ok_or_else(|| "expected a field of view above 0 and below 180 degrees".to_owned())
}

fn ortho_height(text: &str) -> Result<OrthoHeight, String> {
    match text {
        "fit" => Ok(OrthoHeight::Fit),
        number => {
            let height = number.parse().ok().filter(|&height: &f64| height.is_finite() && height > 0.0);
            let expected = "expected a height above 0 in units of the mesh, such as 2.5, or 'fit'";
            height.map(OrthoHeight::Units).ok_or_else(|| expected.to_owned())
        }
    }
}

fn preset(text: &str) -> Result<ViewPreset, String> {
    let known = || ViewPreset::NAMED.map(|(name, _)| name).join(", ");
    let found = ViewPreset::NAMED.iter().find(|(name, _)| *name == text);
    found.map(|&(_, preset)| preset).ok_or_else(|| format!("expected one of {}", known()))
}

/// A size in pixels, or the side of a square one.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let (width, height) = text.split_once(['x', 'X']).unwrap_or((text, text));
    let sides = width.parse().ok().zip(height.parse().ok()).map(|(width, height)| [width, height]);
    sides.ok_or_else(|| "expected width and height such as 1024x768, or one side such as 800".to_owned())
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
        assert_eq!(
            arguments.viewpoint(&BOUNDS, DVec3::ZERO).unwrap(),
            Viewpoint::Perspective { eye: Vec3::new(-1.0, 2.5, 0.0) }
        );
        assert_eq!(
            parse(&["--eye", "0,0,0"]).viewpoint(&BOUNDS, DVec3::ZERO).unwrap(),
            Viewpoint::Perspective { eye: Vec3::ZERO }
        );
        assert!(parse(&["--eye", "0,0,0"]).camera(&BOUNDS, DVec3::ZERO).is_ok());
        assert!(parse(&["--eye", "0,9,0"]).camera(&BOUNDS, DVec3::ZERO).is_ok(), "looks along the default up");
        assert!(parse(&["--eye", "0,9,0", "--target", "0,9,0"]).camera(&BOUNDS, DVec3::ZERO).is_err());
    }

    #[test]
    fn eyes_as_far_as_numbers_reach_are_cameras() {
        for eye in ["0,0,1e20", "0,0,-1e38", "1e30,0,0", "0,0,1e-30", "0,1e25,0", "1e38,1e38,1e38"] {
            let camera = parse(&["--eye", eye]).camera(&BOUNDS, DVec3::ZERO);
            assert!(camera.is_ok(), "{eye}: {camera:?}");
            assert!(parse(&["--eye", eye, "--view", "front"]).camera(&BOUNDS, DVec3::ZERO).is_ok(), "{eye}");
        }
    }

    #[test]
    fn orthographic_views_point_towards_the_viewer() {
        let arguments = parse(&["--ortho", "3", "--view", "top"]);
        let Viewpoint::Orthographic { toward_viewer } = arguments.viewpoint(&BOUNDS, DVec3::ZERO).unwrap() else {
            panic!()
        };
        assert!(toward_viewer.normalize().distance(Vec3::Y) < 1e-6);
        assert_eq!(
            arguments.camera(&BOUNDS, DVec3::ZERO).unwrap().projection(),
            Projection::Orthographic { height: 3.0 }
        );
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        for bad in ["1,2", "1,2,3,4", "a,b,c", "1,2,inf", ""] {
            assert!(vector(bad).is_err(), "{bad}");
        }
        assert!(
            size("12x").is_err() && size("ax2").is_err() && preset("sideways").is_err() && ortho_height("x").is_err()
        );
        assert!(ortho_height("-1").is_err() && ortho_height("0").is_err() && ortho_height("inf").is_err());
        assert_eq!((size("800"), size("640x480")), (Ok([800, 800]), Ok([640, 480])));
    }

    #[test]
    fn views_of_a_mesh_with_z_up_are_cad_s() {
        let front = parse(&["--view", "front", "--up-axis", "z"]).camera(&BOUNDS, DVec3::ZERO).unwrap();
        assert!(front.eye().normalize().distance(Vec3::NEG_Y) < 1e-6 && front.up() == Vec3::Z);
        assert!(parse(&["--eye", "0,0,9", "--up-axis", "z"]).camera(&BOUNDS, DVec3::ZERO).is_ok(), "looks along z");
        let Err(Failure::Input(message)) = parse(&["--view", "front", "--up", "0,0,1"]).camera(&BOUNDS, DVec3::ZERO)
        else {
            panic!("the view looks along z")
        };
        assert!(message.contains("--up-axis z"), "{message}");
    }

    #[test]
    fn an_eye_beside_a_view_is_its_distance() {
        let camera = parse(&["--view", "left", "--eye", "0,0,7"]).camera(&BOUNDS, DVec3::ZERO).unwrap();
        assert!(camera.eye().distance(Vec3::new(-7.0, 0.0, 0.0)) < 1e-5, "{camera:?}");
    }
}
