//! Names of the columns of kinematics.

use percuss_mechanism::near_names;

/// Quantities with one column per spring, damper and stop.
const CONTACT_QUANTITIES: [&str; 2] = ["motion_ratio", "force"];

/// Name of a column: `CONTACT.QUANTITY`, such as `bump_stop_left.motion_ratio`, is the column `motion_ratio_bump_stop_left`; any other
/// name stays as it is.
pub fn column_name(text: &str) -> String {
    match text.split_once('.') {
        Some((contact, quantity)) => format!("{quantity}_{contact}"),
        None => text.to_owned(),
    }
}

/// Message about an unknown column. For a quantity with one column per spring, damper and stop, the message lists these columns.
pub(crate) fn unknown_column(name: &str, names: &[String]) -> String {
    let of_contacts: Vec<String> = names
        .iter()
        .filter_map(|known| known.strip_prefix(name)?.strip_prefix('_'))
        .map(|contact| format!("{contact}.{name}"))
        .collect();
    if !of_contacts.is_empty() && CONTACT_QUANTITIES.contains(&name) {
        return format!(
            "\"{name}\" is that of a spring, damper or stop; name it: {}",
            of_contacts.join(", ")
        );
    }
    let near = near_names(name, names.iter().map(String::as_str)).into_iter().next();
    let near = near.map_or_else(String::new, |near| format!(" (did you mean \"{near}\"?)"));
    format!("no quantity \"{name}\"{near}; these are: {}", names.join(", "))
}
