//! Parsers of the values of flags.

use percuss_study::contact::Law;
use percuss_study::contact::exports::Tool;
use percuss_study::{
    Dimension, EstimateQuestion, GivenPosition, GivenTravel, Hold, JointStop, Quantity, RatioPoint,
    Tolerance, UPWARDS, parse_triple,
};

/// Simulators named by one value of `--for`: one, or all.
pub type Tools = Vec<Tool>;

/// `X,Y,Z`: a point.
pub fn point(text: &str) -> Result<[f64; 3], String> {
    parse_triple(text, Dimension::Length).map_err(|e| e.to_string())
}

/// `X,Y,Z`: a direction.
pub fn normal(text: &str) -> Result<[f64; 3], String> {
    parse_triple(text, Dimension::Plain).map_err(|e| e.to_string())
}

/// Length in m; the range is checked later.
pub fn edge(text: &str) -> Result<f64, String> {
    Quantity::parse(text).and_then(|q| q.in_dimension(Dimension::Length, text)).map_err(|e| e.to_string())
}

/// `NAME=FOLDER`.
pub fn package(text: &str) -> Result<(String, std::path::PathBuf), String> {
    match text.split_once('=') {
        Some((name, folder)) if !name.is_empty() && !folder.is_empty() => {
            Ok((name.to_owned(), folder.into()))
        }
        _ => Err("expected NAME=FOLDER, such as ur_description=/opt/ros/share/ur_description".into()),
    }
}

/// Mass above zero with an optional unit, kg.
pub fn kilograms(text: &str) -> Result<f64, String> {
    let mass = Quantity::parse(text)
        .and_then(|q| q.in_dimension(Dimension::Mass, text))
        .map_err(|e| e.to_string())?;
    if mass > 0.0 { Ok(mass) } else { Err(format!("{mass} kg; a mass above 0 is expected")) }
}

/// Mass in kg; the range is checked later, with the other data of the contact.
pub fn plain_kilograms(text: &str) -> Result<f64, String> {
    Quantity::parse(text).and_then(|q| q.in_dimension(Dimension::Mass, text)).map_err(|e| e.to_string())
}

/// Number without a unit; the range is checked later.
pub fn plain_number(text: &str) -> Result<f64, String> {
    Quantity::parse(text).and_then(|q| q.in_dimension(Dimension::Plain, text)).map_err(|e| e.to_string())
}

/// Name of a contact law, checked.
pub fn law(text: &str) -> Result<String, String> {
    Law::from_name(text).map(|_| text.to_owned()).map_err(|e| e.to_string())
}

/// Number with an optional unit of a dimension.
fn measured(dimension: Dimension, text: &str) -> Result<Quantity, String> {
    dimension.parse(text).map_err(|e| e.to_string())
}

/// Translational or rotational stiffness; the joint type is checked later.
pub fn stiffness(text: &str) -> Result<Quantity, String> {
    measured(Dimension::Stiffness, text)
        .or_else(|error| measured(Dimension::RotationalStiffness, text).map_err(|_| error))
}

/// Dimensionless number, plain or in per cent.
pub fn ratio(text: &str) -> Result<f64, String> {
    measured(Dimension::Ratio, text).map(|m| m.value)
}

/// Translational or rotational speed; the joint type is checked later.
pub fn speed(text: &str) -> Result<Quantity, String> {
    measured(Dimension::Speed, text)
        .or_else(|error| measured(Dimension::AngularSpeed, text).map_err(|_| error))
}

/// `JOINT`, `JOINT:lower` or `JOINT:upper`.
pub fn joint_stop(text: &str) -> Result<JointStop, String> {
    JointStop::parse(text)
}

/// Time, s.
pub fn time(text: &str) -> Result<f64, String> {
    measured(Dimension::Time, text).map(|m| m.value)
}

/// Force, N.
pub fn force(text: &str) -> Result<f64, String> {
    measured(Dimension::Force, text).map(|m| m.value)
}

/// Pressure, Pa.
pub fn pressure(text: &str) -> Result<f64, String> {
    measured(Dimension::Pressure, text).map(|m| m.value)
}

/// Energy, J.
pub fn energy(text: &str) -> Result<f64, String> {
    measured(Dimension::Energy, text).map(|m| m.value)
}

/// Momentum, N·s.
pub fn momentum(text: &str) -> Result<f64, String> {
    measured(Dimension::Momentum, text).map(|m| m.value)
}

/// Area, m².
pub fn area(text: &str) -> Result<f64, String> {
    measured(Dimension::Area, text).map(|m| m.value)
}

/// Simulators separated by commas, or `all`.
pub fn tools(text: &str) -> Result<Tools, String> {
    match text {
        "all" => Ok(Tool::ALL.to_vec()),
        _ => Ok(vec![Tool::from_name(text).map_err(|e| e.to_string())?]),
    }
}

/// Length above zero with an optional unit, m.
pub fn metres(text: &str) -> Result<f64, String> {
    let length = Quantity::parse(text)
        .and_then(|q| q.in_dimension(Dimension::Length, text))
        .map_err(|e| e.to_string())?;
    if length > 0.0 { Ok(length) } else { Err(format!("{length} m; a length above 0 is expected")) }
}

/// Three moments of inertia, kg·m², not negative.
pub fn moments(text: &str) -> Result<[f64; 3], String> {
    let moments = parse_triple(text, Dimension::Plain).map_err(|e| e.to_string())?;
    if moments.iter().all(|i| *i >= 0.0) {
        Ok(moments)
    } else {
        Err("moments of 0 or more are expected".into())
    }
}

/// Value of --tolerance.
#[derive(Clone, Copy, Debug)]
pub enum ToleranceArg {
    /// Relative tolerance of --expect.
    OfExpected(f64),
    /// Tolerances of the model's data.
    OfParts(Tolerance),
}

/// `1e-6` or `mass=2%,point=0.5mm`.
pub fn tolerance_argument(text: &str) -> Result<ToleranceArg, String> {
    if text.contains('=') {
        return Tolerance::parse(text).map(ToleranceArg::OfParts).map_err(|e| e.to_string());
    }
    let read = tolerance(text).map(ToleranceArg::OfExpected);
    read.map_err(|e| format!("{e} (with --expect), or mass=2%,point=0.5mm for the model's data"))
}

/// Relative tolerance, not negative.
fn tolerance(text: &str) -> Result<f64, String> {
    let value = Quantity::parse(text)
        .and_then(|q| q.in_dimension(Dimension::Plain, text))
        .map_err(|e| e.to_string())?;
    if value >= 0.0 { Ok(value) } else { Err(format!("{value}; a tolerance of 0 or more is expected")) }
}

/// `POINT=X,Y,Z`: hardpoint and displacement.
pub fn point_shift(text: &str) -> Result<(String, [f64; 3]), String> {
    let (name, by) = assignment(text).map_err(|_| "expected POINT=X,Y,Z, such as lower_ball=0,0,5mm")?;
    Ok((name, point(&by)?))
}

/// `LINK=KG`.
pub fn link_mass(text: &str) -> Result<(String, f64), String> {
    let (link, mass) = assignment(text).map_err(|_| "expected LINK=KG, such as upright=10kg")?;
    Ok((link, plain_kilograms(&mass)?))
}

/// `LINK=X,Y,Z`.
pub fn link_com(text: &str) -> Result<(String, [f64; 3]), String> {
    let (link, com) = assignment(text).map_err(|_| "expected LINK=X,Y,Z, such as upright=0,20mm,0")?;
    Ok((link, point(&com)?))
}

/// `LINK:X,Y,Z`, split at the last colon, because link names may contain colons.
pub fn line(text: &str) -> Result<(String, [f64; 3]), String> {
    match text.rsplit_once(':') {
        Some((link, numbers)) if !link.is_empty() => Ok((link.to_owned(), point(numbers)?)),
        _ => Err("expected LINK:X,Y,Z, such as chassis:0.3,0,0.4".into()),
    }
}

/// `JOINT=VALUE`: position of a joint, with optional units.
pub fn position(text: &str) -> Result<(String, GivenPosition), String> {
    let (joint, value) = assignment(text)?;
    Ok((joint, GivenPosition::parse(&value).map_err(|e| e.to_string())?))
}

/// `LINK:X,Y,Z[:DX,DY,DZ]`.
pub fn ratio_at(text: &str) -> Result<RatioPoint, String> {
    let (link, found) = triples(text);
    let (at, along) = match found[..] {
        [at] => (at, UPWARDS),
        [at, along] => (at, normal(along)?),
        _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:DX,DY,DZ, such as wheel:0,0,0:0,0,1".into()),
    };
    Ok(RatioPoint { link: link.to_owned(), point: point(at)?, direction: along })
}

/// `LINK:X,Y,Z:DX,DY,DZ=DISTANCE`.
pub fn travel(text: &str) -> Result<GivenTravel, String> {
    GivenTravel::parse(text).map_err(|e| e.to_string())
}

/// `JOINT=VALUE`, split at the last equals sign.
fn assignment(text: &str) -> Result<(String, String), String> {
    match text.rsplit_once('=') {
        Some((joint, value)) if !joint.is_empty() && !value.is_empty() => {
            Ok((joint.to_owned(), value.to_owned()))
        }
        _ => Err("expected JOINT=VALUE, such as elbow=30deg".into()),
    }
}

/// `JOINT=VALUES`: reflected inertias separated by commas.
pub fn armature(text: &str) -> Result<(String, Vec<f64>), String> {
    let (joint, value) = assignment(text)?;
    let values = percuss_study::parse_list(&value, |_| Dimension::Plain).map_err(|e| e.to_string())?;
    Ok((joint, values))
}

/// Name followed by up to two triples, split from the right.
fn triples(text: &str) -> (&str, Vec<&str>) {
    let (mut name, mut found) = (text, Vec::new());
    while found.len() < 2
        && let Some((rest, last)) = name.rsplit_once(':')
        && last.contains(',')
        && last.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
    {
        found.insert(0, last);
        name = rest;
    }
    (name, found)
}

/// `LINK:X,Y,Z[:NX,NY,NZ]`: held point with an optional normal.
pub fn hold(text: &str) -> Result<Hold, String> {
    let (link, found) = triples(text);
    let (at, along) = match found[..] {
        [at] => (at, None),
        [at, along] => (at, Some(normal(along)?)),
        _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as foot:0,0,0:0,0,-1".into()),
    };
    Ok(Hold { link: link.to_owned(), point: point(at)?, normal: along })
}

/// `LINKS[:X,Y,Z[:DX,DY,DZ]]`: links of the classical estimate, point A and direction.
pub fn estimate(text: &str) -> Result<EstimateQuestion, String> {
    let (links, found) = triples(text);
    let links: Vec<String> = links.split(',').map(str::to_owned).collect();
    if links.iter().any(String::is_empty) {
        return Err("expected LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]], such as spindle,upright:0,0,0:0,0,1".into());
    }
    let at = found.first().map_or(Ok([0.0; 3]), |text| point(text))?;
    let direction = found.get(1).map(|text| normal(text)).transpose()?;
    Ok(EstimateQuestion { links, point: at, direction })
}
