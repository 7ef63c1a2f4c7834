//! Identities and closed forms: what must hold of m̄ on every mechanism, and what it is where it can be written down.

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
