//! Laws that approximate the damping for the required restitution, one per file.

pub(super) mod carvalho_martins;
pub(super) mod exudyn_mixed;
pub(super) mod flores;
pub(super) mod gharib_hurmuzlu;
pub(super) mod gonthier;
pub(super) mod herbert_mcwhannell;
pub(super) mod hu_guo;
pub(super) mod hunt_crossley_1975;
pub(super) mod lankarani_nikravesh;
pub(super) mod lee_wang;
pub(super) mod safaeifar_farshidianfar;
pub(super) mod zhiying_qishao;
