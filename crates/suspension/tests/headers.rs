//! Headers of tables of points: a family of orders, words, units, separators and first cells. Each header is read as name, x, y, z, or
//! refused.

use super::sheets::Car;
use percuss_formats::{LoadError, Source};
use percuss_suspension::{ImportOptions, Imported, import};

/// Words of the axes x, y, z.
const WORDS: [[&str; 3]; 21] = [
    ["x", "y", "z"],
    ["X", "Y", "Z"],
    ["loc_x", "loc_y", "loc_z"],
    ["X coordinate", "Y coordinate", "Z coordinate"],
    ["Coord X", "Coord Y", "Coord Z"],
    ["PosX", "PosY", "PosZ"],
    ["x-pos.", "y-pos.", "z-pos."],
    ["Point X", "Point Y", "Point Z"],
    ["Longitudinal", "Lateral", "Vertical"],
    ["LONG", "LAT", "VERT"],
    ["X (longitudinal)", "Y (lateral)", "Z (vertical)"],
    ["length", "width", "height"],
    ["Länge", "Breite", "Höhe"],
    ["Laengsrichtung", "Querrichtung", "Hochrichtung"],
    ["x-Koordinate", "y-Koordinate", "z-Koordinate"],
    ["Longueur", "Largeur", "Hauteur"],
    ["Lunghezza", "Larghezza", "Altezza"],
    ["Longitud", "Anchura", "Altura"],
    ["Lengte", "Breedte", "Hoogte"],
    ["Comprimento", "Largura", "Altura"],
    ["Längd", "Bredd", "Höjd"],
];

/// Words that determine no axis, or another one: such a header is refused.
const TRAPS: [[&str; 3]; 11] = [
    ["x1", "x2", "x3"],
    ["-y", "x", "z"],
    ["X (lateral)", "Y (longitudinal)", "Z (vertical)"],
    ["Forward", "Left", "Up"],
    ["depth", "width", "height"],
    ["dx", "dy", "dz"],
    ["Largo", "Ancho", "Alto"],
    ["east", "north", "up"],
    ["x", "x", "z"],
    ["y left", "x", "z"],
    ["lateral", "longitudinal", "elevation of the point"],
];

const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 0, 2], [2, 1, 0], [0, 2, 1], [1, 2, 0], [2, 0, 1]];

/// Endings with the unit of a column, and the length of the unit in mm, the unit of the sheet.
const UNITS: [(&str, f64); 12] = [
    ("", 1.0),
    (" [mm]", 1.0),
    ("_mm", 1.0),
    ("(mm)", 1.0),
    (" in mm", 1.0),
    (" / mm", 1.0),
    ("_in", 25.4),
    (" [in]", 25.4),
    (" (inch)", 25.4),
    (" in cm", 10.0),
    ("_m", 1e3),
    (" in Zoll", 25.4),
];

/// Double wishbone with like distances in x and y, so that exchanged columns are a possible suspension.
fn car() -> Car {
    let mut car = Car::example("double-wishbone");
    car.without(&[]);
    let moved = |at: [f64; 3]| [at[0] + 700.0, at[1], at[2]];
    car.points.iter_mut().for_each(|(_, at)| *at = moved(*at));
    car.bodies.iter_mut().for_each(|(_, _, com, _)| *com = com.map(moved));
    car
}

/// Table with all data: keys, then the header and the rows of the points.
fn table(
    car: &Car,
    keys: &str,
    separator: &str,
    header: &[String],
    row: impl Fn(&str, [f64; 3]) -> Vec<String>,
) -> String {
    let mut text = format!(
        "template,double-wishbone\nunit,mm\naxes,iso\nwheel.mass,18.5\nwheel.inertia,0.62,1.05,0.62\n{keys}"
    );
    for (name, mass, com, inertia) in &car.bodies {
        let list = |values: &[f64]| values.iter().map(|x| format!(",{x}")).collect::<String>();
        text += &format!("{name}.mass,{mass}\n");
        text += &com.map_or_else(String::new, |com| format!("{name}.com{}\n", list(&com)));
        text +=
            &if inertia.is_empty() { String::new() } else { format!("{name}.inertia{}\n", list(inertia)) };
    }
    text = text.replace(',', separator);
    for cells in [header.to_vec()].into_iter().chain(car.points.iter().map(|(name, at)| row(name, *at))) {
        text += &(cells.join(separator) + "\n");
    }
    text
}

fn read(text: &str) -> Result<Imported, LoadError> {
    import(&Source::from_text("my.csv", text), &ImportOptions::default())
}

/// True if the table gives the points of the car; false if its header is refused. Other points, or another error, fail the test.
#[track_caller]
fn is_read(text: &str, car: &Car) -> bool {
    match read(text) {
        Ok(imported) => {
            for (name, at) in &imported.understood.coordinates {
                let expected = car.point(name);
                let off = expected - nalgebra::Vector3::from(*at);
                // Roundings of the conversion between units.
                assert!(off.amax() < 1e-12, "{name} at {at:?} m, expected {expected}\n{text}");
            }
            assert_eq!(imported.understood.coordinates.len(), car.points.len(), "{text}");
            true
        }
        Err(error) => {
            let is_about_header = error.diagnostics.iter().any(|d| d.code == "unknown-header");
            assert!(is_about_header, "{error}\n{text}");
            false
        }
    }
}

fn texts(cells: &[&str]) -> Vec<String> {
    cells.iter().map(|cell| (*cell).to_owned()).collect()
}

#[test]
fn columns_have_the_meaning_of_their_words() {
    let car = car();
    let (firsts, separators) = (["name", "Point", "", "Hardpoint name", "Gelenkpunkt"], [",", ";", "\t"]);
    let mut count = 0;
    for (i, words) in WORDS.iter().chain(&TRAPS).enumerate() {
        for (k, order) in ORDERS.iter().enumerate() {
            for round in 0..2 {
                let (unit, in_mm) = UNITS[(6 * i + k + 5 * round) % UNITS.len()];
                let separator = separators[(i + k + round) % 3];
                let cell = |axis: &usize| {
                    let cell = format!("{}{unit}", words[*axis]);
                    if round == 1 && i % 4 == 0 { cell.to_uppercase() } else { cell }
                };
                let mut header = vec![firsts[(i + k + round) % 5].to_owned()];
                header.extend(order.iter().map(cell));
                let row = |name: &str, at: [f64; 3]| {
                    let values = order.iter().map(|axis| format!("{}", at[*axis] / in_mm));
                    [name.to_owned()].into_iter().chain(values).collect()
                };
                let text = table(&car, "", separator, &header, row);
                // The header is below the keys or the first row of the file.
                let at = text.find(&header.join(separator)).expect("the header");
                let text = if round == 0 { text } else { format!("{}{}", &text[at..], &text[..at]) };
                let is_known = i < WORDS.len();
                // A trap may be a title of another kind of table, but its points are never read.
                assert_eq!(is_read(&text, &car), is_known, "{header:?}");
                count += 1;
            }
        }
    }
    assert!(count >= 200, "{count}");
    // The family detects exchanged columns: their points are a possible suspension, read without error.
    let exchanged = |name: &str, [x, y, z]: [f64; 3]| {
        vec![name.to_owned(), format!("{y}"), format!("{x}"), format!("{z}")]
    };
    let other = read(&table(&car, "", ",", &texts(&["name", "x", "y", "z"]), exchanged));
    let other = other.unwrap_or_else(|error| panic!("{error}"));
    assert!(other.understood.coordinates.iter().all(|(name, at)| (car.point(name).x - at[0]).abs() > 1e-3));
}

/// Names that are not in the first column, both sides, a second row of units, units of rows, a header without the column of names.
#[test]
fn columns_of_names_units_and_sides_are_found() {
    let car = car();
    let numbers = |[x, y, z]: [f64; 3]| texts(&[&format!("{y}"), &format!("{x}"), &format!("{z}")]);
    let plain = |name: &str, at: [f64; 3]| [vec![name.to_owned()], numbers(at)].concat();
    let behind =
        |first: &'static str| move |name: &str, at: [f64; 3]| [texts(&[first, name]), numbers(at)].concat();
    let last = |name: &str, at: [f64; 3]| [numbers(at), vec![name.to_owned()]].concat();
    let both = |name: &str, at: [f64; 3]| {
        [vec![name.to_owned()], numbers([at[0], -at[1], at[2]]), numbers(at)].concat()
    };
    let inches = |name: &str, [x, y, z]: [f64; 3]| {
        texts(&[name, &format!("{}", y / 25.4), &format!("{x}"), &format!("{z}"), "mm"])
    };
    let in_inches = |name: &str, at: [f64; 3]| plain(name, at.map(|x| x / 25.4));
    let of_row = |name: &str, at: [f64; 3]| [in_inches(name, at), texts(&["in"])].concat();
    let found: Vec<bool> = [
        table(&car, "", ";", &texts(&["id", "Name", "y", "x", "z"]), behind("7")),
        table(
            &car,
            "",
            ";",
            &texts(&["Group", "Point", "Lateral", "Longitudinal", "Vertical"]),
            behind("front"),
        ),
        table(&car, "", ";", &texts(&["y", "x", "z", "Name"]), last),
        table(&car, "", ";", &texts(&["y", "x", "z"]), plain),
        table(&car, "", ";", &texts(&["Point", "Y_R", "X_R", "Z_R", "Y_L", "X_L", "Z_L"]), both),
        table(
            &car,
            "",
            ";",
            &texts(&["Point", "Y (Right)", "X (Right)", "Z (Right)", "Y (Left)", "X (Left)", "Z (Left)"]),
            both,
        ),
        table(
            &car,
            "",
            ";",
            &texts(&["Point", "Lateral [in]", "Longitudinal [mm]", "Vertical [mm]"]),
            inches,
        ),
        table(&car, "", ";", &texts(&["Point", "y", "x", "z\n;[in];[in];[in]"]), in_inches),
        table(&car, "", ";", &texts(&["Point [in]", "y", "x", "z"]), in_inches),
        table(&car, "", ";", &texts(&["Point", "y", "x", "z", "Unit"]), of_row),
        format!("Units;inch\n{}", table(&car, "", ";", &texts(&["Point", "y", "x", "z"]), in_inches)),
        // Not understood, and refused.
        table(&car, "", ";", &texts(&["Point", "y_mm [in]", "x", "z"]), plain),
        table(&car, "", ";", &texts(&["Point", "y [in]", "x [in]", "z [in]\n;[mm];[mm];[mm]"]), plain),
        table(&car, "", ";", &texts(&["Point", "y [mm]", "x", "z"]), plain),
        table(&car, "", ";", &texts(&["Point", "y", "x"]), plain),
        table(&car, "", ";", &texts(&["Point", "Coordinates (y, x, z)"]), plain),
        table(&car, "", ";", &texts(&["name", "y", "x", "z"]), plain) + "name;x;y;z\n",
        table(&car, "", ";", &texts(&["name", "y", "x", "z"]), plain).replace("name;y;x;z\n", "")
            + "name;y;x;z\n",
        table(&car, "side,right\n", ";", &texts(&["Point", "Y_L", "X_L", "Z_L"]), plain),
    ]
    .iter()
    .map(|text| is_read(text, &car))
    .collect();
    assert_eq!(found, [[true; 11].as_slice(), &[false; 8]].concat());
    // The columns used are stated.
    let imported =
        read(&table(&car, "", ";", &texts(&["Punkt", "Breite", "Länge", "Höhe", "Bemerkung"]), plain))
            .unwrap();
    let told = imported.diagnostics.iter().find(|d| d.code == "columns").expect("a note");
    for words in ["x = column 3 \"Länge\"", "y = column 2 \"Breite\"", "not used: \"Bemerkung\""] {
        assert!(told.message.contains(words), "{told}");
    }
}

/// A header in a comment is the header of a table without one; a title that names the axes in another order is refused.
#[test]
fn headers_in_comments_and_titles() {
    let car = car();
    let row =
        |name: &str, [x, y, z]: [f64; 3]| texts(&[name, &format!("{y}"), &format!("{x}"), &format!("{z}")]);
    let plain = table(&car, "", ",", &texts(&["HEADER"]), row);
    for (header, is_read_) in [
        ("#name,y,x,z", true),
        ("# Point,Y,X,Z", true),
        ("## Hardpoint,Lateral,Longitudinal,Vertical", true),
        ("# y x z", false),
        ("order: y x z", false),
        ("Points (Y, X, Z)", true),
        ("Points in X, Y, Z", false),
        ("# name,y,x,z\nname,y,x,z", true),
    ] {
        assert_eq!(is_read(&plain.replace("HEADER", header), &car), is_read_, "{header}");
    }
    let row =
        |name: &str, [x, y, z]: [f64; 3]| texts(&[name, &format!("{x}"), &format!("{y}"), &format!("{z}")]);
    let plain = table(&car, "", ",", &texts(&["HEADER"]), row);
    for comment in ["# x y z", "# x forward, y left, z up", "# a comment", "#name,x,y,z"] {
        assert!(is_read(&plain.replace("HEADER", comment), &car), "{comment}");
    }
}

/// The columns that are used are stated, unless the header is the plain name, x, y, z.
#[test]
fn other_headers_than_the_plain_one_are_stated() {
    let car = car();
    for (header, order, is_stated) in [
        (&["name", "x", "y", "z"][..], [0, 1, 2], false),
        (&["Point", "X", "Y", "Z"], [0, 1, 2], false),
        (&["name", "y", "x", "z"], [1, 0, 2], true),
        (&["name", "x", "y", "z", "remark"], [0, 1, 2], true),
    ] {
        let row = |name: &str, at: [f64; 3]| {
            [vec![name.to_owned()], order.map(|k: usize| at[k].to_string()).to_vec()].concat()
        };
        let imported =
            read(&table(&car, "", ",", &texts(header), row)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(imported.diagnostics.iter().any(|d| d.code == "columns"), is_stated, "{header:?}");
    }
}
