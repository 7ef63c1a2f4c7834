//! Rules of ARCHITECTURE.md that no compiler checks.

mod circles;
mod imports;
mod imports_tests;
mod literals;
mod modules;
mod names;
mod touched;

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Package};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ is in the workspace").to_path_buf()
}

fn metadata() -> Metadata {
    MetadataCommand::new()
        .manifest_path(root().join("Cargo.toml"))
        .other_options(vec!["--locked".into()])
        .exec()
        .expect("cargo metadata")
}

/// Text files below the root with this ending, without build output.
fn files(ending: &str) -> Vec<PathBuf> {
    fn walk(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).expect("a readable folder").flatten() {
            let (path, name) = (entry.path(), entry.file_name());
            let name = name.to_string_lossy();
            if path.is_dir() {
                if !name.starts_with('.') && name != "target" {
                    walk(&path, ending, found);
                }
            } else if name.ends_with(ending) {
                found.push(path);
            }
        }
    }
    let mut found = Vec::new();
    walk(&root(), ending, &mut found);
    assert!(!found.is_empty(), "no file ends with {ending}");
    found
}

/// Permitted dependencies between the crates of the workspace, without those of tests.
const ARROWS: [(&str, &[&str]); 22] = [
    ("percuss-spatial", &[]),
    ("percuss-kernel", &["percuss-spatial"]),
    ("percuss-tables", &[]),
    ("percuss-units", &[]),
    ("percuss-mechanism", &["percuss-spatial"]),
    ("percuss-formats", &["percuss-spatial", "percuss-mechanism"]),
    (
        "percuss-suspension",
        &[
            "percuss-spatial",
            "percuss-mechanism",
            "percuss-formats",
            "percuss-units",
            "percuss-contact",
            "percuss-dynamics",
        ],
    ),
    ("percuss-dynamics", &["percuss-spatial", "percuss-kernel", "percuss-mechanism"]),
    ("percuss-generate", &["percuss-spatial", "percuss-mechanism", "percuss-dynamics"]),
    ("percuss-impact", &["percuss-spatial", "percuss-mechanism", "percuss-dynamics", "percuss-contact"]),
    ("percuss-contact", &[]),
    ("percuss-render", &[]),
    ("percuss-oracle", &["percuss-spatial", "percuss-mechanism"]),
    (
        "percuss-study",
        &[
            "percuss-spatial",
            "percuss-units",
            "percuss-tables",
            "percuss-mechanism",
            "percuss-formats",
            "percuss-suspension",
            "percuss-dynamics",
            "percuss-generate",
            "percuss-impact",
            "percuss-contact",
        ],
    ),
    (
        "percuss-cli",
        &[
            "percuss-spatial",
            "percuss-mechanism",
            "percuss-formats",
            "percuss-suspension",
            "percuss-dynamics",
            "percuss-explorer",
            "percuss-render",
            "percuss-study",
        ],
    ),
    ("percuss-explorer", &[]),
    ("percuss-web", &["percuss-formats", "percuss-study"]),
    (
        "percuss",
        &[
            "percuss-spatial",
            "percuss-mechanism",
            "percuss-formats",
            "percuss-suspension",
            "percuss-dynamics",
            "percuss-impact",
            "percuss-contact",
            "percuss-study",
        ],
    ),
    ("percuss-capi", &["percuss"]),
    // The package contains the command, and notebooks show pictures.
    ("percuss-python", &["percuss", "percuss-cli", "percuss-render"]),
    (
        "percuss-tests",
        &[
            "percuss-spatial",
            "percuss-mechanism",
            "percuss-formats",
            "percuss-suspension",
            "percuss-dynamics",
            "percuss-oracle",
            "percuss-study",
        ],
    ),
    (
        "percuss-benches",
        &[
            "percuss-spatial",
            "percuss-mechanism",
            "percuss-formats",
            "percuss-dynamics",
            "percuss-impact",
            "percuss-oracle",
            "percuss-study",
        ],
    ),
];

#[test]
fn crates_depend_along_the_arrows() {
    let metadata = metadata();
    let arrows: BTreeMap<&str, &[&str]> = ARROWS.into_iter().collect();
    for package in metadata.workspace_packages() {
        let name = package.name.as_str();
        let allowed = arrows.get(name).unwrap_or_else(|| panic!("{name} has no row in ARROWS"));
        for dependency in package.dependencies.iter().filter(|d| d.kind == DependencyKind::Normal) {
            let other = dependency.name.as_str();
            let ours = other == "percuss" || other.starts_with("percuss-");
            assert!(!ours || allowed.contains(&other), "{name} must not depend on {other}");
        }
    }
}

/// Most dependencies of other authors that a user of the library and of the command compile without features: mostly those of
/// the linear algebra, of URDF and of the command line.
const MOST_DEPENDENCIES: [(&str, usize); 2] = [("percuss", 80), ("percuss-cli", 145)];

#[test]
fn the_library_and_the_command_have_few_dependencies_and_none_in_c() {
    for (package, most) in MOST_DEPENDENCIES {
        let tree = Command::new(env!("CARGO"))
            .args(["tree", "--locked", "-p", package, "-e", "normal,build", "--prefix", "none"])
            .current_dir(root())
            .output()
            .expect("cargo tree");
        assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
        let tree = String::from_utf8(tree.stdout).expect("text");
        // A name and a version; marks of repetition follow.
        let versions = tree.lines().map(|line| line.split_whitespace().take(2).collect::<Vec<_>>().join(" "));
        let others: BTreeSet<String> = versions.filter(|version| !version.starts_with("percuss")).collect();
        assert!((40..=most).contains(&others.len()), "{package}: {} dependencies: {others:#?}", others.len());
        for version in &others {
            let name = version.split(' ').next().unwrap_or_default();
            assert!(
                name == "linux-raw-sys"
                    || !name.ends_with("-sys") && !["cc", "cmake", "bindgen"].contains(&name),
                "{package}: {name} compiles C code"
            );
        }
    }
}

#[test]
fn the_oracle_never_sees_dynamics() {
    let metadata = metadata();
    let oracle =
        metadata.workspace_packages().into_iter().find(|p| p.name.as_str() == "percuss-oracle").unwrap();
    // Dependencies of tests included.
    assert!(oracle.dependencies.iter().all(|d| d.name != "percuss-dynamics"));
}

#[test]
fn files_and_folders_import_one_way() {
    let crates = root().join("crates");
    let mut failures = String::new();
    let mut checked = 0;
    for entry in fs::read_dir(&crates).expect("crates/ is readable").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let source = entry.path().join("src");
        let texts = files(".rs")
            .into_iter()
            .filter_map(|path| {
                let below = path.strip_prefix(&source).ok()?.to_string_lossy().replace('\\', "/");
                Some((below, fs::read_to_string(&path).expect("a readable file")))
            })
            .collect();
        let imports = imports::imports(&texts);
        checked += imports.len();
        for (kind, imports) in [("files", &imports), ("folders", &circles::between_folders(&imports))] {
            for circle in circles::circles(imports) {
                failures += &format!("{name}: {kind} in a circle\n{}", circles::describe(&circle, imports));
            }
        }
    }
    assert!(failures.is_empty(), "{failures}");
    assert!(checked > 100, "only {checked} imports were found");
}

/// Crates re-exported by the façade; true if all types of the crate are at the root, false if they are in a module.
const FACADE: [(&str, bool); 8] = [
    ("dynamics", true),
    ("formats", true),
    ("suspension", false),
    ("mechanism", true),
    ("spatial", false),
    ("contact", false),
    ("impact", false),
    ("study", false),
];

#[test]
fn the_facade_has_every_type_once() {
    let of = |name: &str| names::public_names(&root().join("crates").join(name).join("src"));
    let facade = of("percuss");
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (name, at_root) in FACADE {
        for (found, modules) in of(name) {
            let missing = at_root && modules.contains("") && !facade.contains_key(&found);
            assert!(!missing, "percuss does not re-export {found} of {name}");
            places.entry(found).or_default().extend(modules.iter().map(|m| format!("{name} {m}")));
        }
    }
    let clashes: Vec<_> = places.iter().filter(|(_, places)| places.len() > 1).collect();
    assert!(clashes.is_empty(), "types that share a name: {clashes:?}");
    assert!(places.len() > 100, "only {} types were found", places.len());
}

#[test]
fn files_keep_within_the_budget() {
    for path in files(".rs") {
        let lines = fs::read_to_string(&path).unwrap().lines().count();
        assert!(lines <= 600, "{} has {lines} lines; 600 is the most", path.display());
    }
}

/// Other processes delay a test: limits concern processor time or counted work.
#[test]
fn no_test_reads_the_clock() {
    for (ending, call, least) in [(".rs", "Instant::now", 100), (".py", "perf_counter", 20)] {
        let is_of_tests = |path: &&PathBuf| {
            let path = path.strip_prefix(root()).unwrap();
            path.iter().any(|part| part == "tests")
                && !path.starts_with("tests/external")
                && !path.starts_with("tests/tidy")
        };
        let paths = files(ending);
        let paths: Vec<_> = paths.iter().filter(is_of_tests).collect();
        assert!(paths.len() > least, "only {} files {ending} of tests", paths.len());
        for path in paths {
            assert!(!fs::read_to_string(path).unwrap().contains(call), "{} reads the clock", path.display());
        }
    }
}

#[test]
fn folders_of_sources_have_few_entries() {
    // Data of a crate among its sources, such as templates, count as well.
    let data =
        files(".toml").into_iter().filter(|path| path.components().any(|part| part.as_os_str() == "src"));
    let folders: BTreeSet<PathBuf> = files(".rs")
        .into_iter()
        .chain(data)
        .filter_map(|path| path.parent().map(Path::to_path_buf))
        .collect();
    // Scripts of the comparisons with other programs, with two programs in Rust.
    for folder in folders.iter().filter(|folder| !folder.ends_with("tests/external")) {
        let entries = fs::read_dir(folder).unwrap().count();
        assert!(entries <= 14, "{} has {entries} entries; 14 is the most", folder.display());
    }
    assert!(folders.len() > 80, "only {} folders were found", folders.len());
}

#[test]
fn thresholds_are_in_one_file_per_crate() {
    for (name, least) in [("dynamics", 130), ("kernel", 25)] {
        let inside = root().join("crates").join(name).join("src");
        let (mut here, home) = (0, inside.join("tolerances.rs"));
        for path in files(".rs").into_iter().filter(|p| p.starts_with(&inside)) {
            for threshold in literals::thresholds(&fs::read_to_string(&path).unwrap()) {
                assert!(path == home, "{}: {threshold}", path.display());
                here += 1;
            }
        }
        assert!(here > least, "only {here} thresholds were found in {name}");
    }
}

#[test]
fn banned_calls_stay_banned() {
    let rules = fs::read_to_string(root().join("clippy.toml")).unwrap();
    for call in ["Matrix::svd\"", "Matrix::pseudo_inverse\"", "Matrix::rank\"", "SVD::new\""] {
        assert!(rules.contains(call), "clippy.toml no longer bans nalgebra::{call}");
    }
    let workspace = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    assert!(workspace.contains("disallowed_methods = \"deny\""));
    // Clippy checks compiled code only; this test also covers other code and `allow` attributes.
    for path in files(".rs").into_iter().filter(|p| !p.ends_with("tests/tidy/main.rs")) {
        let text = fs::read_to_string(&path).unwrap();
        for call in ["pseudo_inverse(", "allow(clippy::disallowed_methods)"] {
            assert!(!text.contains(call), "{} has {call}", path.display());
        }
    }
}

/// Checks a `path::name` of the documents: the file must exist and contain the name.
fn assert_exists(place: &str, from: &str) {
    let (path, name) = place.split_once("::").map_or((place, None), |(p, n)| (p, Some(n)));
    let text = fs::read_to_string(root().join(path))
        .unwrap_or_else(|_| panic!("{from} names {path}, which does not exist"));
    if let Some(name) = name {
        let found =
            ["fn ", "struct ", "enum ", "const "].iter().any(|kind| text.contains(&format!("{kind}{name}")));
        assert!(found, "{from} names {name} in {path}, which is not there");
    }
}

#[test]
fn every_formula_has_its_code_and_its_test() {
    let text = fs::read_to_string(root().join("docs/reference/FORMULAS.md")).unwrap();
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| line.starts_with("| F"))
        .map(|line| line.trim_matches('|').split(" | ").map(str::trim).collect())
        .collect();
    assert!(rows.len() >= 10, "only {} formulas were found", rows.len());
    for (i, row) in rows.iter().enumerate() {
        let [id, statement, source, code, test] = row[..] else {
            panic!("row {i} has not five columns: {row:?}")
        };
        assert_eq!(id, format!("F{}", i + 1), "formulas are numbered in order");
        assert!(!statement.is_empty() && !source.is_empty(), "{id} lacks its statement or its source");
        for place in [code, test] {
            for place in place.split(", ") {
                assert_exists(place.trim_matches('`'), id);
            }
        }
        assert!(test.contains("::"), "{id} names no test function");
    }
}

#[test]
fn every_invariant_names_a_test_that_exists() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let places: Vec<&str> = text.split('`').skip(1).step_by(2).filter(|s| s.contains(".rs::")).collect();
    assert!(places.len() >= 6, "{places:?}");
    places.into_iter().for_each(|place| assert_exists(place, "ARCHITECTURE.md"));
}

#[test]
fn rust_version_is_true() {
    let metadata = metadata();
    let ours = metadata.workspace_packages().into_iter().find(|p| p.name.as_str() == "percuss").unwrap();
    let stated = ours.rust_version.clone().expect("rust-version is stated");
    let mut most = None;
    for package in &metadata.packages {
        if let Some(needed) = &package.rust_version {
            assert!(*needed <= stated, "{} needs Rust {needed}, we state {stated}", package.name);
            most = most.max(Some(needed.clone()));
        }
    }
    assert_eq!(most, Some(stated.clone()), "rust-version {stated} is higher than anything asks for");
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(
        readme.contains(&format!("{}.{} or later", stated.major, stated.minor)),
        "README states another version"
    );
}

/// The registry refuses a package without a description or a licence; the other fields are how its users find and read it.
#[test]
fn published_manifests_are_complete() {
    let metadata = metadata();
    let (published, unpublished): (Vec<_>, Vec<_>) = metadata
        .workspace_packages()
        .into_iter()
        .partition(|package| package.publish.as_ref().is_none_or(|registries| !registries.is_empty()));
    let names = |packages: &[&Package]| packages.iter().map(|p| p.name.to_string()).collect::<BTreeSet<_>>();
    let expected = ["percuss-benches", "percuss-capi", "percuss-python", "percuss-tests", "percuss-web"];
    assert_eq!(names(&unpublished), BTreeSet::from(expected.map(str::to_owned)));
    for package in published {
        let name = package.name.as_str();
        let documentation = format!("https://docs.rs/{name}");
        assert_eq!(package.documentation.as_deref(), Some(&*documentation), "{name}");
        assert_eq!(package.readme.as_ref().map(|path| path.as_str()), Some("README.md"), "{name}");
        assert_eq!(package.license.as_deref(), Some("MIT OR Apache-2.0"), "{name}");
        assert!(package.description.as_ref().is_some_and(|text| text.len() > 20), "{name}: description");
        assert!(package.rust_version.is_some(), "{name}: rust-version");
        // Limits of the registry.
        assert!((1..=5).contains(&package.keywords.len()), "{name}: {:?}", package.keywords);
        assert!(package.keywords.iter().all(|keyword| keyword.len() <= 20), "{name}: {:?}", package.keywords);
        assert!((1..=5).contains(&package.categories.len()), "{name}: {:?}", package.categories);
        // A dependency on another member needs a version; without a version, cargo leaves out a dependency of tests.
        for dependency in package.dependencies.iter().filter(|d| d.path.is_some()) {
            let is_for_tests = dependency.kind == DependencyKind::Development;
            let has_version = dependency.req.to_string() != "*";
            assert!(has_version || is_for_tests, "{name}: {} has no version", dependency.name);
            let of_unpublished = names(&unpublished).contains(&dependency.name);
            assert!(!of_unpublished, "{name} depends on {}, which is not published", dependency.name);
        }
        let readme = fs::read_to_string(package.manifest_path.with_file_name("README.md")).expect("a README");
        assert!((10..=60).contains(&readme.lines().count()), "{name}: README.md");
        assert!(
            name == "percuss" || readme.contains("https://docs.rs/percuss)"),
            "{name}: no link to percuss"
        );
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            let text = fs::read_to_string(package.manifest_path.with_file_name(licence)).expect("a licence");
            assert_eq!(
                text,
                fs::read_to_string(root().join(licence)).expect("a licence"),
                "{name}: {licence}"
            );
        }
    }
}

/// Anchor of a heading, as generated by GitHub and mdBook.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().to_lowercase().replace(' ', "-");
    kept.chars().filter(|c| c.is_alphanumeric() || matches!(c, '-' | '_')).collect()
}

#[test]
fn links_between_documents_resolve() {
    let (mut checked, mut anchors) = (0, 0);
    for path in files(".md") {
        let text = fs::read_to_string(&path).unwrap();
        for (words, rest) in text.split("](").zip(text.split("](").skip(1)) {
            let link = rest.split(')').next().unwrap_or_default();
            if link.contains("://") {
                continue;
            }
            assert!(!words.ends_with(".md"), "{}: {link} has no title", path.display());
            let (target, place) = link.split_once('#').unwrap_or((link, ""));
            let lead = if target.is_empty() { path.clone() } else { path.parent().unwrap().join(target) };
            assert!(lead.exists(), "{} links to {link}", path.display());
            checked += 1;
            if !place.is_empty() {
                let page = fs::read_to_string(lead).unwrap();
                let headings = page.lines().filter(|line| line.starts_with('#'));
                let found = headings.map(|line| anchor(line.trim_start_matches('#'))).any(|a| a == place);
                assert!(found, "{} links to {link}, which is no heading", path.display());
                anchors += 1;
            }
        }
    }
    assert!(checked > 80 && anchors > 0, "only {checked} links and {anchors} anchors were found");
}

/// mdBook omits pages that SUMMARY.md does not name.
#[test]
fn the_summary_names_every_page_once() {
    let docs = root().join("docs");
    let text = fs::read_to_string(docs.join("SUMMARY.md")).unwrap();
    let links = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let mut named: Vec<PathBuf> = links.map(|link| docs.join(link)).collect();
    let mut pages: Vec<PathBuf> =
        files(".md").into_iter().filter(|p| p.starts_with(&docs) && !p.ends_with("SUMMARY.md")).collect();
    named.sort();
    pages.sort();
    assert_eq!(named, pages);
    let entries = text.lines().filter(|line| line.starts_with("- [")).count();
    assert!(entries <= 25, "{entries} entries of the navigation; 25 fit on a screen");
}

/// Pages of the documentation that messages and comments name must exist.
#[test]
fn pages_that_the_sources_name_exist() {
    let mut named = 0;
    for ending in [".rs", ".py", ".sh", ".toml", ".urdf", ".md", ".h"] {
        for path in files(ending) {
            let bytes = fs::read(&path).unwrap();
            let text = String::from_utf8_lossy(&bytes);
            for rest in text.split("docs/").skip(1) {
                let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || "/_.".contains(c)));
                let page = rest[..end.unwrap_or(rest.len())].trim_end_matches('.');
                if page.ends_with(".md") && page.starts_with(|c: char| c.is_ascii_alphabetic()) {
                    let is_ours = ["tutorials/", "howto/", "reference/", "explanation/"];
                    let is_ours = is_ours.iter().any(|kind| page.starts_with(kind))
                        || page.starts_with(|c: char| c.is_ascii_uppercase());
                    assert!(
                        !is_ours || root().join("docs").join(page).exists(),
                        "{} names docs/{page}",
                        path.display()
                    );
                    named += usize::from(is_ours);
                }
            }
        }
    }
    assert!(named > 40, "only {named} names of pages were found");
}

/// Actions are pinned by a hash, because a tag can be moved to other code. Builds use `--locked`, because other versions of
/// the dependencies were not tested.
#[test]
fn actions_are_pinned_and_builds_are_locked() {
    let mut actions = 0;
    for entry in fs::read_dir(root().join(".github/workflows")).expect("workflows").flatten() {
        let text = fs::read_to_string(entry.path()).expect("text");
        for line in
            text.lines().filter_map(|line| line.trim().trim_start_matches("- ").strip_prefix("uses: "))
        {
            let hash = line.split_once('@').map(|(_, version)| version.split(' ').next().unwrap_or(""));
            let is_hash = |hash: &str| hash.len() == 40 && hash.bytes().all(|b| b.is_ascii_hexdigit());
            assert!(
                hash.is_some_and(is_hash),
                "{}: {line}; expected ACTION@HASH # VERSION",
                entry.path().display()
            );
            actions += 1;
        }
    }
    assert!(actions >= 3, "only {actions} actions");
    let mut builds = 0;
    for path in files(".sh") {
        let text = fs::read_to_string(&path).expect("text");
        for line in text.lines().filter(|line| !line.trim_start().starts_with('#')) {
            let is_build = |word: &&str| line.contains(&format!("cargo {word} "));
            if ["build", "rustc", "test", "run", "install", "bench"].iter().any(is_build) {
                assert!(line.contains("--locked"), "{}: {line}; expected --locked", path.display());
                builds += 1;
            }
        }
    }
    assert!(builds >= 6, "only {builds} builds");
}

/// Packing a folder twice, with different times and permissions of its files, gives the same bytes.
#[test]
fn archives_of_the_same_files_are_the_same() {
    let folder = std::env::temp_dir().join(format!("percuss-tidy-archive-{}", std::process::id()));
    for ending in ["tar.gz", "zip"] {
        let packed = ["first", "second"].map(|name| {
            let parent = folder.join(name);
            fs::create_dir_all(parent.join("percuss/docs")).expect("a folder");
            // The files are created in different orders, which changes the order of the directory listing.
            let mut files = ["a.txt", "docs/b.txt", "c"];
            if name == "second" {
                files.reverse();
            }
            for file in files {
                fs::write(parent.join("percuss").join(file), file).expect("a file");
            }
            let at = std::time::SystemTime::UNIX_EPOCH
                + std::time::Duration::from_secs(1_000_000_000 * name.len() as u64 / 5);
            let file = fs::File::options().append(true).open(parent.join("percuss/c")).expect("a file");
            file.set_modified(at).expect("a time");
            let archive = parent.join(format!("percuss.{ending}"));
            let mut pack = std::process::Command::new("python3");
            pack.arg(root().join("crates/cli/packaging/archive.py"))
                .arg(&parent)
                .arg("percuss")
                .arg(&archive);
            assert!(
                pack.env("SOURCE_DATE_EPOCH", "1700000000").status().expect("python3 is there").success()
            );
            fs::read(archive).expect("an archive")
        });
        assert!(packed[0] == packed[1], "{ending}: two archives of the same files differ");
        assert!(packed[0].len() > 100, "{ending}: {} bytes", packed[0].len());
    }
    fs::remove_dir_all(folder).expect("removed");
}
