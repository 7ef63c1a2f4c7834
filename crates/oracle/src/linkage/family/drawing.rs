//! A planar linkage as it is drawn: pins in the plane between bodies, and how the bodies move.

use faer::Mat;
use nalgebra::Vector2;

/// The body that every drawing has first.
const GROUND: usize = 0;

/// Where two bodies hold one another.
#[derive(Clone, Debug)]
pub(super) struct Pin {
    pub name: &'static str,
    pub bodies: [usize; 2],
    pub at: Vector2<f64>,
    /// The direction of a slide; none: a hinge.
    pub slide: Option<Vector2<f64>>,
}

/// How a body moves in the plane, per unit rate of the input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub rate: f64,
    /// A point of the plane and its velocity.
    pub at: Vector2<f64>,
    pub velocity: Vector2<f64>,
}

impl Motion {
    pub const STILL: Motion =
        Motion { rate: 0.0, at: Vector2::new(0.0, 0.0), velocity: Vector2::new(0.0, 0.0) };

    /// A turn about a fixed point.
    pub fn about(at: Vector2<f64>, rate: f64) -> Self {
        Motion { rate, at, velocity: Vector2::zeros() }
    }

    pub fn velocity_of(&self, point: Vector2<f64>) -> Vector2<f64> {
        self.velocity + self.rate * across(point - self.at)
    }
}

/// Turned by 90°.
pub(super) fn across(v: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v.y, v.x)
}

/// Two bars pinned together at `pin`, the other ends at `a` and `b` led by two bodies: how the bars move.
///
/// v_a + ω k×(c − a) = v_b + ψ k×(c − b): two equations for ω and ψ.
pub(super) fn dyad(
    (a, of_a): (Vector2<f64>, Motion),
    (b, of_b): (Vector2<f64>, Motion),
    pin: Vector2<f64>,
) -> [Motion; 2] {
    let (va, vb) = (of_a.velocity_of(a), of_b.velocity_of(b));
    let (ra, rb) = (across(pin - a), across(pin - b));
    let det = ra.y * rb.x - ra.x * rb.y;
    let gap = vb - va;
    // ω ra − ψ rb = gap
    let omega = (rb.x * gap.y - rb.y * gap.x) / det;
    let psi = (ra.x * gap.y - ra.y * gap.x) / det;
    [Motion { rate: omega, at: a, velocity: va }, Motion { rate: psi, at: b, velocity: vb }]
}

/// A planar linkage with one freedom, as drawn.
#[derive(Clone, Debug)]
pub(super) struct Drawing {
    /// Names of the bodies; the ground first.
    pub bodies: Vec<&'static str>,
    /// Slides first; those of the tree before those that close loops, once it is [`cut`](Self::cut).
    pub pins: Vec<Pin>,
    /// How each body moves.
    pub motions: Vec<Motion>,
    /// Which body may bear a tool.
    pub coupler: usize,
}

impl Drawing {
    /// Makes a tree of the pins that come first, the others close loops: how many are in the tree. The pins of the
    /// tree then go from a body nearer to the ground to one further, parents first.
    pub fn cut(&mut self) -> usize {
        let mut kept = Vec::new();
        let mut rest = Vec::new();
        let mut part: Vec<usize> = (0..self.bodies.len()).collect();
        for pin in std::mem::take(&mut self.pins) {
            let [a, b] = pin.bodies.map(|body| part[body]);
            if a == b {
                rest.push(pin);
            } else {
                part.iter_mut().filter(|p| **p == b).for_each(|p| *p = a);
                kept.push(pin);
            }
        }
        let mut reached = vec![GROUND];
        let mut ordered: Vec<Pin> = Vec::new();
        while let Some(next) =
            kept.iter().position(|pin| pin.bodies.iter().filter(|b| reached.contains(b)).count() == 1)
        {
            let mut pin = kept.remove(next);
            if !reached.contains(&pin.bodies[0]) {
                pin.bodies.swap(0, 1);
            }
            reached.push(pin.bodies[1]);
            ordered.push(pin);
        }
        let count = ordered.len();
        self.pins = ordered;
        self.pins.extend(rest);
        count
    }

    /// The greatest distance between pins on the same body, the ground aside.
    pub fn size(&self) -> f64 {
        let mut most: f64 = 0.0;
        for body in 1..self.bodies.len() {
            let own: Vec<_> = self.pins.iter().filter(|pin| pin.bodies.contains(&body)).collect();
            for a in &own {
                most = own.iter().map(|b| (a.at - b.at).norm()).fold(most, f64::max);
            }
        }
        most
    }

    /// The least distance between two pins on the same body (on the ground: too), slides aside.
    pub fn least_bar(&self) -> f64 {
        let mut least = f64::INFINITY;
        for body in 0..self.bodies.len() {
            let own = self.pins.iter().filter(|pin| pin.slide.is_none() && pin.bodies.contains(&body));
            let own: Vec<_> = own.collect();
            for (i, a) in own.iter().enumerate() {
                least = own[..i].iter().map(|b| (a.at - b.at).norm()).fold(least, f64::min);
            }
        }
        least
    }

    /// The singular values, falling, of the loops' rows in the plane over the first `tree` pins, angles times
    /// `size`.
    pub fn singular_values(&self, tree: usize, size: f64) -> Vec<f64> {
        // Pins from a body up to the ground.
        let up = |body: usize| {
            let mut path = Vec::new();
            let mut at = body;
            while let Some(pin) = (0..tree).find(|&pin| self.pins[pin].bodies[1] == at) {
                path.push(pin);
                at = self.pins[pin].bodies[0];
            }
            path
        };
        let closing = &self.pins[tree..];
        let mut rows: Mat<f64> = Mat::zeros(2 * closing.len(), tree);
        for (i, closure) in closing.iter().enumerate() {
            for (sign, body) in [(-1.0, closure.bodies[0]), (1.0, closure.bodies[1])] {
                for pin in up(body) {
                    let moves = &self.pins[pin];
                    let column = moves.slide.unwrap_or_else(|| across(closure.at - moves.at) / size);
                    rows[(2 * i, pin)] += sign * column.x;
                    rows[(2 * i + 1, pin)] += sign * column.y;
                }
            }
        }
        rows.singular_values().expect("finite rows")
    }
}
