//! Unique names for links and joints that have none in the file.

use std::collections::{HashMap, HashSet};

/// Names in use.
#[derive(Debug, Default)]
pub(crate) struct UniqueNames {
    used: HashSet<String>,
    /// Number to try next, by wanted name.
    next: HashMap<String, usize>,
}

impl UniqueNames {
    /// Marks names of the file as used.
    pub fn reserve<'n>(&mut self, names: impl Iterator<Item = &'n str>) {
        self.used.extend(names.map(str::to_owned));
    }

    /// Reserves and returns the wanted name, or, if it is in use, the first free name with an appended number.
    pub fn take(&mut self, wanted: String) -> String {
        if self.used.insert(wanted.clone()) {
            return wanted;
        }
        let next = self.next.entry(wanted.clone()).or_insert(2);
        loop {
            let name = format!("{wanted}_{next}");
            *next += 1;
            if self.used.insert(name.clone()) {
                return name;
            }
        }
    }
}
