//! [`Messages`]: what the window has to say, in the command line's words.

use eframe::egui;
use std::fmt::Display;

/// One line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    /// Whether something failed, or else is worth knowing only.
    pub is_error: bool,
    /// What happened, where, and what to do about it.
    pub text: String,
}

/// Lines that have not been read.
#[derive(Debug, Default)]
pub struct Messages(Vec<Message>);

/// How many lines are kept.
const KEPT: usize = 5;

impl Messages {
    /// Something failed.
    pub fn error(&mut self, text: impl Display) {
        self.push(true, &text);
    }

    /// Something worth knowing.
    pub fn note(&mut self, text: impl Display) {
        self.push(false, &text);
    }

    /// The last lines, each once.
    fn push(&mut self, is_error: bool, text: &dyn Display) {
        let text = text.to_string();
        self.0.retain(|message| message.text != text);
        self.0.push(Message { is_error, text });
        let surplus = self.0.len().saturating_sub(KEPT);
        self.0.drain(..surplus);
    }

    /// All of them, the oldest first.
    pub fn all(&self) -> &[Message] {
        &self.0
    }

    /// The oldest that says that something failed.
    pub fn first_error(&self) -> Option<&str> {
        self.0.iter().find(|message| message.is_error).map(|message| message.text.as_str())
    }

    /// Forgets all of them, as another mesh makes them stale.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Shows them, each with a button by which it goes.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let mut read = None;
        for (index, message) in self.0.iter().enumerate() {
            ui.horizontal_wrapped(|ui| {
                if ui.small_button("Dismiss").clicked() {
                    read = Some(index);
                }
                let (word, color) = if message.is_error {
                    ("Error: ", ui.visuals().error_fg_color)
                } else {
                    ("Note: ", ui.visuals().text_color())
                };
                ui.colored_label(color, format!("{word}{}", message.text));
            });
        }
        if let Some(index) = read {
            self.0.remove(index);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_lines_are_kept_each_once() {
        let mut messages = Messages::default();
        for round in 0..2 {
            (0..8).for_each(|number| messages.error(number));
            messages.note(3);
            let kept: Vec<_> = messages.all().iter().map(|message| message.text.as_str()).collect();
            assert_eq!(kept, ["4", "5", "6", "7", "3"], "{round}");
        }
        assert!(!messages.all()[4].is_error);
        messages.clear();
        assert!(messages.all().is_empty());
    }
}
