//! Proved bounds of m̄ at a pose and over ranges.

use super::problem::Problem;
use super::range::{Ranges, Side};
use super::records::{CertifiedTree, ExtremesCertificate, MassCertificate, NoCertificate, RangeProof};
use super::{bracket, linkage_range, plan};
use crate::analysis::pose::Pose;
use crate::kinematics::contact::Contact;
use percuss_mechanism::JointId;

impl Pose {
    /// Proved bounds of m̄ at this pose, for the numbers of the model as read, with an enclosure of each of a few units in the last place.
    ///
    /// 1/m̄ = max { 2 j·u − uᵀM u : A u = 0 } is bounded from below by the energy of one admissible motion, and from above by a Lagrange
    /// multiplier. The assembly of loops is proved by the operator of Krawczyk over the dependent positions; the driving positions are
    /// those of the pose. Cost: O(n²) interval operations, about 100 times that of m̄.
    ///
    /// Source: Krawczyk 1969; Rump 2010 (Acta Numerica), §13.
    ///
    /// # Errors
    /// [`NoCertificate`]: a change point, a massless or immovable contact, or an unsupported constraint.
    pub fn certify(&self, contact: &Contact) -> Result<MassCertificate, NoCertificate> {
        let problem = Problem::new(self, contact)?;
        let closed = problem.close(&problem.q)?;
        let bounds = bracket::inverse_mass(
            &problem.plan,
            &problem.load,
            &problem.loops,
            &closed.q,
            (&closed.rows, &closed.dependent),
        );
        let bounds = bounds.filter(|bounds| bounds.most.is_finite()).ok_or(NoCertificate::Massless)?;
        if bounds.least <= 0.0 {
            return Err(NoCertificate::Immovable);
        }
        let [lower, upper] = bounds.mass();
        let (omitted, implied) = (problem.omitted(&closed), problem.loops.implied);
        let is_tree = problem.loops.is_empty();
        Ok(MassCertificate {
            lower,
            upper,
            uniqueness: if is_tree { None } else { problem.closing().uniqueness(&closed) },
            rows: problem.loops.names.len() + implied,
            implied,
            omitted,
        })
    }

    /// Proved bounds of the smallest and the largest m̄ over ranges of driving joints (rad or m); the other driving joints keep their
    /// positions at this pose.
    ///
    /// For each box of positions the motion u of its centre is fixed. One recursion in intervals then bounds 1/m̄ ≥ 2 j·u − uᵀM u, and its
    /// derivatives give the mean-value form: the bound is exact at the centre, with an error of the square of the box. The box with the
    /// worst bound is halved first. Loops are proved for each box by the operator of Krawczyk, and neighbouring boxes to be one branch.
    ///
    /// A cone of normals and edges of contact points (trees only) are further positions, of bodies without mass and velocity that carry the
    /// contact.
    ///
    /// M with any masses within ±t is between (1 − t) M and (1 + t) M, and so is m̄: the largest m̄ is 1 + t times that of the model, the
    /// smallest one 1 − t times.
    ///
    /// # Errors
    /// [`NoCertificate`]: a joint that does not drive, more than two ranges of loops, or an unsupported constraint. Bounds that are not
    /// proved within the budget are no errors.
    pub fn certify_extremes(
        &self,
        contact: &Contact,
        ranges: &[(JointId, f64, f64)],
        proof: RangeProof,
    ) -> Result<ExtremesCertificate, NoCertificate> {
        let mut problem = Problem::new(self, contact)?;
        let mut varied = ranges
            .iter()
            .map(|&(joint, lower, upper)| {
                let own = self.mechanism().joint(joint);
                let no_driver = || NoCertificate::NoDriver { joint: own.name().to_owned() };
                let coordinate = problem.model.coordinates.iter().position(|c| c.joint == Some(joint));
                let is_free = coordinate.is_none_or(|c| problem.free[c]);
                let drives = own.kind().dofs() == 1 && own.mimic().is_none() && is_free;
                let (lower, upper) = (plan::position(lower).lo(), plan::position(upper).hi());
                drives
                    .then(|| (problem.model.joint_q[joint.index()].start, lower, upper))
                    .ok_or_else(no_driver)
            })
            .collect::<Result<Vec<_>, _>>()?;
        varied.extend(problem.vary_contact(&proof)?);
        if !problem.loops.is_empty() {
            // An immovable or massless contact, or a change point, at the pose.
            self.certify(contact)?;
            return Ok(linkage_range::enclose(&problem, &varied, proof)?.with_masses(proof.mass_tolerance));
        }
        let ranges = Ranges {
            plan: &problem.plan,
            load: &problem.load,
            loops: &problem.loops,
            q: &problem.q,
            varied: &varied,
            proof,
        };
        let certificate = ExtremesCertificate {
            least: (!proof.only_largest).then(|| ranges.enclose(Side::Least)),
            most: ranges.enclose(Side::Most),
            branch: None,
            tree: problem.plan.numbers().zip(problem.load.numbers()).map(|(bodies, contact)| CertifiedTree {
                bodies,
                contact,
                positions: problem.q.iter().map(|x| [x.lo(), x.hi()]).collect(),
                ranges: varied.clone(),
            }),
        };
        Ok(certificate.with_masses(proof.mass_tolerance))
    }
}
