//! Names of the columns of kinematics.

use percuss_mechanism::near_names;

/// Quantities with one column per spring, damper and stop.
const CONTACT_QUANTITIES: [&str; 5] = ["motion_ratio", "leverage_ratio", "ratio_gradient", "force", "moment"];

/// Name of a column: `CONTACT.QUANTITY`, such as `bump_stop_left.motion_ratio`, is the column `motion_ratio_bump_stop_left`; any other
/// name stays as it is.
pub fn column_name(text: &str) -> String {
    match text.split_once('.') {
        Some((contact, quantity)) => format!("{quantity}_{contact}"),
        None => text.to_owned(),
    }
}

/// True if `name` is a quantity of springs, dampers and stops without the name of a contact, and `column` is a column of this quantity.
pub(crate) fn is_of_every_contact(name: &str, column: &str) -> bool {
    CONTACT_QUANTITIES.contains(&name)
        && column.strip_prefix(name).is_some_and(|contact| contact.starts_with('_'))
}

/// Column of a target: a quantity without the name of a contact is that of the spring, if the suspension has one.
pub(crate) fn target_column(name: &str, columns: &[String]) -> String {
    let of_spring = format!("{name}_spring");
    let has_spring = columns.iter().any(|column| column.starts_with(&of_spring));
    if CONTACT_QUANTITIES.contains(&name) && has_spring { of_spring } else { name.to_owned() }
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
            "\"{name}\" is a quantity of a spring, damper or stop; expected one of: {}",
            of_contacts.join(", ")
        );
    }
    let near = near_names(name, names.iter().map(String::as_str)).into_iter().next();
    let near = near.map_or_else(String::new, |near| format!(" (did you mean \"{near}\"?)"));
    format!("no quantity \"{name}\"{near}; these are: {}", names.join(", "))
}
