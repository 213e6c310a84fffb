//! Step 1: what is wanted. A [`Goal`] decides which methods come into question and by which [errors](ErrorMetric) they can be
//! judged; an [`ErrorLimit`] says how large one of them may be.

use crate::metrics::table::{Better, METRICS, PictureKind};
use crate::registry::Capabilities;
use serde::{Deserialize, Serialize};

/// What a method is wanted for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Goal {
    /// Visible silhouette lines as ink.
    Lines,
    /// The filled image of the mesh.
    Fill,
    /// Closed loops of silhouette edges, visible or not.
    Loops,
}

/// A way of judging one view: a finite number, 0 at best, in the same unit for all methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ErrorMetric {
    /// Name on the command line and in results.
    pub name: &'static str,
    /// Name in a sentence.
    pub title: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// What it is, in one sentence.
    pub summary: &'static str,
}

/// The errors of [`Goal::Loops`], in the order of [`EdgeErrors::values`](super::loops::EdgeErrors::values).
pub const LOOP_METRICS: [ErrorMetric; 3] = [
    ErrorMetric {
        name: "differing_edges",
        title: "differing edges",
        unit: "share",
        summary: "Silhouette edges that no loop holds, plus edges of loops that are no silhouette edges, over the silhouette edges.",
    },
    ErrorMetric {
        name: "missed_edges",
        title: "missed edges",
        unit: "share",
        summary: "Silhouette edges that no loop holds, over the silhouette edges.",
    },
    ErrorMetric {
        name: "wrong_edges",
        title: "wrong edges",
        unit: "share",
        summary: "Edges of loops that are no silhouette edges, over the silhouette edges.",
    },
];

impl Goal {
    /// Every goal.
    pub const ALL: [Self; 3] = [Self::Lines, Self::Fill, Self::Loops];

    /// Name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lines => "lines",
            Self::Fill => "fill",
            Self::Loops => "loops",
        }
    }

    /// Whether a method with these capabilities comes into question.
    pub fn is_met_by(self, can: Capabilities) -> bool {
        match self {
            Self::Lines => can.lines || can.edges,
            Self::Fill => can.fill,
            Self::Loops => can.loops,
        }
    }

    /// The kind of picture that is drawn and judged; `None` where edges are.
    pub fn picture(self) -> Option<PictureKind> {
        match self {
            Self::Lines => Some(PictureKind::Lines),
            Self::Fill => Some(PictureKind::Fill),
            Self::Loops => None,
        }
    }

    /// The errors that can be limited: of pictures every metric of [`METRICS`] that is better the lower it is and that this
    /// build measures.
    pub fn metrics(self) -> Vec<ErrorMetric> {
        let Some(kind) = self.picture() else { return LOOP_METRICS.to_vec() };
        let is_measured = |name: &str| name != "flip" || cfg!(feature = "flip");
        let of_kind = METRICS.iter().filter(|metric| metric.kind == kind && metric.better == Better::Lower);
        let measured = of_kind.filter(|metric| is_measured(metric.name));
        let metric = measured.map(|metric| ErrorMetric {
            name: metric.name,
            title: metric.title,
            unit: metric.unit,
            summary: metric.summary,
        });
        metric.collect()
    }

    /// The limit where the user states none: lines and boundaries half a pixel off on average, all edges and no others.
    pub fn default_limit(self) -> ErrorLimit {
        let (name, max) = match self {
            Self::Lines => ("chamfer_px", 0.5),
            Self::Fill => ("boundary_chamfer_px", 0.5),
            Self::Loops => ("differing_edges", 0.0),
        };
        ErrorLimit { metric: name.to_owned(), max }
    }
}

/// How large an error may be.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ErrorLimit {
    /// Name of the [`ErrorMetric`].
    pub metric: String,
    /// Largest value, in the metric's unit, 0 or more.
    pub max: f64,
}

/// Why a limit was refused.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LimitFault {
    /// Not of the form `NAME=MAX`, or a number alone.
    #[error("'{text}' is not of the form NAME=MAX, for example {example}, or a number of 0 or more for {metric}")]
    Form {
        /// What was given.
        text: String,
        /// What would be right.
        example: String,
        /// The metric that a number alone limits.
        metric: String,
    },
    /// The goal has no such error.
    #[error("'{name}' is no error of {goal} that is better the lower it is; there are {known}")]
    Metric {
        /// What was given.
        name: String,
        /// The goal.
        goal: &'static str,
        /// The names that exist, separated by commas.
        known: String,
    },
}

impl ErrorLimit {
    /// Reads `NAME=MAX`, or `MAX` alone for the goal's own metric.
    ///
    /// # Errors
    /// [`LimitFault`].
    pub fn parse(goal: Goal, text: &str) -> Result<Self, LimitFault> {
        let own = goal.default_limit().metric;
        let (name, max) = text.split_once('=').unwrap_or((&own, text));
        let form = || LimitFault::Form { text: text.to_owned(), example: format!("{own}=0.2"), metric: own.clone() };
        let max = max.trim().parse().ok().filter(|max: &f64| max.is_finite() && *max >= 0.0).ok_or_else(form)?;
        let limit = Self { metric: name.trim().to_owned(), max };
        limit.place(goal).map(|_| limit)
    }

    /// Where the metric stands among those of a goal.
    ///
    /// # Errors
    /// [`LimitFault::Metric`].
    pub fn place(&self, goal: Goal) -> Result<usize, LimitFault> {
        let metrics = goal.metrics();
        let known = || metrics.iter().map(|metric| metric.name).collect::<Vec<_>>().join(", ");
        let fault = || LimitFault::Metric { name: self.metric.clone(), goal: goal.name(), known: known() };
        metrics.iter().position(|metric| metric.name == self.metric).ok_or_else(fault)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::Registry;

    #[test]
    fn every_goal_has_methods_and_limits_an_error_of_its_own() {
        for goal in Goal::ALL {
            assert!(goal.default_limit().place(goal).is_ok());
            let of_goal = Registry::builtin().names(|entry| goal.is_met_by(entry.capabilities()));
            assert!(of_goal.split(", ").count() >= 4, "{}: {of_goal}", goal.name());
        }
    }

    #[test]
    fn limits_are_read_with_and_without_a_name() {
        let limit = |goal, text| ErrorLimit::parse(goal, text).map_err(|fault| fault.to_string());
        assert_eq!(limit(Goal::Lines, "0.25").unwrap(), ErrorLimit { metric: "chamfer_px".to_owned(), max: 0.25 });
        assert_eq!(limit(Goal::Loops, "missed_edges=0.1").unwrap().metric, "missed_edges");
        for text in ["", "x", "chamfer_px=", "-1", "NaN", "chamfer_px=inf"] {
            let fault = limit(Goal::Lines, text).unwrap_err();
            assert!(fault.contains("NAME=MAX") && fault.contains("chamfer_px=0.2"), "{fault}");
        }
        let fault = limit(Goal::Fill, "chamfer_px=1").unwrap_err();
        assert!(fault.contains("no error of fill") && fault.contains("xor_share"), "{fault}");
        assert!(limit(Goal::Fill, "psnr_db=30").is_err(), "higher is better");
    }

    /// The table of METRICS.md is written from the same rows.
    #[test]
    fn the_documentation_holds_the_errors_of_loops() {
        let text = include_str!("../../../../docs/METRICS.md");
        for ErrorMetric { name, unit, summary, .. } in LOOP_METRICS {
            let row = format!("| `{name}` | {unit} | {summary} |");
            assert!(text.contains(&row), "docs/METRICS.md lacks this row:\n{row}");
        }
    }
}
