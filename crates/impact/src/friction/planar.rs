//! Frictional impact of a contact that moves in one plane: closed form.

use crate::friction::phases::{Phase, PhaseKind, RestitutionLaw, add_phase};
use crate::friction::rounding::resolved_rate;

/// Mobility of a contact in a plane, 1/kg.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlanarMobility {
    /// a_nn.
    pub normal: f64,
    /// a_nt.
    pub coupling: f64,
    /// a_tt.
    pub tangential: f64,
}

/// Result in the plane.
#[derive(Clone, Debug)]
pub(crate) struct PlanarCollision {
    /// Normal and tangential impulse, N·s.
    pub impulse: [f64; 2],
    /// Normal and tangential velocity after the impact, m/s.
    pub after: [f64; 2],
    pub phases: Vec<Phase>,
    pub compression: f64,
    pub normal_work: [f64; 2],
    pub is_wedged: bool,
}

/// Sign of the sliding velocity that starts from rest; 0 if the contact sticks.
fn direction_from_rest(mobility: &PlanarMobility, friction: f64) -> f64 {
    let sticks = mobility.coupling.abs() <= friction * mobility.tangential;
    if sticks { 0.0 } else { mobility.coupling.signum() }
}

/// Impact with the normal impulse p as independent variable. In each phase the velocities are linear in p, and the works quadratic.
///
/// | phase  | tangential per normal impulse | ends if                        |
/// |--------|-------------------------------|--------------------------------|
/// | slip σ | −µσ                           | the sliding velocity vanishes  |
/// | stick  | −a_nt/a_tt, at most µ         | never                          |
///
/// From rest the contact sticks if |a_nt| ≤ µ a_tt, and slides with the sign of a_nt otherwise. The impact ends by the law
/// of restitution. Sources: Routh 1905; Stronge 1990; Wang and Mason 1992.
///
/// `before`: normal velocity (negative) and tangential velocity. `None` if the impact has no end.
pub(crate) fn planar_collision(
    mobility: &PlanarMobility,
    before: [f64; 2],
    friction: f64,
    restitution: f64,
    law: RestitutionLaw,
) -> Option<PlanarCollision> {
    let (nn, nt, tt) = (mobility.normal, mobility.coupling, mobility.tangential);
    let [mut un, mut ut] = before;
    let mut done = PlanarCollision {
        impulse: [0.0; 2],
        after: before,
        phases: Vec::new(),
        compression: 0.0,
        normal_work: [0.0; 2],
        is_wedged: false,
    };
    let (mut is_expansion, mut has_slid, mut expansion) = (false, false, 0.0);
    // At most one slip, one stick or reverse slip, in two stages.
    for _ in 0..8 {
        let starts_at_rest = ut == 0.0;
        let sigma = if starts_at_rest { direction_from_rest(mobility, friction) } else { ut.signum() };
        let sticks = starts_at_rest && sigma == 0.0;
        let tangential = match (sticks, tt > 0.0) {
            (true, true) => -nt / tt,
            (true, false) => 0.0,
            (false, _) => -friction * sigma,
        };
        let alpha = resolved_rate(nn + nt * tangential, nn);
        let beta = if sticks { 0.0 } else { nt + tt * tangential };
        let kind = match (sticks, has_slid) {
            (true, _) => PhaseKind::Stick,
            (false, true) if starts_at_rest || done.phases.last().is_some_and(is_reverse) => {
                PhaseKind::ReverseSlip
            }
            (false, _) if alpha <= 0.0 && !is_expansion => PhaseKind::Jam,
            (false, _) => PhaseKind::Slip,
        };
        if sticks && alpha <= 0.0 && is_expansion && un <= 0.0 {
            done.is_wedged = true;
            break;
        }
        let to_rest = if beta * ut < 0.0 { -ut / beta } else { f64::INFINITY };
        let to_end = if !is_expansion {
            if alpha > 0.0 { -un / alpha } else { f64::INFINITY }
        } else {
            match law {
                RestitutionLaw::Poisson => restitution * done.compression - expansion,
                RestitutionLaw::Newton | RestitutionLaw::Algebraic => {
                    let wanted = -restitution * before[0] - un;
                    if wanted <= 0.0 {
                        0.0
                    } else if alpha > 0.0 {
                        wanted / alpha
                    } else {
                        f64::INFINITY
                    }
                }
                RestitutionLaw::Energetic => {
                    let wanted = -restitution * restitution * done.normal_work[0] - done.normal_work[1];
                    let root = un * un + 2.0 * alpha * wanted;
                    if wanted <= 0.0 {
                        0.0
                    } else if root >= 0.0 {
                        2.0 * wanted / (un + root.sqrt())
                    } else {
                        f64::INFINITY
                    }
                }
            }
        }
        .max(0.0);
        let length = to_rest.min(to_end);
        if !length.is_finite() {
            return None;
        }
        add_phase(&mut done.phases, kind, is_expansion, length);
        done.normal_work[usize::from(is_expansion)] += length * (un + 0.5 * alpha * length);
        done.impulse[0] += length;
        done.impulse[1] += tangential * length;
        un += alpha * length;
        has_slid |= !sticks;
        ut = if to_rest <= to_end { 0.0 } else { ut + beta * length };
        if is_expansion {
            expansion += length;
        } else {
            done.compression += length;
        }
        if to_end <= to_rest {
            if is_expansion {
                break;
            }
            un = 0.0;
            is_expansion = true;
        }
    }
    done.after = [un, ut];
    Some(done)
}

fn is_reverse(phase: &Phase) -> bool {
    phase.kind == PhaseKind::ReverseSlip
}
