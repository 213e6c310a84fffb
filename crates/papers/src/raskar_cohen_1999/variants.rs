//! What is drawn: every variant of the paper at the settings that its text names, and ours.

use silhouette_core::Method;
use silhouette_core::method::{OptionError, OptionValues};
use silhouette_image_precision::ImagePrecision;

/// One variant with its options.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Variant {
    /// Its label in tables.
    pub label: &'static str,
    /// `name=value` words, separated by spaces.
    pub words: &'static str,
    /// What its picture is expected to show.
    pub expected: &'static str,
}

/// All of them, in the order of the tables.
pub const VARIANTS: [Variant; 16] = [
    variant("screen", "variant=screen", "2.00 to 2.05 px everywhere, no gap"),
    variant("equal", "variant=equal", "next to nothing: depths differ at pixel centres"),
    variant("wireframe", "variant=wireframe width=2", "1 px: front faces hide the inner half"),
    variant("fixed pull", "variant=fixed-pull", "width as the square of the pull on smooth rims"),
    variant("scale 0.99", "variant=scale scale=0.99", "hairlines: below a tenth of a pixel on smooth rims"),
    variant("scale 0.95", "variant=scale scale=0.95", "0.6 px on smooth rims, much shows through"),
    variant("near plane out", "variant=depth-range plane-factor=1.05", "much as scale 0.95"),
    variant("far plane closer", "variant=depth-range depth-plane=far plane-factor=0.8", "nothing, against the text"),
    variant("far plane out", "variant=depth-range depth-plane=far plane-factor=1.25", "as the near plane moved out"),
    variant("offset 4", "variant=offset offset-slope=4", "at most 2 px on smooth rims, more at creases"),
    variant("offset 16", "variant=offset offset-slope=16", "at most 8 px on smooth rims; shows through"),
    variant("fatten", "variant=fatten", "spikes cut at four edge lengths"),
    variant("fatten, no clamp", "variant=fatten fatten-clamp=0", "spikes, the longer the finer the mesh"),
    variant(
        "fatten, as printed",
        "variant=fatten fatten-law=as-printed fatten-clamp=0",
        "the same, wider off the axis",
    ),
    variant("fatten, no sine", "variant=fatten-simple", "wider the more edges point at the viewer"),
    variant("charcoal", "variant=charcoal interior=paper", "grey strokes on either side"),
];

const fn variant(label: &'static str, words: &'static str, expected: &'static str) -> Variant {
    Variant { label, words, expected }
}

impl Variant {
    /// Its options, defaults filled in.
    ///
    /// # Errors
    /// [`OptionError`], which a test rules out for [`VARIANTS`].
    pub fn options(&self) -> Result<OptionValues, OptionError> {
        OptionValues::parse(ImagePrecision::INFO.options, self.words.split(' '))
    }
}

/// The variants that draw all that is not in the first layer; measured where winding says nothing.
pub const UNORIENTED: [Variant; 2] = [
    variant("unoriented", "variant=unoriented", "as scale 0.99: no pixel moves, so that small faces cannot ink"),
    variant(
        "unoriented, screen",
        "variant=unoriented unoriented-lines=screen",
        "front faces too small to be seen are inked as well",
    ),
];

/// The paper's law without a bound.
pub const AS_PRINTED: Variant = VARIANTS[13];

/// The oriented variants that [`UNORIENTED`] do the same as, one after another, where every face has a number that is seen.
pub const UNORIENTED_LIKE: [Variant; 2] = [VARIANTS[4], VARIANTS[0]];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn variants_are_options_and_labels_are_unique() {
        let all = VARIANTS.iter().chain(&UNORIENTED);
        let labels: BTreeSet<_> = all.clone().map(|variant| variant.label).collect();
        assert_eq!(labels.len(), VARIANTS.len() + UNORIENTED.len());
        assert!(all.into_iter().all(|variant| variant.options().is_ok()));
        assert_eq!(UNORIENTED_LIKE.map(|variant| variant.label), ["scale 0.99", "screen"]);
        assert_eq!(AS_PRINTED.label, "fatten, as printed");
    }
}
