//! Help texts.

pub(super) mod examples;
pub(super) mod short_help;
pub(super) mod usage_error;
