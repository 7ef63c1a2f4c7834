//! The command, run as a program.

/// A contact at one pose, on several designs, or all over a link.
mod contacts {
    mod frames;
    mod map;
    mod mass;
    mod named_contacts;
    mod questions;
}

/// Closed linkages.
mod linkages {
    mod crossings;
    mod driving_joints;
    mod travel_ends;
}

/// Results that need a contact law.
mod impacts {
    mod cables_and_stops;
    mod damp;
    mod designs;
    mod drives;
    mod extremes;
    mod free_body;
    mod identify;
    mod masses_and_peaks;
    mod moments;
    mod reflected;
    mod rigid_impact;
    mod safe_speed;
}

/// `percuss sweep`.
mod sweep {
    mod grids;
    mod input;
    mod output;
    mod parquet;
    mod rows;
}

/// Study files.
mod study {
    mod contacts;
    mod init;
    mod keys;
    mod report;
    mod run;
}

/// Suspensions from sheets of hardpoints.
mod suspensions {
    mod compliance;
    mod contact_patches;
    mod daily_use;
    mod foreign_files;
    mod import;
    mod incomplete_sheets;
    mod kinematics;
    mod own_contacts;
    mod own_suspension;
    mod parts;
    mod round_trips;
    mod several_contacts;
    mod target_search;
    mod unequal_sides;
}

/// Files that are written or replaced.
mod files {
    mod conversion_changes;
    mod convert;
    mod explorer;
    mod export;
    mod generated_code;
    mod outputs;
    mod special_files;
    mod tables;
    mod windows;
}

/// Bad, hostile and large input.
mod limits {
    mod bounded;
    mod finding_cases;
    mod findings;
    mod hostile_names;
    mod input_rules;
    mod malformed;
    mod sizes;
}

/// Pages, models and help texts of the repository.
mod documentation {
    mod columns;
    mod models;
    mod pages;
}

mod support;

/// Commands with their expected output.
#[path = "cases/list.rs"]
mod cases;
