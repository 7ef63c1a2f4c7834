//! Parser for one level of JSON at a time. Values remain slices of the text, so their positions are known.

use crate::limits::MAX_KEYS;
use serde::de::{Deserialize, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::fmt;

/// JSON object; the values remain text.
pub(super) struct Object<'t> {
    pub entries: Vec<(String, &'t RawValue)>,
    /// True if entries beyond the limit were dropped.
    pub too_many: bool,
}

impl<'de: 't, 't> Deserialize<'de> for Object<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> Visitor<'de> for Entries {
            type Value = Object<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Object<'de>, A::Error> {
                let mut entries = Vec::new();
                while let Some(key) = map.next_key::<String>()? {
                    if entries.len() == MAX_KEYS {
                        map.next_value::<IgnoredAny>()?;
                        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
                        return Ok(Object { entries, too_many: true });
                    }
                    entries.push((key, map.next_value::<&'de RawValue>()?));
                }
                Ok(Object { entries, too_many: false })
            }
        }
        deserializer.deserialize_map(Entries)
    }
}

/// JSON array: the first three entries as text, and the length.
pub(super) struct Array<'t> {
    pub first: [Option<&'t RawValue>; 3],
    pub length: usize,
}

impl<'de: 't, 't> Deserialize<'de> for Array<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> Visitor<'de> for Entries {
            type Value = Array<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an array")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Array<'de>, A::Error> {
                let mut array = Array { first: [None; 3], length: 0 };
                for entry in &mut array.first {
                    *entry = seq.next_element::<&'de RawValue>()?;
                    if entry.is_none() {
                        return Ok(array);
                    }
                    array.length += 1;
                }
                while seq.next_element::<IgnoredAny>()?.is_some() {
                    array.length = array.length.checked_add(1).ok_or_else(|| A::Error::custom("too long"))?;
                }
                Ok(array)
            }
        }
        deserializer.deserialize_seq(Entries)
    }
}
