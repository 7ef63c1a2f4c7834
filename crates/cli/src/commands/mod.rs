//! One module per subcommand.

pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod damp;
pub(crate) mod exports;
pub(crate) mod impacts;
pub(crate) mod init;
pub(crate) mod map;
pub(crate) mod mass;
pub(crate) mod report;
pub(crate) mod run;
pub(crate) mod suspension;
pub(crate) mod sweep;
pub(crate) mod sweep_text;
