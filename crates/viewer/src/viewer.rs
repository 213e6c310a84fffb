//! [`Viewer`]: all that is on screen, from frame to frame.

mod opening;
mod speed;

use crate::arrangement::Arrangement;
use crate::background::{Job, Wake};
use crate::measure::Measurement;
use crate::meshes::Opened;
use crate::messages::Messages;
use crate::pane::{Choice, Look, LooksAt, Pane};
use crate::panels::{self, menu};
use crate::path::Path;
use crate::picture::Pictures;
use crate::save::{Saving, Shown};
use crate::scenes::{OpenedScene, ShownScene};
use crate::tracks::Tracked;
use crate::truth::Measured;
use crate::view::View;
use crate::viewport::Room;
use eframe::{CreationContext, egui};
use silhouette_compare::registry::Registry;
use silhouette_core::{NoProgress, Topology, VertexId};
use silhouette_render::Gpu;
use silhouettes::application::{CameraArguments, Failure, MeshArgument};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Width of the controls beside the pictures, in points, until it is dragged.
pub const SIDE_POINTS: f32 = 300.0;

/// How long a frame of the window waits for pictures. What takes longer is shown by a later frame.
const PATIENCE: Duration = Duration::from_millis(25);

/// What the window begins with.
#[derive(Debug, Clone)]
pub struct Start {
    /// The mesh.
    pub mesh: Option<MeshArgument>,
    /// A scene, of which the path and the pen are taken.
    pub scene: Option<ShownScene>,
    /// The methods on screen: one or two.
    pub choices: Vec<Choice>,
    /// Whether parts of meshes that are wound inside out are turned.
    pub orient: bool,
    /// How long speed is measured, before the window closes.
    pub measure: Option<Duration>,
    /// The view.
    pub camera: CameraArguments,
}

/// The window's contents.
pub struct Viewer {
    gpu: Arc<Gpu>,
    registry: Registry,
    wake: Wake,
    pictures: Pictures,
    start: CameraArguments,
    opened: Opened,
    /// Whether parts of meshes that are wound inside out are turned.
    is_oriented: bool,
    scene: OpenedScene,
    /// Whether the mesh that is being read is seen first from where the path begins.
    starts_on_path: bool,
    asked_for_file: Option<Job<Option<PathBuf>>>,
    view: Option<View>,
    /// Two, of which the arrangement says how many are shown.
    panes: Vec<Pane>,
    arrangement: Arrangement,
    divider: f32,
    look: Look,
    path: Path,
    measured: Measured,
    tracked: Tracked,
    shows_flicker: bool,
    shows_plots: bool,
    saving: Saving,
    /// Size of the first picture, in pixels.
    size: [u32; 2],
    measurement: Option<Measurement>,
    outcome: Outcome,
    messages: Messages,
}

/// What a measurement printed, or why it did not, once it has ended.
pub type Outcome = Arc<Mutex<Option<Result<String, Failure>>>>;

impl Viewer {
    /// A window on the device of `gpu`, which draws it too.
    ///
    /// # Errors
    /// [`Failure::Run`]: the window is not drawn by wgpu.
    pub fn new(
        context: &CreationContext<'_>,
        gpu: Arc<Gpu>,
        registry: Registry,
        start: Start,
    ) -> Result<Self, Failure> {
        let state = context.wgpu_render_state.clone();
        let state = state.ok_or_else(|| Failure::run("the window has no device to draw with"))?;
        let pictures = Pictures::new(gpu.device(), state.target_format);
        let egui = context.egui_ctx.clone();
        let wake: Wake = Arc::new(move || egui.request_repaint());
        let mut opened = Opened::default();
        if let Some(mesh) = start.mesh {
            opened.open(&wake, mesh, start.orient);
        }
        let arrangement = if start.choices.len() > 1 { Arrangement::SideBySide } else { Arrangement::One };
        let choices = start.choices.iter().cycle().take(2);
        let mut viewer = Self {
            gpu,
            registry,
            wake,
            pictures,
            start: start.camera,
            opened,
            is_oriented: start.orient,
            scene: OpenedScene::default(),
            starts_on_path: false,
            asked_for_file: None,
            view: None,
            panes: choices.map(|choice| Pane::new(choice.clone())).collect(),
            arrangement,
            divider: 0.5,
            look: Look::default(),
            path: Path::default(),
            measured: Measured::default(),
            tracked: Tracked::default(),
            shows_flicker: false,
            shows_plots: false,
            saving: Saving::default(),
            size: [1, 1],
            measurement: start.measure.map(Measurement::new),
            outcome: Outcome::default(),
            messages: Messages::default(),
        };
        if let Some(scene) = start.scene {
            viewer.scene.show(scene);
            viewer.follow_scene();
            // A view that was asked for goes before that of the path.
            let unasked = CameraArguments::of_words([])?.with_size(viewer.start.size());
            viewer.starts_on_path = viewer.start == unasked;
        }
        Ok(viewer)
    }

    /// Where the outcome of a measurement will be.
    pub fn outcome(&self) -> Outcome {
        Arc::clone(&self.outcome)
    }

    /// The panes on screen.
    pub fn panes(&self) -> &[Pane] {
        &self.panes[..self.arrangement.panes()]
    }

    /// The camera on screen, once there is a mesh.
    pub fn view(&self) -> Option<&View> {
        self.view.as_ref()
    }

    /// What the window has to say.
    pub fn messages(&self) -> &Messages {
        &self.messages
    }

    /// Whether something in the background is not done.
    pub fn is_busy(&self) -> bool {
        let is_working = self.opened.stage().is_some() || self.saving.is_busy() || self.scene.is_busy();
        let is_looking = self.measured.stage().is_some() || self.tracked.stage().is_some();
        is_working || is_looking || self.panes().iter().any(Pane::is_busy)
    }

    /// The loops on screen.
    pub fn tracked(&self) -> &Tracked {
        &self.tracked
    }

    /// What is to be saved, and where.
    pub fn saving_mut(&mut self) -> &mut Saving {
        &mut self.saving
    }

    /// The camera path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn side(&mut self, ui: &mut egui::Ui) {
        egui::ScrollArea::vertical().show(ui, |ui| {
            let labels: &[&str] =
                if self.arrangement.panes() == 1 { &["method"] } else { &["left method", "right method"] };
            for (pane, label) in self.panes.iter_mut().zip(labels) {
                panels::method::show(ui, label, &self.registry, pane);
                ui.separator();
            }
            section(ui, "Pen and layers", false, |ui| panels::look::show(ui, &mut self.look));
            let (Some(view), Some(mesh)) = (&mut self.view, self.opened.shown()) else { return };
            section(ui, "Camera", true, |ui| panels::camera::show(ui, view, &mut self.messages));
            let mut chosen = None;
            if let Some(scene) = self.scene.shown() {
                section(ui, "Scene", true, |ui| chosen = panels::path::meshes(ui, scene));
            }
            section(ui, "Camera path", false, |ui| panels::path::show(ui, &mut self.path, view, &mut self.messages));
            section(ui, "Truth", false, |ui| {
                panels::truth::show(ui, &mut self.measured);
                if self.measured.is_on {
                    for pane in &self.panes[..self.arrangement.panes()] {
                        panels::truth::figures(ui, pane.choice.name(), pane.score());
                    }
                }
            });
            section(ui, "Loops and flicker", false, |ui| {
                panels::tracks::show(ui, &mut self.tracked);
                let flicker = ui.checkbox(&mut self.shows_flicker, "Show what appears and vanishes");
                flicker.on_hover_text("Of methods that extract edges: edges that appear, green, and vanish, orange");
            });
            section(ui, "Artefacts", false, |ui| panels::artefacts::show(ui, &mesh.named.mesh));
            let choices = self.panes[..self.arrangement.panes()].iter().map(|pane| &pane.choice).collect();
            let (size, look, path) = (self.size, self.look, &self.path);
            let (argument, is_oriented) = (&mesh.argument, mesh.is_oriented);
            let shown = Shown { mesh: argument, is_oriented, view, size, choices, look, path };
            section(ui, "Save", false, |ui| {
                panels::save::show(ui, &mut self.saving, &shown, &self.registry, &self.wake, &mut self.messages);
            });
            if let Some(mesh) = chosen {
                self.open(mesh);
                self.starts_on_path = true;
            }
        });
    }

    /// Shows the next frame of the path once it is due.
    fn play(&mut self, context: &egui::Context) {
        let is_drawn = !self.panes().iter().any(Pane::is_busy);
        let Some(view) = &mut self.view else { return };
        match self.path.advance(view, is_drawn) {
            // A frame that is drawn wakes the window by itself.
            Ok(Some(wait)) => context.request_repaint_after(wait),
            Ok(None) => {}
            Err(error) => {
                self.path.play(false);
                self.messages.error(error);
            }
        }
    }

    fn pictures(&mut self, ui: &mut egui::Ui) {
        let room = Room::new(ui, self.arrangement, self.divider);
        self.size = room.places[0].picture.size;
        self.take_mesh(self.size);
        self.play(ui.ctx());
        self.refuse_truth_of_textures();
        let (Some(shown), Some(view)) = (self.opened.shown(), &mut self.view) else {
            if self.opened.stage().is_none() {
                let text = "Open a mesh: drop a file here, or choose File or Shapes above.";
                ui.centered_and_justified(|ui| ui.label(text));
            }
            return;
        };
        let mesh = &shown.named;
        let was_on_path = self.path.is_on(view);
        if let Err(failure) = view.resize(self.size) {
            self.messages.error(failure);
        } else if was_on_path
            && !self.path.is_on(view)
            && let Err(error) = self.path.go_to(i64::from(self.path.frame()), view)
        {
            self.messages.error(error);
        }
        let panes = &mut self.panes[..room.places.len()];
        let names: Vec<&str> = panes.iter().map(|pane| pane.choice.name()).collect();
        room.steer(ui, view, &format!("Picture of {}", names.join(" and ")));
        self.tracked.update(&self.wake, mesh, view.camera());
        let looks_at = LooksAt { pixels: self.measured.is_on, changes: self.shows_flicker };
        for (index, place) in room.places.iter().enumerate() {
            match view.camera_of_size(place.picture.size) {
                Ok(camera) => {
                    panes[index].update(&self.gpu, &self.wake, shown, self.look, &camera, looks_at);
                }
                Err(error) => self.messages.error(error),
            }
        }
        let until = Instant::now() + PATIENCE;
        panes.iter_mut().for_each(|pane| pane.wait(until, looks_at));
        self.measured.update(&self.gpu, &self.wake, mesh, ui.ctx(), panes);
        for (index, pane) in panes.iter_mut().enumerate() {
            let overlay = pane.overlay().filter(|_| self.measured.is_on && self.measured.is_over);
            let picture = pane.picture(self.gpu.device(), &self.pictures);
            room.show(ui, index, picture, overlay);
            room.caption(ui, index, &format!("{} · {}", pane.choice.name(), mesh.name));
            let Some(frame) = pane.frame() else { continue };
            if let Some(loops) = self.tracked.loops() {
                panels::tracks::draw(ui, &room, index, &frame.camera, loops);
            }
            // Whoever extracts edges has asked for the topology before.
            if self.shows_flicker
                && frame.edges.is_some()
                && let Ok(topology) = mesh.mesh.artefact::<Topology>("viewer", &NoProgress)
            {
                let position = |vertex: VertexId| mesh.mesh.mesh().positions()[vertex.index()].as_dvec3();
                let ends = |edge| topology.end_points(edge).map(position);
                pane.flicker().draw(ui, &room, index, &frame.camera, ends);
            }
        }
        room.divide(ui, &mut self.divider);
    }

    /// The mesh of a silhouette texture is its hull, which encloses the mesh that it was baked of and is not what it shows.
    fn refuse_truth_of_textures(&mut self) {
        let Some(argument) = self.opened.shown().map(|shown| &shown.argument) else { return };
        if self.measured.is_on && argument.texture().is_some() {
            self.messages.error(format_args!(
                "{argument}: holds no mesh to measure against; open the mesh that it was baked of, and choose the method texture"
            ));
            self.measured.cancel();
        }
    }

    fn plots(&self, ui: &mut egui::Ui) {
        let panes: Vec<_> = self.panes().iter().map(|pane| (pane.choice.name(), pane.history())).collect();
        let metric = self.panes[0].choice.kind().leading_metric();
        panels::plots::show(ui, &panes, &format!("{} in {} (measured frames)", metric.title, metric.unit));
    }
}

/// A part of the side panel that can be folded.
fn section(ui: &mut egui::Ui, title: &str, is_open: bool, contents: impl FnOnce(&mut egui::Ui)) {
    egui::CollapsingHeader::new(title).default_open(is_open).show(ui, contents);
}

impl eframe::App for Viewer {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.measure(ui.ctx());
        self.take_files(ui);
        self.take_scene();
        self.saving.update(&mut self.messages);
        let chosen = egui::Panel::top("menu")
            .show(ui, |ui| menu::show(ui, &mut self.arrangement, &mut self.shows_plots, self.is_oriented))
            .inner;
        match chosen {
            Some(menu::Chosen::Open(argument)) => self.open(argument),
            Some(menu::Chosen::Browse) => self.browse(),
            Some(menu::Chosen::Orient(is_wanted)) => {
                self.is_oriented = is_wanted;
                if let Some(argument) = self.opened.shown().map(|shown| shown.argument.clone()) {
                    self.open(argument);
                }
            }
            None => {}
        }
        if !self.messages.all().is_empty() || self.opened.stage().is_some() {
            egui::Panel::bottom("messages").show(ui, |ui| {
                self.messages.show(ui);
                if let Some((name, stage)) = self.opened.stage()
                    && panels::progress(ui, &format!("reading {name}"), &stage)
                {
                    self.opened.cancel();
                }
            });
        }
        if self.shows_plots {
            egui::Panel::bottom("plots").show(ui, |ui| self.plots(ui));
        }
        egui::Panel::left("controls").default_size(SIDE_POINTS).show(ui, |ui| self.side(ui));
        egui::CentralPanel::no_frame().show(ui, |ui| self.pictures(ui));
    }
}
