//! Report of a study: one self-contained page with the numbers of the result.

use crate::support;
use crate::support::{Scratch, percuss, root};
use sha2::{Digest, Sha256};
use std::fs;
use std::sync::LazyLock;

/// Inline pictures of a page.
fn pictures(page: &str) -> Vec<String> {
    let inner = page.split("<svg ").skip(1).filter_map(|rest| rest.split("</svg>").next());
    inner.map(|inner| format!("<svg {inner}</svg>\n")).collect()
}

#[test]
fn every_shipped_study_has_a_report() {
    let folder = Scratch::new("reports");
    let mut studies = 0;
    for entry in fs::read_dir(root().join("models")).expect("there").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.ends_with(".toml") || name.ends_with(".urdf") {
            fs::copy(entry.path(), folder.path(&name)).expect("copied");
        }
    }
    for entry in fs::read_dir(folder.path("")).expect("there").flatten() {
        let study = entry.path().to_string_lossy().into_owned();
        if !study.ends_with(".toml") {
            continue;
        }
        let html = study.replace(".toml", "-report.html");
        let json = percuss(&format!("run {study} --format json"));
        if json.code != 0 {
            continue;
        }
        // The second run replaces the report, because percuss wrote it.
        for _ in 0..2 {
            let outcome = percuss(&format!("run {study} --report {html}"));
            assert_eq!(outcome.code, 0, "{study}: {}", outcome.stderr);
        }
        let page = fs::read_to_string(&html).expect("written");
        assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
        // The page loads no external content and runs no scripts.
        for word in ["http://", "https://", "<script", "<link rel=\"stylesheet", "@import", "url("] {
            assert!(!page.contains(word), "{study}: {word}");
        }
        let pictures = pictures(&page);
        assert!(
            !pictures.is_empty()
                && pictures.iter().all(|svg| svg.starts_with("<svg") && svg.ends_with("</svg>\n"))
        );
        assert!(
            pictures[0].contains("(y to the right, ") || pictures[0].contains("from the left"),
            "{study}"
        );
        // The accompanying JSON equals the output of the command, and the page contains the mass.
        assert_eq!(fs::read_to_string(html.replace(".html", ".json")).expect("written"), json.stdout);
        let answer: serde_json::Value = serde_json::from_str(&json.stdout).expect("JSON");
        if let Some(mass) = answer["effective_mass"].as_f64() {
            let four_digits: f64 = format!("{mass:.3e}").parse().expect("a number");
            assert!(page.contains(&format!("<b>{four_digits}")), "{study}: {mass}");
        }
        for input in answer["inputs"].as_array().expect("a list") {
            assert!(page.contains(input["sha256"].as_str().expect("a hash")));
        }
        if fs::read_to_string(&study).expect("there").contains("[sweep]") {
            let csv = fs::read_to_string(html.replace(".html", ".csv")).expect("written");
            assert!(csv.starts_with("row,") && csv.lines().count() > 2, "{study}");
            assert!(page.contains("The sweep"));
        }
        studies += 1;
    }
    assert!(studies > 5, "only {studies} studies were reported");
}

const STUDY: &str = "[model]\npath = \"MODEL\"\n[contact]\nlink = \"rod\"\npoint = [0, 0, -0.8]\nnormal = [1, 0, 0]\n\
    [damping]\nrestitution = 0.3\nstiffness = 2e5\nspeed = 0.5\nfor = [\"mujoco\"]\n\
    [sweep]\nvary = [\"hinge=0:1:3\"]\n";

#[test]
fn the_damper_its_snippets_and_the_diagnostics_are_in_it() {
    let folder = Scratch::new("report-damper");
    let model = fs::read_to_string(root().join("models/point_mass_pendulum.urdf")).expect("there");
    folder.write("model.urdf", &model.replacen("</robot>", "<surplus/></robot>", 1));
    let study = folder.write("study.toml", &STUDY.replace("MODEL", "model.urdf"));
    let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("r.html")).expect("written");
    for words in
        ["The damper", "solref", "surplus", "percuss run study.toml --report r.html", "<b>0.7812 kg</b>"]
    {
        assert!(page.contains(words), "{words}");
    }
    // The normal is fixed to the rod, so that its m̄ is constant: a sentence in place of a plot.
    assert_eq!(pictures(&page).len(), 3, "the mechanism twice, the force");
    assert!(page.contains("m̄ (kg) is constant over the range: 0.7812."), "no constant");
}

#[test]
fn markup_in_names_is_text() {
    let folder = Scratch::new("report-markup");
    let model = fs::read_to_string(root().join("models/point_mass_pendulum.urdf")).expect("there");
    let name = "&lt;script&gt;alert(1)&lt;/script&gt;&quot; onload=&quot;x\u{202e}";
    folder.write("model.urdf", &model.replace("\"rod\"", &format!("\"{name}\"")));
    let study = STUDY
        .replace("MODEL", "model.urdf")
        .replace("\"rod\"", "'<script>alert(1)</script>\" onload=\"x\u{202e}'");
    let study = folder.write("study.toml", &study);
    let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("r.html")).expect("written");
    assert!(page.contains("&lt;script&gt;") && !page.contains("<script") && !page.contains('\u{202e}'));
    assert!(!page.contains("\" onload=\""));
}

#[test]
fn a_report_keeps_to_its_folder_and_its_name() {
    let folder = Scratch::new("report-places");
    fs::copy(root().join("models/point_mass_pendulum.urdf"), folder.path("model.urdf")).expect("copied");
    fs::create_dir_all(folder.path("inner")).expect("a folder");
    let study = folder.write("inner/study.toml", &STUDY.replace("MODEL", "../model.urdf"));
    for (report, words) in [
        (folder.path("inner/r.pdf"), "must end in .html"),
        (folder.path("r.html"), "--allow-outside"),
        // The accompanying JSON file must not overwrite a file of another origin.
        (folder.path("inner/foreign.html"), "--force"),
    ] {
        folder.write("inner/foreign.json", "of somebody else");
        let outcome = percuss(&format!("run {study} --report {report}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{report}: {}", outcome.stderr);
        assert!(!std::path::Path::new(&report).exists());
    }
    let outcome = percuss(&format!("run {study} --report {} --allow-outside", folder.path("r.html")));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
}

#[test]
fn an_import_draws_what_it_understood() {
    let folder = Scratch::new("import-picture");
    let mut drawn = 0;
    for entry in fs::read_dir(root().join("models/suspensions")).expect("there").flatten() {
        let sheet = entry.path().to_string_lossy().into_owned();
        if !sheet.ends_with(".toml") {
            continue;
        }
        let (model, picture) = (folder.path("model.urdf"), folder.path("picture.svg"));
        let outcome = percuss(&format!("import {sheet} -o {model} --picture {picture}"));
        assert_eq!(outcome.code, 0, "{sheet}: {}", outcome.stderr);
        let svg = fs::read_to_string(&picture).expect("written");
        // Lines of links, dots at their ends, and the wheel in both views.
        assert!(svg.matches("stroke-linecap").count() > 4 && svg.contains("from the "), "{sheet}");
        drawn += 1;
    }
    assert!(drawn >= 6, "only {drawn} sheets were drawn");
    let sheet = "models/suspensions/double-wishbone.toml";
    for ending in ["png", "pdf"] {
        let line = format!(
            "import {sheet} -o {} --picture {}",
            folder.path("m.urdf"),
            folder.path(&format!("p.{ending}"))
        );
        assert_eq!(percuss(&line).code, 0);
    }
    let outcome = percuss(&format!("import {sheet} -o {} --picture p.gif", folder.path("m.urdf")));
    assert!(outcome.code == 2 && outcome.stderr.contains(".svg, .png or .pdf"), "{}", outcome.stderr);
}

/// All questions of a study on one page: shapes, sensitivities, tolerances, variants, map, safe speed.
#[test]
fn the_page_has_all_that_the_study_asks() {
    let folder = Scratch::new("report-all");
    let models = root().join("models");
    fs::create_dir_all(folder.path("meshes")).expect("a folder");
    fs::copy(models.join("meshes/finger.obj"), folder.path("meshes/finger.obj")).expect("copied");
    fs::copy(models.join("shaped_arm.urdf"), folder.path("arm.urdf")).expect("copied");
    let text = "[model]\npath = \"arm.urdf\"\n[contact]\nlink = \"finger\"\npoint = [0.1, 0, 0]\nnormal = [0, 1, 0]\n\
        [mass]\nexplain = true\ntolerance = \"mass=2%\"\n[sweep]\nvary = \"elbow=-1:1:5\"\ntitle = \"Over the elbow\"\n\
        [map]\nlink = \"finger\"\nedge = 0.02\n[safe_speed]\nregion = \"chest\"\nforce = 280\n\
        [[variant]]\nname = \"lighter\"\nlink_mass = { forearm = 1.5 }\n";
    let study = folder.write("my study.toml", text);
    let run = |study: &str, report: &str| {
        let words = ["run", study, "--report", report];
        support::run(words)
    };
    let outcome = run(&study, &folder.path("r.html"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("r.html")).expect("written");
    for words in [
        "Sensitivities",
        "1 kg less of finger",
        "root sum square",
        "<th class=\"number\">difference</th>",
        "<td>lighter</td>",
        "Over the surface",
        "<th class=\"number\">smallest kg</th>",
        "Safe speed",
        "chest: 40 kg",
        // Quoted for the shell; HTML text contains double quotes as entities.
        if cfg!(windows) {
            "percuss run &quot;my study.toml&quot; --report r.html"
        } else {
            "percuss run 'my study.toml' --report r.html"
        },
    ] {
        assert!(page.contains(words), "{words}");
    }
    let pictures = pictures(&page);
    assert_eq!(
        pictures.len(),
        8,
        "the mechanism and the curve twice, two tornado charts, the variants, the map"
    );
    // Shapes are pixels below the lines in all views; all else is vector graphics.
    assert_eq!([0, 2].map(|i| pictures[i].matches("<image ").count()), [1, 3]);
    assert!(pictures[3].contains("Effect of 1 kg") && pictures[4].contains("limit of its tolerance"));
    assert!(pictures[5].contains("Over the elbow") && !pictures[5].contains("<image "));
    assert_eq!(pictures[7].matches("<image ").count(), 2);
    // The mesh is listed as an input, with the hash of the file.
    let at = page.rfind("finger.obj").expect("the name of the mesh");
    let hash = page[at..].split("SHA-256 ").nth(1).expect("its hash");
    let mesh = fs::read(folder.path("meshes/finger.obj")).expect("there");
    let sum: String = Sha256::digest(mesh).iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(&hash[..64], sum);
    // The accompanying JSON equals the output of the command.
    let json = support::run(["run", &study, "--format", "json"]);
    assert_eq!(fs::read_to_string(folder.path("r.json")).expect("written"), json.stdout);
    // Without the mesh file, the link is drawn as lines, and a note reports the reason.
    fs::remove_file(folder.path("meshes/finger.obj")).expect("removed");
    let study = folder.write("bare.toml", &text.replace("[map]\nlink = \"finger\"\nedge = 0.02\n", ""));
    let outcome = run(&study, &folder.path("bare.html"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("bare.html")).expect("written");
    assert!(page.contains("link &quot;finger&quot; is drawn without its shape"), "no note");
}

/// Without a contact: the mechanism, its contents, and the other questions of the study.
#[test]
fn a_study_without_a_contact_has_a_report() {
    let folder = Scratch::new("report-contactless");
    fs::create_dir_all(folder.path("meshes")).expect("a folder");
    let models = root().join("models");
    fs::copy(models.join("meshes/finger.obj"), folder.path("meshes/finger.obj")).expect("copied");
    for (from, to) in
        [("shaped_arm.urdf", "arm.urdf"), ("six_r_arm.urdf", "six.urdf"), ("four_bar.urdf", "bar.urdf")]
    {
        fs::copy(models.join(from), folder.path(to)).expect("copied");
    }
    let speed = "[contact]\nlink = \"tool\"\npoint = [0.08, 0, 0]\n[pose]\nset = { elbow = \"70deg\" }\n\
                 [safe_speed]\nregion = \"chest\"\nforce = 280\nworst_direction = true\n";
    let stop =
        "[damping]\nrestitution = 0.3\nstiffness = \"50 Nm/rad\"\nspeed = 0.5\nlimit = \"elbow:upper\"\n";
    for (model, asked, words, pictures_expected) in [
        ("arm.urdf", "[map]\nlink = \"forearm\"\n", "Over the surface", 2),
        (
            "bar.urdf",
            "[map]\ndirections = 200\nlink = \"coupler\"\npoint = [0, 0, 0]\n",
            "In all directions",
            1,
        ),
        ("six.urdf", speed, "Safe speed", 1),
        ("arm.urdf", stop, "effective inertia", 2),
    ] {
        let study = folder.write("study.toml", &format!("[model]\npath = \"{model}\"\n{asked}"));
        let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
        assert_eq!(outcome.code, 0, "{asked}: {}", outcome.stderr);
        let page = fs::read_to_string(folder.path("r.html")).expect("written");
        let init = format!("percuss init {model} -o contact.toml");
        for words in [
            words,
            "degrees of freedom",
            "centre of mass",
            "parent → child",
            "Possible contacts",
            &init,
            "SHA-256",
        ] {
            assert!(page.contains(words), "{asked}: {words}");
        }
        assert!(
            !page.contains("m̄ = ") && !outcome.stdout.contains("effective mass"),
            "{asked}: {}",
            outcome.stdout
        );
        let drawn = pictures(&page);
        assert_eq!(drawn.len(), pictures_expected, "{asked}");
        assert!(drawn[0].contains("from "));
        let json = percuss(&format!("run {study} --format json"));
        assert_eq!(fs::read_to_string(folder.path("r.json")).expect("written"), json.stdout, "{asked}");
    }
}

/// A wheel named by the importer is drawn as a circle about its bearing axis; seen from the left, its width equals
/// its height.
#[test]
fn wheels_are_drawn() {
    let folder = Scratch::new("report-wheel");
    let sheet = root().join("models/suspensions/double-wishbone.toml");
    fs::copy(sheet, folder.path("my.toml")).expect("copied");
    let text = "[model]\npath = \"my.toml\"\n[contact]\nlink = \"bump_stop_pad\"\npoint = [0, 0, 0]\n\
                along_line = { link = \"bump_stop\", point = [0, 0, 0] }\nagainst = \"chassis\"\n";
    let lines = |sheet: &str| {
        folder.write("my.toml", sheet);
        let study = folder.write("study.toml", text);
        let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let page = fs::read_to_string(folder.path("r.html")).expect("written");
        pictures(&page)[1].len()
    };
    let sheet = fs::read_to_string(folder.path("my.toml")).expect("there");
    let with = lines(&sheet);
    let without = lines(&sheet.replacen("radius = 300.0", "# radius", 1));
    // The outline of the tyre has some fifty points in the view along the axis, ten characters each; the link to the lowest point is a
    // line.
    assert!(with >= without + 400, "{with} and {without}");
}

/// Study with all parts about a stop of a suspension.
const FULL: &str = "models/studies/report.toml";

/// The shipped study with its sheet in a folder of its own; `alter` changes the text of the study.
fn full_report(name: &str, alter: impl Fn(&str) -> String) -> (Scratch, String) {
    let folder = Scratch::new(name);
    fs::copy(root().join("models/suspensions/double-wishbone.toml"), folder.path("my.toml")).expect("copied");
    let study = fs::read_to_string(root().join(FULL)).expect("there");
    let study = study
        .replace("../suspensions/double-wishbone.toml", "my.toml")
        .replace("samples = 2000", "samples = 60");
    let study = folder.write("study.toml", &alter(&study));
    let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = fs::read_to_string(folder.path("r.html")).expect("written");
    (folder, page)
}

/// Page and JSON of the shipped study.
fn shipped_report() -> &'static (String, String) {
    static REPORT: LazyLock<(String, String)> = LazyLock::new(|| {
        let (folder, page) = full_report("report-shipped", str::to_owned);
        (page, fs::read_to_string(folder.path("r.json")).expect("written"))
    });
    &REPORT
}

/// Position of a text in a page.
fn position(page: &str, text: &str) -> usize {
    page.find(text).unwrap_or_else(|| panic!("{text} is not in the page"))
}

#[test]
fn the_head_and_the_number_come_before_the_contents() {
    let (page, _) = shipped_report();
    assert!(page.contains("<h1>Effective mass at the front bump stop</h1>"));
    let in_order = [
        "Double wishbone, front left: the figures of an example",
        "Chassis development, 2026-11-26",
        "Study study.toml, percuss ",
        "When the bump stop touches, 61 mm above the design position, the mechanism strikes like a mass of <b>151.1 ± 2.4 kg</b>",
        "<b>151.1 <span>± 2.4 kg</span></b>",
        "No action needed.",
        ">At the touch</h3>",
        ">Where the 151.1 kg come from</h3>",
        "151.1 at the touch</text>",
        ">What would lower it</h3>",
        "Holds for",
        "<nav class=\"next\">",
        "</nav>",
        "<h2 id=\"s1\">1. The mechanism at this pose</h2>",
    ];
    let found: Vec<usize> = in_order.iter().map(|text| position(page, text)).collect();
    assert!(found.is_sorted(), "{found:?}");
    // Each section is linked once, and each link has its section.
    let sections = page.matches("<h2 id=\"s").count();
    assert!(sections > 8 && page.matches("<a href=\"#s").count() == sections, "{sections}");
    for i in 1..=sections {
        assert_eq!(page.matches(&format!("<h2 id=\"s{i}\">{i}. ")).count(), 1, "{i}");
        assert_eq!(page.matches(&format!("<a href=\"#s{i}\">{i}. ")).count(), 1, "{i}");
    }
}

#[test]
fn a_stop_has_its_symbols_charts_and_tables() {
    let (page, _) = shipped_report();
    let drawn = pictures(page);
    let titles =
        drawn.iter().map(|svg| svg.split("<title>").nth(1).unwrap_or("").split('<').next().unwrap_or(""));
    let titles: Vec<&str> = titles.collect();
    for title in [
        "Effect of 1 kg more or less of each link",
        "Effect of 1 mm of each hardpoint",
        "Effect of each number at the limit of its tolerance",
        "Effective mass within the tolerances",
        "Effective mass over the wheel travel",
    ] {
        assert!(titles.iter().any(|drawn| drawn.starts_with(title)), "{title} in {titles:?}");
    }
    // The picture names links with their shares and named contacts; the pointer shows the names of joints.
    for name in
        ["wheel 56 %", "upright 15 %", ">spring<", ">bump stop<", "<title>lower_front</title></circle>"]
    {
        assert!(drawn[2].contains(name), "{name}: {}", drawn[2]);
    }
    // The tolerances are a band about the curve.
    let sweep = drawn.iter().find(|svg| svg.contains("± tolerances")).expect("the sweep");
    assert_eq!(sweep.matches("Z\" fill=\"#").count(), 1, "{sweep}");
    assert!(page.contains("The band is the first-order effect of the tolerances."), "no caption");
    assert!(page.contains("<td class=\"name\">contact</td>") && page.contains("mm, normal ("), "no axes");
    // Parts have the names of the sheet, angles are in degrees.
    assert!(page.contains("lower_arm (hinge) ") && page.contains("°"), "no positions of the parts");
    assert!(
        !page.contains("lower_arm_hinge = ") && !page.contains("<td class=\"name\">free joints</td>"),
        "names of joints"
    );
    // Bars of the histogram: rectangles, and marks.
    let histogram = drawn.iter().find(|svg| svg.contains("97.5 %")).expect("the histogram");
    assert!(histogram.matches("<rect").count() > 6 && histogram.contains("nominal"));
    for words in [
        "<td class=\"name\">all at the limit</td>",
        "; point 0.5 mm: ",
        "<td>stop 20 mm further out</td>",
        "closing of the contact per upward travel of wheel_centre",
        "<td class=\"name\">compression</td>",
        "MuJoCo",
        "<th>hardpoint</th>",
        "<th>wheel travel mm</th>",
    ] {
        assert!(page.contains(words), "{words}");
    }
    // Only commands and snippets are preformatted.
    for text in page.split("<pre>").skip(1).filter_map(|rest| rest.split("</pre>").next()) {
        assert!(text.starts_with("percuss ") || text.contains('<') || text.contains("&lt;"), "{text}");
    }
}

#[test]
fn text_of_the_head_is_escaped_and_optional() {
    let hostile = "'<script>alert(1)</script>\" onload=\"x\u{202e}'";
    // Tolerances of points need most of the time.
    let without_tolerances = |study: &str| study.replace("tolerance = ", "# ").replace("samples = ", "# ");
    let alter = |study: &str| {
        let study = without_tolerances(study);
        let keys = ["title", "object", "author", "date"];
        let head: String = keys.iter().map(|key| format!("{key} = {hostile}\n")).collect();
        let rest = study.split_once("[model]").expect("a model").1;
        let rest = rest.replace("name = \"lighter lower arm\"", &format!("name = {hostile}"));
        format!("[report]\n{head}[model]{rest}")
            .replace("title = \"Effective mass over the wheel travel\"", &format!("title = {hostile}"))
    };
    let (_folder, page) = full_report("report-hostile", alter);
    assert!(page.matches("&lt;script&gt;").count() >= 5);
    for text in [&page, &pictures(&page).join("")] {
        assert!(!text.contains("<script") && !text.contains('\u{202e}'));
    }
    assert!(!page.contains("\" onload=\""));
    // Without the table, the contact is the title, and no line of author and date is written.
    let bare = |study: &str| {
        format!("[model]{}", without_tolerances(study).split_once("[model]").expect("a model").1)
    };
    let (_folder, page) = full_report("report-bare", bare);
    assert!(
        page.contains("<h1>Effective mass at bump_stop</h1>")
            && page.matches("<p class=\"head\">").count() == 1
    );
    // A date is a date or a text.
    let folder = Scratch::new("report-date");
    let study = folder.write("study.toml", &STUDY.replace("[damping]", "[report]\ndate = 5\n[damping]"));
    let outcome = percuss(&format!("run {study}"));
    assert!(outcome.code == 2 && outcome.stderr.contains("report.date"), "{}", outcome.stderr);
}

/// The pendulum's m̄ grows without bound where the contact moves along the link.
#[test]
fn a_curve_with_a_pole_is_clipped_and_the_caption_says_so() {
    let folder = Scratch::new("report-pole");
    fs::copy(root().join("models/point_mass_pendulum.urdf"), folder.path("model.urdf")).expect("copied");
    let sweep = "normal_frame = \"world\"\n[sweep]\nvary = \"hinge=0:1.57:41\"\n";
    let text = STUDY.split("[damping]").next().expect("the contact").replace("MODEL", "model.urdf") + sweep;
    let report = |text: &str| {
        let study = folder.write("study.toml", text);
        let outcome = percuss(&format!("run {study} --report {}", folder.path("r.html")));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        fs::read_to_string(folder.path("r.html")).expect("written")
    };
    let page = report(&text);
    let caption = page.split("<figcaption>").filter(|rest| rest.contains("the axis ends at")).count();
    assert_eq!(caption, 1);
    assert!(page.contains("of 41 values are larger, the extreme "), "no caption");
    assert!(!report(&text.replace("1.57:41", "0.5:41")).contains("the axis ends at"));
}

#[test]
fn a_warning_is_beside_its_number() {
    let (page, json) = shipped_report();
    let answer: serde_json::Value = serde_json::from_str(json).expect("JSON");
    let all = answer["diagnostics"].as_array().expect("a list");
    let messages = |severity: &str| {
        let of_result = all.iter().filter(|d| d["path"].is_null() && d["severity"] == *severity);
        let texts: Vec<String> =
            of_result.map(|d| d["message"].as_str().expect("text").replace('"', "&quot;")).collect();
        texts
    };
    let (summary, rest) = page.split_once("<nav class=\"next\">").expect("contents");
    assert!(!messages("warning").is_empty());
    for warning in messages("warning") {
        assert!(summary.contains(&format!("warning: {warning}")), "{warning}");
    }
    // Notes are in the last section; a suspension has none about its driving joints.
    let last = rest.rsplit("<h2 ").next().expect("a section");
    for note in messages("note") {
        assert!(last.contains(&note) && !note.contains("the loops are driven by"), "{note}");
    }
}

/// The files that the study names are written in addition to the page, and are the same as without a page.
#[test]
fn outputs_of_the_study_are_written_beside_the_page() {
    let folder = Scratch::new("report-outputs");
    let sheet = percuss("template double-wishbone").stdout;
    folder.write("car.toml", &sheet);
    let data = root().join("models/measured/bump_stop.csv");
    let further = format!(
        "[identify]\ndata = {:?}\noutput = \"fit.csv\"\n[kinematics]\nvary = \"wheel-travel=-20mm:20mm:5\"\noutput = \"angles.csv\"\n\
         [map]\nlink = \"upright\"\npoint = [0, 0, 0]\ndirections = 20\noutput = [\"map.csv\"]\n[convert]\noutput = \"car.xml\"\n",
        [data]
    );
    let of_further = ["fit.csv", "angles.csv", "map.csv", "car.xml"];
    for (name, contact, output, further, of_further) in [
        ("rows", "at = \"bump_stop\"", "rows.csv", further.as_str(), &of_further[..]),
        ("figure", "at = \"bump_stop\"", "travel.svg", "", &[]),
        ("contacts", "at = \"all\"", "contacts.xlsx", "", &[]),
    ] {
        let text = format!(
            "[model]\npath = \"car.toml\"\n[contact]\n{contact}\n[sweep]\nvary = [\"wheel-travel=-20mm:20mm:5\"]\noutput = \
             \"{output}\"\n[damping]\nrestitution = 0.3\nstiffness = 1e6\nspeed = 0.1\noutput = \"{name}-history.csv\"\n{further}"
        );
        let study = folder.write(&format!("{name}.toml"), &text);
        let plain = percuss(&format!("run {study}"));
        assert_eq!(plain.code, 0, "{}", plain.stderr);
        let history = format!("{name}-history.csv");
        let files = [&[output, &history], of_further].concat();
        let files: Vec<String> = files.into_iter().map(|file| folder.path(file)).collect();
        let alone: Vec<Vec<u8>> = files.iter().map(|file| fs::read(file).expect("written")).collect();
        files.iter().for_each(|file| fs::remove_file(file).expect("removed"));
        let outcome = percuss(&format!("run {study} --report {}", folder.path(&format!("{name}-page.html"))));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let printed: String = outcome.stdout.split_whitespace().collect();
        for (file, alone) in files.iter().zip(&alone) {
            assert!(fs::read(file).is_ok_and(|bytes| bytes == *alone), "{file}");
            assert!(printed.contains(file.as_str()), "{}", outcome.stdout);
        }
    }
    // The table that accompanies the page has another name.
    let same = folder.path("rows.html");
    let outcome = percuss(&format!("run {} --report {same}", folder.path("rows.toml")));
    assert_eq!(outcome.code, 2, "{}", outcome.stdout);
    assert!(
        outcome.stderr.contains("sweep.output") && outcome.stderr.contains("--report"),
        "{}",
        outcome.stderr
    );
}

/// Report of an impact: impulses in the mechanism, bearings with the magnitudes of the command's components, and the impact in time.
#[test]
fn an_impact_has_arrows_and_a_table_of_bearings() {
    let folder = Scratch::new("impact-report");
    for study in ["bump-stop", "four-bar", "arm", "feet"] {
        let path = format!("models/studies/{study}-impact.toml");
        let html = folder.path(&format!("{study}.html"));
        let outcome = percuss(&format!("run {path} --report {html} --allow-outside"));
        assert_eq!(outcome.code, 0, "{study}: {}", outcome.stderr);
        let page = fs::read_to_string(html).expect("written");
        let drawn = pictures(&page);
        let impulse = drawn.iter().find(|svg| svg.contains(">p</text>")).expect("the impulse at the contact");
        assert!(!impulse.contains("share of"), "{study}");
        assert_eq!(page.contains(">Bearings</h3>"), study != "feet", "{study}");
    }
    let stop = "impact models/suspensions/double-wishbone.toml --at bump_stop --restitution 0.3 --speed 0.5 --stiffness 200N/mm \
                --in-time --format json";
    let answer: serde_json::Value = serde_json::from_str(&percuss(stop).stdout).expect("JSON");
    let page = fs::read_to_string(folder.path("bump-stop.html")).expect("written");
    let table = &page[position(&page, ">Bearings</h3>")..position(&page, ">Reactions by components</h3>")];
    for (name, shown) in [("lower_arm_hinge", "lower_arm (hinge)"), ("lower_ball", "lower_ball")] {
        let all = answer["reactions"].as_array().expect("a list");
        let record = all.iter().find(|record| record["name"] == name).expect("a reaction");
        let row = table.split("<tr>").find(|row| row.contains(shown)).expect("a row");
        let cells = row.split(['<', '>']).map(|cell| cell.trim_matches('\u{2007}'));
        let cells: Vec<f64> = cells.filter_map(|cell| cell.parse().ok()).collect();
        let components = record["force"].as_array().expect("components");
        let impulse: f64 =
            components.iter().map(|c| c.as_f64().expect("determinate").powi(2)).sum::<f64>().sqrt();
        let in_time = answer["in_time"]["bearings"].as_array().expect("a list");
        let timed = in_time.iter().find(|record| record["name"] == name).expect("a bearing");
        // Peak, its time, impulse and moment; the largest of a column has four digits.
        let [peak, _, shown, _] = cells[..] else { panic!("{row}") };
        assert!((peak - timed["peak_force"].as_f64().expect("a force")).abs() <= 0.5, "{row}");
        assert!((shown - impulse).abs() <= 0.005, "{row} {impulse}");
    }
    let drawn = pictures(&page);
    assert!(drawn.iter().any(|svg| svg.contains("compression (mm)")), "no impact in time");
}
