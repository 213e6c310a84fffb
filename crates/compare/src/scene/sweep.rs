//! `METHOD.OPTION[=N]`: cells for values of an option, spread over the [sweep](silhouette_core::method::Sweep) that it declares.

use super::error::SceneFault;
use super::model::{MethodSpec, OptionSpread, Scene};
use crate::options::OptionSetting;
use crate::registry::Registry;
use silhouette_core::method::{OptionSpec, OptionValue};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// How many values a sweep has where nothing is said.
pub const DEFAULT_VALUES: usize = 5;

/// How many values a sweep may be asked for.
pub const VALUES: RangeInclusive<usize> = 2..=64;

impl Scene {
    /// Adds cells for `N` values of each option that `texts` name, [`DEFAULT_VALUES`] where no number is given, to every cell of its
    /// method that the scene lists. Each sweep varies one option and leaves the others: several sweeps add, where lists of
    /// [`set`](Self::set) multiply.
    ///
    /// # Errors
    /// [`SceneFault`]: a text is not of this form, a method is not compared, or an option has no sweep, or several values already.
    pub fn sweep(&mut self, texts: &[String], registry: &Registry) -> Result<(), SceneFault> {
        if texts.is_empty() {
            return Ok(());
        }
        self.list_methods(registry);
        // Every sweep is about the cells that are there now, not about those of other sweeps.
        let listed = self.methods.clone();
        let mut seen = BTreeSet::new();
        for text in texts {
            let (method, spec, count) = parse(text, registry, &listed)?;
            let of_method = || listed.iter().filter(|cell| cell.name == method);
            let is_varied = |cell: &MethodSpec| matches!(cell.options.get(spec.name), Some(OptionSpread::Several(_)));
            if !seen.insert((method, spec.name)) || of_method().any(is_varied) {
                return Err(SceneFault::SweptTwice { method: method.to_owned(), option: spec.name.to_owned() });
            }
            let last =
                self.methods.iter().rposition(|cell| cell.name == method).map_or(self.methods.len(), |last| last + 1);
            self.methods.splice(last..last, of_method().filter_map(|cell| swept(cell, spec, count)));
        }
        Ok(())
    }
}

/// The method, the option and the number of values that a text names.
fn parse<'a>(
    text: &'a str,
    registry: &Registry,
    listed: &[MethodSpec],
) -> Result<(&'a str, &'static OptionSpec, usize), SceneFault> {
    let form = || SceneFault::SweepForm { text: text.to_owned() };
    let (place, count) = text.split_once('=').map_or((text, None), |(place, count)| (place, Some(count)));
    let count = count.map_or(Ok(DEFAULT_VALUES), |count| count.parse().map_err(|_| form()))?;
    let (method, option) = place.split_once('.').ok_or_else(form)?;
    if method.is_empty() || option.is_empty() || !VALUES.contains(&count) {
        return Err(form());
    }
    let specs = registry.find(method)?.info().options;
    if listed.iter().all(|cell| cell.name != method) {
        return Err(SceneFault::NotCompared { method: method.to_owned(), option: option.to_owned() });
    }
    let spec = specs.iter().find(|spec| spec.name == option && spec.sweep.is_some());
    let spec = spec.ok_or_else(|| SceneFault::NoSweep {
        method: method.to_owned(),
        option: option.to_owned(),
        known: specs.iter().filter(|spec| spec.sweep.is_some()).map(|spec| spec.name).collect(),
    })?;
    Ok((method, spec, count))
}

/// A method with the values of a sweep that it does not have; `None` where there are none.
fn swept(cell: &MethodSpec, spec: &'static OptionSpec, count: usize) -> Option<MethodSpec> {
    let present = match cell.options.get(spec.name).map(OptionSpread::values) {
        Some([value]) => value.clone(),
        _ => setting(spec.default_value()),
    };
    let values: Vec<OptionSetting> =
        spec.sweep_values(count).into_iter().map(setting).filter(|value| *value != present).collect();
    if values.is_empty() {
        return None;
    }
    let mut swept = cell.clone();
    swept.options.insert(spec.name.to_owned(), OptionSpread::Several(values));
    Some(swept)
}

fn setting(value: OptionValue) -> OptionSetting {
    OptionSetting::from(value.to_string().as_str())
}

#[cfg(test)]
mod tests {
    use super::super::cells::choices;
    use super::super::profile::Profile;
    use super::*;

    fn scene(methods: &[&str], sweeps: &[&str]) -> Result<Vec<String>, String> {
        let registry = Registry::builtin();
        let mut scene = Profile::Quick.scene();
        scene.select(&methods.iter().map(|&name| name.to_owned()).collect::<Vec<_>>());
        let sweeps: Vec<String> = sweeps.iter().map(|&sweep| sweep.to_owned()).collect();
        scene.sweep(&sweeps, &registry).map_err(|fault| fault.to_string())?;
        let choices = choices(&scene, &registry).map_err(|fault| fault.to_string())?;
        Ok(choices.iter().map(|choice| format!("{} {}", choice.entry.info().name, choice.options)).collect())
    }

    fn values(cells: &[String], option: &str) -> Vec<String> {
        let value = |cell: &String| {
            cell.split(' ').find_map(|word| word.strip_prefix(option)?.strip_prefix('=')).map(str::to_owned)
        };
        cells.iter().filter_map(value).collect()
    }

    #[test]
    fn a_sweep_adds_its_values_and_keeps_the_default_once() {
        let cells = scene(&["brute-force", "tracking"], &["tracking.concavity=3"]).unwrap();
        assert_eq!(values(&cells, "concavity"), ["0", "0.8", "1.6"]);
        assert_eq!(cells.len(), 4);
        let words = scene(&["jump-flood"], &["jump-flood.antialiasing"]).unwrap();
        assert_eq!(values(&words, "antialiasing"), ["samples", "coverage"]);
        assert!(scene(&[], &["tracking.concavity"]).unwrap().len() > cells.len(), "of all methods too");
    }

    #[test]
    fn sweeps_of_several_options_add_up() {
        let cells = scene(&["tracking"], &["tracking.concavity=3", "tracking.audit-share=3"]).unwrap();
        assert_eq!(values(&cells, "concavity"), ["0", "0.8", "1.6", "0", "0"]);
        assert_eq!(values(&cells, "audit-share"), ["0.1", "0.1", "0.1", "0.01", "1"], "0.1 is the default");
    }

    #[test]
    fn sweeps_are_about_every_cell_that_lists_make() {
        let registry = Registry::builtin();
        let mut scene = Profile::Quick.scene();
        scene.select(&["tracking".to_owned()]);
        // Lists with the default and without it.
        scene.set("tracking.mesh=refuse,cut", &registry).unwrap();
        scene.set("tracking.audit-share=0.2,0.3", &registry).unwrap();
        scene.sweep(&["tracking.concavity=3".to_owned()], &registry).unwrap();
        assert_eq!(choices(&scene, &registry).unwrap().len(), 12);
        let twice = scene.sweep(&["tracking.concavity=2".to_owned()], &registry).unwrap_err().to_string();
        assert!(twice.contains("tracking.concavity has several values already"), "{twice}");
        let both = ["tracking.concavity=2", "tracking.concavity=3"].map(str::to_owned);
        let mut fresh = Profile::Quick.scene();
        fresh.select(&["tracking".to_owned()]);
        assert!(fresh.sweep(&both, &registry).unwrap_err().to_string().contains("several values already"));
    }

    #[test]
    fn what_cannot_be_swept_is_refused_with_what_can() {
        let refused = |sweep: &str| scene(&["tracking"], &[sweep]).unwrap_err();
        let none = refused("tracking.jump");
        assert!(none.contains("tracking.jump has no sweep") && none.contains("concavity"), "{none}");
        assert!(refused("image-precision.pull").contains("name it in --methods"));
        assert!(refused("trucking.x").contains("no method 'trucking'"));
        for form in
            ["tracking", ".x", "tracking.", "tracking.concavity=", "tracking.concavity=1", "tracking.concavity=9999"]
        {
            assert!(refused(form).contains("METHOD.OPTION[=N]"), "{form}");
        }
        let fault = scene(&["brute-force"], &["brute-force.x"]).unwrap_err();
        assert!(fault.contains("no option of brute-force has one"), "{fault}");
    }
}
