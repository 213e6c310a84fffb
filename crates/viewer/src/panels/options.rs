//! The options of a method, as its specs describe them: a slider for a number, a choice for words.

use eframe::egui::{self, ComboBox, Slider, SliderClamping};
use silhouette_core::method::{OptionKind, OptionSpec, OptionValue, OptionValues, Sweep};

/// Shows every option; `values` are what is chosen.
pub fn show(ui: &mut egui::Ui, specs: &'static [OptionSpec], values: &mut OptionValues) {
    let mut chosen: Vec<OptionValue> =
        specs.iter().map(|spec| values.get(spec.name).unwrap_or(spec.default_value())).collect();
    for (spec, value) in specs.iter().zip(&mut chosen) {
        one(ui, spec, unit(spec, values), value);
    }
    // Sliders keep to the range; what the specs refuse all the same is not taken.
    if let Ok(checked) = OptionValues::checked(specs, chosen) {
        *values = checked;
    }
    if !specs.is_empty() && ui.button("Default options").clicked() {
        *values = OptionValues::defaults(specs);
    }
}

/// The unit of an option, which may be the choice of another one: `in width-unit`.
fn unit(spec: &OptionSpec, values: &OptionValues) -> &'static str {
    match spec.unit.strip_prefix("in ").and_then(|name| values.get(name)) {
        Some(OptionValue::Choice(word)) => word,
        _ => spec.unit,
    }
}

fn one(ui: &mut egui::Ui, spec: &OptionSpec, unit: &str, value: &mut OptionValue) {
    let suffix = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let hover = format!("{} It is {}.", spec.summary, spec.expected());
    match (spec.kind, value) {
        (OptionKind::Number { min, max, .. }, OptionValue::Number(number)) => {
            let slider = Slider::new(number, min..=max).logarithmic(is_logarithmic(spec, min, max));
            let slider = slider.text(spec.name).suffix(suffix).smallest_positive(smallest(min, max));
            ui.add(slider.clamping(SliderClamping::Always)).on_hover_text(hover);
        }
        (OptionKind::Whole { min, max, .. }, OptionValue::Whole(number)) => {
            let is_logarithmic = is_logarithmic(spec, f64::from(min), f64::from(max));
            let slider = Slider::new(number, min..=max).logarithmic(is_logarithmic).text(spec.name).suffix(suffix);
            ui.add(slider.clamping(SliderClamping::Always)).on_hover_text(hover);
        }
        (OptionKind::Choice(words), OptionValue::Choice(chosen)) => {
            let choice = ComboBox::new(spec.name, spec.name).selected_text(*chosen);
            let shown = choice.show_ui(ui, |ui| {
                for &word in words {
                    ui.selectable_value(chosen, word, word);
                }
            });
            shown.response.on_hover_text(hover);
        }
        // A value of another kind is not made from these specs.
        _ => {}
    }
}

/// Whether steps at the low end matter as much as at the high one: where the spec's own sweep says so, or the range spans thousands.
fn is_logarithmic(spec: &OptionSpec, min: f64, max: f64) -> bool {
    match spec.sweep {
        Some(Sweep::Log { .. }) => true,
        Some(Sweep::Linear { .. }) => false,
        _ => min >= 0.0 && max / min.max(1.0) >= 1000.0,
    }
}

/// The smallest number above 0 that a slider whose range begins at 0 distinguishes from 0.
fn smallest(min: f64, max: f64) -> f64 {
    if min > 0.0 { min } else { max * 1e-6 }
}
