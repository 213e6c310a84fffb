//! [`Row`]: an extreme, and what is expected of every method there.

use crate::cell::{Aspect, Found, Outcome};
use crate::meshes::torus;
use crate::scene::Scene;

/// Whom an expectation is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Who {
    /// Every method.
    All,
    /// What all methods yield of this.
    Every(Aspect),
    /// One method, whatever it yields.
    Method(&'static str),
    /// What one method yields of this.
    Of(&'static str, Aspect),
}

/// What is expected, and why where that is not evident.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expectation {
    /// Of whom.
    pub who: Who,
    /// The outcome.
    pub outcome: Outcome,
    /// The reason; empty for an outcome that needs none.
    pub why: &'static str,
}

type MakeScene = Box<dyn Fn() -> Result<Scene, Found> + Send + Sync>;

/// An extreme.
pub struct Row {
    /// Its name at the head of a column.
    pub name: &'static str,
    /// What goes in, in a sentence.
    pub input: &'static str,
    /// Makes what methods are given, or yields what refuses it before any method sees it.
    pub scene: MakeScene,
    /// Makes what pictures and curves are compared with.
    pub plain: fn() -> Scene,
    /// Name of the plain scene.
    pub plain_name: &'static str,
    /// Whether only methods with an option that the scene sets are concerned.
    pub is_about_options: bool,
    /// Expectations; the last that is about a cell counts.
    pub expected: Vec<Expectation>,
}

impl Row {
    /// A row whose scene is always made. Edges are expected to be exact, all else as in the plain case, a torus.
    pub fn new(name: &'static str, input: &'static str, scene: impl Fn() -> Scene + Send + Sync + 'static) -> Self {
        Self::fallible(name, input, move || Ok(scene()))
    }

    /// A row whose scene may be refused before any method sees it.
    pub fn fallible(
        name: &'static str,
        input: &'static str,
        scene: impl Fn() -> Result<Scene, Found> + Send + Sync + 'static,
    ) -> Self {
        let default = |aspect, outcome| Expectation { who: Who::Every(aspect), outcome, why: "" };
        Self {
            name,
            input,
            scene: Box::new(scene),
            plain: || Scene::of(torus()),
            plain_name: "torus",
            is_about_options: false,
            expected: vec![
                default(Aspect::Edges, Outcome::Exact),
                default(Aspect::Curves, Outcome::Same),
                default(Aspect::Lines, Outcome::Same),
                default(Aspect::Fill, Outcome::Same),
                Expectation {
                    who: Who::Of("randomized", Aspect::Edges),
                    outcome: Outcome::Subset,
                    why: "it looks at some faces only, and finds the loops that it meets",
                },
            ],
        }
    }

    /// The same, compared with another plain scene. Rows of one name share it.
    #[must_use]
    pub fn beside(self, plain_name: &'static str, plain: fn() -> Scene) -> Self {
        Self { plain_name, plain, ..self }
    }

    /// The same, about options: methods without one that the scene sets are not concerned.
    #[must_use]
    pub fn about_options(self) -> Self {
        Self { is_about_options: true, ..self }
    }

    /// One more expectation.
    #[must_use]
    pub fn expect(mut self, who: Who, outcome: Outcome, why: &'static str) -> Self {
        self.expected.push(Expectation { who, outcome, why });
        self
    }

    /// One more expectation of what some methods yield.
    #[must_use]
    pub fn expect_of(self, aspect: Aspect, methods: &[&'static str], outcome: Outcome, why: &'static str) -> Self {
        methods.iter().fold(self, |row, method| row.expect(Who::Of(method, aspect), outcome, why))
    }

    /// `randomized` happens to meet every loop.
    #[must_use]
    pub fn expect_all_of_randomized(self) -> Self {
        self.expect(Who::Of("randomized", Aspect::Edges), Outcome::Exact, "it meets every loop of this view")
    }

    /// What is expected of a cell.
    pub fn expected_of(&self, method: &str, aspect: Aspect) -> Expectation {
        let is_about = |expectation: &&Expectation| match expectation.who {
            Who::All => true,
            Who::Every(of) => of == aspect,
            Who::Method(name) => name == method,
            Who::Of(name, of) => name == method && of == aspect,
        };
        *self.expected.iter().rev().find(is_about).expect("a row expects something of every aspect")
    }
}
