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
