//! [`Viewer`]: all that is on screen, from frame to frame.

use crate::arrangement::Arrangement;
use crate::background::{Job, Wake};
use crate::meshes::Opened;
use crate::messages::Messages;
use crate::pane::{Choice, Look, Pane};
use crate::panels::{self, menu};
use crate::view::View;
use crate::viewport::Room;
use eframe::{CreationContext, egui, egui_wgpu};
use silhouette_compare::registry::Registry;
use silhouette_render::Gpu;
use silhouettes::application::{CameraArguments, Failure, MeshArgument};
use std::path::PathBuf;
use std::sync::Arc;

/// What the window begins with.
#[derive(Debug, Clone)]
pub struct Start {
    /// The mesh.
    pub mesh: Option<MeshArgument>,
    /// The methods on screen: one or two.
    pub choices: Vec<Choice>,
    /// The view.
    pub camera: CameraArguments,
}

/// The window's contents.
pub struct Viewer {
    gpu: Arc<Gpu>,
    registry: Registry,
    wake: Wake,
    state: egui_wgpu::RenderState,
    start: CameraArguments,
    opened: Opened,
    asked_for_file: Option<Job<Option<PathBuf>>>,
    view: Option<View>,
    /// Two, of which the arrangement says how many are shown.
    panes: Vec<Pane>,
    arrangement: Arrangement,
    divider: f32,
    look: Look,
    messages: Messages,
}

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
        let egui = context.egui_ctx.clone();
        let wake: Wake = Arc::new(move || egui.request_repaint());
        let mut opened = Opened::default();
        if let Some(mesh) = start.mesh {
            opened.open(&wake, mesh);
        }
        let arrangement = if start.choices.len() > 1 { Arrangement::SideBySide } else { Arrangement::One };
        let choices = start.choices.iter().cycle().take(2);
        Ok(Self {
            gpu,
            registry,
            wake,
            state,
            start: start.camera,
            opened,
            asked_for_file: None,
            view: None,
            panes: choices.map(|choice| Pane::new(choice.clone())).collect(),
            arrangement,
            divider: 0.5,
            look: Look::default(),
            messages: Messages::default(),
        })
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
        self.opened.stage().is_some() || self.panes().iter().any(Pane::is_busy)
    }

    fn open(&mut self, argument: MeshArgument) {
        self.opened.open(&self.wake, argument);
    }

    /// Asks for a file, where there is something that can: the dialog is the system's.
    fn browse(&mut self) {
        let dialog = rfd::AsyncFileDialog::new().add_filter("Meshes", &["obj", "ply", "off", "stl", "gltf", "glb"]);
        let asked = dialog.pick_file();
        let path = move || pollster::block_on(asked).map(|file| file.path().to_owned());
        self.asked_for_file = Some(Job::start(&self.wake, move |_| path()));
    }

    fn take_files(&mut self, ui: &egui::Ui) {
        if let Some(result) = self.asked_for_file.as_ref().and_then(Job::poll) {
            self.asked_for_file = None;
            match result {
                Ok(Some(path)) => self.open(path.into_os_string().into()),
                Ok(None) => {}
                Err(died) => self.messages.error(died),
            }
        }
        let dropped = ui.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()));
        if let Some(path) = dropped {
            self.open(path.into_os_string().into());
        }
    }

    /// Puts a mesh on screen that was read, seen as the last one was asked to be seen first.
    fn take_mesh(&mut self, size: [u32; 2]) {
        if !self.opened.update(&mut self.messages) {
            return;
        }
        self.panes.iter_mut().for_each(Pane::clear);
        let Some(mesh) = self.opened.mesh().map(|named| named.mesh.mesh()) else { return };
        let Some(bounds) = mesh.bounds() else { return };
        match View::new(&self.start, bounds, mesh.origin(), size) {
            Ok(view) => self.view = Some(view),
            Err(failure) => {
                self.view = None;
                self.messages.error(failure);
            }
        }
    }

    fn side(&mut self, ui: &mut egui::Ui) {
        egui::ScrollArea::vertical().show(ui, |ui| {
            let labels: &[&str] =
                if self.arrangement.panes() == 1 { &["method"] } else { &["left method", "right method"] };
            for (pane, label) in self.panes.iter_mut().zip(labels) {
                panels::method::show(ui, label, &self.registry, pane);
                ui.separator();
            }
            if let Some(view) = &mut self.view {
                ui.heading("Camera");
                panels::camera::show(ui, view, &mut self.messages);
            }
        });
    }

    fn pictures(&mut self, ui: &mut egui::Ui) {
        let room = Room::new(ui, self.arrangement, self.divider);
        self.take_mesh(room.places[0].picture.size);
        let (Some(mesh), Some(view)) = (self.opened.mesh(), &mut self.view) else {
            if self.opened.stage().is_none() {
                ui.centered_and_justified(|ui| {
                    ui.label("Open a mesh: drop a file here, or choose File or Shapes above.")
                });
            }
            return;
        };
        let names: Vec<&str> = self.panes[..room.places.len()].iter().map(|pane| pane.choice.name()).collect();
        room.steer(ui, view, &format!("Picture of {}", names.join(" and ")));
        for (index, place) in room.places.iter().enumerate() {
            let pane = &mut self.panes[index];
            match view.camera_of_size(place.picture.size) {
                Ok(camera) => pane.update(&self.gpu, &self.wake, mesh, self.look, &camera, false),
                Err(error) => self.messages.error(error),
            }
            let textures: Vec<_> = pane.texture(&self.state).into_iter().collect();
            room.show(ui, index, &textures);
            room.caption(ui, index, &format!("{} · {}", pane.choice.name(), mesh.name));
        }
        room.divide(ui, &mut self.divider);
    }
}

impl eframe::App for Viewer {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.take_files(ui);
        let chosen = egui::Panel::top("menu").show(ui, |ui| menu::show(ui, &mut self.arrangement)).inner;
        match chosen {
            Some(menu::Chosen::Open(argument)) => self.open(argument),
            Some(menu::Chosen::Browse) => self.browse(),
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
        egui::Panel::left("controls").default_size(290.0).show(ui, |ui| self.side(ui));
        egui::CentralPanel::no_frame().show(ui, |ui| self.pictures(ui));
    }
}
