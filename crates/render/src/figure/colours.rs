//! Colours of series.

use super::Panel;
use crate::palette::{Colour, SERIES};

/// Assigns a colour to every series, panel by panel. Equal names get the same colour, each unnamed series a new one.
pub(crate) fn assign_colours(panels: &[Panel]) -> Vec<Vec<Colour>> {
    let mut assigned = std::collections::HashMap::new();
    let mut used = 0;
    let mut next = || {
        used += 1;
        SERIES[(used - 1) % SERIES.len()]
    };
    panels
        .iter()
        .map(|panel| {
            let colour_of = |series: &crate::Series| match series.name.as_str() {
                "" => next(),
                name => *assigned.entry(name.to_owned()).or_insert_with(&mut next),
            };
            panel.series.iter().map(colour_of).collect()
        })
        .collect()
}
