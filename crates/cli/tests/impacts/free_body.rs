//! Impacts against a free body, and results that do not include friction.

use crate::support::json;
use serde_json::Value;

/// Against a free body, friction with the coefficient 0 changes nothing, and the contact in time reaches the requested restitution at the
/// effective mass of both sides.
#[test]
fn a_free_body_with_friction_and_in_time() {
    let number = |value: &Value| value.as_f64().expect("a number");
    let arm = "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg --restitution 0.3";
    let at_rest =
        format!("{arm} --against-mass 2 --speed 1 --rates shoulder=0 --rates elbow=0 --format json");
    let smooth = json(&at_rest);
    let rough = json(&format!("{at_rest} --friction 0"));
    let impulse = number(&smooth["impulse"]);
    assert!((number(&rough["impulse"]) / impulse - 1.0).abs() < 1e-9, "{rough}");
    assert!((impulse - 1.3 * number(&smooth["mass"]["effective_mass"])).abs() < 1e-12);
    let in_time = json(&format!("{at_rest} --stiffness 1e5 --in-time"));
    // The effective mass of the arm drifts during the impact.
    assert!((number(&in_time["in_time"]["restitution"]) - 0.3).abs() < 1e-3, "{in_time}");
    assert!(number(&in_time["in_time"]["mass_change"]).abs() < 0.01, "{in_time}");
}
