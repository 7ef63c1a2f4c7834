//! Family of planar linkages in space, from seeds; closed as drawn, with all joints at 0.
//!
//! Four-bars, parallel cranks under a platform, slider-cranks and six-bars, in planes parallel to no coordinate
//! plane. Link frames and loop frames have random orientations, with axes given accordingly; any pin can be the
//! loop closure. Loops are closed by spatial hinges, with redundant rows in a plane: three of five, or four for
//! parallel cranks. [`Drawn::written`] gives the same linkage as a file with few decimals.

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
use crate::{alter, linkage::family::space::PlacedDrawing};
use drawing::Drawing;
use faer::Mat;
use nalgebra::{Matrix3, Matrix4, Vector3};
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Numbers of decimals of the written files of a family.
pub const DECIMALS: [usize; 6] = [12, 9, 7, 6, 5, 4];

/// Smallest accepted ratio of the smallest nonzero singular value of the loops to the largest.
const MIN_CONDITIONING: f64 = 0.05;
/// Smallest distance between pins on one body, m.
const MIN_BAR: f64 = 0.2;
/// Contacts per linkage.
const CONTACTS: usize = 3;

/// Contact on a linkage of the family, against the ground.
#[derive(Clone, Debug)]
pub struct Touch {
    /// Contact link.
    pub link: LinkId,
    /// Contact point in the link frame, m.
    pub point: Vector3<f64>,
    /// Unit normal in the link's axes.
    pub normal: Vector3<f64>,
    /// m̄ in the drawn position by route C, kg.
    pub mass: f64,
    /// m̄ in closed form, kg; `None` with a hinged tool.
    pub closed_form: Option<f64>,
}

/// Linkage of the family with exact numbers.
#[derive(Debug)]
pub struct Drawn {
    /// Seed.
    pub seed: u64,
    /// Kind of linkage.
    pub kind: Kind,
    /// Tool on the coupler.
    pub tool: Tool,
    /// The mechanism in full precision.
    pub mechanism: Mechanism,
    /// Degrees of freedom on the ground.
    pub mobility: usize,
    /// Number of redundant rows.
    pub redundant: usize,
    /// Largest distance between pins on a moving body, m.
    pub size: f64,
    /// Joints of the loops.
    pub loop_joints: Vec<JointId>,
    /// Contacts.
    pub contacts: Vec<Touch>,
}

/// Linkage of this seed. The kinds alternate: eight consecutive seeds contain all kinds.
pub fn drawn(seed: u64) -> Drawn {
    drawn_as(seed, Kind::ALL[seed as usize % Kind::ALL.len()])
}

/// Linkage of this seed and kind.
///
/// # Panics
/// If a thousand consecutive drawings are nearly singular.
pub fn drawn_as(seed: u64, kind: Kind) -> Drawn {
    let mut rng = StdRng::seed_from_u64(0xFA_0000 + seed);
    let tool = [Tool::None, Tool::Fixed, Tool::Hinged][rng.random_range(0..3)];
    for _ in 0..1000 {
        let mut drawing = kinds::random_drawing(&mut rng, kind);
        let tree = drawing.select_spanning_tree();
        let size = drawing.size();
        let values = drawing.singular_values(tree, size);
        if drawing.shortest_bar() < MIN_BAR || values[tree - 2] < MIN_CONDITIONING * values[0] {
            continue;
        }
        let name = format!("{kind:?} {seed}");
        let PlacedDrawing { mechanism, plane } = space::place_in_space(&mut rng, &name, &drawing, tree, tool);
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
        drawn.contacts = random_contacts(&mut rng, &drawn, &drawing, &plane);
        return drawn;
    }
    panic!("{kind:?} {seed}: every drawing is nearly singular")
}

/// Random contacts with a closing speed well above zero in the linkage's motion.
fn random_contacts(rng: &mut StdRng, drawn: &Drawn, drawing: &Drawing, plane: &space::Plane) -> Vec<Touch> {
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
        let velocity = plane.velocity(&motion, &(rotation_of(&x_wl, link) * point + origin_of(&x_wl, link)));
        if velocity.norm() < 0.3 * fastest || normal.dot(&velocity).abs() < 0.4 * velocity.norm() {
            continue;
        }
        let mut touch = Touch {
            link,
            point,
            normal: rotation_of(&x_wl, link).tr_mul(&normal),
            mass: 0.0,
            closed_form: None,
        };
        let Outcome::Finite(mass) = drawn.mass_of(mechanism, &zero, &touch, None) else {
            panic!("{}: a contact that cannot be answered", mechanism.name())
        };
        touch.mass = mass;
        if drawn.tool != Tool::Hinged {
            let energy = |(id, body): (LinkId, usize)| {
                let own = mechanism.link(id).inertial().expect("a body");
                let motion = &drawing.motions[body];
                let com = rotation_of(&x_wl, id) * own.com + origin_of(&x_wl, id);
                let spin = rotation_of(&x_wl, id).tr_mul(&plane.normal()) * motion.rate;
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

/// Orientation of a link in the world.
fn rotation_of(x_wl: &[Matrix4<f64>], link: LinkId) -> Matrix3<f64> {
    x_wl[link.index()].fixed_view::<3, 3>(0, 0).into_owned()
}

/// Origin of a link in the world.
fn origin_of(x_wl: &[Matrix4<f64>], link: LinkId) -> Vector3<f64> {
    x_wl[link.index()].fixed_view::<3, 1>(0, 3).into_owned()
}

impl Drawn {
    /// The linkage as a file with the given number of decimals.
    pub fn written(&self, decimals: usize) -> Mechanism {
        alter::written(&self.mechanism, decimals)
    }

    /// One-line description for failure messages.
    pub fn label(&self) -> String {
        format!("seed {} {:?} tool {:?}", self.seed, self.kind, self.tool)
    }

    /// m̄ of a contact by route C on this linkage or one of its [`written`](Self::written) twins; the normal
    /// rotates with the link. Singular values up to `threshold` of the largest count as zero (`None`: default
    /// of route C).
    pub fn mass_of(
        &self,
        mechanism: &Mechanism,
        positions: &[Vec<f64>],
        touch: &Touch,
        threshold: Option<f64>,
    ) -> Outcome {
        let normal = rotation_of(&poses(mechanism, positions), touch.link) * touch.normal;
        let question = Question::new(mechanism, positions.to_vec(), touch.link, touch.point, normal);
        effective_mass(&Question { threshold, ..question })
    }

    /// Ratio of the smallest to the largest singular value of the loop rows over their joints without `driver`
    /// (angles times the size): small near a dead centre of the driver.
    pub fn conditioning_of_driver(&self, positions: &[Vec<f64>], driver: JointId) -> f64 {
        // Central differences with the errors h² and ε/h.
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

    /// Positions of the exact linkage with a loop joint at `value`, on the drawn branch; `None` if the path
    /// comes near a dead centre of this joint.
    pub fn at(&self, driver: JointId, value: f64) -> Option<Vec<Vec<f64>>> {
        const STEPS: usize = 4;
        let followers: Vec<JointId> = self.loop_joints.iter().copied().filter(|id| *id != driver).collect();
        let mut positions = zero_positions(&self.mechanism);
        for step in 0..=STEPS {
            positions[driver.index()] = vec![value * step as f64 / STEPS as f64];
            positions = close(&self.mechanism, &positions, &followers).ok()?;
            if self.conditioning_of_driver(&positions, driver) < MIN_CONDITIONING {
                return None;
            }
        }
        Some(positions)
    }
}
