//! The pictures and the divider, and the pointer and the keys that move the camera.
//!
//! A drag turns the eye about the target, with Shift or another button it moves both; the wheel takes the eye closer, with Ctrl it
//! changes the field of view. Keys, once the picture has the focus: arrows turn, with Shift they move, + and - take the eye closer and
//! away.

use crate::arrangement::{Arrangement, PixelRect, Place};
use crate::picture::Picture;
use crate::view::View;
use eframe::egui::{
    self, Color32, CursorIcon, EventFilter, Key, PointerButton, Rect, Response, Role, Sense, Stroke, TextureId, Vec2,
    WidgetInfo, pos2, vec2,
};

/// Turn for each press of an arrow, as a drag in points.
const KEY_POINTS: f64 = 12.0;
/// How much closer a press of + takes the eye.
const KEY_DOLLY: f64 = 0.9;
/// How far the wheel turns for the distance to change by a factor of e, in points.
const WHEEL_POINTS: f64 = 400.0;
/// Width that the divider can be caught in, in points.
const DIVIDER_POINTS: f32 = 10.0;

/// The room for pictures.
#[derive(Debug, Clone)]
pub struct Room {
    /// Where each picture lies, in pixels.
    pub places: Vec<Place>,
    area: Rect,
    pixels_per_point: f32,
}

impl Room {
    /// All that the window has left.
    pub fn new(ui: &egui::Ui, arrangement: Arrangement, divider: f32) -> Self {
        let pixels_per_point = ui.ctx().pixels_per_point();
        let pixels = PixelRect::within(ui.available_rect_before_wrap(), pixels_per_point);
        let places = arrangement.places(pixels, divider);
        Self { places, area: pixels.to_points(pixels_per_point), pixels_per_point }
    }

    /// Shows a picture on white paper, as far as its place shows it, and what lies over it.
    pub fn show(&self, ui: &egui::Ui, place: usize, drawn: Option<Picture>, over: Option<TextureId>) {
        let Place { picture, shown } = self.places[place];
        let [picture, shown] = [picture, shown].map(|rect| rect.to_points(self.pixels_per_point));
        let painter = ui.painter().with_clip_rect(shown);
        match drawn {
            Some(drawn) => drop(painter.add(drawn.shape(picture))),
            None => drop(painter.rect_filled(shown, 0.0, Color32::WHITE)),
        }
        if let Some(texture) = over {
            let all = Rect { min: pos2(0.0, 0.0), max: pos2(1.0, 1.0) };
            painter.image(texture, picture, all, Color32::WHITE);
        }
    }

    /// A line of text at the top left of a picture.
    pub fn caption(&self, ui: &egui::Ui, place: usize, text: &str) {
        let shown = self.places[place].shown.to_points(self.pixels_per_point);
        let painter = ui.painter().with_clip_rect(shown);
        let color = Color32::from_gray(70);
        painter.text(shown.min + vec2(8.0, 6.0), egui::Align2::LEFT_TOP, text, egui::FontId::proportional(13.0), color);
    }

    /// Where a point of a picture lies in the window.
    pub fn point(&self, place: usize, pixel: glam::DVec2) -> egui::Pos2 {
        let min = self.places[place].picture.to_points(self.pixels_per_point).min;
        min + vec2(pixel.x as f32, pixel.y as f32) / self.pixels_per_point
    }

    /// A painter of what a place shows.
    pub fn painter(&self, ui: &egui::Ui, place: usize) -> egui::Painter {
        ui.painter().with_clip_rect(self.places[place].shown.to_points(self.pixels_per_point))
    }

    /// Moves the camera as pointer and keys say.
    pub fn steer(&self, ui: &mut egui::Ui, view: &mut View, label: &str) -> Response {
        let response = ui.interact(self.area, ui.scope_id().with("picture"), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, label));
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        let drag = response.drag_delta();
        let by = [drag.x, drag.y].map(f64::from);
        let scale = f64::from(self.pixels_per_point);
        if response.dragged() && drag != Vec2::ZERO {
            let is_moved = !response.dragged_by(PointerButton::Primary) || ui.input(|input| input.modifiers.shift);
            if is_moved { view.pan(by.map(|points| points * scale)) } else { view.orbit(by) }
        }
        if response.contains_pointer() {
            let (wheel, pinch) =
                ui.input(|input| (f64::from(input.smooth_scroll_delta().y), f64::from(input.zoom_delta())));
            // Both are exactly that where nothing was turned.
            if pinch.ln().abs() > 0.0 {
                view.zoom(1.0 / pinch);
            } else if wheel.abs() > 0.0 {
                view.dolly((-wheel / WHEEL_POINTS).exp());
            }
        }
        if response.has_focus() {
            let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
            Self::press(ui, view);
            ui.painter().rect_stroke(
                self.area.shrink(1.0),
                0.0,
                Stroke::new(2.0, ui.visuals().selection.bg_fill),
                egui::StrokeKind::Inside,
            );
        }
        response
    }

    fn press(ui: &egui::Ui, view: &mut View) {
        const ARROWS: [(Key, [f64; 2]); 4] = [
            (Key::ArrowLeft, [-1.0, 0.0]),
            (Key::ArrowRight, [1.0, 0.0]),
            (Key::ArrowUp, [0.0, -1.0]),
            (Key::ArrowDown, [0.0, 1.0]),
        ];
        let pressed = ui.input(|input| input.events.clone());
        for event in pressed {
            let egui::Event::Key { key, pressed: true, modifiers, .. } = event else { continue };
            if let Some((_, direction)) = ARROWS.iter().find(|(arrow, _)| *arrow == key) {
                let by = direction.map(|side| side * KEY_POINTS);
                if modifiers.shift { view.pan(by) } else { view.orbit(by) }
            }
            match key {
                Key::Plus | Key::Equals => view.dolly(KEY_DOLLY),
                Key::Minus => view.dolly(1.0 / KEY_DOLLY),
                _ => {}
            }
        }
    }

    /// Shows the divider; `share` of the width lies on its left.
    pub fn divide(&self, ui: &mut egui::Ui, share: &mut f32) {
        let [_, second] = &self.places[..] else { return };
        let x = second.shown.to_points(self.pixels_per_point).min.x;
        let line = Rect { min: pos2(x, self.area.min.y), max: pos2(x, self.area.max.y) };
        let response =
            ui.interact(line.expand2(vec2(DIVIDER_POINTS * 0.5, 0.0)), ui.scope_id().with("divider"), Sense::drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, "Divider"));
        let mut moved = response.drag_delta().x;
        if response.has_focus() {
            let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
            let presses = |key| ui.input(|input| input.num_presses(key)) as f32;
            moved += (presses(Key::ArrowRight) - presses(Key::ArrowLeft)) * KEY_POINTS as f32;
        }
        *share = (*share + moved / self.area.width().max(1.0)).clamp(0.02, 0.98);
        let is_held = response.hovered() || response.dragged() || response.has_focus();
        let color = if is_held { ui.visuals().selection.bg_fill } else { Color32::from_gray(120) };
        ui.painter().vline(x, line.y_range(), Stroke::new(if is_held { 3.0 } else { 1.5 }, color));
        response.on_hover_cursor(CursorIcon::ResizeHorizontal);
    }
}
