//! The six Chrono templates: keys, links, joints.
//!
//! Each function reads all sections first and builds only if no error was found. The functions follow `Construct` and
//! `InitializeSide` of Chrono's classes of the same names; `docs/reference/SUSPENSIONS.md` has the table.

use super::corner::{Body, CHASSIS, Corner};
use super::frames;
use super::parts::{self, Axes, Inertias, SHOCK, SPRING, WISHBONE, ball, hooke, seats, spanned};
use super::reader::{Reader, Section};
use super::spindle::Spindle;
use percuss_mechanism::JointKind;
use percuss_spatial::{Matrix3, Vector3};

type Template = for<'t> fn(&mut Reader<'t>, &mut Section<'t>, &Spindle) -> Option<Corner>;

/// Templates by their names in the file.
pub(super) const TEMPLATES: [(&str, Template); 6] = [
    ("DoubleWishbone", double_wishbone),
    ("DoubleWishboneReduced", double_wishbone_reduced),
    ("MacPhersonStrut", macpherson_strut),
    ("SemiTrailingArm", semi_trailing_arm),
    ("ThreeLinkIRS", three_link_irs),
    ("MultiLink", multi_link),
];

const OWN: Option<(Inertias, Axes)> = Some((Inertias::Moments, Axes::Own));

/// Adds the upright on a ball joint of the tree at the outer point of an arm.
fn upright_on(corner: &mut Corner, arm: &str, joint: &str, at: Vector3<f64>, upright: &Body) {
    corner.link("upright", at, Some(upright), format!("Upright: frame at the ball joint of {arm}"));
    let comment = "a ball joint";
    corner.joint((joint, JointKind::Spherical), [arm, "upright"], Vector3::x(), &upright.spot, comment);
}

fn double_wishbone<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>, spindle: &Spindle) -> Option<Corner> {
    let axes = if reader.flag(root, "Vehicle-Frame Inertia") { Axes::Vehicle } else { Axes::Own };
    let how = Some((Inertias::WithProducts, axes));
    let upright = parts::lone_body(reader, root, "Upright", Inertias::WithProducts);
    let upper = parts::arm(reader, root, "Upper Control Arm", WISHBONE, how);
    let lower = parts::arm(reader, root, "Lower Control Arm", WISHBONE, how);
    let tie_rod = parts::tie_rod(reader, root, true);
    let spring = seats(reader, root, "Spring", "Location Arm");
    let shock = seats(reader, root, "Shock", "Location Arm");
    if reader.has_errors() {
        return None;
    }
    let mut corner = Corner::new();
    lower.attach(&mut corner, "lower_arm");
    upright_on(&mut corner, "lower_arm", "lower_ball", lower.ball, &upright);
    spindle.attach(reader, &mut corner, "upright");
    upper.attach(&mut corner, "upper_arm");
    ball(&mut corner, "upper_ball", ["upper_arm", "upright"], upper.ball, &upper.spot);
    tie_rod.tie(reader, &mut corner);
    corner.seats(SPRING, "lower_arm", spring);
    corner.seats(SHOCK, "lower_arm", shock);
    Some(corner)
}

fn double_wishbone_reduced<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    spindle: &Spindle,
) -> Option<Corner> {
    let upright = parts::lone_body(reader, root, "Upright", Inertias::Moments);
    let upper = parts::arm(reader, root, "Upper Control Arm", WISHBONE, None);
    let lower = parts::arm(reader, root, "Lower Control Arm", WISHBONE, None);
    let tie_rod = parts::tie_rod(reader, root, false);
    let shock = seats(reader, root, "Shock", "Location Upright");
    if reader.has_errors() {
        return None;
    }
    let mut corner = Corner::new();
    corner.link("upright", lower.ball, Some(&upright), "Upright: frame at the lower ball joint");
    let free = ("upright_free", JointKind::Floating);
    let comment = "only the rods hold the upright";
    corner.joint(free, [CHASSIS, "upright"], Vector3::x(), &upright.spot, comment);
    spindle.attach(reader, &mut corner, "upright");
    for (arm, names) in
        [(&upper, ["upper_front_rod", "upper_back_rod"]), (&lower, ["lower_front_rod", "lower_back_rod"])]
    {
        for (name, end) in names.into_iter().zip([arm.front, arm.back]) {
            corner.rod(name, [CHASSIS, "upright"], [end, arm.ball], (&arm.spot, "a massless rod"));
        }
    }
    tie_rod.tie(reader, &mut corner);
    corner.seats(SHOCK, "upright", shock);
    Some(corner)
}

fn macpherson_strut<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    spindle: &Spindle,
) -> Option<Corner> {
    let upright = parts::lone_body(reader, root, "Upright", Inertias::Moments);
    let arm = parts::arm(reader, root, "Control Arm", WISHBONE, OWN);
    let mut section = reader.section(root, "Strut");
    let strut_spot = section.spot.clone();
    let mass = reader.number(&mut section, "Mass", "a mass in kg");
    let moments = reader.triple(&mut section, "Inertia", "three moments in kg·m², [xx, yy, zz],");
    parts::close(reader, section);
    let tie_rod = parts::tie_rod(reader, root, true);
    let spring = seats(reader, root, "Spring", "Location Upright");
    let shock = seats(reader, root, "Shock", "Location Upright");
    let [bottom, top] = spring;
    // The strut's own axes are used for its joints; its inertia is given in the vehicle's axes.
    let y = frames::normal(bottom - arm.back, top - arm.back);
    let axes = y.and_then(|y| frames::along_z(top - bottom, y));
    let defect =
        "the spring's line passes through the arm's back hinge point: the strut's pins have no direction";
    let axes = spanned(reader, axes, &strut_spot, defect);
    if reader.has_errors() {
        return None;
    }
    let strut = Body {
        mass,
        com: (bottom + top) / 2.0,
        about_com: Matrix3::from_diagonal(&moments),
        spot: strut_spot.clone(),
    };
    let [x, y, z] = [0, 1, 2].map(|i| axes.column(i).into_owned());
    let mut corner = Corner::new();
    arm.attach(&mut corner, "control_arm");
    upright_on(&mut corner, "control_arm", "lower_ball", arm.ball, &upright);
    spindle.attach(reader, &mut corner, "upright");
    let comment = "Strut, half way along the spring's line: frame at the spring's upper seat".to_owned();
    hooke(reader, &mut corner, (CHASSIS, "strut"), top, &strut, [x, y], comment);
    corner.slide("strut_slide", ["strut", "upright"], bottom, z, &strut_spot);
    tie_rod.tie(reader, &mut corner);
    corner.seats(SPRING, "upright", spring);
    corner.seats(SHOCK, "upright", shock);
    Some(corner)
}

fn semi_trailing_arm<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    spindle: &Spindle,
) -> Option<Corner> {
    // Chrono uses the opposite normal for this arm; principal moments do not depend on its sign.
    let points = ["Location Chassis Outer", "Location Chassis Inner", "Location Spindle"];
    let arm = parts::arm(reader, root, "Trailing Arm", points, OWN);
    let spring = seats(reader, root, "Spring", "Location Arm");
    let shock = seats(reader, root, "Shock", "Location Arm");
    if reader.has_errors() {
        return None;
    }
    let mut corner = Corner::new();
    arm.attach(&mut corner, "trailing_arm");
    spindle.attach(reader, &mut corner, "trailing_arm");
    corner.seats(SPRING, "trailing_arm", spring);
    corner.seats(SHOCK, "trailing_arm", shock);
    Some(corner)
}

/// Link between two points, with its body.
struct Rod {
    body: Body,
    inner: Vector3<f64>,
    outer: Vector3<f64>,
    /// Pins of the Hooke's joint: on the chassis, on the link.
    pins: [Vector3<f64>; 2],
}

fn three_link_irs<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>, spindle: &Spindle) -> Option<Corner> {
    let vertical = "it is vertical, or its ends coincide: its axes have no direction";
    let mut section = reader.section(root, "Trailing Arm");
    let stated = parts::body(reader, &mut section, Inertias::Moments);
    let chassis = reader.point(&mut section, "Location Chassis");
    let outer = reader.point(&mut section, "Location Spindle");
    let frame = spanned(reader, frames::along_x(chassis - outer), &section.spot, vertical);
    parts::close(reader, section);
    let arm = stated.in_frame(&frame);
    let mut link = |reader: &mut Reader<'t>, key| {
        let mut section = reader.section(root, key);
        let stated = parts::body(reader, &mut section, Inertias::Moments);
        let inner = reader.point(&mut section, "Location Chassis");
        let outer = reader.point(&mut section, "Location Arm");
        let pin = reader.direction(&mut section, "Universal Joint Axis");
        let frame = spanned(reader, frames::along_x(outer - inner), &section.spot, vertical);
        // The pin in the file is fixed in the link; the chassis pin is the component of ẑ normal to it.
        let axes = frames::normal(pin, Vector3::z()).and_then(|w| frames::along_z(w, w.cross(&pin)));
        let defect = "Universal Joint Axis is zero or vertical: the other pin has no direction";
        let axes = spanned(reader, axes, &section.spot, defect);
        parts::close(reader, section);
        let pins = [axes.column(1).into_owned(), axes.column(0).into_owned()];
        Rod { body: stated.in_frame(&frame), inner, outer, pins }
    };
    let links = [("upper_link", link(reader, "Upper Link")), ("lower_link", link(reader, "Lower Link"))];
    let spring = seats(reader, root, "Spring", "Location Arm");
    let shock = seats(reader, root, "Shock", "Location Arm");
    if reader.has_errors() {
        return None;
    }
    let mut corner = Corner::new();
    corner.link("trailing_arm", chassis, Some(&arm), "Trailing Arm: frame at its ball joint on the chassis");
    let joint = ("trailing_arm_ball", JointKind::Spherical);
    corner.joint(joint, [CHASSIS, "trailing_arm"], Vector3::x(), &arm.spot, "a ball joint");
    corner.drawing.rod("trailing_arm", [chassis, outer], &arm.spot);
    spindle.attach(reader, &mut corner, "trailing_arm");
    for (name, link) in links {
        let comment = format!("{}: frame at its inner end", link.body.spot.label());
        hooke(reader, &mut corner, (CHASSIS, name), link.inner, &link.body, link.pins, comment);
        let joint = format!("{name}_ball");
        ball(&mut corner, &joint, [name, "trailing_arm"], link.outer, &link.body.spot);
        corner.drawing.rod(name, [link.inner, link.outer], &link.body.spot);
    }
    corner.seats(SPRING, "trailing_arm", spring);
    corner.seats(SHOCK, "trailing_arm", shock);
    Some(corner)
}

fn multi_link<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>, spindle: &Spindle) -> Option<Corner> {
    let upright = parts::lone_body(reader, root, "Upright", Inertias::Moments);
    let upper = parts::arm(reader, root, "Upper Arm", WISHBONE, OWN);
    // The sections are read before their frames are computed, because each frame needs a point of another section.
    let mut link = |reader: &mut Reader<'t>, key| {
        let mut section = reader.section(root, key);
        let stated = parts::body(reader, &mut section, Inertias::Moments);
        let inner = reader.point(&mut section, "Location Chassis");
        let outer = reader.point(&mut section, "Location Upright");
        // Chrono's joint takes the link as first body. The key "... Link" therefore gives the chassis pin, and vice
        // versa.
        let pins = ["Universal Joint Axis Link", "Universal Joint Axis Chassis"].map(|key| {
            let pin = frames::unit(reader.direction(&mut section, key));
            spanned(reader, pin, &section.spot, &format!("{key} is zero: it has no direction"))
        });
        let defect = "the pins of its universal joint are parallel";
        spanned(reader, frames::normal(pins[0], pins[1]), &section.spot, defect);
        parts::close(reader, section);
        (stated, inner, outer, pins)
    };
    let lateral = link(reader, "Lateral");
    let trailing = link(reader, "Trailing Link");
    let tie_rod = parts::tie_rod(reader, root, true);
    let spring = seats(reader, root, "Spring", "Location Link");
    let shock = seats(reader, root, "Shock", "Location Link");
    let foot = trailing.2;
    let rods = [("lateral", lateral, foot), ("trailing_link", trailing, spring[0])].map(
        |(name, (stated, inner, outer, pins), third)| {
            let y = frames::normal(outer - third, inner - third);
            let defect = "the plane of its axes (its ends, and the trailing link's outer end for the lateral, the \
                           spring's lower seat for the trailing link) is not defined: the points lie on one line";
            let frame = y.and_then(|y| frames::along_z(inner - outer, y));
            let frame = spanned(reader, frame, &stated.spot, defect);
            (name, Rod { body: stated.in_frame(&frame), inner, outer, pins })
        },
    );
    if reader.has_errors() {
        return None;
    }
    let mut corner = Corner::new();
    upper.attach(&mut corner, "upper_arm");
    upright_on(&mut corner, "upper_arm", "upper_ball", upper.ball, &upright);
    spindle.attach(reader, &mut corner, "upright");
    for (name, rod) in rods {
        let comment = format!("{}: frame at its inner end", rod.body.spot.label());
        hooke(reader, &mut corner, (CHASSIS, name), rod.inner, &rod.body, rod.pins, comment);
        ball(&mut corner, &format!("{name}_ball"), [name, "upright"], rod.outer, &rod.body.spot);
        corner.drawing.rod(name, [rod.inner, rod.outer], &rod.body.spot);
    }
    tie_rod.tie(reader, &mut corner);
    corner.seats(SPRING, "trailing_link", spring);
    corner.seats(SHOCK, "trailing_link", shock);
    Some(corner)
}
