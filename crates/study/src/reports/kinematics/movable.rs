//! Copy of a suspension in which every part can drive the motion.

use crate::checks::design_variant::DesignError;
use crate::model::loading::{Model, SheetKinematics};
use crate::model::wheel_points::sliding_rack;

/// Copy of a suspension with joints in place of massless rods.
pub(crate) struct MovableModel {
    pub model: Model,
    /// Parts and forces that the sheet names.
    pub origin: SheetKinematics,
    /// True if the rack of the original model slides.
    pub rack_slides: bool,
}

impl MovableModel {
    /// Builds the copy from the sheet of a model, with all changes of the model; `None` for a model without a sheet.
    /// `steers`: the rack moves.
    pub fn new(model: &Model, steers: bool) -> Result<Option<Self>, DesignError> {
        let Some(origin) = model.origin.sheet.as_deref() else { return Ok(None) };
        let rack_slides = sliding_rack(&model.mechanism).is_some();
        let sheet = origin.sheet.as_movable(steers && !rack_slides);
        let built = Model::from_sheet(&sheet, &[], model.inputs.clone())?;
        let built = built.with_changes(&model.origin.changes)?;
        Ok(Some(Self { model: built, origin: origin.kinematics.clone(), rack_slides }))
    }
}
