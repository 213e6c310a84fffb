//! What is baked, against closed forms and brute force.

mod closed_forms;
