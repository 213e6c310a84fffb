//! Meshes and scenes, from the dialog, the command line or a drop to what is on screen.

use super::Viewer;
use crate::arrangement::Arrangement;
use crate::background::Job;
use crate::pane::Pane;
use crate::path::Path;
use crate::view::View;
use eframe::egui;
use silhouettes::application::MeshArgument;
use std::path::Path as FilePath;

impl Viewer {
    /// Opens a mesh, or a scene where that is what the name ends in.
    pub(super) fn open(&mut self, argument: MeshArgument) {
        self.starts_on_path = false;
        let is_scene = |path: &&FilePath| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
        match argument.path().filter(is_scene) {
            Some(path) => self.scene.open(&self.wake, &self.registry, path.to_owned()),
            None => self.opened.open(&self.wake, argument, self.is_oriented),
        }
    }

    /// Shows a scene that was opened: its first mesh, its methods, pen and path.
    pub(super) fn take_scene(&mut self) {
        if !self.scene.update(&mut self.messages) {
            return;
        }
        let Some(scene) = self.scene.shown() else { return };
        if let [first, ..] = &scene.choices[..] {
            let second = scene.choices.get(1);
            self.arrangement = if second.is_some() { Arrangement::SideBySide } else { Arrangement::One };
            self.panes[0].choice = first.clone();
            self.panes[1].choice = second.unwrap_or(first).clone();
        }
        let mesh = scene.meshes().next();
        self.follow_scene();
        if let Some(mesh) = mesh {
            self.open(mesh);
            self.starts_on_path = true;
        } else if let Some(view) = &mut self.view
            && let Err(error) = self.path.go_to(0, view)
        {
            self.messages.error(error);
        }
    }

    /// Takes path and pen of the scene on screen.
    pub(super) fn follow_scene(&mut self) {
        let Some(shown) = self.scene.shown() else { return };
        self.path = Path::of(&shown.scene);
        (self.look.pen_width_px, self.look.samples) = (shown.scene.pen.width_px, shown.scene.picture.samples);
    }

    /// Asks for a file, where there is something that can: the dialog is the system's.
    pub(super) fn browse(&mut self) {
        const ENDINGS: [&str; 8] = ["obj", "ply", "off", "stl", "gltf", "glb", "siltex", "toml"];
        let dialog = rfd::AsyncFileDialog::new().add_filter("Meshes, silhouette textures and scenes", &ENDINGS);
        let asked = dialog.pick_file();
        let path = move || pollster::block_on(asked).map(|file| file.path().to_owned());
        self.asked_for_file = Some(Job::start(&self.wake, move |_| path()));
    }

    pub(super) fn take_files(&mut self, ui: &egui::Ui) {
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
    pub(super) fn take_mesh(&mut self, size: [u32; 2]) {
        if !self.opened.update(&mut self.messages) {
            return;
        }
        self.panes.iter_mut().for_each(Pane::clear);
        self.measured.clear();
        self.tracked.clear();
        let Some(shown) = self.opened.shown() else { return };
        if let Some(note) = self.scene.shown().and_then(|scene| scene.note_on(&shown.argument)) {
            self.messages.note(note);
        }
        match View::new(&self.start, shown.bounds, shown.named.mesh.mesh().origin(), size) {
            Ok(mut view) => {
                if std::mem::take(&mut self.starts_on_path)
                    && let Err(error) = self.path.go_to(0, &mut view)
                {
                    self.messages.error(error);
                }
                self.view = Some(view);
            }
            Err(failure) => {
                self.view = None;
                self.messages.error(failure);
            }
        }
    }
}
