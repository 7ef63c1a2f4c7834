//! Compliant contact: effective mass and stiffness, which is a power law or a curve of force over penetration.

use crate::ContactLawError;
use crate::error::{LawParameter, positive, representable};
use crate::limits;

/// Effective mass of a contact, and the stiffness between the two surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompliantContact<'a> {
    mass: f64,
    stiffness: StiffnessLaw<'a>,
}

impl<'a> CompliantContact<'a> {
    /// Smallest and largest exponent of the spring.
    pub const EXPONENTS: std::ops::RangeInclusive<f64> = 1.0..=10.0;

    /// Contact with a linear spring.
    ///
    /// `mass` is the effective mass m̄ along the normal, in kg; `stiffness` is k, in N/m. Errors: one of the two is not
    /// a finite number above zero.
    pub fn new(mass: f64, stiffness: f64) -> Result<Self, ContactLawError> {
        let mass = positive(LawParameter::Mass, mass)?;
        let coefficient = positive(LawParameter::Stiffness, stiffness)?;
        Ok(Self { mass, stiffness: StiffnessLaw::Power { coefficient, exponent: 1.0 } })
    }

    /// Contact with the force curve of a stop. `mass` is the effective mass m̄ along the normal, in kg. Errors: the mass is not a finite
    /// number above zero.
    pub fn on_curve(mass: f64, curve: &'a ForceCurve) -> Result<Self, ContactLawError> {
        Ok(Self { mass: positive(LawParameter::Mass, mass)?, stiffness: StiffnessLaw::Curve(curve) })
    }

    /// Contact with the spring force k xᵖ, k in N/mᵖ: p = 1 for a linear spring, 3/2 for spheres (Hertz).
    ///
    /// Errors: as [`new`](Self::new); p is not from 1 to 10; the contact has a curve.
    pub fn with_exponent(self, exponent: f64) -> Result<Self, ContactLawError> {
        let valid = match self.stiffness {
            StiffnessLaw::Power { coefficient, .. } if Self::EXPONENTS.contains(&exponent) => {
                return Ok(Self { stiffness: StiffnessLaw::Power { coefficient, exponent }, ..self });
            }
            StiffnessLaw::Power { .. } => "a number from 1 to 10",
            StiffnessLaw::Curve(_) => "no exponent with a force curve",
        };
        Err(ContactLawError::OutOfRange { what: LawParameter::Exponent, got: exponent, valid })
    }

    /// m̄, in kg.
    pub fn mass(self) -> f64 {
        self.mass
    }

    /// Stiffness between the two surfaces.
    pub fn stiffness(self) -> StiffnessLaw<'a> {
        self.stiffness
    }

    /// k, in N/mᵖ, and p; `None` for a force curve.
    pub fn power_law(self) -> Option<(f64, f64)> {
        match self.stiffness {
            StiffnessLaw::Power { coefficient, exponent } => Some((coefficient, exponent)),
            StiffnessLaw::Curve(_) => None,
        }
    }

    /// Largest penetration without damping, m, for an approach speed in m/s. Errors: overflow; a curve that does not stop the mass.
    pub(crate) fn undamped_penetration(self, speed: f64) -> Result<f64, ContactLawError> {
        let depth = match self.stiffness {
            StiffnessLaw::Power { coefficient, exponent: p } => {
                // √(m̄/k) v first: intermediate squares cannot overflow.
                let root = self.mass.sqrt() / coefficient.sqrt() * speed;
                let scale = (0.5 * (p + 1.0)).sqrt() * representable("compression, m", root)?;
                scale.powf(2.0 / (p + 1.0))
            }
            StiffnessLaw::Curve(curve) => {
                let energy = 0.5 * self.mass * speed * speed;
                curve.depth(energy).ok_or(ContactLawError::NotStopped { energy })?
            }
        };
        representable("compression, m", depth)
    }
}

/// Force curve of a stop: force over penetration, by points with lines between them, or by a sum of powers Σ cᵢ x^pᵢ from the touch to a last
/// penetration. Beyond the last point the last slope continues, but the force does not fall below zero.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceCurve {
    deflections: Vec<f64>,
    forces: Vec<f64>,
    /// Work ∫ F dx from the touch to each point, J.
    works: Vec<f64>,
    /// cᵢ (N/m^pᵢ) and pᵢ between the two points; empty for lines.
    powers: Vec<(f64, f64)>,
}

/// Parts of a sum of powers that are examined for its sign and for a maximum of the contact force.
const PARTS_OF_POWERS: u32 = 64;

impl ForceCurve {
    /// Creates a curve from penetrations (m), increasing from 0, and the force (N) at each.
    ///
    /// # Errors
    /// [`ContactLawError::Curve`]: lists of different lengths or of less than two numbers, penetrations that do not increase from 0,
    /// negative or infinite numbers.
    pub fn new(deflections: Vec<f64>, forces: Vec<f64>) -> Result<Self, ContactLawError> {
        let refuse = |why: String| Err(ContactLawError::Curve { why });
        let (x, f) = (&deflections, &forces);
        check_points("deflection", "m", x, f)?;
        if x[0] != 0.0 {
            return refuse(format!("the first deflection is {} m; expected 0, the touch", x[0]));
        }
        if let Some(force) = f.iter().find(|force| **force < 0.0) {
            return refuse(format!(
                "a force of {force} N is given; expected forces of compression, 0 or more"
            ));
        }
        let mut works = vec![0.0];
        for i in 1..x.len() {
            works.push(works[i - 1] + 0.5 * (x[i] - x[i - 1]) * (f[i] + f[i - 1]));
        }
        Ok(Self { deflections, forces, works, powers: Vec::new() })
    }

    /// Creates the curve F = Σ cᵢ x^pᵢ up to the penetration `to` (m) from pairs of cᵢ (N/m^pᵢ) and pᵢ: a polynomial, or k xᵖ.
    ///
    /// # Errors
    /// [`ContactLawError::Curve`]: no pair, infinite numbers, exponents that do not increase or are not from 1 to 10, `to` not above 0, a
    /// negative force between 0 and `to`.
    pub fn powers(powers: Vec<(f64, f64)>, to: f64) -> Result<Self, ContactLawError> {
        let refuse = |why: String| Err(ContactLawError::Curve { why });
        if powers.is_empty() || !powers.iter().all(|(c, _)| c.is_finite()) {
            return refuse("the coefficients of a sum of powers are expected, finite numbers".to_owned());
        }
        if let Some((_, p)) = powers.iter().find(|(_, p)| !CompliantContact::EXPONENTS.contains(p)) {
            return refuse(format!("an exponent of {p} is given; expected numbers from 1 to 10"));
        }
        if let Some(pair) = powers.windows(2).find(|pair| pair[0].1 >= pair[1].1) {
            let (a, b) = (pair[0].1, pair[1].1);
            return refuse(format!("an exponent of {b} follows {a}; expected increasing exponents"));
        }
        if !(to.is_finite() && to > 0.0) {
            return refuse(format!("the last deflection is {to} m; expected a number above 0"));
        }
        let mut curve =
            Self { deflections: vec![0.0, to], forces: vec![0.0; 2], works: vec![0.0; 2], powers };
        for part in 1..=PARTS_OF_POWERS {
            let x = to * f64::from(part) / f64::from(PARTS_OF_POWERS);
            let force = curve.sum(x, |p| p);
            if !(force.is_finite() && force >= 0.0) {
                return refuse(format!(
                    "the force is {force} N at {x} m; expected a compression up to {to} m"
                ));
            }
        }
        curve.forces[1] = curve.sum(to, |p| p);
        curve.works[1] = curve.work(0.0, to);
        if curve.works[1] > 0.0 { Ok(curve) } else { refuse("the force is 0 everywhere".to_owned()) }
    }

    /// Same curve with all forces multiplied by a factor above 0.
    ///
    /// # Errors
    /// [`ContactLawError::Curve`]: forces that are infinite or negative.
    pub fn scaled(&self, factor: f64) -> Result<Self, ContactLawError> {
        if self.powers.is_empty() {
            return Self::new(
                self.deflections.clone(),
                self.forces.iter().map(|force| force * factor).collect(),
            );
        }
        Self::powers(self.powers.iter().map(|(c, p)| (c * factor, *p)).collect(), self.deflections[1])
    }

    /// Σ cᵢ x^r, with r a function of pᵢ.
    fn sum(&self, x: f64, exponent: impl Fn(f64) -> f64) -> f64 {
        self.powers.iter().map(|(c, p)| c * x.powf(exponent(*p))).sum()
    }

    /// Penetrations of the points, m.
    pub fn deflections(&self) -> &[f64] {
        &self.deflections
    }

    /// Forces of the points, N.
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }

    /// Pairs of cᵢ (N/m^pᵢ) and pᵢ of a sum of powers; empty for points with lines.
    pub fn terms(&self) -> &[(f64, f64)] {
        &self.powers
    }

    /// Last point of the curve: penetration (m) and force (N).
    pub fn end(&self) -> (f64, f64) {
        let last = self.forces.len() - 1;
        (self.deflections[last], self.forces[last])
    }

    /// Slope of the line after point `i`, N/m; of a sum of powers, the slope at its last penetration.
    fn slope(&self, i: usize) -> f64 {
        if !self.powers.is_empty() {
            return self.powers.iter().map(|(c, p)| c * p * self.deflections[1].powf(p - 1.0)).sum();
        }
        (self.forces[i + 1] - self.forces[i]) / (self.deflections[i + 1] - self.deflections[i])
    }

    /// Index of the point at which the line begins that has the penetration `x`; at a point, the next line.
    fn line(&self, x: f64) -> usize {
        let last = self.deflections.len() - if self.powers.is_empty() { 1 } else { 0 };
        self.deflections.partition_point(|at| *at <= x).clamp(1, last) - 1
    }

    /// True if the force at the penetration `x` is the sum of powers.
    fn is_power(&self, x: f64) -> bool {
        !self.powers.is_empty() && x <= self.deflections[1]
    }

    /// Force (N) and its slope (N/m) at a penetration (m); zero before the touch. At a point of the curve, the slope is that of the next
    /// piece.
    pub fn at(&self, penetration: f64) -> (f64, f64) {
        if penetration < 0.0 {
            return (0.0, 0.0);
        }
        if self.is_power(penetration) {
            let slope = self.powers.iter().map(|(c, p)| c * p * penetration.powf(p - 1.0)).sum();
            return (self.sum(penetration, |p| p).max(0.0), slope);
        }
        let i = self.line(penetration);
        let slope = self.slope(i);
        let force = self.forces[i] + slope * (penetration - self.deflections[i]);
        if force < 0.0 { (0.0, 0.0) } else { (force, slope) }
    }

    /// Penetration (m) at which the work ∫ F dx is `work` (J); `None` if the curve never does this work.
    pub(crate) fn depth(&self, work: f64) -> Option<f64> {
        if !self.powers.is_empty() && work < self.works[1] {
            return Some(self.depth_of_powers(work));
        }
        let last = self.works.len() - if self.powers.is_empty() { 1 } else { 0 };
        let i = self.works.partition_point(|w| *w <= work).clamp(1, last) - 1;
        let (force, slope, rest) = (self.forces[i], self.slope(i), work - self.works[i]);
        if rest <= 0.0 {
            return Some(self.deflections[i]);
        }
        // F y + ½ k y² = rest.
        let root = (force * force + 2.0 * slope * rest).sqrt();
        let beyond = 2.0 * rest / (force + root);
        (root.is_finite() && beyond.is_finite()).then_some(self.deflections[i] + beyond)
    }

    /// Penetration (m) at which the work of the sum of powers is `work` (J): Newton's method within a bracket, because the work increases.
    fn depth_of_powers(&self, work: f64) -> f64 {
        let (mut low, mut high) = (0.0, self.deflections[1]);
        let mut x = high;
        for _ in 0..limits::MAX_SEARCH_STEPS {
            let excess = self.work(0.0, x) - work;
            *(if excess > 0.0 { &mut high } else { &mut low }) = x;
            let newton = x - excess / self.sum(x, |p| p);
            let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
            let is_found = (next - x).abs() <= limits::CONVERGED * x;
            x = next;
            if is_found {
                break;
            }
        }
        x
    }

    /// Smallest penetration (m) with a force (N); `None` if the curve never has it.
    pub(crate) fn penetration(&self, force: f64) -> Option<f64> {
        let (last, at_last) = self.end();
        let mut from = 0.0;
        for to in self.parts(last) {
            if self.at(from).0 >= force {
                return Some(from);
            }
            if self.at(to).0 >= force {
                let (mut low, mut high) = (from, to);
                for _ in 0..limits::MAX_ITERATIONS {
                    let middle = 0.5 * (low + high);
                    *(if self.at(middle).0 < force { &mut low } else { &mut high }) = middle;
                }
                return Some(high);
            }
            from = to;
        }
        let slope = self.slope(self.line(last));
        let depth = last + (force - at_last) / slope;
        (slope > 0.0 && depth.is_finite()).then_some(depth)
    }

    /// Work ∫ F dx (J) from the penetration `from` over the distance `by`, both in m. No difference of large numbers.
    pub(crate) fn work(&self, from: f64, by: f64) -> f64 {
        let to = from + by;
        let inner: Vec<f64> = self.corners(from, to).collect();
        let piece = |a: f64, b: f64, length: f64| {
            if !self.is_power(b) || length == 0.0 {
                return 0.5 * length * (self.at(a).0 + self.at(b).0);
            }
            // b^q − (b − length)^q = −b^q ((1 − length/b)^q − 1), q = p + 1.
            let rest = (-(length / b).min(1.0)).ln_1p();
            let term = |(c, p): &(f64, f64)| -c / (p + 1.0) * b.powf(p + 1.0) * ((p + 1.0) * rest).exp_m1();
            self.powers.iter().map(term).sum()
        };
        let (Some(&first), Some(&last)) = (inner.first(), inner.last()) else {
            return piece(from, to, by);
        };
        let between: f64 = inner.windows(2).map(|p| piece(p[0], p[1], p[1] - p[0])).sum();
        piece(from, first, first - from) + between + piece(last, to, to - last)
    }

    /// Points of the curve between two penetrations, m.
    pub(crate) fn corners(&self, from: f64, to: f64) -> impl DoubleEndedIterator<Item = f64> + '_ {
        self.deflections.iter().copied().filter(move |x| from < *x && *x < to)
    }

    /// Ends of the parts up to the penetration `to` (m) in which the contact force has at most one maximum: the points of the curve, and parts
    /// of a sum of powers.
    pub(crate) fn parts(&self, to: f64) -> Vec<f64> {
        let count = if self.powers.is_empty() { 1 } else { PARTS_OF_POWERS };
        let of_powers = to.min(self.deflections[1]) / f64::from(count);
        let within = (1..count).map(|part| of_powers * f64::from(part));
        within.chain(self.corners(0.0, to)).chain([to]).collect()
    }
}

/// Stiffness of a contact: force over penetration without damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StiffnessLaw<'a> {
    /// F = k xᵖ; p = 1 is a linear spring.
    Power {
        /// k, N/mᵖ.
        coefficient: f64,
        /// p.
        exponent: f64,
    },
    /// Curve of a stop.
    Curve(&'a ForceCurve),
}

impl StiffnessLaw<'_> {
    /// Force (N) at a penetration (m); 0 before the touch.
    pub fn force(self, penetration: f64) -> f64 {
        match self {
            Self::Power { coefficient, exponent } => coefficient * penetration.max(0.0).powf(exponent),
            Self::Curve(curve) => curve.at(penetration).0,
        }
    }
}

/// Checks the points of a curve: two lists of the same length, at least 2, of finite numbers, the first list increasing.
fn check_points(name: &str, unit: &str, x: &[f64], forces: &[f64]) -> Result<(), ContactLawError> {
    let refuse = |why: String| Err(ContactLawError::Curve { why });
    if x.len() != forces.len() || x.len() < 2 {
        return refuse(format!(
            "{} {name}s and {} forces are given; expected two lists of the same length, at least 2",
            x.len(),
            forces.len()
        ));
    }
    if let Some(number) = x.iter().chain(forces).find(|number| !number.is_finite()) {
        return refuse(format!("{number} is given; finite numbers are expected"));
    }
    if let Some(pair) = x.windows(2).find(|pair| pair[0] >= pair[1]) {
        let (a, b) = (pair[0], pair[1]);
        return refuse(format!("a {name} of {b} {unit} follows {a} {unit}; expected increasing {name}s"));
    }
    Ok(())
}

/// Largest force at rest relative to the largest of the points: rounding of the interpolation.
const AT_REST: f64 = 1e-12;

/// Force curve of a damper: points of speed and force, linear between the points. Beyond the first and the last point the last slope
/// continues, but a force never drives the motion: it is 0 where the line would change its sign. Speed and force are positive in rebound: the
/// damper gets longer, and the force resists.
#[derive(Clone, Debug, PartialEq)]
pub struct DamperCurve {
    speeds: Vec<f64>,
    forces: Vec<f64>,
}

impl DamperCurve {
    /// Creates a curve from increasing speeds (m/s) and the force (N) at each.
    ///
    /// # Errors
    /// [`ContactLawError::Curve`]: lists of different lengths or of less than two numbers, speeds that do not increase, a force with the sign
    /// against its speed, infinite numbers.
    pub fn new(speeds: Vec<f64>, forces: Vec<f64>) -> Result<Self, ContactLawError> {
        let refuse = |why: String| Err(ContactLawError::Curve { why });
        let (v, f) = (&speeds, &forces);
        check_points("speed", "m/s", v, f)?;
        if let Some((v, f)) = v.iter().zip(f).find(|(v, f)| **v * **f < 0.0) {
            return refuse(format!(
                "the force {f} N at the speed {v} m/s drives the motion; expected the same signs: positive in rebound"
            ));
        }
        let largest = f.iter().fold(0.0f64, |most, force| most.max(force.abs()));
        let curve = Self { speeds, forces };
        let at_rest = curve.force(0.0);
        if at_rest.abs() > AT_REST * largest {
            return refuse(format!(
                "the force is {at_rest} N at rest; expected a curve through 0 m/s and 0 N"
            ));
        }
        Ok(curve)
    }

    /// Linear damper with the damping c, N·s/m.
    ///
    /// # Errors
    /// [`ContactLawError::Curve`]: negative or infinite.
    pub fn linear(damping: f64) -> Result<Self, ContactLawError> {
        Self::new(vec![0.0, 1.0], vec![0.0, damping])
    }

    /// Force (N) at a speed (m/s).
    pub fn force(&self, speed: f64) -> f64 {
        let (v, f) = (&self.speeds, &self.forces);
        let i = v.partition_point(|x| *x <= speed).clamp(1, v.len() - 1);
        let force = f[i] + (speed - v[i]) * (f[i] - f[i - 1]) / (v[i] - v[i - 1]);
        if force * speed < 0.0 { 0.0 } else { force }
    }

    /// Speeds of the points, m/s.
    pub fn speeds(&self) -> &[f64] {
        &self.speeds
    }

    /// Forces of the points, N.
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }
}

/// Definition of the end of a contact, for laws with a force that would pull before the gap closes.
///
/// Laws of the Hunt–Crossley family never pull, so their contacts end when the gap closes with both choices.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
pub enum Separation {
    /// Zero force, with the spring still compressed: contacts without adhesion, and simulators with the force max(0,
    /// F).
    #[default]
    ForceVanishes,
    /// Free length of the spring; the damper pulls shortly before. The half-period formula of textbooks.
    GapCloses,
}

impl Separation {
    /// Both choices, the default first.
    pub const ALL: [Self; 2] = [Self::ForceVanishes, Self::GapCloses];

    /// Name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::ForceVanishes => "force",
            Self::GapCloses => "gap",
        }
    }

    /// Returns the choice with a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|separation| separation.name() == name)
    }
}
