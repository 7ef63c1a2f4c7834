//! File of a sheet with moved hardpoints.

use crate::model::loading::Model;
use crate::reports::kinematics::errors::KinematicsError;
use percuss_suspension::ChangedFile;
use std::collections::BTreeMap;

/// File with the hardpoints of a model, moved by `moves` (m, axes of the sheet) in addition to the moves of the model, in the format that was
/// read. All other content stays.
///
/// # Errors
/// [`KinematicsError`]: no sheet, or points without coordinates of their own in a file.
pub fn changed_sheet(model: &Model, moves: &[(String, [f64; 3])]) -> Result<ChangedFile, KinematicsError> {
    let refuse = |why: &str| KinematicsError::Search {
        why: format!("{why}; the changed sheet cannot be written, give the displacement by --move instead"),
    };
    let origin = model.origin.sheet.as_deref().ok_or_else(|| refuse("the model has no sheet"))?;
    let mut shifts: BTreeMap<&str, [f64; 3]> = BTreeMap::new();
    for (point, by) in model.origin.changes.moves.iter().chain(moves) {
        let shift = shifts.entry(point).or_default();
        shift.iter_mut().zip(by).for_each(|(sum, x)| *sum += x);
    }
    let shifts: Vec<(String, [f64; 3])> =
        shifts.into_iter().map(|(name, by)| (name.to_owned(), by)).collect();
    origin.sheet.changed(&shifts).map_err(|why| refuse(&why))
}
