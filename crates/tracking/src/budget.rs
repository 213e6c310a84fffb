//! The error-budget mode: a concavity level that follows from the error that a user accepts. Not in Hall's paper.
//!
//! Which level misses how much depends on the mesh, its tessellation and the path of the eye, so it is found out while
//! tracking. Every now and then a frame is *audited*: once it has been tracked, all other faces are evaluated too, and the
//! length of silhouette that this adds, over the whole length, is the share that tracking had missed. The audited frame
//! itself is exact, and what was missed is tracked from then on.
//!
//! - *When*: as soon as the frames since the last audit have evaluated so many faces that an audit of F faces is no more
//!   than [`ErrorBudget::audit_share`] of them.
//! - *What follows*: a share above the budget lowers the level by one step of the table, by two if it is more than four times the budget.
//!   A share below a quarter of the budget raises it by one step, if enough audits in a row were so good: one at first,
//!   twice as many after each time that the level had to be lowered, so that it settles.
//!
//! The budget is kept by observation, not by proof: between two audits more may be missed.

use crate::options::{Concavity, ErrorBudget};

/// The levels to choose from, from exact to fast.
const LEVELS: [Concavity; 9] = [
    Concavity::Above(0.0),
    Concavity::Above(0.01),
    Concavity::Above(0.02),
    Concavity::Above(0.05),
    Concavity::Above(0.1),
    Concavity::Above(0.2),
    Concavity::Above(0.5),
    Concavity::Above(1.0),
    Concavity::Ignored,
];

/// Most good audits in a row that are asked for before the level is raised.
const MOST_PATIENCE: u32 = 64;

/// What an audit saw and did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Audit {
    /// Length of silhouette that tracking had missed in this frame, over the whole length, in object space: 0 to 1.
    pub missed_share: f64,
    /// The level that the frame was tracked at.
    pub level: Concavity,
    /// The level that the next frames are tracked at.
    pub next_level: Concavity,
}

/// The level of a tracker with a budget, and what it rests on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BudgetMode {
    budget: ErrorBudget,
    step: usize,
    /// Faces evaluated since the last audit.
    evaluated: u64,
    /// Audits in a row below a quarter of the budget, and how many of them raise the level.
    good_audits: u32,
    patience: u32,
}

impl BudgetMode {
    /// Begins at level 0.
    pub fn new(budget: ErrorBudget) -> Self {
        Self { budget, step: 0, evaluated: 0, good_audits: 0, patience: 1 }
    }

    /// The level of the next frame.
    pub fn level(&self) -> Concavity {
        LEVELS[self.step]
    }

    /// Whether this frame, tracked by evaluating some of `faces` faces, is to be audited.
    pub fn is_due(&mut self, evaluated: u64, faces: usize) -> bool {
        self.evaluated += evaluated;
        let is_due = self.evaluated as f64 * f64::from(self.budget.audit_share) >= faces as f64;
        if is_due {
            self.evaluated = 0;
        }
        is_due
    }

    /// Draws the conclusion from an audit.
    pub fn conclude(&mut self, missed_share: f64) -> Audit {
        let level = self.level();
        let budget = f64::from(self.budget.missed_share);
        if missed_share > budget {
            self.step = self.step.saturating_sub(if missed_share > 4.0 * budget { 2 } else { 1 });
            self.patience = (2 * self.patience).min(MOST_PATIENCE);
            self.good_audits = 0;
        } else if missed_share <= budget / 4.0 {
            self.good_audits += 1;
            if self.good_audits >= self.patience {
                self.step = (self.step + 1).min(LEVELS.len() - 1);
                self.good_audits = 0;
            }
        } else {
            self.good_audits = 0;
        }
        Audit { missed_share, level, next_level: self.level() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A made-up mesh that misses this much at each step of the table.
    const MISSED: [f64; 9] = [0.0, 0.001, 0.004, 0.009, 0.03, 0.06, 0.1, 0.2, 0.3];

    fn shares_after(budget: f32, audits: usize) -> Vec<f64> {
        let mut mode = BudgetMode::new(ErrorBudget { missed_share: budget, audit_share: 0.1 });
        (0..audits)
            .map(|_| {
                let missed = MISSED[mode.step];
                let audit = mode.conclude(missed);
                assert_eq!(audit.next_level, mode.level());
                missed
            })
            .collect()
    }

    #[test]
    fn the_level_settles_below_the_budget() {
        for budget in [0.01, 0.05, 0.2] {
            let shares = shares_after(budget, 1000);
            let violations = shares[500..].iter().filter(|&&share| share > f64::from(budget)).count();
            assert!(violations <= 8, "{violations} of 500 audits beyond {budget}");
            let mean = shares[500..].iter().sum::<f64>() / 500.0;
            assert!(mean <= f64::from(budget) && mean >= f64::from(budget) / 20.0, "{mean} for {budget}");
        }
        assert!(shares_after(0.0, 100).iter().skip(50).filter(|&&share| share > 0.0).count() <= 2);
        assert_eq!(shares_after(1.0, 20).last(), Some(&0.3), "whoever accepts everything gets the fastest");
    }

    #[test]
    fn audits_cost_their_share() {
        let mut mode = BudgetMode::new(ErrorBudget { missed_share: 0.01, audit_share: 0.1 });
        let audits = (0..1000).filter(|_| mode.is_due(200, 1000)).count();
        assert_eq!(audits, 1000 * 200 / (10 * 1000));
    }
}
