//! Step 2: what is drawn and stroked.
//!
//! Of all properties, those by which a stroke leaves ink or does not: `stroke`, `color`, `stroke-width`, `stroke-opacity`, `stroke-dasharray`,
//! `display`, `visibility` and `opacity`, and whether there are `clip-path` and `mask`. They come from attributes, then from style sheets, then from `style`; what is `!important` in a
//! style sheet stays.

use super::at;
use crate::foreign::error::ForeignFault;
use roxmltree::{Document, Node};
use simplecss::{AttributeOperator, Declaration, DeclarationTokenizer, PseudoClass, StyleSheet};
use svgtypes::{Color, Paint};

/// Most rules of all style sheets: each is tried on each element.
const MAX_RULES: usize = 1000;

/// How a shape is drawn. `Default` is what holds where nothing is said.
#[derive(Debug, Clone, Copy)]
pub struct Style {
    /// Whether it and what it holds is drawn at all.
    pub is_displayed: bool,
    is_visible: bool,
    is_opaque: bool,
    stroke: Stroke,
    /// What `currentColor` stands for.
    color: Stroke,
    has_opaque_stroke: bool,
    has_width: bool,
    /// Whether it is clipped or masked itself.
    pub is_clipped: bool,
    /// Whether its stroke is dashed.
    pub is_dashed: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stroke {
    None,
    Paper,
    Ink,
    /// As [`Style::color`] says, which may be set after it.
    CurrentColor,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            is_displayed: true,
            is_visible: true,
            is_opaque: true,
            stroke: Stroke::None,
            color: Stroke::Ink,
            has_opaque_stroke: true,
            has_width: true,
            is_clipped: false,
            is_dashed: false,
        }
    }
}

impl Style {
    /// Whether its stroke leaves ink.
    pub fn leaves_ink(&self) -> bool {
        self.is_stroked() && self.stroke() == Stroke::Ink
    }

    /// Whether its stroke is as white as the paper.
    pub fn is_paper(&self) -> bool {
        self.is_stroked() && self.stroke() == Stroke::Paper
    }

    fn stroke(&self) -> Stroke {
        if self.stroke == Stroke::CurrentColor { self.color } else { self.stroke }
    }

    fn is_stroked(&self) -> bool {
        self.is_displayed && self.is_visible && self.is_opaque && self.has_opaque_stroke && self.has_width
    }

    fn set(&mut self, name: &str, value: &str) {
        let value = value.trim();
        if value == "inherit" {
            return;
        }
        match name {
            "stroke" => self.stroke = stroke(value),
            // The colour of an element whose colour is its own current one is that of what holds it.
            "color" if stroke(value) != Stroke::CurrentColor => self.color = stroke(value),
            "stroke-width" => self.has_width = value.bytes().any(|byte| (b'1'..=b'9').contains(&byte)),
            "clip-path" | "mask" => self.is_clipped |= value != "none",
            "stroke-opacity" => self.has_opaque_stroke = is_above_zero(value),
            "opacity" => self.is_opaque &= is_above_zero(value),
            "stroke-dasharray" => self.is_dashed = value.bytes().any(|byte| (b'1'..=b'9').contains(&byte)),
            "display" => self.is_displayed = value != "none",
            "visibility" => self.is_visible = value == "visible",
            _ => {}
        }
    }
}

fn is_above_zero(value: &str) -> bool {
    value.trim_end_matches('%').parse().is_ok_and(|number: f64| number > 0.0)
}

fn stroke(value: &str) -> Stroke {
    match Paint::from_str(value) {
        Ok(Paint::None) => Stroke::None,
        Ok(Paint::CurrentColor) => Stroke::CurrentColor,
        Ok(Paint::Color(Color { alpha: 0, .. })) => Stroke::None,
        Ok(Paint::Color(Color { red: 255, green: 255, blue: 255, .. })) => Stroke::Paper,
        _ => Stroke::Ink,
    }
}

/// The style sheets of a document.
pub struct Styles<'a>(StyleSheet<'a>);

impl<'a> Styles<'a> {
    /// Reads them all. O(bytes).
    pub fn of(document: &'a Document<'_>) -> Result<Self, ForeignFault> {
        let mut sheet = StyleSheet::new();
        for node in document
            .descendants()
            .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "style")) || node.has_tag_name("style"))
        {
            for text in node.children().filter_map(|child| child.text()) {
                sheet.parse_more(text);
            }
            if sheet.rules.len() > MAX_RULES {
                let message = format!("more than {MAX_RULES} rules of style; write styles as attributes");
                return Err(at(&node, None, &message));
            }
        }
        Ok(Self(sheet))
    }

    /// The style of an element in one of this style.
    pub fn of_element(&self, node: &Node<'_, '_>, inherited: Style) -> Style {
        let mut style = Style { is_clipped: false, ..inherited };
        for attribute in node.attributes() {
            style.set(attribute.name(), attribute.value());
        }
        let matching = || self.0.rules.iter().filter(|rule| rule.selector.matches(&Element(*node)));
        let mut apply = |declaration: &Declaration<'_>| style.set(declaration.name, declaration.value);
        matching().flat_map(|rule| &rule.declarations).for_each(&mut apply);
        DeclarationTokenizer::from(node.attribute("style").unwrap_or_default())
            .for_each(|declaration| apply(&declaration));
        matching().flat_map(|rule| &rule.declarations).filter(|declaration| declaration.important).for_each(&mut apply);
        style
    }
}

/// An element as selectors ask about it.
struct Element<'a, 'input>(Node<'a, 'input>);

impl simplecss::Element for Element<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Element)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Element)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, local_name: &str, operator: AttributeOperator<'_>) -> bool {
        self.0.attribute(local_name).is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        matches!(class, PseudoClass::FirstChild) && self.prev_sibling_element().is_none()
    }
}
