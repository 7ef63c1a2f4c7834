//! Drawing of a planar linkage: bodies, pins, and the velocities of the bodies.

use faer::Mat;
use nalgebra::Vector2;

/// Index of the ground body.
const GROUND: usize = 0;

/// Joint between two bodies of a drawing.
#[derive(Clone, Debug)]
pub(super) struct Pin {
    pub name: &'static str,
    pub bodies: [usize; 2],
    pub at: Vector2<f64>,
    /// Direction of a slider; `None` for a hinge.
    pub slide: Option<Vector2<f64>>,
}

/// Planar motion of a body per unit rate of the input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub rate: f64,
    /// A point of the plane and its velocity.
    pub at: Vector2<f64>,
    pub velocity: Vector2<f64>,
}

impl Motion {
    pub const AT_REST: Motion =
        Motion { rate: 0.0, at: Vector2::new(0.0, 0.0), velocity: Vector2::new(0.0, 0.0) };

    /// Rotation about a fixed point.
    pub fn about(at: Vector2<f64>, rate: f64) -> Self {
        Motion { rate, at, velocity: Vector2::zeros() }
    }

    /// Velocity of the body point at a point of the plane, per unit rate of the input.
    pub fn velocity_of(&self, point: Vector2<f64>) -> Vector2<f64> {
        self.velocity + self.rate * across(point - self.at)
    }
}

/// Vector rotated by 90°.
pub(super) fn across(v: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v.y, v.x)
}

/// Motion of two bars pinned together at `pin`, with their other ends at `a` and `b` on two moving bodies.
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

/// Planar linkage with one degree of freedom in its drawn position.
#[derive(Clone, Debug)]
pub(super) struct Drawing {
    /// Names of the bodies; the ground is first.
    pub bodies: Vec<&'static str>,
    /// Sliders first; after [`select_spanning_tree`](Self::cut), pins of the tree before pins that close loops.
    pub pins: Vec<Pin>,
    /// Motion of each body.
    pub motions: Vec<Motion>,
    /// Body that can carry a tool.
    pub coupler: usize,
}

impl Drawing {
    /// Selects a spanning tree, preferring the pins that come first, and returns its number of pins; the other
    /// pins close loops. Tree pins are reordered parents first, and each is directed away from the ground.
    pub fn select_spanning_tree(&mut self) -> usize {
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

    /// Largest distance between pins on one body, without the ground.
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

    /// Smallest distance between two pins on one body, including the ground, without sliders.
    pub fn shortest_bar(&self) -> f64 {
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

    /// Singular values, in descending order, of the planar loop rows over the first `tree` pins; angles times `size`.
    pub fn singular_values(&self, tree: usize, size: f64) -> Vec<f64> {
        // Path of pins from a body to the ground.
        let path_to_ground = |body: usize| {
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
                for pin in path_to_ground(body) {
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
