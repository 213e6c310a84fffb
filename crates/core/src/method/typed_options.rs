//! Options of a method as a struct: one field per option, from which the specification and the string form follow.
//!
//! [`method_options!`](crate::method_options) makes the struct, [`option_choice!`](crate::option_choice) the enums of
//! words among its fields. Each option is written once: its doc comment is also the summary of its [`OptionSpec`].

use super::options::{OptionError, OptionSpec, OptionValue, OptionValues};
use std::fmt::Debug;

/// The options of a method, as a struct whose fields hold checked or unchecked values.
///
/// Fields may be set by hand to anything of their type; [`validate`](Self::validate) says whether they are in range, and
/// every [`Method`](super::Method) refuses those that are not. Implemented by [`method_options!`](crate::method_options),
/// and by [`NoOptions`].
pub trait MethodOptions: Clone + Default + PartialEq + Debug + Send + Sync + 'static {
    /// Name, summary, unit, range and default of each field, in their order.
    const SPECS: &'static [OptionSpec];

    /// The struct of checked values.
    ///
    /// # Errors
    /// [`OptionError::Foreign`] where the values were made from the options of another method.
    fn read(values: &OptionValues) -> Result<Self, OptionError>;

    /// The value of each field, in the order of [`SPECS`](Self::SPECS), whether it is in range or not.
    fn field_values(&self) -> Vec<OptionValue>;

    /// The struct of `name=value` words, defaults filled in; of two for the same name the later one counts.
    ///
    /// # Errors
    /// [`OptionError`] names the first word that does not fit and what would.
    fn parse<'a>(words: impl IntoIterator<Item = &'a str>) -> Result<Self, OptionError> {
        Self::read(&OptionValues::parse(Self::SPECS, words)?)
    }

    /// The fields as checked values, whose text [`parse`](Self::parse) reads.
    ///
    /// # Errors
    /// [`OptionError::Value`] names the first field that is out of range.
    fn values(&self) -> Result<OptionValues, OptionError> {
        OptionValues::checked(Self::SPECS, self.field_values())
    }

    /// Whether each field is in range.
    ///
    /// # Errors
    /// As [`values`](Self::values).
    fn validate(&self) -> Result<(), OptionError> {
        self.values().map(drop)
    }
}

/// The options of a method that has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NoOptions;

impl MethodOptions for NoOptions {
    const SPECS: &'static [OptionSpec] = &[];

    fn read(_values: &OptionValues) -> Result<Self, OptionError> {
        Ok(Self)
    }

    fn field_values(&self) -> Vec<OptionValue> {
        Vec::new()
    }
}

/// An enum whose variants are words on the command line. Implemented by [`option_choice!`](crate::option_choice).
pub trait OptionChoice: Copy + 'static {
    /// The word of each variant, in their order. The first is the default.
    const WORDS: &'static [&'static str];

    /// The variant's word.
    fn word(self) -> &'static str;

    /// The variant of a word.
    fn of_word(word: &str) -> Option<Self>;
}

/// A type that a field of an options struct can have: `f64`, `u32` or an [`OptionChoice`].
pub trait OptionField: Copy {
    /// The field as a value.
    fn value(self) -> OptionValue;

    /// The field of a value; `None` if it is of another kind.
    fn of_value(value: OptionValue) -> Option<Self>;
}

impl OptionField for f64 {
    fn value(self) -> OptionValue {
        OptionValue::Number(self)
    }

    fn of_value(value: OptionValue) -> Option<Self> {
        if let OptionValue::Number(number) = value { Some(number) } else { None }
    }
}

impl OptionField for u32 {
    fn value(self) -> OptionValue {
        OptionValue::Whole(self)
    }

    fn of_value(value: OptionValue) -> Option<Self> {
        if let OptionValue::Whole(number) = value { Some(number) } else { None }
    }
}

impl<C: OptionChoice> OptionField for C {
    fn value(self) -> OptionValue {
        OptionValue::Choice(self.word())
    }

    fn of_value(value: OptionValue) -> Option<Self> {
        if let OptionValue::Choice(word) = value { Self::of_word(word) } else { None }
    }
}

impl OptionValues {
    /// The value of an option as the type of its field.
    ///
    /// # Errors
    /// [`OptionError::Foreign`] where there is no such option of this type: the values were made for another method.
    pub fn field<T: OptionField>(&self, name: &'static str) -> Result<T, OptionError> {
        self.get(name).and_then(T::of_value).ok_or(OptionError::Foreign { name })
    }
}

/// Makes the options struct of a method: the struct, its `Default`, and [`MethodOptions`](crate::method::MethodOptions).
///
/// Each field has a doc comment, which is also the summary of the option, and on its right one of
///
/// - `number("name", MIN..=MAX "unit", default VALUE)` for an `f64`; the unit is left out where there is none,
/// - `whole("name", MIN..=MAX "unit", default VALUE)` for a `u32`,
/// - `choice("name")` for an enum made by [`option_choice!`](crate::option_choice), whose first word is the default.
///
/// An option that trades speed for accuracy ends with the values that are worth comparing, its [`Sweep`](crate::method::Sweep):
/// `, sweep linear FROM..=TO` or `, sweep log FROM..=TO`, and for words `, sweep ["one", "another"]`.
///
/// Names, units, ranges and defaults are added to the documentation of the field. Summaries are printed as plain text, so
/// they hold no links.
///
/// ```
/// use silhouette_core::method::{MethodOptions, OptionValues};
///
/// silhouette_core::option_choice! {
///     /// How lines end.
///     pub enum Ends {
///         /// Bluntly.
///         Butt = "butt",
///         /// In half a disk.
///         Round = "round",
///     }
/// }
///
/// silhouette_core::method_options! {
///     /// Options of a method that draws lines.
///     pub struct PenOptions {
///         /// Width of lines: 0 draws nothing.
///         pub width_px: f64 = number("width", 0.0..=100.0 "px", default 2.0),
///         /// Copies of each line; more look more like a sketch.
///         pub copies: u32 = whole("copies", 1..=8, default 1, sweep linear 1..=4),
///         /// How lines end.
///         pub ends: Ends = choice("ends"),
///     }
/// }
///
/// let options = PenOptions { copies: 3, ..PenOptions::default() };
/// let text = options.values()?.to_string();
/// assert_eq!(text, "copies=3 ends=butt width=2");
/// assert_eq!(PenOptions::parse(text.split(' '))?, options);
///
/// assert_eq!(PenOptions::SPECS[0].summary, "Width of lines: 0 draws nothing.");
/// let error = PenOptions::parse(["width=200"]).unwrap_err();
/// assert_eq!(error.to_string(), "width=200 does not fit: a number from 0 to 100 px");
/// let too_many = PenOptions { copies: 100, ..options };
/// assert_eq!(too_many.validate().unwrap_err().to_string(), "copies=100 does not fit: a whole number from 1 to 8");
/// # Ok::<(), silhouette_core::method::OptionError>(())
/// ```
#[macro_export]
macro_rules! method_options {
    (
        $(#[$meta:meta])*
        $vis:vis struct $options:ident {
            $(
                $(#[doc = $doc:literal])+
                $field_vis:vis $field:ident: $type:ty = $kind:ident($($spec:tt)*)
            ),+ $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        $vis struct $options {
            $(
                $(#[doc = $doc])+
                #[doc = ""]
                #[doc = $crate::method_options!(@doc $kind($($spec)*))]
                $field_vis $field: $type,
            )+
        }

        impl ::core::default::Default for $options {
            fn default() -> Self {
                Self { $($field: $crate::method_options!(@default $kind($($spec)*))),+ }
            }
        }

        impl $crate::method::MethodOptions for $options {
            const SPECS: &'static [$crate::method::OptionSpec] = &[
                $($crate::method_options!(@spec ::core::concat!($($doc),+), $type, $kind($($spec)*))),+
            ];

            fn read(values: &$crate::method::OptionValues) -> ::core::result::Result<Self, $crate::method::OptionError> {
                ::core::result::Result::Ok(Self {
                    $($field: values.field($crate::method_options!(@name $($spec)*))?),+
                })
            }

            fn field_values(&self) -> ::std::vec::Vec<$crate::method::OptionValue> {
                ::std::vec![$($crate::method::OptionField::value(self.$field)),+]
            }
        }
    };

    (@name $name:literal $($rest:tt)*) => { $name };

    (@default choice($($spec:tt)*)) => { ::core::default::Default::default() };
    (
        @default
        $kind:ident($name:literal, $min:literal..=$max:literal $($unit:literal)?, default $default:literal $($sweep:tt)*)
    ) => {
        $default
    };

    (@doc choice($name:literal $($sweep:tt)*)) => {
        ::core::concat!("Option `", $name, "`: a word; the first is the default.")
    };
    (
        @doc
        $kind:ident($name:literal, $min:literal..=$max:literal $($unit:literal)?, default $default:literal $($sweep:tt)*)
    ) => {
        ::core::concat!(
            "Option `", $name, "`: ", ::core::stringify!($min), " to ", ::core::stringify!($max), $(" ", $unit,)?
            ", default ", ::core::stringify!($default), "."
        )
    };

    (@spec $doc:expr, $type:ty, choice($name:literal $($sweep:tt)*)) => {
        $crate::method::OptionSpec {
            name: $name,
            summary: $doc.trim_ascii(),
            unit: "",
            kind: $crate::method::OptionKind::Choice(<$type as $crate::method::OptionChoice>::WORDS),
            sweep: $crate::method_options!(@sweep $($sweep)*),
        }
    };
    (
        @spec $doc:expr, $type:ty,
        $kind:ident($name:literal, $min:literal..=$max:literal $($unit:literal)?, default $default:literal $($sweep:tt)*)
    ) => {
        $crate::method::OptionSpec {
            name: $name,
            summary: $doc.trim_ascii(),
            unit: ::core::concat!($($unit)?),
            kind: $crate::method_options!(@kind $kind $min, $max, $default),
            sweep: $crate::method_options!(@sweep $($sweep)*),
        }
    };

    (@sweep) => { ::core::option::Option::None };
    (@sweep , sweep linear $from:literal..=$to:literal) => {
        ::core::option::Option::Some($crate::method::Sweep::Linear { from: $from as f64, to: $to as f64 })
    };
    (@sweep , sweep log $from:literal..=$to:literal) => {
        ::core::option::Option::Some($crate::method::Sweep::Log { from: $from as f64, to: $to as f64 })
    };
    (@sweep , sweep [$($word:literal),+ $(,)?]) => {
        ::core::option::Option::Some($crate::method::Sweep::Words(&[$($word),+]))
    };

    (@kind number $min:literal, $max:literal, $default:literal) => {
        $crate::method::OptionKind::Number { min: $min, max: $max, default: $default }
    };
    (@kind whole $min:literal, $max:literal, $default:literal) => {
        $crate::method::OptionKind::Whole { min: $min, max: $max, default: $default }
    };
}

/// Makes an enum of the words that an option can have, with [`OptionChoice`](crate::method::OptionChoice). The first
/// variant is the default. See [`method_options!`](crate::method_options) for an example.
#[macro_export]
macro_rules! option_choice {
    (
        $(#[$meta:meta])*
        $vis:vis enum $choice:ident {
            $(#[$first_meta:meta])*
            $first:ident = $first_word:literal
            $(, $(#[$variant_meta:meta])* $variant:ident = $word:literal)*
            $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        $vis enum $choice {
            $(#[$first_meta])*
            #[doc = ""]
            #[doc = ::core::concat!("`", $first_word, "`, the default.")]
            #[default]
            $first,
            $(
                $(#[$variant_meta])*
                #[doc = ""]
                #[doc = ::core::concat!("`", $word, "`.")]
                $variant,
            )*
        }

        impl $crate::method::OptionChoice for $choice {
            const WORDS: &'static [&'static str] = &[$first_word $(, $word)*];

            fn word(self) -> &'static str {
                match self {
                    Self::$first => $first_word,
                    $(Self::$variant => $word,)*
                }
            }

            fn of_word(word: &str) -> ::core::option::Option<Self> {
                match word {
                    $first_word => ::core::option::Option::Some(Self::$first),
                    $($word => ::core::option::Option::Some(Self::$variant),)*
                    _ => ::core::option::Option::None,
                }
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    option_choice! {
        /// A mode.
        enum Mode {
            /// One.
            Screen = "screen",
            /// Other.
            Paper = "as-printed",
        }
    }

    method_options! {
        /// Options.
        struct Options {
            /// Of two lines, the second
            /// after the first.
            level_rad: f64 = number("level", 1e-6..=3.2 "rad", default 0.5),
            /// Any.
            seed: u32 = whole("seed", 0..=4_294_967_295, default 1),
            /// Mode.
            mode: Mode = choice("mode"),
        }
    }

    #[test]
    fn every_spec_follows_from_its_field() {
        let [level, seed, mode] = Options::SPECS else { panic!("three fields") };
        assert_eq!((level.name, level.unit), ("level", "rad"));
        assert_eq!(level.summary, "Of two lines, the second after the first.");
        assert_eq!(level.kind, super::super::OptionKind::Number { min: 1e-6, max: 3.2, default: 0.5 });
        assert_eq!(seed.kind, super::super::OptionKind::Whole { min: 0, max: u32::MAX, default: 1 });
        assert_eq!((seed.unit, mode.kind), ("", super::super::OptionKind::Choice(&["screen", "as-printed"])));
    }

    #[test]
    fn defaults_of_the_struct_are_those_of_its_specs() {
        assert_eq!(Options::default().values().unwrap(), OptionValues::defaults(Options::SPECS));
        assert_eq!(NoOptions.values().unwrap(), OptionValues::defaults(&[]));
    }

    #[test]
    fn text_round_trips() {
        let options = Options { level_rad: 0.25, seed: u32::MAX, mode: Mode::Paper };
        let text = options.values().unwrap().to_string();
        assert_eq!(text, "level=0.25 mode=as-printed seed=4294967295");
        assert_eq!(Options::parse(text.split(' ')).unwrap(), options);
        assert_eq!(
            [Mode::Screen, Mode::Paper].map(|mode| Mode::of_word(mode.word())),
            [Some(Mode::Screen), Some(Mode::Paper)]
        );
    }

    #[test]
    fn fields_out_of_range_are_refused_by_name() {
        for level_rad in [0.0, 4.0, f64::NAN, f64::INFINITY] {
            let error = Options { level_rad, ..Options::default() }.validate().unwrap_err();
            assert!(matches!(error, OptionError::Value { name: "level", .. }), "{level_rad}: {error}");
        }
    }

    #[test]
    fn values_of_another_method_are_refused() {
        assert_eq!(Options::read(&OptionValues::defaults(&[])), Err(OptionError::Foreign { name: "level" }));
        let values = OptionValues::defaults(Options::SPECS);
        assert_eq!(values.field::<f64>("mode"), Err(OptionError::Foreign { name: "mode" }));
        assert_eq!(values.field::<Mode>("level"), Err(OptionError::Foreign { name: "level" }));
        assert_eq!(NoOptions::read(&values), Ok(NoOptions));
    }
}
