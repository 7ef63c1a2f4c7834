//! Header of a table: the columns of the names and of the coordinates, their units and their side.
//!
//! A cell is split into words; every word must be known. A row of words that determines the columns not completely is refused: points
//! would be read by position.

use super::super::entries::{Cell, parse_number};
use crate::options::Side;
use percuss_units::LengthUnit;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];
/// Characters between the words of a cell. Any other character apart from letters makes the cell unknown: −x, 2y, |z|.
const SEPARATORS: &str = " \u{a0}\t\n\r_-.,:;/()[]{}<>";

/// Words of headers, from the data file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Words {
    x: Vec<String>,
    y: Vec<String>,
    z: Vec<String>,
    name: Vec<String>,
    other: Vec<String>,
    left: Vec<String>,
    right: Vec<String>,
    unit: Vec<String>,
    units: BTreeMap<String, Vec<String>>,
}

static WORDS: LazyLock<Words> = LazyLock::new(|| {
    toml::from_str(include_str!("header-words.toml")).expect("the words of this crate are valid")
});

/// Unit of length with a name in one of the languages.
pub(in super::super) fn unit_of(word: &str) -> Option<LengthUnit> {
    let known = WORDS.units.iter().find(|(_, words)| words.iter().any(|known| known == word));
    known.and_then(|(unit, _)| LengthUnit::from_name(unit))
}

/// Meaning of one cell.
#[derive(Clone, Debug, Default, PartialEq)]
struct Meaning {
    /// Axes in the order of the words, each once.
    axes: Vec<usize>,
    units: Vec<LengthUnit>,
    sides: Vec<Side>,
    is_name: bool,
    is_unit_column: bool,
    /// True for words without influence.
    has_others: bool,
    /// True if a word names a direction of the vehicle: longitudinal, in place of x.
    has_direction: bool,
}

impl Meaning {
    /// Meaning of a text; `None` if a word is unknown or the words contradict each other.
    fn of(text: &str) -> Option<Self> {
        let text = without_accents(text);
        let is_signed = text.starts_with('-');
        if is_signed || !text.chars().all(|c| c.is_ascii_lowercase() || SEPARATORS.contains(c)) {
            return None;
        }
        let (mut meaning, mut rest) = (Self::default(), &*text);
        while let Some(start) = rest.find(|c| !SEPARATORS.contains(c)) {
            let (before, from) = rest.split_at(start);
            let end = from.find(|c| SEPARATORS.contains(c)).unwrap_or(from.len());
            let (word, after) = from.split_at(end);
            rest = after;
            // The preposition of "x in mm"; the unit of "x_in [mm]" is inches, a contradiction.
            let is_open = after.starts_with(' ') && !before.contains('_');
            let next = after.trim_matches(|c| SEPARATORS.contains(c));
            let is_preposition = word == "in" && is_open && unit_of(next).is_some();
            if !is_preposition && !meaning.add(word) {
                return None;
            }
        }
        (meaning.units.len() < 2 && meaning.sides.len() < 2).then_some(meaning)
    }

    /// Adds a word, or a compound of an axis and another word; false if unknown.
    fn add(&mut self, word: &str) -> bool {
        let words = &*WORDS;
        let is_in = |list: &[String]| list.iter().any(|known| known == word);
        if let Some(axis) = [&words.x, &words.y, &words.z].iter().position(|list| is_in(list)) {
            add_once(&mut self.axes, axis);
            self.has_direction |= word != AXES[axis];
        } else if let Some(unit) = unit_of(word) {
            add_once(&mut self.units, unit);
        } else if is_in(&words.left) {
            add_once(&mut self.sides, Side::Left);
        } else if is_in(&words.right) {
            add_once(&mut self.sides, Side::Right);
        } else if is_in(&words.name) {
            self.is_name = true;
        } else if is_in(&words.unit) {
            self.is_unit_column = true;
        } else if is_in(&words.other) {
            self.has_others = true;
        } else {
            return self.add_compound(word);
        }
        true
    }

    /// Adds a compound without separator: "xmm", "yleft", "posx", "langsrichtung"; false if unknown.
    fn add_compound(&mut self, word: &str) -> bool {
        let words = &*WORDS;
        let is_axis =
            |part: &str| [&words.x, &words.y, &words.z].iter().any(|list| list.iter().any(|w| w == part));
        let fillers = || words.name.iter().chain(&words.other);
        let with_filler = fillers().find_map(|filler| {
            word.strip_suffix(&**filler).or_else(|| word.strip_prefix(&**filler)).filter(|part| is_axis(part))
        });
        if let Some(axis) = with_filler {
            return self.add(axis);
        }
        // Units and sides follow a single letter only: "lat" and "long" with a letter may be another word.
        let Some((letter, end)) = word.split_at_checked(1).filter(|(letter, _)| AXES.contains(letter)) else {
            return false;
        };
        let is_end = unit_of(end).is_some()
            || [&words.left, &words.right].iter().any(|list| list.iter().any(|w| w == end));
        is_end && self.add(letter) && self.add(end)
    }

    /// True for a unit alone.
    fn is_unit(&self) -> bool {
        self.units.len() == 1
            && self.axes.is_empty()
            && self.sides.is_empty()
            && !self.is_name
            && !self.is_unit_column
            && !self.has_others
    }
}

fn add_once<T: PartialEq>(list: &mut Vec<T>, item: T) {
    if !list.contains(&item) {
        list.push(item);
    }
}

/// Text in lower case without accents.
fn without_accents(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for c in text.trim().to_lowercase().chars() {
        match c {
            'à'..='å' | 'ą' => plain.push('a'),
            'ç' | 'ć' | 'č' => plain.push('c'),
            'è'..='ë' | 'ę' | 'ě' => plain.push('e'),
            'ì'..='ï' => plain.push('i'),
            'ł' => plain.push('l'),
            'ñ' | 'ń' => plain.push('n'),
            'ò'..='ö' | 'ø' => plain.push('o'),
            'ř' => plain.push('r'),
            'ś' | 'š' => plain.push('s'),
            'ù'..='ü' | 'ů' => plain.push('u'),
            'ý' => plain.push('y'),
            'ź' | 'ż' | 'ž' => plain.push('z'),
            'ß' => plain.push_str("ss"),
            'æ' => plain.push_str("ae"),
            '−' | '–' | '—' => plain.push('-'),
            // Combining accents of decomposed letters.
            '\u{300}'..='\u{36f}' => {}
            c => plain.push(c),
        }
    }
    plain
}

/// Columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Columns {
    pub name: usize,
    pub xyz: [usize; 3],
    /// Units of x, y, z: all given, or none.
    pub units: Option<[LengthUnit; 3]>,
    /// Column of the units of the rows.
    pub unit: Option<usize>,
    /// Columns x, y, z of the other side.
    pub other_side: Option<[usize; 3]>,
    /// True if a column is named by its direction in the vehicle: longitudinal, in place of x.
    pub has_directions: bool,
    /// Number of columns before the first cell of the header.
    shift: usize,
    /// True for x, y, z in this order with these names, behind the name, without further columns.
    is_plain: bool,
}

/// Kind of a row.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Row {
    /// Title, key or data.
    Other,
    Header(Columns),
    /// Row above a header that names the sides of its columns.
    Sides,
    /// Row of words that is no complete header, with the reason; `has_parts`: a cell names an axis, a unit or a side.
    Unclear {
        reason: String,
        has_parts: bool,
    },
}

/// Text of a cell that is no number, no length and not empty.
fn word(cell: &Cell) -> Option<&str> {
    match cell {
        Cell::Text(text) => Some(text.trim()).filter(|text| !text.is_empty() && !is_number(text)),
        Cell::Number(_) | Cell::Switch(_) | Cell::Unreadable(_) => None,
    }
}

fn is_number(text: &str) -> bool {
    parse_number(percuss_units::split(text).0).is_some()
}

/// Header below a row that names sides, such as "Left" above x, y, z and "Right" above x, y, z: each axis with the side that is next to
/// the left of it. `None` for other rows.
pub(super) fn with_sides(above: &[Cell], header: &[Cell]) -> Option<Vec<Cell>> {
    let meaning = |cell: &Cell| word(cell).and_then(Meaning::of);
    let side_at = |i: usize| {
        let named = above.iter().take(i + 1).rev().filter_map(meaning);
        named.map(|m| m.sides).find(|sides| !sides.is_empty()).map(|sides| sides[0])
    };
    let sides: Vec<Side> = above.iter().filter_map(meaning).flat_map(|m| m.sides).collect();
    let has_axes = |row: &[Cell]| row.iter().filter_map(meaning).any(|m| !m.axes.is_empty());
    let has_sides = |row: &[Cell]| row.iter().filter_map(meaning).any(|m| !m.sides.is_empty());
    if sides.len() != 2 || sides[0] == sides[1] || has_axes(above) || !has_axes(header) || has_sides(header) {
        return None;
    }
    let with_side = |(i, cell): (usize, &Cell)| match (meaning(cell), word(cell), side_at(i)) {
        (Some(m), Some(text), Some(side)) if !m.axes.is_empty() => {
            Cell::Text(format!("{text} {}", if side == Side::Right { "right" } else { "left" }))
        }
        _ => cell.clone(),
    };
    Some(header.iter().enumerate().map(with_side).collect())
}

/// Kind of a row; `side`: side of the points to read, for headers with both sides.
pub(super) fn read(cells: &[Cell], side: Side) -> Row {
    let meanings: Vec<Option<Meaning>> = cells.iter().map(|cell| Meaning::of(word(cell)?)).collect();
    let with_axis: Vec<(usize, &Meaning)> = meanings
        .iter()
        .enumerate()
        .filter_map(|(i, m)| Some((i, m.as_ref()?)))
        .filter(|(_, m)| !m.axes.is_empty())
        .collect();
    let named = |axis: usize| with_axis.iter().any(|(_, m)| m.axes.contains(&axis));
    let axes = (0..3).filter(|axis| named(*axis)).count();
    let is_ordered_title = with_axis.len() == 1 && with_axis[0].1.axes == [0, 1, 2];
    let words = cells.iter().skip(1).filter(|cell| word(cell).is_some()).count();
    let numbers = cells
        .iter()
        .filter(|cell| matches!(cell, Cell::Number(_)) || matches!(cell, Cell::Text(text) if is_number(text)))
        .count();
    if numbers >= 3 || words < 3 && (axes < 2 || is_ordered_title) {
        return Row::Other;
    }
    match columns(cells, &meanings, &with_axis, side) {
        Ok(columns) => Row::Header(columns),
        Err(reason) => {
            let has_parts = meanings
                .iter()
                .flatten()
                .any(|m| !m.axes.is_empty() || !m.units.is_empty() || !m.sides.is_empty());
            Row::Unclear { reason, has_parts }
        }
    }
}

/// Columns of a header; the error is the reason why they are not determined.
fn columns(
    cells: &[Cell],
    meanings: &[Option<Meaning>],
    with_axis: &[(usize, &Meaning)],
    side: Side,
) -> Result<Columns, String> {
    if let Some((i, _)) = with_axis.iter().find(|(_, m)| m.axes.len() > 1) {
        return Err(format!("{} names two axes", cells[*i].to_text()));
    }
    let has_sides = with_axis.iter().any(|(_, m)| !m.sides.is_empty());
    let wanted = if has_sides { vec![side] } else { Vec::new() };
    let mut xyz = [0; 3];
    for (axis, name) in AXES.into_iter().enumerate() {
        let of_axis: Vec<usize> = with_axis
            .iter()
            .filter(|(_, m)| m.axes == [axis] && m.sides == wanted)
            .map(|(i, _)| *i)
            .collect();
        // Complete blocks x, y, z of the left and of the right side, or of two units: the first one is used.
        let blocks = with_axis.len() / 3;
        let is_block = with_axis.len().is_multiple_of(3)
            && with_axis.chunks(3).all(|block| block.iter().any(|(_, m)| m.axes == [axis]));
        xyz[axis] = match of_axis[..] {
            [column] => column,
            [first, ..] if !has_sides && is_block && of_axis.len() == blocks => first,
            [] if has_sides => {
                let side = if side == Side::Right { "right" } else { "left" };
                return Err(format!("some columns name a side, and no column is {name} of the {side} side"));
            }
            [] => {
                let unknown = cells
                    .iter()
                    .zip(meanings)
                    .skip(1)
                    .filter(|(cell, m)| m.is_none() && word(cell).is_some());
                let unknown: Vec<String> = unknown.map(|(cell, _)| cell.to_text()).take(3).collect();
                let unknown = if unknown.is_empty() {
                    String::new()
                } else {
                    format!(" ({} is not understood)", unknown.join(", "))
                };
                return Err(format!("no column is {name}{unknown}"));
            }
            _ => return Err(format!("several columns are {name}")),
        };
    }
    let unit = |i: usize| meanings[i].as_ref().and_then(|m| m.units.first().copied());
    // "Point [mm]" or a cell "[mm]" states the unit of the columns without one.
    let others: Vec<LengthUnit> =
        meanings.iter().flatten().filter(|m| m.axes.is_empty()).flat_map(|m| m.units.clone()).collect();
    let units = match xyz.map(unit) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        [None, None, None] if others.windows(2).all(|pair| pair[0] == pair[1]) => {
            others.first().map(|unit| [*unit; 3])
        }
        _ => return Err("x, y and z do not have one unit each".to_owned()),
    };
    let is_letter = |(axis, i): (usize, usize)| {
        let text = word(&cells[i]).unwrap_or_default();
        text.split([' ', '[', '(']).next().is_some_and(|first| first.eq_ignore_ascii_case(AXES[axis]))
    };
    let has_more = cells.iter().skip(4).any(|cell| word(cell).is_some());
    let is_plain = xyz == [1, 2, 3] && xyz.into_iter().enumerate().all(is_letter) && !has_more;
    let is_unit_column = |m: &Option<Meaning>| m.as_ref().is_some_and(|m| m.is_unit_column);
    let unit = meanings.iter().position(is_unit_column);
    let has_directions = xyz.iter().any(|i| meanings[*i].as_ref().is_some_and(|m| m.has_direction));
    let other = if side == Side::Right { Side::Left } else { Side::Right };
    let of_other = |axis: usize| {
        let columns: Vec<usize> = with_axis
            .iter()
            .filter(|(i, m)| m.axes == [axis] && !xyz.contains(i) && (!has_sides || m.sides == [other]))
            .map(|(i, _)| *i)
            .collect();
        if let [column] = columns[..] { Some(column) } else { None }
    };
    let other_side = match [0, 1, 2].map(of_other) {
        [Some(x), Some(y), Some(z)] if has_sides => Some([x, y, z]),
        _ => None,
    };
    Ok(Columns { name: 0, xyz, units, unit, other_side, has_directions, shift: 0, is_plain })
}

/// True for a title or comment with the letters of the three axes side by side, first in another order than x, y, z.
pub(super) fn names_other_order(line: &str) -> bool {
    let words = line.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let axes: Vec<_> =
        words.map(|word| AXES.iter().position(|axis| word.eq_ignore_ascii_case(axis))).collect();
    let is_order = |order: &&[Option<usize>]| (0..3).all(|axis| order.contains(&Some(axis)));
    axes.windows(3).find(is_order).is_some_and(|order| order != [Some(0), Some(1), Some(2)])
}

/// Unit of length that a title states: "Units; mm", "Hardpoints [in]"; `None` if a word is unknown.
pub(super) fn unit_of_title(cells: &[Cell]) -> Option<LengthUnit> {
    let words = cells.iter().filter_map(word);
    let meanings = words.map(Meaning::of).collect::<Option<Vec<_>>>()?;
    let units: Vec<LengthUnit> = meanings.iter().flat_map(|m| m.units.clone()).collect();
    let is_plain = meanings.iter().all(|m| m.axes.is_empty() && m.sides.is_empty());
    units.first().copied().filter(|unit| is_plain && units.iter().all(|other| other == unit))
}

impl Columns {
    /// Columns name, x, y, z of a table without a header.
    pub fn without_header() -> Self {
        Self {
            name: 0,
            xyz: [1, 2, 3],
            units: None,
            unit: None,
            other_side: None,
            has_directions: false,
            shift: 0,
            is_plain: true,
        }
    }

    /// Finds the column of the names: text in all rows of points, by preference below a word such as "name". A header without a cell for
    /// the names begins at the second column.
    pub fn find_names<'r>(&mut self, header: &[Cell], rows: impl Iterator<Item = &'r [Cell]>) {
        let is_value = |cell: &&Cell| !matches!(cell, Cell::Text(text) if !is_number(text));
        let points: Vec<&[Cell]> = rows.filter(|row| row.iter().filter(is_value).count() >= 3).collect();
        let has_names =
            |i: usize| !points.is_empty() && points.iter().all(|row| row.get(i).and_then(word).is_some());
        if self.xyz.contains(&0) && has_names(0) {
            (self.xyz, self.unit, self.shift) = (self.xyz.map(|i| i + 1), self.unit.map(|i| i + 1), 1);
            self.other_side = self.other_side.map(|xyz| xyz.map(|i| i + 1));
            return;
        }
        let is_named = |i: &usize| {
            header
                .get(*i)
                .and_then(word)
                .and_then(Meaning::of)
                .is_some_and(|m| m.is_name && m.axes.is_empty())
        };
        let candidates = || (0..header.len()).filter(|i| !self.xyz.contains(i) && has_names(*i));
        self.name = candidates().find(is_named).or_else(|| candidates().next()).unwrap_or(0);
        self.is_plain &= self.name == 0;
    }

    /// Adds the units of a second row of the header, if the row has units in the columns x, y, z.
    ///
    /// # Errors
    /// Units that contradict those of the first row.
    pub fn add_units(&mut self, row: &[Cell]) -> Result<bool, String> {
        let unit = |i: usize| {
            let meaning = row.get(i).and_then(word).and_then(Meaning::of).filter(Meaning::is_unit);
            meaning.and_then(|m| m.units.first().copied())
        };
        let [Some(x), Some(y), Some(z)] = self.xyz.map(unit) else { return Ok(false) };
        match self.units {
            Some(units) if units != [x, y, z] => {
                Err("the units of this row contradict those of the row above".to_owned())
            }
            _ => {
                self.units = Some([x, y, z]);
                Ok(true)
            }
        }
    }

    /// Columns of the other side in place of those of the side that is read.
    pub fn of_other_side(&self) -> Option<Self> {
        Some(Self { xyz: self.other_side?, ..self.clone() })
    }

    /// Unit of all three columns.
    pub fn common_unit(&self) -> Option<LengthUnit> {
        self.units.filter(|[x, y, z]| x == y && y == z).map(|[x, ..]| x)
    }

    /// Coordinates of a row, each number with its unit; `default`: unit if the header has none.
    pub fn values(&self, row: &[Cell], default: Option<LengthUnit>) -> Vec<Cell> {
        let of_row = self.unit.and_then(|i| row.get(i)).and_then(word);
        let value = |(axis, i): (usize, usize)| {
            let unit = of_row.map(|word| unit_of(&word.to_lowercase()).map_or(word, |unit| unit.name()));
            let of_column = self.units.map(|units| units[axis]).or(default).map(LengthUnit::name);
            with_units(row.get(i)?, &[unit, of_column])
        };
        self.xyz.into_iter().enumerate().filter_map(value).collect()
    }

    /// Message about the columns that are used; `None` for the plain header name, x, y, z.
    pub fn message(&self, header: &[Cell]) -> Option<String> {
        if self.is_plain {
            return None;
        }
        let title = |i: usize| {
            i.checked_sub(self.shift)
                .and_then(|i| header.get(i))
                .map_or_else(String::new, |cell| format!(" {}", cell.to_text()))
        };
        let used = ["name", "x", "y", "z"].into_iter().zip([self.name].into_iter().chain(self.xyz));
        let used: Vec<String> =
            used.map(|(role, i)| format!("{role} = column {}{}", i + 1, title(i))).collect();
        let is_used = |i: &usize| *i == self.name || self.xyz.contains(i) || self.unit == Some(*i);
        let unused: Vec<String> = (0..header.len())
            .filter(|i| !is_used(&(i + self.shift)) && word(&header[*i]).is_some())
            .map(|i| header[i].to_text())
            .collect();
        let unused =
            if unused.is_empty() { String::new() } else { format!("; not used: {}", unused.join(", ")) };
        Some(format!("columns of the points: {}{unused}", used.join(", ")))
    }
}

/// Number with its units, each once: two different units make it no length. Any other cell is unchanged; a number with its own unit, too.
fn with_units(cell: &Cell, units: &[Option<&str>]) -> Option<Cell> {
    let number = match cell {
        Cell::Number(x) => format!("{x}"),
        Cell::Text(text) if parse_number(text).is_some() => text.trim().to_owned(),
        Cell::Text(_) | Cell::Switch(_) | Cell::Unreadable(_) => return Some(cell.clone()),
    };
    let mut units: Vec<&str> = units.iter().flatten().copied().collect();
    units.dedup();
    Some(if units.is_empty() { cell.clone() } else { Cell::Text(format!("{number} {}", units.join(" "))) })
}
