//! Tests over several crates.
//!
//! Programs of their own: `allocations.rs` has a global allocator that counts, and `tidy` uses no code of percuss.

/// Identities and closed forms: properties of m̄ on every mechanism, and values of m̄ with a closed form.
mod identities {
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
    mod row_contacts;
    mod workspaces;
}

/// Closed loops: assembly, continuation, and results on them.
mod loops {
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
}

/// Families of mechanisms with known results: rounded files, independent mechanisms in one file, loops drawn open,
/// extreme sizes, robots with held points.
mod families {
    mod adams_datasets;
    mod certificates;
    mod coverage;
    mod drawn_open;
    mod first_poses;
    mod gazebo_joints;
    mod held_points;
    mod independent_groups;
    mod moments;
    mod rigid;
    mod rounded_files;
    mod tiny_and_huge;
    mod turned_lines;
}

mod precision;
mod readers;
