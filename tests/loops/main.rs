//! Closed loops: assembly, continuation, and results on them.

mod against_the_oracle;
mod assembly;
mod branches;
mod closed_forms;
mod kinds;
mod many_freedoms;
mod paths;
mod rank;
mod sweeps;
mod travel;
