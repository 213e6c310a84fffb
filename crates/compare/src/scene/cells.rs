//! Step 4: which methods with which options. Each choice, on each mesh, is a cell of the comparison.

use super::error::SceneFault;
use super::model::{MethodSpec, OptionSpread, Scene};
use crate::drawing::pictures_of;
use crate::metrics::PictureKind;
use crate::options::OptionSetting;
use crate::registry::{Entry, Registry};
use silhouette_core::method::OptionValues;

/// Most choices of methods and options in one comparison.
pub const MAX_CHOICES: usize = 256;

/// A method with the options it is compared with.
#[derive(Debug, Clone)]
pub struct MethodChoice {
    /// The method.
    pub entry: Entry,
    /// Its options.
    pub options: OptionValues,
    /// What its pictures show.
    pub picture: PictureKind,
}

impl Scene {
    /// Restricts the comparison to the methods of these names, in this order. One that the scene lists keeps its options
    /// there, any other has its defaults.
    pub fn select(&mut self, names: &[String]) {
        let listed = std::mem::take(&mut self.methods);
        for name in names {
            let mut of_name = listed.iter().filter(|method| method.name == *name).cloned().peekable();
            if of_name.peek().is_some() {
                self.methods.extend(of_name);
            } else {
                self.methods.push(MethodSpec { name: name.clone(), options: Default::default() });
            }
        }
    }

    /// Sets an option of every cell of a method by `METHOD.OPTION=VALUE[,VALUE...]`; with several values there is one cell
    /// for each.
    ///
    /// # Errors
    /// [`SceneFault`]: the text is not of this form, or the method is not compared. Whether option and values fit is found
    /// out by [`choices`].
    pub fn set(&mut self, text: &str, registry: &Registry) -> Result<(), SceneFault> {
        let form = || SceneFault::SetForm { text: text.to_owned() };
        let (place, values) = text.split_once('=').ok_or_else(form)?;
        let (method, option) = place.split_once('.').ok_or_else(form)?;
        let values: Vec<OptionSetting> = values.split(',').map(|value| value.trim().into()).collect();
        let is_empty = |value: &OptionSetting| matches!(value, OptionSetting::Word(word) if word.is_empty());
        if method.is_empty() || option.is_empty() || values.iter().any(is_empty) {
            return Err(form());
        }
        self.list_methods(registry);
        let mut is_compared = false;
        for spec in self.methods.iter_mut().filter(|spec| spec.name == method) {
            spec.options.insert(option.to_owned(), OptionSpread::Several(values.clone()));
            is_compared = true;
        }
        let fault = || SceneFault::NotCompared { method: method.to_owned(), option: option.to_owned() };
        if is_compared { Ok(()) } else { Err(fault()) }
    }

    /// Lists every method that yields pictures, where none is listed, which stands for the same.
    pub(super) fn list_methods(&mut self, registry: &Registry) {
        if self.methods.is_empty() {
            let every = registry.entries().iter().filter(|entry| yields_pictures(entry));
            self.select(&every.map(|entry| entry.info().name.to_owned()).collect::<Vec<_>>());
        }
    }
}

/// The choices of a scene, in its order: methods as listed, or all that yield pictures; of several options with lists, the last varies first. A
/// method that yields several kinds of picture is chosen for each.
///
/// # Errors
/// [`SceneFault`]: an unknown method or option, a method without pictures, a value that does not fit, the same choice twice, more than
/// [`MAX_CHOICES`].
pub fn choices(scene: &Scene, registry: &Registry) -> Result<Vec<MethodChoice>, SceneFault> {
    let mut choices: Vec<MethodChoice> = Vec::new();
    if scene.methods.is_empty() {
        for entry in registry.entries() {
            choices.extend(of_entry(entry, &OptionValues::defaults(entry.info().options)));
        }
    }
    for spec in &scene.methods {
        let entry = registry.find(&spec.name)?;
        if !yields_pictures(entry) {
            return Err(SceneFault::NoPicture { method: spec.name.clone() });
        }
        for words in combinations(spec, choices.len())? {
            let options = OptionValues::parse(entry.info().options, words.iter().map(String::as_str))
                .map_err(|fault| SceneFault::Option { method: spec.name.clone(), fault })?;
            let is_same = |other: &MethodChoice| other.entry.info().name == spec.name && other.options == options;
            if choices.iter().any(is_same) {
                let options = options.to_string();
                let options = if options.is_empty() { "none".to_owned() } else { options };
                return Err(SceneFault::Twice { method: spec.name.clone(), options });
            }
            choices.extend(of_entry(entry, &options));
        }
    }
    Ok(choices)
}

fn yields_pictures(entry: &Entry) -> bool {
    pictures_of(entry.capabilities()).next().is_some()
}

/// A method with its options, once for each kind of picture.
fn of_entry(entry: &Entry, options: &OptionValues) -> impl Iterator<Item = MethodChoice> {
    pictures_of(entry.capabilities()).map(|picture| MethodChoice {
        entry: entry.clone(),
        options: options.clone(),
        picture,
    })
}

/// The product of all lists of values of a method, as `name=value` words.
fn combinations(spec: &MethodSpec, before: usize) -> Result<Vec<Vec<String>>, SceneFault> {
    let mut all: Vec<Vec<String>> = vec![Vec::new()];
    for (option, spread) in &spec.options {
        let values = spread.values();
        if values.is_empty() {
            return Err(SceneFault::NoValue { method: spec.name.clone(), option: option.clone() });
        }
        let cells = before.saturating_add(all.len().saturating_mul(values.len()));
        if cells > MAX_CHOICES {
            return Err(SceneFault::TooManyCells { cells, limit: MAX_CHOICES });
        }
        let extended = |words: &Vec<String>| {
            values.iter().map(|value| [&words[..], &[format!("{option}={value}")]].concat()).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(extended).collect();
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::super::profile::Profile;
    use super::*;

    fn scene(methods: &[&str], settings: &[&str]) -> Result<Vec<(&'static str, String)>, String> {
        let mut scene = Profile::Quick.scene();
        scene.select(&methods.iter().map(|&name| name.to_owned()).collect::<Vec<_>>());
        for setting in settings {
            scene.set(setting, &Registry::builtin()).map_err(|fault| fault.to_string())?;
        }
        let choices = choices(&scene, &Registry::builtin()).map_err(|fault| fault.to_string())?;
        Ok(choices.into_iter().map(|choice| (choice.entry.info().name, choice.options.to_string())).collect())
    }

    fn names_with_pictures() -> Vec<&'static str> {
        let registry = Registry::builtin();
        registry.entries().iter().filter(|entry| yields_pictures(entry)).map(|entry| entry.info().name).collect()
    }

    #[test]
    fn without_names_every_method_that_yields_pictures_is_compared() {
        let names: Vec<_> = scene(&[], &[]).unwrap().into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, names_with_pictures());
        let fault = scene(&["interpolated-contours"], &[]).unwrap_err();
        assert_eq!(fault, "interpolated-contours yields no picture that could be compared");
    }

    #[test]
    fn several_values_are_several_cells_and_lists_multiply() {
        let swept = scene(&["tracking", "brute-force"], &["tracking.concavity=0,0.5,1", "tracking.mesh=cut,refuse"]);
        let swept = swept.unwrap();
        assert_eq!(swept.len(), 7);
        assert_eq!(swept[6].0, "brute-force");
        let found = |index: usize, words: [&str; 2]| words.iter().all(|word| swept[index].1.contains(word));
        assert!(found(0, ["concavity=0 ", "mesh=cut"]) && found(1, ["concavity=0 ", "mesh=refuse"]), "{swept:?}");
        assert!(found(4, ["concavity=1 ", "mesh=cut"]), "{swept:?}");
        // Without --methods too.
        assert_eq!(scene(&[], &["tracking.concavity=0,1"]).unwrap().len(), names_with_pictures().len() + 1);
        // The later of two settings of one option counts.
        assert_eq!(scene(&["tracking"], &["tracking.jump=1,2", "tracking.jump=3"]).unwrap().len(), 1);
    }

    #[test]
    fn a_method_may_be_listed_several_times_but_not_twice_the_same() {
        let mut twice = Profile::Quick.scene();
        twice.select(&["tracking".to_owned(), "tracking".to_owned()]);
        assert!(
            choices(&twice, &Registry::builtin())
                .unwrap_err()
                .to_string()
                .contains("tracking is there twice with the same options")
        );
        let level = OptionSpread::One(OptionSetting::Number(1.0));
        twice.methods[1].options.insert("concavity".to_owned(), level);
        assert_eq!(choices(&twice, &Registry::builtin()).unwrap().len(), 2);
        // A selection keeps what the scene says about its methods.
        twice.select(&["brute-force".to_owned(), "tracking".to_owned()]);
        assert_eq!(choices(&twice, &Registry::builtin()).unwrap().len(), 3);
    }

    #[test]
    fn what_does_not_fit_is_refused_with_what_would() {
        let refused = |methods: &[&str], setting: &str| scene(methods, &[setting]).unwrap_err();
        assert!(refused(&["brute-farce"], "brute-farce.x=1").contains("there is no method 'brute-farce'"));
        assert!(refused(&["brute-force"], "tracking.concavity=1").contains("name it in --methods"));
        assert!(refused(&["tracking"], "tracking.concave=1").contains("tracking: there is no option 'concave'"));
        assert!(refused(&["tracking"], "tracking.concavity=9").contains("a number from 0 to 3.2 rad"));
        assert!(refused(&["tracking"], "tracking.concavity=0,0").contains("twice"));
        for form in ["tracking", "tracking=1", "tracking.concavity", "tracking.concavity=", "tracking.concavity=1,,2"] {
            assert!(refused(&["tracking"], form).contains("METHOD.OPTION=VALUE[,VALUE...]"), "{form}");
        }
        let many: Vec<String> = (0..300).map(|at| format!("{}", f64::from(at) / 100.0)).collect();
        let many = refused(&["tracking"], &format!("tracking.concavity={}", many.join(",")));
        assert!(many.contains("300 combinations") && many.contains("256"), "{many}");
    }
}
