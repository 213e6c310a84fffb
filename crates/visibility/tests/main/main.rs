//! Visible lines against brute force, closed forms and hostile scenes.

mod oracle;
mod rays;
mod scenes;
