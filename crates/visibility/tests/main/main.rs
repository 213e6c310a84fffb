//! Visible lines against brute force, closed forms and hostile scenes.

mod closed_forms;
mod determinism;
mod hostile;
mod octants;
mod oracle;
mod outline;
mod rays;
mod scenes;
mod soups;
mod strokes_of_the_caller;
