//! What is baked, against closed forms and brute force.

mod atlas;
mod closed_forms;
mod errors;
mod exact_rays;
mod resume;
