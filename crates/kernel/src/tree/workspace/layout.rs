//! Layout of the workspace of a tree. The slot of an inertia is used again after the body's elimination, so that the workspace of a tree
//! remains in the fastest cache. Light bodies keep their slots.

use percuss_spatial::lanes::Lanes;

/// Indices of the sizes of the moment and the force of the stored wrench, whose six numbers are before them.
pub(super) const STORED_MOMENT: usize = 6;
pub(super) const STORED_FORCE: usize = 7;
/// Numbers before those of the steps: at least those of an inertia, because bodies without one have the offset 0.
const FIRST_NUMBERS: usize = INERTIA;

/// Index of the sine, or of the travel, and of the cosine among the numbers of a joint.
pub(in super::super) const SINE: usize = 0;
pub(in super::super) const COSINE: usize = 1;
/// Count of the numbers of a joint.
const JOINT: usize = 2;

/// Index of the sizes of terms among the numbers of an inertia.
pub(in super::super) const SIZES: usize = 21;
/// Count of the numbers of an inertia with its sizes.
const INERTIA: usize = SIZES + 2;

/// Index of the twist among the numbers of a light body; the rates t/D of the velocities are before it.
pub(in super::super) const TWIST: usize = 6;
/// Index of the sizes of the force on it.
pub(super) const LIGHT_SIZES: usize = TWIST + 6;
/// Count of the numbers of a light body.
const LIGHT: usize = LIGHT_SIZES + 2;

/// Offsets of the numbers of a step in the workspace, per lane.
#[derive(Clone, Copy, Debug, Default)]
pub(in super::super) struct Offsets {
    /// Sine and cosine of the joint angle, or the travel, m.
    pub joint: usize,
    /// Inertia of the body and its children.
    pub inertia: usize,
    /// Inertia of the parent and its children.
    pub parent_inertia: usize,
    /// Rates and twist, for light bodies and the bodies between these and the root.
    pub light: Option<usize>,
}

/// What a step needs in the workspace.
pub(in super::super) struct Places {
    /// Parent to which the step adds an inertia.
    pub parent: Option<usize>,
    /// True for a light body.
    pub is_light: bool,
}

/// Offsets of all steps by their numbers, and the total number of values per lane.
pub(in super::super) fn layout(steps: &[Places]) -> (Vec<Offsets>, usize) {
    let mut offsets = vec![Offsets::default(); steps.len()];
    let mut end = FIRST_NUMBERS;
    let mut take = |numbers: usize| {
        end += numbers;
        end - numbers
    };
    for own in &mut offsets {
        own.joint = take(JOINT);
    }
    let mut slots: Vec<Option<usize>> = vec![None; steps.len()];
    let mut needs_twist = vec![false; steps.len()];
    let mut free = Vec::new();
    for (i, step) in steps.iter().enumerate().rev() {
        needs_twist[i] |= step.is_light;
        if needs_twist[i] {
            offsets[i].light = Some(take(LIGHT));
        }
        if let Some(parent) = step.parent {
            needs_twist[parent] |= needs_twist[i];
            let slot = *slots[parent].get_or_insert_with(|| free.pop().unwrap_or_else(|| take(INERTIA)));
            offsets[i].parent_inertia = slot;
        }
        if let Some(slot) = slots[i] {
            offsets[i].inertia = slot;
            // The twists of light bodies are computed after the recursion, from their inertias.
            if !needs_twist[i] {
                free.push(slot);
            }
        }
    }
    (offsets, end)
}

/// Values of `numbers` numbers from an offset on.
#[cfg_attr(not(debug_assertions), inline(always))]
fn part<T: Lanes>(scratch: &[f64], offset: usize, numbers: usize) -> &[f64] {
    &scratch[offset * T::WIDTH..][..numbers * T::WIDTH]
}

/// Mutable values.
#[cfg_attr(not(debug_assertions), inline(always))]
fn part_mut<T: Lanes>(scratch: &mut [f64], offset: usize, numbers: usize) -> &mut [f64] {
    &mut scratch[offset * T::WIDTH..][..numbers * T::WIDTH]
}

impl Offsets {
    /// Sine and cosine of the joint angle; in place of the sine the travel of a slide.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn joint<'a, T: Lanes>(&self, scratch: &'a [f64]) -> &'a [f64] {
        part::<T>(scratch, self.joint, JOINT)
    }

    /// Mutable values.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn joint_mut<'a, T: Lanes>(&self, scratch: &'a mut [f64]) -> &'a mut [f64] {
        part_mut::<T>(scratch, self.joint, JOINT)
    }

    /// Inertia of the body, with its sizes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn inertia<'a, T: Lanes>(&self, scratch: &'a [f64]) -> &'a [f64] {
        part::<T>(scratch, self.inertia, INERTIA)
    }

    /// Inertia of the parent, with its sizes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn parent_inertia<'a, T: Lanes>(&self, scratch: &'a mut [f64]) -> &'a mut [f64] {
        part_mut::<T>(scratch, self.parent_inertia, INERTIA)
    }

    /// Stores t/D of the velocity along a component of the twist, for light bodies.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn store_rate<T: Lanes>(&self, rate: T, component: usize, scratch: &mut [f64]) {
        if let Some(light) = self.light {
            rate.store(&mut scratch[(light + component) * T::WIDTH..]);
        }
    }
}

/// Number at an index.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in super::super) fn number<T: Lanes>(numbers: &[f64], index: usize) -> T {
    T::load(&numbers[index * T::WIDTH..])
}
