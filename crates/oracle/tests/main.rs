//! Tests of the oracle: closed forms and internal consistency.

mod closed_forms;
mod differences;
mod families;
mod figures;
mod invariance;
mod linkages;
mod loop_differences;
mod loops;
mod outcomes;
