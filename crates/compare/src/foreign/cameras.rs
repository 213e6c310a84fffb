//! [`CamerasDocument`]: the cameras of the scored frames, as another program sets them up.

use super::views::ScoredView;
use glam::{DMat4, DVec3};
use serde::Serialize;
use silhouette_core::TriangleMesh;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{DepthDirection, Projection};

/// The cameras of the scored frames of a mesh. All coordinates are those of the mesh's file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CamerasDocument {
    /// The mesh.
    pub mesh: CameraMesh,
    /// Width of the pen that lines are drawn with, in pixels.
    pub pen_width_px: f64,
    /// The scored frames, ascending.
    pub views: Vec<CameraDocument>,
}

/// The mesh that cameras look at.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CameraMesh {
    /// Its name, usually that of its file.
    pub name: String,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
}

/// A matrix as rows, for column vectors: a point is transformed by matrix times point.
pub type Rows = [[f64; 4]; 4];

/// A camera. It looks along -z of its own coordinates, y up, x to the right: the convention of OpenGL and of Blender.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CameraDocument {
    /// The number of the frame: `--frame` of its file.
    pub frame: u32,
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// Where it is.
    pub eye: DVec3,
    /// What it looks at.
    pub target: DVec3,
    /// The direction to the top of the picture.
    pub up: DVec3,
    /// Vertical field of view in degrees, for a perspective.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fov_y_deg: Option<f64>,
    /// The same as a focal length in pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub focal_px: Option<f64>,
    /// The same as a focal length in millimetres, for a sensor 24 mm high.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub focal_mm: Option<f64>,
    /// Units from the top to the bottom of the picture, for a parallel projection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ortho_height: Option<f64>,
    /// Depths between which the mesh lies.
    pub near: f64,
    /// See `near`.
    pub far: f64,
    /// From the camera's coordinates to those of the mesh: `matrix_world` of a camera in Blender.
    pub camera_to_world: Rows,
    /// From the coordinates of the mesh to those of the camera.
    pub world_to_camera: Rows,
    /// From the coordinates of the mesh to pixels: x and y of the product over its w are those of the picture, origin at its top left,
    /// y down, centres of pixels at .5; z over w is 0 at `near` and 1 at `far`.
    pub world_to_pixels: Rows,
}

/// Height of the sensor that `focal_mm` is for: Blender's, for cameras fitted vertically.
const SENSOR_MM: f64 = 24.0;

impl CamerasDocument {
    /// The cameras of views of a mesh with these bounds.
    pub fn new(name: &str, mesh: &TriangleMesh, bounds: &Bounds, views: &[ScoredView], pen_width_px: f64) -> Self {
        Self {
            mesh: CameraMesh { name: name.to_owned(), vertices: mesh.vertex_count(), triangles: mesh.face_count() },
            pen_width_px,
            views: views.iter().map(|view| camera(view, mesh, bounds)).collect(),
        }
    }
}

fn camera(&ScoredView { frame, camera }: &ScoredView, mesh: &TriangleMesh, bounds: &Bounds) -> CameraDocument {
    let size = camera.size();
    let [width, height] = size.map(f64::from);
    let fov_y_rad =
        if let Projection::Perspective { fov_y_rad } = camera.projection() { Some(fov_y_rad) } else { None };
    let half = fov_y_rad.map(|fov_y_rad| (fov_y_rad * 0.5).tan());
    let ortho_height = if let Projection::Orthographic { height } = camera.projection() { Some(height) } else { None };
    let range = camera.clip_range(bounds);
    // Positions of a mesh far from zero count from its origin; in files they do not.
    let from_file = DMat4::from_translation(-mesh.origin());
    let world_to_camera = camera.view_matrix() * from_file;
    let to_clip = camera.world_to_clip(range, DepthDirection::Standard) * from_file;
    let to_pixels = DMat4::from_translation(DVec3::new(width * 0.5, height * 0.5, 0.0))
        * DMat4::from_scale(DVec3::new(width * 0.5, -height * 0.5, 1.0));
    CameraDocument {
        frame,
        size,
        eye: mesh.in_file(camera.eye()),
        target: mesh.in_file(camera.target()),
        up: camera.up().as_dvec3(),
        fov_y_deg: fov_y_rad.map(f64::to_degrees),
        focal_px: half.map(|half| height * 0.5 / half),
        focal_mm: half.map(|half| SENSOR_MM * 0.5 / half),
        ortho_height,
        near: range.near,
        far: range.far,
        camera_to_world: rows(world_to_camera.inverse()),
        world_to_camera: rows(world_to_camera),
        world_to_pixels: rows(to_pixels * to_clip),
    }
}

fn rows(matrix: DMat4) -> Rows {
    // Adding 0 makes a zero of a negative one.
    matrix.transpose().to_cols_array_2d().map(|row| row.map(|value| value + 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Profile;
    use glam::DVec4;
    use silhouette_core::shapes;

    fn documents(ortho: bool) -> (TriangleMesh, Vec<ScoredView>, CamerasDocument) {
        let mut scene = Profile::Quick.scene();
        if ortho {
            (scene.path.projection, scene.path.fov_deg) = (crate::scene::model::ProjectionKind::Orthographic, None);
        }
        (scene.picture.width, scene.picture.height) = (300, 200);
        let origin = DVec3::new(1e6, -2e6, 3e6);
        let mesh = shapes::by_name("torus").unwrap().with_origin(origin);
        let bounds = mesh.bounds().unwrap();
        let views = ScoredView::of_scene(&scene, &bounds).unwrap();
        let document = CamerasDocument::new("torus", &mesh, &bounds, &views, 2.0);
        (mesh, views, document)
    }

    #[test]
    fn matrices_take_points_of_the_file_to_their_pixels() {
        for ortho in [false, true] {
            let (mesh, views, document) = documents(ortho);
            assert_eq!(document.views.iter().map(|view| view.frame).collect::<Vec<_>>(), [2, 7, 12, 17, 22, 27]);
            for (view, document) in views.iter().zip(&document.views) {
                let times = |rows: &Rows, point: DVec4| {
                    DVec4::from_array([0, 1, 2, 3].map(|row| DVec4::from_array(rows[row]).dot(point)))
                };
                for &position in &mesh.positions()[..20] {
                    let point = mesh.in_file(position).extend(1.0);
                    let clip = times(&document.world_to_pixels, point);
                    let seen = view.camera.project(position.as_dvec3()).unwrap();
                    assert!((clip.truncate() / clip.w).truncate().distance(seen.pixel) < 1e-3, "{clip} {seen:?}");
                    assert!((0.0..=1.0).contains(&(clip.z / clip.w)));
                    let in_camera = times(&document.world_to_camera, point);
                    assert!((in_camera.z + seen.depth).abs() < 1e-6);
                    assert!(times(&document.camera_to_world, in_camera).distance(point) < 1e-6);
                }
                assert!(times(&document.camera_to_world, DVec4::W).truncate().distance(document.eye) < 1e-6);
                assert_eq!((document.focal_px.is_some(), document.ortho_height.is_some()), (!ortho, ortho));
                if let (Some(fov), Some(px), Some(mm)) = (document.fov_y_deg, document.focal_px, document.focal_mm) {
                    let angle = |size: f64, focal: f64| (2.0 * (size * 0.5 / focal).atan()).to_degrees();
                    assert!((angle(200.0, px) - fov).abs() < 1e-9 && (angle(24.0, mm) - fov).abs() < 1e-9);
                }
            }
        }
    }
}
