//! Mechanisms with closed loops, and their motion.
//!
//! Planar linkages lie in the x-y plane of [`plane`], which is parallel to no coordinate plane, so that no
//! component is zero by chance. Their closures are spatial: three of the five rows of a revolute closure are
//! redundant.

mod branching;
mod driven;
mod every_closure;
mod extremes;
pub mod family;
mod large;
mod planar;
mod rounded;
mod spatial;
mod suspension;
mod trains;

pub use branching::{BRANCHING_KINDS, Branching, branching, nearly_parallel_four_bar, position_distance};
pub use driven::Linkage;
pub use every_closure::{every_closure, foot_on_the_world};
pub use extremes::{CrankRow, contradicting};
pub use large::{ladder, separate};
pub use planar::{
    FOUR_BAR, FOUR_BAR_BODIES, PARALLELOGRAM, SLIDER_CRANK, SLIDER_CRANK_BODIES, antiparallelogram, four_bar,
    four_bar_of, massless_arm_suspension, parallelogram, planar_leg, plane, six_bar, slider_crank,
    slider_crank_of,
};
pub use rounded::rounded_four_bar;
pub use spatial::{TRAMMEL, hooke_shaft, trammel, trammel_with_rod};
pub use suspension::{Arm, Corner, GENERIC_CORNER, double_wishbone, double_wishbone_of, two_point_wishbone};
pub use trains::{cam_and_sum, geared_pair, planetary_gear, rack_and_pinion, rocker_bogie};

/// All linkages. They contain all kinds of closure, with and without redundancy, couplings, several loops in
/// one group, several groups, closures to an ancestor and to the world, and free massless rotations.
pub fn all() -> Vec<Linkage> {
    vec![
        four_bar(),
        slider_crank(),
        parallelogram(),
        antiparallelogram(),
        six_bar(),
        planar_leg(),
        massless_arm_suspension(),
        double_wishbone(),
        two_point_wishbone(),
        hooke_shaft(0.6),
        trammel(),
        trammel_with_rod(),
        rack_and_pinion(),
        geared_pair(),
        planetary_gear(),
        rocker_bogie(),
        every_closure(),
        foot_on_the_world(),
        ladder(4),
        separate(3),
        cam_and_sum(),
    ]
}
