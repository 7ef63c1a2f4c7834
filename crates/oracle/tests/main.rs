//! The oracle against closed forms and itself.

mod closed_forms;
mod differences;
mod families;
mod figures;
mod invariance;
mod linkages;
mod loop_differences;
mod loops;
mod outcomes;
