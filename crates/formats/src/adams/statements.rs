//! Statements of a dataset of Adams Solver: `NAME/ID, ARGUMENT = VALUE, VALUE, FLAG`.
//!
//! The first line is the title. A line that begins with a comma continues a statement, `!` begins a comment; Adams View writes the name of a
//! part in a comment above its statement. Names and arguments have no case. Source: Adams Solver, chapter *Using statements to define your
//! model*.

/// Statement of a dataset.
#[derive(Debug)]
pub(super) struct Statement {
    /// Name in capitals.
    pub kind: String,
    /// Identifier; empty without one.
    pub id: String,
    /// Name in Adams View; empty without one.
    pub view_name: String,
    /// Arguments in capitals with their values; a flag has none.
    pub arguments: Vec<(String, Vec<String>)>,
    /// First byte.
    pub at: usize,
}

impl Statement {
    /// Statement and identifier for messages: `JOINT/3`.
    pub fn name(&self) -> String {
        if self.id.is_empty() { self.kind.clone() } else { format!("{}/{}", self.kind, self.id) }
    }

    /// Values of an argument.
    pub fn values(&self, argument: &str) -> Option<&[String]> {
        self.arguments.iter().find(|(name, _)| name == argument).map(|(_, values)| &values[..])
    }

    /// The only value of an argument; empty without one.
    pub fn value(&self, argument: &str) -> &str {
        if let Some([value]) = self.values(argument) { value } else { "" }
    }

    /// True for an argument without values.
    pub fn has_flag(&self, flag: &str) -> bool {
        self.values(flag).is_some_and(<[String]>::is_empty)
    }
}

/// Name in Adams View in a comment: `adams_view_name='crank'`.
fn view_name(comment: &str) -> Option<&str> {
    comment.split_once("adams_view_name='")?.1.split('\'').next()
}

/// Parts of a text between commas outside of parentheses.
fn items(text: &str) -> Vec<&str> {
    let (mut depth, mut begin, mut found) = (0i64, 0, Vec::new());
    for (i, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                found.push(text[begin..i].trim());
                begin = i + 1;
            }
            _ => {}
        }
    }
    found.push(text[begin..].trim());
    found
}

/// Statement of a text without comments.
fn parse(text: &str, view_name: String, at: usize) -> Statement {
    let (head, rest) = text.split_once(['/', ',']).unwrap_or((text, ""));
    let kind = head.trim().to_ascii_uppercase();
    let mut statement = Statement { kind, id: String::new(), view_name, arguments: Vec::new(), at };
    for (i, item) in items(rest).into_iter().enumerate().filter(|(_, item)| !item.is_empty()) {
        let is_number = item.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        match item.split_once('=') {
            Some((name, value)) => {
                let (name, value) = (name.trim().to_ascii_uppercase(), value.trim().to_owned());
                statement.arguments.push((name, vec![value]));
            }
            None if i == 0 && text[head.len()..].starts_with('/') && is_number => {
                statement.id = item.trim_start_matches('0').to_owned();
            }
            None => match statement.arguments.last_mut() {
                Some((_, values)) if is_number && !values.is_empty() => values.push(item.to_owned()),
                _ => statement.arguments.push((item.to_ascii_uppercase(), Vec::new())),
            },
        }
    }
    statement
}

/// Statements of a text, up to `END`.
pub(super) fn read(text: &str) -> Vec<Statement> {
    let (mut found, mut open): (Vec<Statement>, Option<(String, String, usize)>) = (Vec::new(), None);
    let (mut name, mut offset) = (String::new(), 0);
    for (number, line) in text.split_inclusive('\n').enumerate() {
        let at = offset;
        offset += line.len();
        if number == 0 {
            continue;
        }
        let (content, comment) = line.split_once('!').unwrap_or((line, ""));
        let content = content.trim();
        match &mut open {
            Some((statement, ..)) if content.starts_with(',') => statement.push_str(content),
            _ if content.is_empty() => {}
            _ => {
                found.extend(open.take().map(|(text, name, at)| parse(&text, name, at)));
                open = Some((content.to_owned(), std::mem::take(&mut name), at));
            }
        }
        if let Some(of_view) = view_name(comment) {
            name = of_view.to_owned();
        }
    }
    found.extend(open.map(|(text, name, at)| parse(&text, name, at)));
    if let Some(end) = found.iter().position(|statement| statement.kind == "END") {
        found.truncate(end);
    }
    found
}

/// Number of a value; angles in degrees end in D: `90D`.
pub(super) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let (digits, factor) = match text.strip_suffix(['D', 'd']) {
        Some(digits) => (digits, std::f64::consts::PI / 180.0),
        None => (text, 1.0),
    };
    let value = digits.trim().parse::<f64>().ok()? * factor;
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_are_split_into_arguments() {
        let text = "title PART/1\n! adams_view_name='arm'\nPart/02, mass = 3 ! kg\n, CM = 5, IP = 1, 2.5,-3\n,GROUND\nOUTPUT/REQSAVE\nEND\nPART/9\n";
        let found = read(text);
        assert_eq!(found.len(), 2);
        let part = &found[0];
        assert_eq!(
            (part.name(), part.view_name.as_str(), part.value("MASS")),
            ("PART/2".to_owned(), "arm", "3")
        );
        assert_eq!(part.values("IP").map(<[String]>::len), Some(3));
        assert!(part.has_flag("GROUND") && !part.has_flag("MASS"));
        assert_eq!(found[1].name(), "OUTPUT");
        assert!((number("90D").unwrap() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert_eq!((number("1.5E+02"), number("x")), (Some(150.0), None));
    }
}
