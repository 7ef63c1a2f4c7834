//! A question about a model, and its answer: what the command line, and later the other faces, share.
//!
//! [`Model::load`] reads a file; [`mass`] answers one contact with a [`MassReport`]; [`check`] says what is in a
//! model with a [`CheckReport`]. Reports serialise to the JSON that scripts rely on. Nothing here writes to a
//! terminal.

mod check;
mod damped_contact;
mod damping;
mod estimate;
mod far_point;
mod findings;
mod mass;
mod measure;
mod model;
mod quantity;
mod question;
mod record;
mod safe_speed;
mod simulators;
mod study_file;
mod study_value;
mod sweep;

/// Contact laws, simulators and safe speeds, for the faces that name them.
pub use percuss_contact as contact;

pub use check::{CheckReport, ClosureRecord, JointRecord, LinkRecord, check};
pub use damped_contact::damp_contact;
pub use damping::{
    BodyAlone, DamperRecord, DampingQuestion, DampingReport, Drift, blow_history, damp, damper,
};
pub use estimate::EstimateRecord;
pub use mass::{
    Assumptions, BodyShare, ConditionsRecord, ContactRecord, HoldRecord, MassReport, RotorShare, Status,
    mass, mass_with_damper,
};
pub use measure::{Measure, Measured};
pub use model::{Input, Model};
pub use quantity::{Dimension, Quantity, QuantityError, parse_list, parse_triple};
pub use question::{EstimateQuestion, Hold, MassQuestion, Normal, StudyError};
pub use record::DiagnosticRecord;
pub use safe_speed::{Limit, SafeSpeedQuestion, SafeSpeedReport, SpeedRecord, safe_speed};
pub use simulators::ExportRecord;
pub use study_file::{StudyFile, StudyFileError};
pub use sweep::{SweepReport, SweepRow, Varied, Vary, sweep};
