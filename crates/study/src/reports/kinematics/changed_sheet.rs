//! Text of a sheet with moved hardpoints.

use crate::model::loading::Model;
use crate::reports::kinematics::errors::KinematicsError;
use std::collections::BTreeMap;

/// Text of the TOML sheet of a model with the hardpoints moved by `moves` (m, axes of the sheet) in addition to the moves of
/// the model. All other text stays.
///
/// # Errors
/// [`KinematicsError`]: a sheet in another format, or points in a table of their own.
pub fn changed_sheet(model: &Model, moves: &[(String, [f64; 3])]) -> Result<String, KinematicsError> {
    let refuse = |why: &str| KinematicsError::Search {
        why: format!("{why}; the changed sheet cannot be written, give the displacement by --move instead"),
    };
    let origin = model.origin.sheet.as_deref().ok_or_else(|| refuse("the model has no sheet"))?;
    let text = origin.sheet.text().ok_or_else(|| refuse("the sheet is no TOML file"))?;
    let mut shifts: BTreeMap<&str, [f64; 3]> = BTreeMap::new();
    for (point, by) in model.origin.changes.moves.iter().chain(moves) {
        let shift = shifts.entry(point).or_default();
        shift.iter_mut().zip(by).for_each(|(sum, x)| *sum += x);
    }
    let mut changed: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut section = String::new();
    for line in &mut changed {
        let trimmed = line.trim();
        if trimmed.starts_with('[') && !trimmed.contains('=') {
            trimmed.trim_matches(['[', ']']).clone_into(&mut section);
            continue;
        }
        let Some((key, value)) = line.split_once('=') else { continue };
        let Some(by) = shifts.get(key.trim()).filter(|_| section == "points") else { continue };
        let (open, close) =
            value.find('[').zip(value.find(']')).ok_or_else(|| refuse("a point is on several lines"))?;
        let known = origin.understood.coordinates.iter().find(|(name, _)| name == key.trim());
        let Some((_, at)) = known else { continue };
        // The coordinates of the model contain its own moves.
        let own = model.origin.changes.moves.iter().filter(|(name, _)| name == key.trim());
        let own = own.fold([0.0; 3], |sum, (_, by)| [0, 1, 2].map(|k| sum[k] + by[k]));
        let old: Vec<String> = value[open + 1..close].split(',').map(|x| x.trim().to_owned()).collect();
        let number = |k: usize| {
            if by[k] == 0.0 {
                return old.get(k).cloned().unwrap_or_default();
            }
            format!("{:?}", rounded(origin.understood.unit.of_metres(at[k] - own[k] + by[k])))
        };
        let list = [0, 1, 2].map(number).join(", ");
        let rest = value[close..].to_owned();
        let before = value[..=open].to_owned();
        let name = key.to_owned();
        shifts.remove(key.trim());
        *line = format!("{name}={before}{list}{rest}");
    }
    match shifts.keys().next() {
        Some(point) => Err(refuse(&format!("the section [points] of the sheet has no line \"{point} = …\""))),
        None => Ok(changed.join("\n") + "\n"),
    }
}

/// Number with thirteen significant digits: the last digits of a difference of coordinates are rounding errors.
fn rounded(x: f64) -> f64 {
    format!("{x:.12e}").parse().unwrap_or(x)
}
