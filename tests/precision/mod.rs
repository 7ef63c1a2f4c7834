//! m̄ and its stated error compared with a reference program in 90 digits (`tests/external/precision`).
//!
//! The fixtures hold every number as the decimal of a double, so that both sides use the same mechanism. A family is
//! tested completely; then every failure is printed, with the counts.

mod alone;
mod definition;
mod families;
mod linear_algebra;
mod matrices;
mod wide;

use percuss::{Answer, Model};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// All calls of percuss in this file.
mod percuss {
    use super::Asked;
    use percuss_dynamics::{
        Base, Conditions, Contact, ContactResponse, Direction, EffectiveMass, Frame, Pose, ResponseError,
        Route, RouteChoice, System,
    };
    use percuss_formats::{LoadOptions, Source, load};

    /// m̄ and its stated error, kg, or the reason of failure.
    pub type Answer = Result<(f64, f64), String>;

    /// m̄ by each route, kg; `None` unless finite.
    pub struct Routes {
        pub auto: Option<f64>,
        /// True if the result is the recursion's own, without a second route.
        pub is_alone: bool,
        pub recursion: Option<f64>,
        /// Rounding error stated by the recursion, relative.
        pub rounding: Option<f64>,
        /// Dense route; computed only for a recursion without a second route and with fewer than eleven digits.
        pub dense: Option<f64>,
        /// By a new workspace, and by a workspace after its first result.
        pub first: Option<f64>,
        pub second: Option<f64>,
        /// By the body-frame kernel, with the stated error, if a batch uses the kernel for the contact.
        pub lanes: Option<(f64, f64)>,
    }

    /// A mechanism under conditions.
    pub struct Model(System);

    impl Model {
        pub fn new(urdf: &str, floating: bool) -> Result<Self, String> {
            let source = Source::from_text("fixture", urdf);
            let loaded = load(&source, &LoadOptions::default()).map_err(|error| error.to_string())?;
            let base = if floating { Base::Floating } else { Base::Fixed };
            let system = System::new(loaded.mechanism, &Conditions::new().base(base));
            system.map(Self).map_err(|error| error.to_string())
        }

        /// Poses the mechanism from joint name, exact value, value to set (a guess), and true for a driver.
        fn pose(&self, values: &[(String, f64, f64, bool)]) -> Result<Pose, String> {
            let mut configuration = self.0.configuration();
            for (joint, _, value, drives) in values {
                let put = if *drives {
                    configuration.set(joint, &[*value])
                } else {
                    configuration.guess(joint, &[*value])
                };
                put.map_err(|error| error.to_string())?;
            }
            self.0.pose(&configuration).map_err(|error| error.to_string())
        }

        fn contact(&self, asked: &Asked) -> Contact {
            let find = |name: &str| self.0.mechanism().find_link(name).expect("a link");
            let mut contact = Contact::new(find(&asked.on), asked.point, asked.normal);
            if asked.world {
                contact = contact.normal(Direction::Along(asked.normal.into(), Frame::World));
            }
            if let Some(end) = &asked.toward {
                contact = contact.normal(Direction::TurningToward(find(end), asked.normal.into()));
            }
            match &asked.against {
                Some(other) => contact.against(find(other)),
                None => contact,
            }
        }

        /// Response of the posed mechanism to every contact, with the largest deviation of the joints from their values.
        pub fn ask(
            &self,
            values: &[(String, f64, f64, bool)],
            contacts: &[Asked],
        ) -> Result<(f64, Vec<Answer>), String> {
            let mechanism = self.0.mechanism();
            let pose = self.pose(values)?;
            let off = |(joint, value, ..): &(String, f64, f64, bool)| {
                (pose.joint(mechanism.find_joint(joint).expect("a joint"))[0] - value).abs()
            };
            let respond = |asked: &Asked| {
                let response =
                    pose.respond(&self.contact(asked)).map_err(|error: ResponseError| error.to_string())?;
                match (response.effective_mass, response.effective_mass_error()) {
                    (EffectiveMass::Finite(mass), Some(error)) => Ok((mass, error)),
                    (mass, error) => Err(format!("{mass:?}, error {error:?}")),
                }
            };
            Ok((values.iter().map(off).fold(0.0, f64::max), contacts.iter().map(respond).collect()))
        }

        /// The same contacts by all routes, and twice by a workspace.
        pub fn ask_routes(
            &self,
            values: &[(String, f64, f64, bool)],
            contacts: &[Asked],
        ) -> Result<Vec<Routes>, String> {
            let pose = self.pose(values)?;
            let finite = |mass| if let EffectiveMass::Finite(mass) = mass { Some(mass) } else { None };
            let mut routes = Vec::new();
            for contact in contacts.iter().map(|asked| self.contact(asked)) {
                let by = |choice| pose.respond_by_route(&contact, choice).ok();
                let mass =
                    |response: Option<ContactResponse>| response.and_then(|r| finite(r.effective_mass));
                let auto = by(RouteChoice::Auto);
                let is_alone = auto.as_ref().is_some_and(|r| r.dense_reason.is_none() && !r.is_energy_value);
                let recursion = by(RouteChoice::Only(Route::Articulated));
                let rounding =
                    recursion.as_ref().and_then(|r| Some(r.error?.rounding? / finite(r.effective_mass)?));
                // The first result allocates; from the second on, errors are computed only if necessary.
                let mut workspace = pose.assembly().workspace();
                workspace.set_positions(pose.positions()).map_err(|error| error.to_string())?;
                let mut again = || workspace.effective_mass(&contact).ok().and_then(finite);
                let (first, second) = (again(), again());
                let mut batch = pose.assembly().batch(&contact).map_err(|error| error.to_string())?;
                let lanes = batch.effective_mass(pose.positions()).map_err(|error| error.to_string())?;
                let lanes = lanes.error.and_then(|error| Some((finite(lanes.mass?)?, error)));
                let is_vague = is_alone && rounding.is_some_and(|stated| stated > super::DIGITS);
                let dense = if is_vague { mass(by(RouteChoice::Only(Route::Dense))) } else { None };
                routes.push(Routes {
                    recursion: mass(recursion),
                    rounding,
                    dense,
                    is_alone,
                    auto: mass(auto),
                    first,
                    second,
                    lanes,
                });
            }
            Ok(routes)
        }
    }
}

/// A contact for percuss.
struct Asked {
    on: String,
    against: Option<String>,
    point: [f64; 3],
    normal: [f64; 3],
    world: bool,
    /// Target link of the normal; `normal` is the target point.
    toward: Option<String>,
}

/// File of a family; the generator's README describes the layout.
#[derive(Deserialize)]
struct Family {
    mechanisms: Vec<Rows>,
    contacts: Vec<ContactRow>,
    groups: BTreeMap<String, Vec<Case>>,
}

/// On, against, point, normal, 1 for a normal in the world's axes, target link of a line.
#[derive(Deserialize)]
struct ContactRow(usize, i64, String, String, u8, #[serde(default)] Option<usize>);

#[derive(Deserialize)]
struct Rows {
    links: Vec<Link>,
    joints: Vec<JointRow>,
    #[serde(default)]
    loops: Vec<(usize, String, usize, String, String)>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Link {
    Like(usize),
    Own(Vec<String>),
}

/// Kind, parent, origin, axis, rotation; 1 for a driver.
#[derive(Deserialize)]
struct JointRow(String, usize, String, String, #[serde(default)] String, #[serde(default)] u8);

#[derive(Deserialize)]
struct Case {
    seed: u32,
    of: usize,
    count: Option<usize>,
    #[serde(default)]
    floating: bool,
    near: Option<f64>,
    values: String,
    #[serde(rename = "masses")]
    contacts: Vec<(usize, String)>,
}

fn three(text: &str) -> [f64; 3] {
    let values: Vec<f64> = text.split(' ').map(|word| word.parse().expect("a number")).collect();
    values.try_into().expect("three numbers")
}

impl Rows {
    /// URDF+ with `count` links besides the root, with the exact digits of the fixture.
    fn urdf(&self, count: usize) -> String {
        let mut out = String::from("<robot name=\"fixture\">\n");
        for i in 0..=count {
            let own = match &self.links[i] {
                Link::Like(other) => &self.links[*other],
                own @ Link::Own(_) => own,
            };
            let Link::Own(row) = own else { panic!("a link like one like another") };
            let _ = write!(out, "<link name=\"l{i}\">");
            if let [mass, com, moments, rest @ ..] = row.as_slice() {
                let rpy = rest.first().map_or("0 0 0", String::as_str);
                let _ = write!(
                    out,
                    "<inertial><origin xyz=\"{com}\" rpy=\"{rpy}\"/><mass value=\"{mass}\"/><inertia"
                );
                for (name, value) in ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].iter().zip(moments.split(' '))
                {
                    let _ = write!(out, " {name}=\"{value}\"");
                }
                out += "/></inertial>";
            }
            out += "</link>\n";
        }
        for (i, row) in (1..=count).zip(&self.joints) {
            let JointRow(kind, parent, xyz, axis, rpy, drives) = row;
            let kind = match kind.as_str() {
                "c" => "continuous",
                "p" => "prismatic",
                _ => "fixed",
            };
            let rpy = if rpy.is_empty() { "0 0 0" } else { rpy };
            let advice = if *drives == 1 { " independent=\"true\"" } else { "" };
            let _ = write!(out, "<joint name=\"j{i}\" type=\"{kind}\"{advice}>");
            let _ = write!(out, "<parent link=\"l{parent}\"/><child link=\"l{i}\"/>");
            let _ = write!(out, "<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><axis xyz=\"{axis}\"/>");
            if kind == "prismatic" {
                out += "<limit lower=\"-100\" upper=\"100\" effort=\"1\" velocity=\"1\"/>";
            }
            out += "</joint>\n";
        }
        for (number, (before, at, after, there, axis)) in self.loops.iter().enumerate() {
            let kind = match axis.split_whitespace().count() {
                0 => "spherical",
                1 => "distance",
                _ => "revolute",
            };
            let _ = write!(out, "<loop name=\"loop{number}\" type=\"{kind}\">");
            let _ = write!(out, "<predecessor link=\"l{before}\"><origin xyz=\"{at}\"/></predecessor>");
            let _ = write!(out, "<successor link=\"l{after}\"><origin xyz=\"{there}\"/></successor>");
            out += &match kind {
                "spherical" => String::new(),
                "distance" => format!("<distance value=\"{axis}\"/>"),
                _ => format!("<axis xyz=\"{axis}\"/>"),
            };
            out += "</loop>\n";
        }
        out + "</robot>\n"
    }

    /// Moving joints with values and driver flags (without loops, all are drivers). Guesses deviate by `rough`.
    fn values(&self, count: usize, words: &str, rough: f64) -> Vec<(String, f64, f64, bool)> {
        let moving = (1..=count).zip(&self.joints).filter(|(_, row)| row.0 != "f");
        let value = |((i, row), word): ((usize, &JointRow), &str)| {
            let drives = self.loops.is_empty() || row.5 == 1;
            let value = word.parse().expect("a number");
            (format!("j{i}"), value, if drives { value } else { value + rough }, drives)
        };
        moving.zip(words.split(' ')).map(value).collect()
    }
}

/// Digits as an integer, and the power of ten of the last digit, for text of the form `d.ddd…e±p`.
fn decimal(text: &str) -> (i128, i32) {
    let (digits, power) = text.split_once('e').expect("an exponent");
    let (whole, part) = digits.split_once('.').expect("a point");
    let power: i32 = power.parse().expect("a power");
    let places = i32::try_from(part.len()).expect("few digits");
    (format!("{whole}{part}").parse().expect("digits"), power - places)
}

/// Relative difference of a double from the reference's 25 digits.
fn off(got: f64, reference: &str) -> f64 {
    let (wanted, last) = decimal(reference);
    let nearest: f64 = reference.parse().expect("a number");
    // The decimals of a double are exact with sufficiently many digits.
    let (mut ours, own_last) = decimal(&format!("{nearest:.24e}"));
    match own_last - last {
        1 => ours *= 10,
        -1 => ours /= 10,
        _ => assert_eq!(own_last, last, "{reference}"),
    }
    let rest = (wanted - ours) as f64 * 10f64.powi(last);
    (((got - nearest) - rest) / nearest).abs()
}

/// Requirements of a group, besides valid stated errors.
#[derive(Clone, Copy, Default)]
struct Wanted {
    /// True if the true and the stated error must be within [`DIGITS`].
    digits: bool,
    /// True if the true error must be within [`DIGITS`].
    right: bool,
    /// True if stated errors must be within 1e4 of the group's largest true error; a single true error may vanish by
    /// chance.
    tight: bool,
}

/// Relative error limit for eleven digits.
const DIGITS: f64 = 1e-11;
/// Limit of a stated error relative to the worst true error of its group.
const TIGHT: f64 = 1e4;
/// 30 · ε · 1e9 kg.
const NOTHING: f64 = 6.7e-6;
/// Half a rounding; smaller true errors are chance.
const LEAST: f64 = 1e-16;

/// True if a number exceeds its bound, or is NaN.
fn above(number: f64, bound: f64) -> bool {
    number.is_nan() || number > bound
}

/// Counts of a group.
#[derive(Default)]
struct Tally {
    asked: usize,
    unanswered: usize,
    exceeded: usize,
    coarse: usize,
    vague: usize,
    loose: usize,
    elsewhere: usize,
    worst: f64,
    stated: Vec<f64>,
    excess: f64,
    looseness: f64,
    pose: f64,
}

impl Tally {
    /// Records a result; returns the complaints, which fail the group.
    fn take(&mut self, answer: &Answer, reference: &str, wanted: Wanted) -> Vec<String> {
        self.asked += 1;
        let (mass, error) = match answer {
            Ok(answer) => *answer,
            // (D) is zero below n·ε of the summed masses: 1e9 kg and 30 links here.
            Err(why) if why.contains("Massless") && reference.parse::<f64>().is_ok_and(|m| m < NOTHING) => {
                return Vec::new();
            }
            Err(why) => {
                self.unanswered += 1;
                return vec![format!("no answer ({why}), reference {reference}")];
            }
        };
        let truth = off(mass, reference);
        // Relative to the reference, as the true error is.
        let stated = error / reference.parse::<f64>().expect("a number");
        let say = |what: &str| {
            format!("{what}: got {mass:?}, reference {reference}, stated {stated:.1e}, true {truth:.1e}")
        };
        self.worst = self.worst.max(truth);
        self.stated.push(stated);
        self.excess = self.excess.max(truth / stated);
        self.looseness = self.looseness.max(stated / truth.max(LEAST));
        let mut complaints = Vec::new();
        if above(truth, stated) {
            self.exceeded += 1;
            complaints.push(say("exceeded"));
        }
        if above(truth, DIGITS) {
            self.coarse += 1;
            if wanted.digits || wanted.right {
                complaints.push(say("coarse"));
            }
        }
        if above(stated, DIGITS) {
            self.vague += 1;
            if wanted.digits {
                complaints.push(say("vague"));
            }
        }
        self.loose += usize::from(above(stated, TIGHT * truth.max(LEAST)));
        complaints
    }

    /// Stated errors too far above the worst true error.
    fn too_loose(&self) -> Vec<String> {
        let bound = TIGHT * self.worst.max(LEAST);
        let loose = self.stated.iter().filter(|stated| above(**stated, bound));
        loose.map(|stated| format!("  loose: stated {stated:.1e}, worst true {:.1e}", self.worst)).collect()
    }

    fn row(&mut self, group: &str) -> String {
        self.stated.sort_by(f64::total_cmp);
        let part = |p: usize| self.stated.get(self.stated.len().saturating_sub(1) * p / 100).copied();
        let [median, most] = [50, 100].map(|p| part(p).unwrap_or(f64::NAN));
        format!(
            "{group:<53} {:>4} {:>4} {:>4} {:>4} {:>4} {:>4} {:>4}   {:>7.0e}  {median:>7.0e} {most:>7.0e}  {:>7.0e} {:>7.0e}  {:>7.0e}",
            self.asked,
            self.unanswered,
            self.exceeded,
            self.coarse,
            self.vague,
            self.loose,
            self.elsewhere,
            self.worst,
            self.excess,
            self.looseness,
            self.pose
        )
    }
}

const HEADER: &str = "group                                                asked none over >dig vague loose else   worst true  stated: median, most  true/stated stated/true (most)  pose off";

/// Tests a family, prints its counts and failures, and fails for any failure. `also` receives the results of every
/// group (seed and results per case) and returns further complaints.
fn judge(
    file: &str,
    wanted: impl Fn(&str) -> Wanted,
    also: impl Fn(&str, &[(u32, Vec<Answer>)]) -> Vec<String>,
) {
    let family = Family::read(file);
    let (mut report, mut failures) = (format!("{file}\n{HEADER}\n"), 0);
    let loops = |cases: &[Case]| cases.iter().any(|case| !family.mechanisms[case.of].loops.is_empty());
    let asked = family.groups.iter().flat_map(|(group, cases)| {
        let again = loops(cases).then(|| (group.as_str(), format!("{group}, rough guess"), cases, true));
        [(group.as_str(), group.clone(), cases, false)].into_iter().chain(again)
    });
    for (group, name, cases, rough) in asked {
        let (mut tally, mut complaints, mut all) = (Tally::default(), Vec::new(), Vec::new());
        // Model of the previous case, reused for the same mechanism, links and base.
        let mut kept: Option<(_, Result<Model, String>)> = None;
        for case in cases {
            let rows = &family.mechanisms[case.of];
            let count = case.count.unwrap_or(rows.links.len() - 1);
            let key = (case.of, count, case.floating);
            if kept.as_ref().is_none_or(|(other, _)| *other != key) {
                kept = Some((key, Model::new(&rows.urdf(count), case.floating)));
            }
            let (_, model) = kept.as_ref().expect("a model");
            let contacts: Vec<Asked> = case.contacts.iter().map(|(k, _)| family.contact(*k)).collect();
            // Near a crossing of branches, the distance between the branches is about the distance to the crossing.
            let apart = case.near.map_or(0.1, f64::abs);
            let values = rows.values(count, &case.values, if rough { apart / 10.0 } else { 0.0 });
            let asked = model.as_ref().map_err(Clone::clone).and_then(|model| model.ask(&values, &contacts));
            let (pose, answers) = asked.unwrap_or_else(|why| (0.0, vec![Err(why); contacts.len()]));
            let elsewhere = pose > apart / 2.0;
            tally.elsewhere += usize::from(elsewhere);
            tally.pose = tally.pose.max(pose);
            let refused = |answer: &Result<_, String>| families::is_short_line(answer);
            let zipped = case.contacts.iter().zip(&answers).filter(|(_, answer)| !refused(answer));
            for ((k, reference), answer) in zipped {
                let near = case.near.map_or(String::new(), |near| format!(", {near:e} from it"));
                let distance_from_origin =
                    if elsewhere { format!(", joints {pose:.1e} away") } else { String::new() };
                let case = format!("{name}, seed {}{near}{distance_from_origin}, contact {k}", case.seed);
                let found = tally.take(answer, reference, wanted(group));
                complaints.extend(found.into_iter().map(|what| format!("  {case}: {what}")));
            }
            all.push((case.seed, answers));
        }
        complaints.extend(also(group, &all).into_iter().map(|what| format!("  {name}: {what}")));
        if wanted(group).tight {
            complaints.extend(tally.too_loose().into_iter().map(|what| format!("  {name}: {what}")));
        }
        let _ = writeln!(report, "{}", tally.row(&name));
        failures += complaints.len();
        for complaint in &complaints {
            println!("{complaint}");
        }
    }
    println!("{report}");
    assert!(failures == 0, "{file}: {failures} failures, printed above\n{report}");
}

impl Family {
    fn read(file: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/precision").join(file);
        let text = std::fs::read_to_string(path).expect("a fixture");
        serde_json::from_str(&text).expect("a family")
    }

    fn contact(&self, k: usize) -> Asked {
        let ContactRow(on, against, point, normal, world, toward) = &self.contacts[k];
        let against = usize::try_from(*against).ok().map(|other| format!("l{other}"));
        Asked {
            on: format!("l{on}"),
            against,
            point: three(point),
            normal: three(normal),
            world: *world == 1,
            toward: toward.map(|end| format!("l{end}")),
        }
    }
}

fn nothing(_: &str, _: &[(u32, Vec<Answer>)]) -> Vec<String> {
    Vec::new()
}

#[test]
fn slider_cranks_of_eighteen_decades_keep_eleven_digits() {
    judge("slider_cranks.json", |_| Wanted { digits: true, ..Wanted::default() }, nothing);
}

#[test]
fn masses_over_eighteen_decades() {
    // Open trees may be ill-conditioned: the number of loose stated errors is only printed.
    judge("decades.json", |group| Wanted { tight: group != "tree", ..Wanted::default() }, nothing);
}

#[test]
fn chains() {
    judge("chains.json", |_| Wanted { tight: true, ..Wanted::default() }, nothing);
}

#[test]
fn near_dead_centres_and_change_points() {
    judge("dead_centres.json", |_| Wanted::default(), nothing);
}

#[test]
fn hubs_of_about_three_hundred_arms() {
    judge(
        "hubs.json",
        |_| Wanted::default(),
        |_, cases| {
            let mut complaints = Vec::new();
            for k in 0..cases[0].1.len() {
                let stated: Vec<f64> = cases
                    .iter()
                    .filter_map(|(_, answers)| answers[k].as_ref().ok())
                    .map(|(m, e)| e / m)
                    .collect();
                let least = stated.iter().copied().fold(f64::INFINITY, f64::min);
                let most = stated.iter().copied().fold(0.0, f64::max);
                if stated.len() < cases.len() || above(most, 2.0 * least) {
                    let sizes: Vec<u32> = cases.iter().map(|(seed, _)| *seed).collect();
                    complaints.push(format!(
                        "contact {k}: stated {stated:?} for {sizes:?} arms, more than 2 apart"
                    ));
                }
            }
            complaints
        },
    );
}

#[test]
fn far_from_the_root() {
    judge("far.json", |_| Wanted::default(), nothing);
}

#[test]
fn rings_of_ten_to_three_hundred_links() {
    judge(
        "rings.json",
        |_| Wanted { tight: true, right: true, ..Wanted::default() },
        |_, cases| {
            // A single large stated error would pass if the worst true error is also large.
            let answers = cases.iter().flat_map(|(_, answers)| answers).filter_map(|a| a.as_ref().ok());
            let vague = answers.filter(|(mass, error)| above(error / mass, 1e-9));
            vague.map(|(mass, error)| format!("stated {error:.1e} of {mass}")).collect()
        },
    );
}

#[test]
fn small_pivots_light_contacts_and_lines() {
    judge("pivots.json", |_| Wanted::default(), nothing);
}

#[test]
fn linkages_in_space_without_a_redundant_row() {
    judge("spatial.json", |_| Wanted::default(), nothing);
}

#[test]
fn rings_of_a_thousand_links() {
    judge("rings_1000.json", |_| Wanted { tight: true, ..Wanted::default() }, nothing);
}
