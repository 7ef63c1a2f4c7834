//! Measured impacts in the forms in which loggers and spreadsheets write them.

use crate::support::{Scratch, percuss, refused, root};

/// Law that is known, so that the search is short.
const KNOWN: &str = "--mass 151.08 --exponent 1.4 --damper hunt-crossley --format json";

/// Rows of the measured stop: ms, kN and g.
fn rows() -> Vec<[String; 3]> {
    let text = std::fs::read_to_string(root().join("models/measured/bump_stop.csv")).expect("a file");
    let row = |line: &str| {
        let cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        cells.try_into().expect("three cells")
    };
    text.lines().skip(1).map(row).collect()
}

/// Stiffness that a file gives, and the warnings and notes.
fn stiffness(path: &str, flags: &str) -> (f64, String) {
    let found = percuss(&format!("identify {path} {KNOWN} {flags} --notes"));
    let report: serde_json::Value =
        serde_json::from_str(&found.stdout).unwrap_or_else(|_| panic!("{path} {flags}: {}", found.stderr));
    (report["stiffness"]["value"].as_f64().expect("a number"), found.stderr)
}

#[test]
fn files_of_loggers_and_spreadsheets_are_read() {
    let scratch = Scratch::new("identify_files");
    let table = |head: &str, separator: &str, decimal: &str| {
        let line = |row: &[String; 3]| row[..2].join(separator).replace('.', decimal);
        let lines: Vec<String> = rows().iter().map(line).collect();
        format!("{head}\n{}\n", lines.join("\n"))
    };
    let expected = stiffness(&scratch.write("plain.csv", &table("time [ms],force [kN]", ",", ".")), "").0;
    let cases = [
        (table("Zeit [ms];Kraft [kN]", ";", ","), "", ""),
        (table("time/ms\tForce_Z/kN", "\t", ","), "", ""),
        (table("t [msec],F1 (kN)", ",", "."), "", ""),
        (table("Time,Force\n[ms],[kN]", ",", "."), "", ""),
        (table("time;force;\nms;kN;", ";", ","), "", ""),
        (table("# logger\n# time_ms,force_kN", ",", "."), "", "lines that are not used: 1"),
        (
            table("DEWESoft X3\nSample rate;10000\n\nTime (ms);Force (kN)", ";", "."),
            "",
            "lines that are not used: 1, 2",
        ),
        (table("", " ", "."), "--columns time_ms,force_kN", ""),
        (table("Zeit in ms,Kraftaufnehmer", ",", "."), "--columns time_ms,force_kN", ""),
    ];
    for (number, (text, flags, note)) in cases.into_iter().enumerate() {
        let (found, stderr) = stiffness(&scratch.write(&format!("{number}.csv"), &text), flags);
        assert!((found / expected - 1.0).abs() < 1e-9, "{number}: {found} {expected}");
        assert!(stderr.contains(note), "{number}: {stderr}");
    }
    let lines: Vec<String> =
        rows().iter().enumerate().map(|(i, row)| format!("{},{},5", i, row[1])).collect();
    let counted = scratch.write("counted.csv", &format!("sample,force [kN],trigger\n{}\n", lines.join("\n")));
    let (found, stderr) = stiffness(&counted, "--rate 3000");
    // The times of the file are rounded to 1 µs.
    assert!(
        (found / expected - 1.0).abs() < 1e-3 && stderr.contains("trigger"),
        "{found} {expected} {stderr}"
    );
    // 0.0132 kN are read as 0.0132 N.
    let bare = scratch.write("bare.csv", &table("time,force", ",", "."));
    let warned = percuss(&format!("identify {bare} --mass 151"));
    assert!(
        warned.stderr.contains("no unit is given") && warned.stderr.contains("implausible"),
        "{}",
        warned.stderr
    );
    for (text, words) in [
        (table("0,0", ",", "."), &["no header", "--columns"][..]),
        (table("time [ms],torque [Nm]", ",", "."), &["2", "torque", "--ignore"]),
        (table("time [fortnights],force [kN]", ",", "."), &["fortnights", "ms"]),
        (table("force [kN],acceleration [g]", ",", "."), &["time", "--rate"]),
        (table("acc1 [g],acc2 [g]", ",", "."), &["second column", "--ignore"]),
        (table("time [ms];force [kN]\n0,5;1.5", ";", "."), &["decimal"]),
        (table("time [ms];force [kN]\n0;1.000,5", ";", ","), &["two decimal marks"]),
    ] {
        refused(&format!("identify {} --mass 151", scratch.write("refused.csv", &text)), words);
    }
    let (one, other) = (scratch.write("one.csv", &table("time_ms,force_kN", ",", ".")), counted);
    refused(&format!("identify {one} {other} --speed 1,2,3 --rate 3000"), &["3 values for 2 files"]);
}

/// A long record before the impact is cut off before samples are counted.
#[test]
fn a_long_record_before_the_impact_is_cut_off() {
    let scratch = Scratch::new("identify_long");
    let rows = rows();
    let before = (0..110_000).map(|i| {
        format!(
            "{},{},{}",
            30.0 - f64::from(110_000 - i) / 3.0,
            rows[i as usize % 30][1],
            rows[i as usize % 30][2]
        )
    });
    let after = rows.iter().map(|row| row.join(","));
    let lines: Vec<String> = before.chain(after).collect();
    let long = scratch.write("long.csv", &format!("time_ms,force_kN,acceleration_g\n{}\n", lines.join("\n")));
    let (found, _) = stiffness(&long, "");
    let (expected, _) = stiffness("models/measured/bump_stop.csv", "");
    assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
}
