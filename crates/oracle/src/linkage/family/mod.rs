//! A family of planar linkages standing in space, from seeds: drawn closed, so that every joint is at 0 there.
//!
//! Four-bars, parallel cranks under a platform, slider-cranks and six-bars, in planes turned out of all axes. Every link
//! frame and every loop frame is turned at random, axes are given accordingly; any of the pins may be the one that closes
//! the loop. Loops are closed by spatial hinges, whose rows are redundant in a plane: three of five, or four where cranks
//! are parallel. [`Drawn::written`] gives the same as a file with few decimals does.

mod drawing;
mod kinds;
mod open;
mod space;
mod tool;

pub use kinds::Kind;
pub use open::{DrawnOpen, drawn_open, gaps};
pub use tool::Tool;

use crate::maximal::{Outcome, Question, close, effective_mass, moved, poses, residuals};
use crate::random::{direction, vector, zero_positions};
use crate::{alter, linkage::family::space::Stood};
use drawing::Drawing;
use faer::Mat;
use nalgebra::{Matrix3, Matrix4, Vector3};
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// How many decimals the files of a family are written with.
pub const DECIMALS: [usize; 6] = [12, 9, 7, 6, 5, 4];

/// A drawing is taken where the least singular value of its loops that counts is at least this part of the largest.
const REGULAR: f64 = 0.05;
/// Pins on the same body are at least so far apart, m.
const SHORTEST: f64 = 0.2;
/// Contacts on every linkage.
const CONTACTS: usize = 3;

/// A contact on a linkage of the family, against the ground.
#[derive(Clone, Debug)]
pub struct Touch {
    /// The struck link.
    pub link: LinkId,
    /// The struck point in it, m.
    pub point: Vector3<f64>,
    /// The unit normal in its axes.
    pub normal: Vector3<f64>,
    /// m̄ as drawn, by route C, kg.
    pub mass: f64,
    /// The same in closed form, where no tool hangs on a hinge.
    pub closed_form: Option<f64>,
}

/// A linkage of the family: the exact twin.
#[derive(Debug)]
pub struct Drawn {
    /// What it was drawn from.
    pub seed: u64,
    /// What it is.
    pub kind: Kind,
    /// What its coupler bears.
    pub tool: Tool,
    /// It, to full precision.
    pub mechanism: Mechanism,
    /// Its degrees of freedom on the ground.
    pub mobility: usize,
    /// Its redundant rows.
    pub redundant: usize,
    /// The greatest distance between pins on a moving body, m.
    pub size: f64,
    /// The joints of its loops.
    pub loop_joints: Vec<JointId>,
    /// Where it is struck.
    pub contacts: Vec<Touch>,
}

/// The linkage of this seed: kinds take turns, so that eight seeds in a row have all.
pub fn drawn(seed: u64) -> Drawn {
    drawn_as(seed, Kind::ALL[seed as usize % Kind::ALL.len()])
}

/// The linkage of this seed and kind.
///
/// # Panics
/// Where a thousand drawings in a row are too nearly singular.
pub fn drawn_as(seed: u64, kind: Kind) -> Drawn {
    let mut rng = StdRng::seed_from_u64(0xFA_0000 + seed);
    let tool = [Tool::None, Tool::Fixed, Tool::Hinged][rng.random_range(0..3)];
    for _ in 0..1000 {
        let mut drawing = kinds::draw(&mut rng, kind);
        let tree = drawing.cut();
        let size = drawing.size();
        let values = drawing.singular_values(tree, size);
        if drawing.least_bar() < SHORTEST || values[tree - 2] < REGULAR * values[0] {
            continue;
        }
        let name = format!("{kind:?} {seed}");
        let Stood { mechanism, plane } = space::stand(&mut rng, &name, &drawing, tree, tool);
        let rows: usize = mechanism.closures().iter().map(|c| c.kind().rows()).sum();
        let loop_joints: Vec<JointId> =
            drawing.pins[..tree].iter().map(|pin| mechanism.find_joint(pin.name).expect("a joint")).collect();
        let mut drawn = Drawn {
            seed,
            kind,
            tool,
            mechanism,
            mobility: 1 + usize::from(tool == Tool::Hinged),
            redundant: rows - (tree - 1),
            size,
            loop_joints,
            contacts: Vec::new(),
        };
        drawn.contacts = touches(&mut rng, &drawn, &drawing, &plane);
        return drawn;
    }
    panic!("{kind:?} {seed}: every drawing is nearly singular")
}

/// Random contacts that the linkage's own motion closes at a fair speed.
fn touches(rng: &mut StdRng, drawn: &Drawn, drawing: &Drawing, plane: &space::Plane) -> Vec<Touch> {
    let mechanism = &drawn.mechanism;
    let zero = zero_positions(mechanism);
    let x_wl = poses(mechanism, &zero);
    let fastest = drawing
        .pins
        .iter()
        .flat_map(|pin| pin.bodies.map(|body| drawing.motions[body].velocity_of(pin.at).norm()))
        .fold(0.0, f64::max);
    let mut touches = Vec::new();
    while touches.len() < CONTACTS {
        let bodies = drawing.bodies.len();
        // A tool moves with the coupler.
        let body = rng.random_range(1..bodies + usize::from(drawn.tool != Tool::None));
        let (name, motion) = match drawing.bodies.get(body) {
            Some(name) => (*name, drawing.motions[body]),
            None => ("tool", drawing.motions[drawing.coupler]),
        };
        let link = mechanism.find_link(name).expect("a link");
        let own = mechanism.link(link).inertial().expect("a body");
        let point = own.com + vector(rng, 0.3);
        let normal = direction(rng);
        let velocity = plane.velocity(&motion, &(turn(&x_wl, link) * point + place(&x_wl, link)));
        if velocity.norm() < 0.3 * fastest || normal.dot(&velocity).abs() < 0.4 * velocity.norm() {
            continue;
        }
        let mut touch =
            Touch { link, point, normal: turn(&x_wl, link).tr_mul(&normal), mass: 0.0, closed_form: None };
        let Outcome::Finite(mass) = drawn.mass_of(mechanism, &zero, &touch, None) else {
            panic!("{}: a contact that cannot be answered", mechanism.name())
        };
        touch.mass = mass;
        if drawn.tool != Tool::Hinged {
            let energy = |(id, body): (LinkId, usize)| {
                let own = mechanism.link(id).inertial().expect("a body");
                let motion = &drawing.motions[body];
                let com = turn(&x_wl, id) * own.com + place(&x_wl, id);
                let spin = turn(&x_wl, id).tr_mul(&plane.normal()) * motion.rate;
                own.mass * plane.velocity(motion, &com).norm_squared() + spin.dot(&(own.about_com * spin))
            };
            let moving = mechanism.link_ids().filter(|id| *id != mechanism.root());
            let with_body = moving.map(|id| {
                let own = drawing.bodies.iter().position(|n| *n == mechanism.link(id).name());
                (id, own.unwrap_or(drawing.coupler))
            });
            let closing = normal.dot(&velocity);
            touch.closed_form = Some(with_body.map(energy).sum::<f64>() / (closing * closing));
        }
        touches.push(touch);
    }
    touches
}

fn turn(x_wl: &[Matrix4<f64>], link: LinkId) -> Matrix3<f64> {
    x_wl[link.index()].fixed_view::<3, 3>(0, 0).into_owned()
}

fn place(x_wl: &[Matrix4<f64>], link: LinkId) -> Vector3<f64> {
    x_wl[link.index()].fixed_view::<3, 1>(0, 3).into_owned()
}

impl Drawn {
    /// The same as a file with so many decimals gives it.
    pub fn written(&self, decimals: usize) -> Mechanism {
        alter::written(&self.mechanism, decimals)
    }

    /// In a line, for a failure.
    pub fn label(&self) -> String {
        format!("seed {} {:?} tool {:?}", self.seed, self.kind, self.tool)
    }

    /// m̄ of a contact by route C on this linkage or one of its [`written`](Self::written) twins, the normal turning
    /// with the link; singular values up to `threshold` of the largest count as zero (none: route C's own).
    pub fn mass_of(
        &self,
        mechanism: &Mechanism,
        positions: &[Vec<f64>],
        touch: &Touch,
        threshold: Option<f64>,
    ) -> Outcome {
        let normal = turn(&poses(mechanism, positions), touch.link) * touch.normal;
        let question = Question::new(mechanism, positions.to_vec(), touch.link, touch.point, normal);
        effective_mass(&Question { threshold, ..question })
    }

    /// The least singular value of the loops' rows over their joints without `driver`, as a part of the largest
    /// (angles times the size): small at a dead centre of the driver.
    pub fn ease(&self, positions: &[Vec<f64>], driver: JointId) -> f64 {
        // Central differences: h² and ε/h.
        const H: f64 = 1e-5;
        let mechanism = &self.mechanism;
        let followers: Vec<JointId> = self.loop_joints.iter().copied().filter(|id| *id != driver).collect();
        let columns: Vec<Vec<f64>> = followers
            .iter()
            .map(|&id| {
                let unit =
                    if mechanism.joint(id).kind() == JointKind::Prismatic { 1.0 } else { 1.0 / self.size };
                let [plus, minus] = [H, -H]
                    .map(|h| residuals(mechanism, &moved(mechanism, positions, id, 0, h * unit)).concat());
                plus.iter().zip(&minus).map(|(a, b)| (a - b) / (2.0 * H)).collect()
            })
            .collect();
        let matrix = Mat::from_fn(columns[0].len(), columns.len(), |r, c| columns[c][r]);
        let values = matrix.singular_values().expect("finite differences");
        values[values.len() - 1] / values[0]
    }

    /// Positions of the exact twin with a joint of its loops at `value`, on the branch on which it is drawn; none where
    /// that joint comes near a dead centre on the way.
    pub fn at(&self, driver: JointId, value: f64) -> Option<Vec<Vec<f64>>> {
        const STEPS: usize = 4;
        let followers: Vec<JointId> = self.loop_joints.iter().copied().filter(|id| *id != driver).collect();
        let mut here = zero_positions(&self.mechanism);
        for step in 0..=STEPS {
            here[driver.index()] = vec![value * step as f64 / STEPS as f64];
            here = close(&self.mechanism, &here, &followers).ok()?;
            if self.ease(&here, driver) < REGULAR {
                return None;
            }
        }
        Some(here)
    }
}
