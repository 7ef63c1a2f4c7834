//! Names of points in other programs and in drawings: each table is read as the sheet it was written from, or refused.

use super::sheets::{Car, Spelling, at_seat, sheet};
use nalgebra::Vector3;
use percuss_formats::{LoadError, Source};
use percuss_suspension::{
    ImportOptions, Imported, LengthUnit, TemplateOptions, VehicleAxes, changed_file, import, template_names,
    template_sheet,
};

/// Points of the template double-wishbone, in the order of [`STYLES`].
const POINTS: [&str; 13] = [
    "lower_front",
    "lower_back",
    "lower_ball",
    "upper_front",
    "upper_back",
    "upper_ball",
    "tie_rod_inner",
    "tie_rod_outer",
    "wheel_centre",
    "spring_seat",
    "spring_chassis_seat",
    "damper_seat",
    "damper_chassis_seat",
];

/// Names of these points in one style each, separated by commas.
const STYLES: [&str; 13] = [
    "lca_front,lca_rear,lca_outer,uca_front,uca_rear,uca_outer,tierod_inner,tierod_outer,wheel_center,spring_lower,spring_upper,damper_lower,damper_upper",
    "CHAS_LowFor,CHAS_LowAft,UPRI_LowPnt,CHAS_UppFor,CHAS_UppAft,UPRI_UppPnt,CHAS_TiePnt,UPRI_TiePnt,WC,spring_lower,spring_upper,damper_lower,damper_upper",
    "lca_inner_front,lca_inner_rear,lca_outer,uca_inner_front,uca_inner_rear,uca_outer,tierod_inner,tierod_outer,wheel_center,spring_lower,spring_upper,shock_lower,shock_upper",
    "lower_wishbone_inboard_front,lower_wishbone_inboard_rear,lower_wishbone_outboard,upper_wishbone_inboard_front,upper_wishbone_inboard_rear,upper_wishbone_outboard,trackrod_inboard,trackrod_outboard,wheel_center,spring_outboard,spring_inboard,damper_outboard,damper_inboard",
    "Lower wishbone front pivot,Lower wishbone rear pivot,Lower wishbone outer ball joint,Upper wishbone front pivot,Upper wishbone rear pivot,Upper wishbone outer ball joint,Inner track rod ball joint,Outer track rod ball joint,Wheel centre point,Lower spring pivot point,Upper spring pivot point,Damper wishbone end,Damper body end",
    "LBIF,LBIR,LBJ,UBIF,UBIR,UBJ,TRI,TRO,WC,Spring bottom,Spring top,Shock bottom,Shock top",
    "LCA_IF,LCA_IR,LCA_O,UCA_IF,UCA_IR,UCA_O,toe_link_in,toe_link_out,wheel centre,spring lwr,spring upr_chassis,damper lwr,damper frame",
    "LCF,LCR,LCO,UCF,UCR,UCO,tie inner,tie outer,hub centre,spring arm,spring chassis,damper arm,damper chassis",
    "lwb.front,lwb.rear,lwb.outer,uwb.front,uwb.rear,uwb.outer,tr.inner,tr.outer,wheel.centre,spring_bottom,spring_top,damper_bottom,damper_top",
    "lowerArmFront,lowerArmRear,lowerBallJoint,upperArmFront,upperArmRear,upperBallJoint,tieRodInner,tieRodOuter,wheelCenter,springLower,springUpper,damperLower,damperUpper",
    "lower_front,lower_rear,lower_outer,upper_front,upper_rear,upper_outer,steering_inner,steering_outer,wheel_center,lower_spring,upper_spring,lower_damper,upper_damper",
    "Lower Tub Mount (Front),Lower Tub Mount (Rear),Lower Upright Mount,Upper Tub Mount (Front),Upper Tub Mount (Rear),Upper Upright Mount,Tie Rod Chassis Mount,Tie Rod Upright Mount,Wheel Center,Lower Spring Mount,Upper Spring Mount,Lower Shock Mount,Upper Shock Mount",
    "lower_front,lower_back,lower_ball,upper_front,upper_back,upper_ball,tie_rod_inner,tie_rod_outer,wheel_centre,spring_seat,spring_chassis_seat,damper_seat,damper_chassis_seat",
];

/// Beginning and ending of a name that states the left side, and the same for the right side.
const SIDES: [[[&str; 2]; 2]; 5] = [
    [["", ""], ["", ""]],
    [["hpl_", ""], ["hpr_", ""]],
    [["", "_L"], ["", "_R"]],
    [["FL ", ""], ["FR ", ""]],
    [["", " left"], ["", " right"]],
];

/// The example with 13 points.
fn car() -> Car {
    let mut car = Car::example("double-wishbone");
    car.without(&[]);
    car.points.retain(|(name, _)| POINTS.contains(&&**name));
    car
}

/// Imports a sheet of the example in millimetres and the axes of ISO 8855 whose points are in the table.
fn with_table(table: &str, keys: &str, options: &ImportOptions) -> Result<Imported, LoadError> {
    with_table_in(table, keys, options, &TemplateOptions::default())
}

/// Imports a sheet of the example in some unit and axes whose points are in the table.
fn with_table_in(
    table: &str,
    keys: &str,
    options: &ImportOptions,
    of_sheet: &TemplateOptions,
) -> Result<Imported, LoadError> {
    with_files(table, keys, of_sheet, |source| import(source, options))
}

/// Reads such a sheet beside its table.
fn with_files<T>(table: &str, keys: &str, of_sheet: &TemplateOptions, read: impl FnOnce(&Source) -> T) -> T {
    let text = template_sheet("double-wishbone", of_sheet).expect("a template");
    let bodies = text.split("\n[").filter(|section| {
        let name = section.split(']').next().unwrap_or_default();
        ["lower_arm", "upper_arm", "upright", "spindle", "tie_rod", "wheel", "spring", "damper"]
            .contains(&name)
    });
    let bodies: String = bodies.map(|section| format!("\n[{section}")).collect();
    let (unit, axes) = (of_sheet.unit.name(), of_sheet.axes.name());
    let head = format!(
        "template = \"double-wishbone\"\nunit = \"{unit}\"\naxes = \"{axes}\"\npoints = \"points.csv\"\n"
    );
    let folder = std::env::temp_dir().join(format!("percuss-names-{}-{:p}", std::process::id(), &text));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("points.csv"), table).expect("a table");
    let path = folder.join("my.toml");
    std::fs::write(&path, format!("{head}{keys}\n{bodies}")).expect("a sheet");
    let found = read(&Source::read(&path.to_string_lossy(), 1 << 20).expect("a sheet"));
    std::fs::remove_dir_all(folder).expect("the folder");
    found
}

/// Rows of a table: own names replaced.
fn rows(name: impl Fn(&str) -> String, mirror: f64) -> String {
    car().points.iter().map(|(own, [x, y, z])| format!("{};{x};{};{z}\n", name(own), mirror * y)).collect()
}

#[track_caller]
fn is_the_car(imported: &Imported, table: &str) {
    let car = car();
    assert_eq!(imported.understood.coordinates.len(), POINTS.len(), "{table}");
    for (name, at) in &imported.understood.coordinates {
        let off = car.point(name) - imported.understood.axes.to_iso(Vector3::from(*at));
        // Roundings of the conversion between units.
        assert!(off.amax() < 1e-12, "{name}\n{table}");
    }
}

#[test]
fn names_of_every_style_are_the_points_of_the_sheet() {
    let mut count = 0;
    for style in STYLES {
        let names: Vec<&str> = style.split(',').collect();
        assert_eq!(names.len(), POINTS.len(), "{style}");
        let other =
            |own: &str| names[POINTS.iter().position(|point| *point == own).expect("a point")].to_owned();
        for [left, right] in SIDES {
            let with = |[before, after]: [&str; 2], own: &str| format!("{before}{}{after}", other(own));
            let mut table = format!("name;x;y;z\n{}", rows(|own| with(left, own), 1.0));
            if left != right {
                table += &rows(|own| with(right, own), -1.0);
            }
            match with_table(&table, "", &ImportOptions::default()) {
                Ok(imported) => {
                    is_the_car(&imported, &table);
                    // The names of percuss without a mark of the side are not replaced.
                    let is_own = names[..] == POINTS && left == right;
                    let is_noted = imported.diagnostics.iter().any(|d| d.code == "other-names");
                    assert_ne!(is_noted, is_own, "{table}");
                    count += 1;
                }
                Err(error) => panic!("{error}\n{table}"),
            }
        }
    }
    assert_eq!(count, STYLES.len() * SIDES.len());
}

/// Names that the sheet states, in the sheet or in a file, have precedence; a wrong one is an error with the place.
#[test]
fn names_can_be_stated() {
    let codes = |own: &str| format!("P{}", POINTS.iter().position(|point| *point == own).expect("a point"));
    let table = rows(codes, 1.0);
    let found = with_table(&table, "", &ImportOptions::default()).unwrap_err().diagnostics;
    assert_eq!(found.iter().map(|d| d.code).collect::<Vec<_>>(), ["unknown-points"], "{found:?}");
    assert!(found[0].message.contains("[names]"), "{}", found[0]);
    let stated: String = POINTS.iter().map(|own| format!("{own} = \"{}\"\n", codes(own))).collect();
    let imported = with_table(&table, &format!("[names]\n{stated}"), &ImportOptions::default());
    is_the_car(&imported.unwrap_or_else(|error| panic!("{error}")), &table);
    // The other way round: a stated name that would be read as another point.
    let swapped = |own: &str| match own {
        "lower_front" => "LCA_rear".to_owned(),
        "lower_back" => "LCA_front".to_owned(),
        own => own.to_owned(),
    };
    let table = rows(swapped, 1.0);
    let stated = "[names]\nlower_front = \"LCA_rear\"\nlower_back = [\"LCA_front\", \"other\"]\n";
    is_the_car(
        &with_table(&table, stated, &ImportOptions::default()).unwrap_or_else(|e| panic!("{e}")),
        &table,
    );
    for (names, code, words) in [
        ("lower_front = \"LCA_reer\"", "unknown-point", "LCA_rear"),
        ("lower_frnt = \"LCA_rear\"", "unknown-point", "lower_front"),
        ("lower_front = 3", "wrong-type", "LBJ"),
        ("wheel_centre = \"lower_ball\"", "ambiguous-name", "more than once"),
    ] {
        let error =
            with_table(&table, &format!("[names]\n{names}\n"), &ImportOptions::default()).unwrap_err();
        let told =
            error.diagnostics.iter().find(|d| d.code == code).unwrap_or_else(|| panic!("{names}: {error}"));
        assert!(told.message.contains(words) && told.line == Some(6), "{told}");
    }
    // A file of names.
    let path = std::env::temp_dir().join(format!("percuss-names-{}.toml", std::process::id()));
    std::fs::write(&path, "lower_front = \"LCA_rear\"\n[names]\nlower_back = \"LCA_front\"\n")
        .expect("a file");
    let options =
        ImportOptions { names: Some(path.to_string_lossy().into_owned()), ..ImportOptions::default() };
    let imported = with_table(&table, "", &options);
    std::fs::remove_file(&path).expect("the file");
    is_the_car(&imported.unwrap_or_else(|e| panic!("{e}")), &table);
}

/// Words that leave several points, two names of one point, and contradictions are refused; the message has all names once.
#[test]
fn ambiguous_names_are_refused() {
    for (own, other, code) in [
        ("lower_ball", "lower", "unknown-key"),
        ("lower_ball", "LCA", "unknown-key"),
        ("lower_ball", "lower upper ball", "unknown-key"),
        ("lower_front", "lower arm inner", "unknown-key"),
        ("wheel_centre", "lower ball joint", "ambiguous-name"),
        ("damper_seat", "damper", "missing-key"),
        ("lower_ball", "LBX", "unknown-key"),
    ] {
        let name =
            |point: &str| if point == own { other.to_owned() } else { point.replace("lower_ball", "LBJ") };
        let table = rows(name, 1.0);
        let error = with_table(&table, "", &ImportOptions::default()).map(|_| ()).unwrap_err();
        assert!(error.diagnostics.iter().any(|d| d.code == code), "{other}: {error}");
        assert!(error.to_string().contains(other), "{other}: {error}");
    }
    // Both axles of a car in one table.
    let table = rows(|own| format!("FL {own}"), 1.0) + &rows(|own| format!("RL {own}"), 1.0);
    let error = with_table(&table, "", &ImportOptions::default()).map(|_| ()).unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "ambiguous-name"), "{error}");
}

/// Row of a table: cells.
type Cells = Vec<String>;

/// Layouts of a table; rows of a point: name, number, coordinates of the left and of the right side.
const LAYOUTS: usize = 12;

fn layout(kind: usize, unit: &str, points: &[(String, [String; 3], [String; 3])]) -> Vec<Cells> {
    let text = |cells: &[&str]| -> Cells { cells.iter().map(|cell| (*cell).to_owned()).collect() };
    let mut rows: Vec<Cells> = match kind {
        0 => vec![text(&["name", "x", "y", "z"])],
        1 => vec![text(&["id", "Point", "X", "Y", "Z"])],
        2 => vec![text(&["#", "Point", "x", "y", "z"])],
        3 => vec![text(&["Group", "Name", "X", "Y", "Z"])],
        4 => vec![text(&["X", "Y", "Z", "Point"])],
        5 => vec![text(&["Point", "XL", "YL", "ZL", "XR", "YR", "ZR"])],
        6 => {
            vec![text(&["Point", "X (Left)", "Y (Left)", "Z (Left)", "X (Right)", "Y (Right)", "Z (Right)"])]
        }
        7 => vec![
            text(&["Point Name", "Left", "", "", "Right", "", ""]),
            text(&["", "X", "Y", "Z", "X", "Y", "Z"]),
        ],
        8 => vec![text(&["Point", "x", "y", "z"]), text(&["", unit, unit, unit])],
        9 => vec![text(&["Point", "x", "", "y", "", "z"])],
        10 => vec![text(&["Front axle of the car"]), text(&["Point", "x", "y", "z", "remark"])],
        _ => vec![
            text(&["", "Name:", "car"]),
            text(&["User Options", "Length", unit, unit]),
            text(&["Double A-Arm", "Point Name", "Left", "", "", "", "Right"]),
            text(&["", "", "X", "Y", "Z", "", "X", "Y", "Z"]),
        ],
    };
    for (i, (name, [x, y, z], [xr, yr, zr])) in points.iter().enumerate() {
        let number = format!("{}", i + 1);
        if kind == 10 && i % 4 == 0 {
            rows.push(text(&[&format!("Part {}", i / 4)]));
        }
        rows.push(match kind {
            0 | 8 => text(&[name, x, y, z]),
            1 | 2 => text(&[&number, name, x, y, z]),
            3 => text(&["arm", name, x, y, z]),
            4 => text(&[x, y, z, name]),
            5..=7 => text(&[name, x, y, z, xr, yr, zr]),
            9 => text(&[name, x, "", y, "", z]),
            10 => text(&[name, x, y, z, "checked"]),
            _ => text(&["", name, x, y, z, "", xr, yr, zr]),
        });
    }
    if kind >= 11 {
        rows.push(text(&["Attachment", "Element", "", "Attached To"]));
        rows.push(text(&["", "Steering Ratio", "86"]));
    }
    rows
}

/// Tables in many layouts, names, axes, units and separators: each has the points of the sheet it was written from.
#[test]
fn generated_tables_are_the_sheet_they_were_written_from() {
    let axes = ["iso", "adams", "sae", "rfactor", "-x y -z", "y -x z"]
        .map(|name| VehicleAxes::from_name(name).expect(name));
    let (mut count, mut k) = (0, 0);
    for kind in 0..LAYOUTS {
        for axes in axes {
            for unit in LengthUnit::ALL {
                k += 1;
                let names: Vec<&str> = STYLES[k % STYLES.len()].split(',').collect();
                let separator = [",", ";", "\t"][k % 3];
                let is_right = k % 5 == 0;
                let coordinates = |[x, y, z]: [f64; 3]| {
                    let at = axes.from_iso(Vector3::new(x, y, z)).map(|x| unit.of_metres(x / 1e3));
                    [0, 1, 2].map(|i| format!("{:?}", at[i]))
                };
                let row = |(own, at): &(String, [f64; 3])| {
                    let name = names[POINTS.iter().position(|point| point == own).expect("a point")];
                    let mirrored = [at[0], -at[1], at[2]];
                    let (left, right) = (coordinates(*at), coordinates(mirrored));
                    // A table of one side describes the side of the sheet.
                    let has_both = [5, 6, 7, 11].contains(&kind);
                    let one = if is_right && !has_both { right.clone() } else { left };
                    (name.to_owned(), one, right)
                };
                let points: Vec<_> = car().points.iter().map(row).collect();
                let rows = layout(kind, unit.name(), &points);
                let quoted = |cell: &String| {
                    if cell.contains(separator) { format!("\"{cell}\"") } else { cell.clone() }
                };
                let lines = rows
                    .iter()
                    .map(|cells| cells.iter().map(quoted).collect::<Vec<_>>().join(separator) + "\n");
                let table: String = lines.collect();
                let of_sheet = TemplateOptions { unit, axes };
                // The bodies of the sheet are those of the left side: a mirrored example would have other centres of mass.
                let keys = if is_right { "side = \"right\"\n" } else { "" };
                let imported = with_table_in(&table, keys, &ImportOptions::default(), &of_sheet);
                let imported = match imported {
                    Ok(imported) => imported,
                    Err(error) => {
                        panic!("layout {kind}, axes {}, {}: {error}\n{table}", axes.name(), unit.name())
                    }
                };
                assert_eq!(imported.understood.axes, axes);
                let expected = car();
                assert_eq!(imported.understood.coordinates.len(), POINTS.len(), "{table}");
                for (name, at) in &imported.understood.coordinates {
                    let mut at = axes.to_iso(Vector3::from(*at));
                    at.y = if is_right { -at.y } else { at.y };
                    let off = (expected.point(name) - at).amax();
                    assert!(
                        off < 1e-12,
                        "{name}: layout {kind}, axes {}, {}\n{table}",
                        axes.name(),
                        unit.name()
                    );
                }
                // The table with two points moved: two rows differ, and all points are those of the move.
                let moves = [("upper_ball", [0.001, -0.002, 0.003]), ("tie_rod_inner", [0.0, 0.0015, 0.0])];
                let moves = moves.map(|(name, by)| (name.to_owned(), by));
                let changed = with_files(&table, keys, &of_sheet, |source| {
                    changed_file(source, &ImportOptions::default(), &moves)
                });
                let changed = String::from_utf8(changed.expect(&table).bytes).expect("a text");
                let differ = changed.lines().zip(table.lines()).filter(|(new, old)| new != old).count();
                assert_eq!((changed.lines().count(), differ), (table.lines().count(), 2), "{changed}");
                let again =
                    with_table_in(&changed, keys, &ImportOptions::default(), &of_sheet).expect(&changed);
                for ((name, at), (_, old)) in
                    again.understood.coordinates.iter().zip(&imported.understood.coordinates)
                {
                    let by = moves.iter().find(|(known, _)| known == name).map_or([0.0; 3], |(_, by)| *by);
                    // Thirteen digits of numbers below 1 m.
                    let off = (Vector3::from(*at) - Vector3::from(*old) - Vector3::from(by)).amax();
                    assert!(off < 1e-12, "{name}: {off}\n{changed}");
                }
                count += 1;
            }
        }
    }
    assert_eq!(count, LAYOUTS * 6 * 4);
}

/// The layout of OptimumK's workbook with all that it states: points, half track, camber, tyre, spring, attachments.
#[test]
fn the_layout_of_optimumk_is_read() {
    let names = [
        ("lower_front", "CHAS_LowFor"),
        ("lower_back", "CHAS_LowAft"),
        ("lower_ball", "UPRI_LowPnt"),
        ("upper_front", "CHAS_UppFor"),
        ("upper_back", "CHAS_UppAft"),
        ("upper_ball", "UPRI_UppPnt"),
        ("tie_rod_inner", "CHAS_TiePnt"),
        ("tie_rod_outer", "UPRI_TiePnt"),
        ("pushrod_outer", "NSMA_PPAttPnt_L"),
        ("pushrod_rocker", "ROCK_RodPnt_L"),
        ("rocker_front", "CHAS_RocAxi_L"),
        ("rocker_back", "CHAS_RocPiv_L"),
        ("damper_seat", "ROCK_CoiPnt_L"),
        ("damper_chassis_seat", "CHAS_AttPnt_L"),
    ];
    let car = Car::example("pushrod-rocker");
    let of = |own: &str| car.points.iter().find(|(name, _)| name == own).expect(own).1;
    let head = ",,X,Y,Z,,X,Y,Z\n";
    let mut table = format!(
        ",Name:,car - Front\n,Type:,Suspension,Created by:,me\n,Version:,1\nUser Options,Length,millimeter,mm\n,Angle,degree,deg\nDouble A-Arm,Point Name,Left,,,,Right\n{head}"
    );
    for (i, (own, other)) in names.iter().enumerate() {
        if i == 8 {
            table += &format!("Push Pull,Point Name,Left,,,,Right\n{head}");
        }
        let [x, y, z] = of(own);
        table += &format!(",{other},{x},{y},{z},,{x},{},{z}\n", -y);
    }
    table += "Wheels,Point Name,Left,,,,Right\n,Half Track,600,,,,600\n,Longitudinal Offset,0,,,,0\n,Static Camber,-1.5,,,,-1.5\n\
              ,Static Toe,0.1,,,,0.1\n,Rim Diameter,254,,,,254\n,Tire Diameter,457.2,,,,457.2\n\
              Attachment,Element,,Attached To\n,Push Pull,NSMA_PPAttPnt,Double A-Arm,UpperAArm\n\
              Stiffness,Element\n,Spring,Push Pull,45,,,,45\nRack Pinion,Steering Ratio,80\n";
    let folder = std::env::temp_dir().join(format!("percuss-layout-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("front.csv"), &table).expect("a table");
    let sheet = "template = \"pushrod-rocker\"\nunit = \"mm\"\naxes = \"iso\"\nmasses = \"estimate\"\npoints = \"front.csv\"\n";
    std::fs::write(folder.join("my.toml"), sheet).expect("a sheet");
    let path = folder.join("my.toml");
    let imported =
        import(&Source::read(&path.to_string_lossy(), 1 << 20).expect("a sheet"), &ImportOptions::default());
    std::fs::remove_dir_all(&folder).expect("the folder");
    let imported = imported.unwrap_or_else(|error| panic!("{error}\n{table}"));
    let points = &imported.understood.coordinates;
    let at = |name: &str| points.iter().find(|(own, _)| own == name).unwrap_or_else(|| panic!("{name}")).1;
    for (own, _) in names {
        let off = Vector3::from(at(own)) - car.point(own);
        assert!(off.amax() < 1e-15, "{own}");
    }
    assert_eq!(at("spring_seat"), at("damper_seat"));
    // y = h + r sin γ, z = r cos γ.
    let (r, camber) = (0.2286, (-1.5f64).to_radians());
    let centre = Vector3::new(0.0, 0.6 + r * camber.sin(), r * camber.cos());
    assert!((Vector3::from(at("wheel_centre")) - centre).amax() < 1e-15);
    let wheel = imported.understood.wheel.expect("a wheel");
    assert!((wheel.radius.expect("a radius") - r).abs() < 1e-15);
    assert!((imported.understood.forces.springs[0].1.rate - 45e3).abs() < 1e-9);
    let link = imported.mechanism.find_link("pushrod").expect("a pushrod");
    let joint = imported.mechanism.joint(imported.mechanism.parent_joint(link).expect("a joint"));
    let cross = imported.mechanism.joint(imported.mechanism.parent_joint(joint.parent()).expect("a joint"));
    assert_eq!(imported.mechanism.link(cross.parent()).name(), "upper_arm");
    for (code, words) in [
        ("unused-rows", "Steering Ratio"),
        ("settings", "wheel.half_track"),
        ("estimated-masses", "lower_arm"),
        ("coil-over", "spring"),
        ("other-names", "OptimumK"),
    ] {
        let told = imported.diagnostics.iter().find(|d| d.code == code).unwrap_or_else(|| panic!("{code}"));
        assert!(told.message.contains(words), "{told}");
    }
}

/// Estimates of the example are the masses of the example; of a vehicle of half the size, an eighth of them.
#[test]
fn estimates_follow_the_size_of_the_parts() {
    for (template, _) in template_names() {
        let text = sheet(template);
        let is_mass = |line: &&str| {
            ["mass =", "com =", "inertia =", "axle_inertia ="].iter().any(|key| line.starts_with(key))
        };
        let lines: Vec<&str> = text.lines().filter(|line| !is_mass(line)).collect();
        let without = lines.join("\n").replacen("unit = ", "masses = \"estimate\"\nunit = ", 1);
        let read = |text: &str| import(&Source::from_text("my.toml", text), &ImportOptions::default());
        let (own, estimated) = (read(&text), read(&without));
        let [own, estimated] =
            [own, estimated].map(|read| read.unwrap_or_else(|error| panic!("{template}: {error}")));
        // A rack that slides is the only other mass; it is fixed in the examples. A beam and a chassis may be left out.
        let optional: f64 =
            own.understood.masses.iter().filter(|(name, _)| name.starts_with("beam")).map(|(_, m)| m).sum();
        let wheels: f64 =
            own.understood.masses.iter().filter(|(name, _)| name.starts_with("wheel")).map(|(_, m)| m).sum();
        let of_wheels: f64 = estimated
            .understood
            .masses
            .iter()
            .filter(|(name, _)| name.starts_with("wheel"))
            .map(|(_, m)| m)
            .sum();
        let parts =
            [own.understood.total_mass - wheels - optional, estimated.understood.total_mass - of_wheels];
        assert!((parts[1] / parts[0] - 1.0).abs() < 1e-9, "{template}: {parts:?}");
        let told = estimated.diagnostics.iter().find(|d| d.code == "estimated-masses").expect("a warning");
        assert!(told.message.contains("spindle") && told.line.is_some(), "{told}");
        // Without the key, one error has all keys.
        let error = read(&lines.join("\n")).map(|_| ()).unwrap_err();
        let missing = error.diagnostics.iter().filter(|d| d.code == "missing-key").count();
        assert!(missing <= 2 && error.diagnostics.len() == missing, "{template}: {error}");
        if template == "double-wishbone" {
            let half = without.replace("unit = \"mm\"", "unit = \"cm\"");
            let scale = |line: &str| match line.split_once(" = [") {
                Some((key, rest)) if !key.starts_with('#') => {
                    let (numbers, tail) = rest.split_once(']').expect("a list");
                    let numbers: Vec<f64> = numbers
                        .split(',')
                        .map(|x| x.trim().parse::<f64>().expect("a number") / 20.0)
                        .collect();
                    format!("{key} = {numbers:?}{tail}\n")
                }
                _ if line.starts_with("radius") => "radius = 15.0\n".to_owned(),
                _ if line.starts_with("gap") => String::new(),
                _ => format!("{line}\n"),
            };
            let half: String = half.lines().map(scale).collect();
            let small = read(&half).unwrap_or_else(|error| panic!("{error}\n{half}"));
            let ratio = estimated.understood.total_mass / small.understood.total_mass;
            assert!((ratio - 8.0).abs() < 1e-9, "{ratio}");
        }
    }
}

/// The pivot of a rocker is mirrored with the other points of a right side: the masses are equal.
#[test]
fn a_rocker_on_one_pivot_is_the_same_on_both_sides() {
    let mut car = Car::example("pushrod-rocker");
    car.without(&[]);
    let pivot = 0.5 * (car.point("rocker_front") + car.point("rocker_back"));
    car.points.retain(|(key, _)| !["rocker_front", "rocker_back"].contains(&key.as_str()));
    car.points.push(("rocker_pivot".into(), (1e3 * pivot).into()));
    let masses = [false, true].map(|right| {
        let spelling = Spelling { unit: LengthUnit::Millimetre, axes: VehicleAxes::ISO, right, table: None };
        let imported =
            import(&Source::from_text("my.toml", car.spelled(spelling)), &ImportOptions::default());
        at_seat(
            &imported.unwrap_or_else(|error| panic!("{error}")).mechanism,
            ["damper_seat", "damper_chassis_seat"],
            "",
        )
    });
    // Roundings of coordinates, multiplied by a condition number of some hundred.
    assert!((masses[0] / masses[1] - 1.0).abs() < 1e-12, "{masses:?}");
}
