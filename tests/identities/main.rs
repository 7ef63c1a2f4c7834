//! Identities and closed forms: properties of m̄ on every mechanism, and values of m̄ with a closed form.

mod accelerations;
mod batches;
mod closed_forms;
mod derivatives;
mod energies;
mod fallbacks;
mod invariances;
mod maps;
mod matrices;
mod orderings;
mod outcomes;
mod routes;
mod scalars;
mod workspaces;

/// Largest relative difference of two results without a stated error: these are near a singular pose or a massless
/// motion, where six digits are left.
const UNSTATED: f64 = 1e-6;
