//! Models built from links, joints and closures, without a file.

use crate::boundary::arrays::{enumeration_value, input_slice, input_text};
use crate::boundary::handle::{
    Exclusive, Handle, argument_mut, argument_ref, clear_handle, free_handle, lock_object, object_of,
    write_handle,
};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_LOAD, guard_call, percuss_status,
};
use crate::setup::model::{DiagnosticTexts, Model, PERCUSS_REVOLUTE, percuss_joint_kind, percuss_model};
use percuss::nalgebra::Matrix3;
use percuss::spatial::Transform;
use percuss::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, Limits, LinkDescription,
    MechanismBuilder, MimicDescription,
};
use std::ffi::c_char;
use std::ptr::null;
use std::sync::Arc;

/// Links, joints and closures of a model that is being built. One thread at a time.
pub struct percuss_builder {
    _opaque: [u8; 0],
}

impl Handle for percuss_builder {
    type Object = Exclusive<MechanismBuilder>;
    const TAG: u64 = 0x7063_5f62_7569_6c64;
    const NAME: &'static str = "percuss_builder";
}

/// Kind of a closure: the relative motion that it leaves.
pub type percuss_closure_kind = i32;
/// The frames coincide.
pub const PERCUSS_CLOSURE_FIXED: percuss_closure_kind = 0;
/// A hinge about the axis.
pub const PERCUSS_CLOSURE_REVOLUTE: percuss_closure_kind = 1;
/// A slide along the axis.
pub const PERCUSS_CLOSURE_PRISMATIC: percuss_closure_kind = 2;
/// Translation along the axis and rotation about it.
pub const PERCUSS_CLOSURE_CYLINDRICAL: percuss_closure_kind = 3;
/// Rotations about two pins: axis in the predecessor's loop frame, axis2 in the successor's.
pub const PERCUSS_CLOSURE_UNIVERSAL: percuss_closure_kind = 4;
/// Translations in the plane normal to the axis, rotation about the axis.
pub const PERCUSS_CLOSURE_PLANAR: percuss_closure_kind = 5;
/// A ball joint.
pub const PERCUSS_CLOSURE_SPHERICAL: percuss_closure_kind = 6;
/// A massless rod with balls at its ends.
pub const PERCUSS_CLOSURE_DISTANCE: percuss_closure_kind = 7;

/// Description of a joint. Initialise it with percuss_joint_description_init. Texts are UTF-8, end with a zero byte and are read during
/// percuss_builder_joint only.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct percuss_joint_description {
    /// Unique name.
    pub name: *const c_char,
    /// Name of the parent link.
    pub parent: *const c_char,
    /// Name of the child link.
    pub child: *const c_char,
    /// A percuss_joint_kind.
    pub kind: percuss_joint_kind,
    /// Number of armature values that are read: 0, 1 (the same for all velocities), or one per velocity, at most 6.
    pub armature_count: i32,
    /// Origin of the joint frame in the parent link, m.
    pub position: [f64; 3],
    /// Orientation of the joint frame in the parent link: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
    /// Axis in the joint frame, of any length.
    pub axis: [f64; 3],
    /// Smallest position, rad or m; lower and upper are NaN without limits.
    pub lower: f64,
    /// Largest position, rad or m.
    pub upper: f64,
    /// Rotor inertias reflected to the joint, kg·m² or kg.
    pub armature: [f64; 6],
    /// Name of the joint that this joint follows, or null: q = multiplier · q of that joint + offset.
    pub mimics: *const c_char,
    /// See mimics.
    pub multiplier: f64,
    /// See mimics.
    pub offset: f64,
}

/// Description of a closure: a joint that closes a loop. Initialise it with percuss_closure_description_init. Texts as in
/// percuss_joint_description.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct percuss_closure_description {
    /// Unique name.
    pub name: *const c_char,
    /// Name of the predecessor link; "world" is the ground, unless a link has this name.
    pub predecessor: *const c_char,
    /// Name of the successor link.
    pub successor: *const c_char,
    /// A percuss_closure_kind.
    pub kind: percuss_closure_kind,
    /// 0.
    pub reserved: i32,
    /// Origin of the loop frame in the predecessor, m.
    pub predecessor_position: [f64; 3],
    /// Orientation of the loop frame in the predecessor: unit quaternion w, x, y, z.
    pub predecessor_quaternion: [f64; 4],
    /// Origin of the loop frame in the successor, m.
    pub successor_position: [f64; 3],
    /// Orientation of the loop frame in the successor: unit quaternion w, x, y, z.
    pub successor_quaternion: [f64; 4],
    /// Axis, with the same components in both loop frames.
    pub axis: [f64; 3],
    /// Second axis of a universal closure, in the successor's loop frame.
    pub axis2: [f64; 3],
    /// Length of a distance closure, m; NaN: the distance with all joints at 0.
    pub distance: f64,
}

/// A hinge at the parent's origin about the x-axis, without name, links, limits and armature.
///
/// # Safety
/// description is null or points to storage for a percuss_joint_description.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_joint_description_init(
    description: *mut percuss_joint_description,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(description, "description")? = percuss_joint_description {
            name: null(),
            parent: null(),
            child: null(),
            kind: PERCUSS_REVOLUTE,
            armature_count: 0,
            position: [0.0; 3],
            quaternion: [1.0, 0.0, 0.0, 0.0],
            axis: [1.0, 0.0, 0.0],
            lower: f64::NAN,
            upper: f64::NAN,
            armature: [0.0; 6],
            mimics: null(),
            multiplier: 1.0,
            offset: 0.0,
        };
        Ok(())
    })
}

/// A hinge about the x-axis between the origins of two links, without names.
///
/// # Safety
/// description is null or points to storage for a percuss_closure_description.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_closure_description_init(
    description: *mut percuss_closure_description,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(description, "description")? = percuss_closure_description {
            name: null(),
            predecessor: null(),
            successor: null(),
            kind: PERCUSS_CLOSURE_REVOLUTE,
            reserved: 0,
            predecessor_position: [0.0; 3],
            predecessor_quaternion: [1.0, 0.0, 0.0, 0.0],
            successor_position: [0.0; 3],
            successor_quaternion: [1.0, 0.0, 0.0, 0.0],
            axis: [1.0, 0.0, 0.0],
            axis2: [0.0, 1.0, 0.0],
            distance: f64::NAN,
        };
        Ok(())
    })
}

/// A model without links. Free it with percuss_builder_free.
///
/// # Safety
/// name ends with a zero byte; builder is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_builder_new(
    name: *const c_char,
    builder: *mut *mut percuss_builder,
) -> percuss_status {
    guard_call(|| {
        clear_handle(builder)?;
        write_handle(Exclusive::new(MechanismBuilder::new(input_text(name, "name")?)), builder)
    })
}

/// Frees a builder and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// builder is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_builder_free(builder: *mut *mut percuss_builder) -> percuss_status {
    guard_call(|| free_handle(builder))
}

/// Replaces the description of a builder by the result of `change`.
fn extend(
    builder: *mut percuss_builder,
    change: impl FnOnce(MechanismBuilder) -> Result<MechanismBuilder, Failure>,
) -> Result<(), Failure> {
    let mut guard = lock_object(object_of(builder)?, "percuss_builder")?;
    *guard = change(guard.clone())?;
    Ok(())
}

/// Three numbers of the caller.
fn triple(values: *const f64, name: &str) -> Result<[f64; 3], Failure> {
    let mut found = [0.0; 3];
    found.copy_from_slice(input_slice(values, 3, name)?);
    Ok(found)
}

/// Adds a link. mass: kg; com: its centre of mass in the link's frame, 3 numbers, m; inertia: about the centre of mass in the link's axes,
/// xx, xy, xz, yy, yz, zz, kg·m². If com is null, the centre of mass is at the origin; if inertia is null, all moments are 0. A link with
/// mass 0 and null inertia is massless.
///
/// # Safety
/// builder is a handle; name ends with a zero byte; com is null or has 3 numbers, inertia is null or has 6.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_builder_link(
    builder: *mut percuss_builder,
    name: *const c_char,
    mass: f64,
    com: *const f64,
    inertia: *const f64,
) -> percuss_status {
    guard_call(|| {
        let name = input_text(name, "name")?;
        let com = if com.is_null() { [0.0; 3] } else { triple(com, "com")? };
        let mut moments = [0.0; 6];
        if !inertia.is_null() {
            moments.copy_from_slice(input_slice(inertia, 6, "inertia")?);
        }
        let [xx, xy, xz, yy, yz, zz] = moments;
        let link = match mass == 0.0 && inertia.is_null() {
            true => LinkDescription::massless(name),
            false => {
                let about_com = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
                LinkDescription::new(name, Inertial { mass, com: com.into(), about_com })
            }
        };
        extend(builder, |found| Ok(found.link(link)))
    })
}

/// Frame in a link.
fn frame(position: [f64; 3], quaternion: [f64; 4], name: &str) -> Result<Transform<f64>, Failure> {
    let named = |error| Failure::new(PERCUSS_ERROR_ARGUMENT, format_args!("{name}: {error}"));
    percuss::input::base_pose(position, quaternion).map_err(named)
}

/// Adds a joint between two links. The links may be added later.
///
/// Errors: PERCUSS_ERROR_ARGUMENT: an unknown kind, a quaternion that is not of unit length, one limit without the other, an armature_count
/// outside 0 to 6.
///
/// # Safety
/// builder is a handle; description is null or points to a description.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_builder_joint(
    builder: *mut percuss_builder,
    description: *const percuss_joint_description,
) -> percuss_status {
    guard_call(|| {
        let given = argument_ref(description, "description")?;
        let name = input_text(given.name, "name")?;
        let kind = enumeration_value(&JointKind::ALL, given.kind, "kind")?;
        let (parent, child) = (input_text(given.parent, "parent")?, input_text(given.child, "child")?);
        let mut joint = JointDescription::new(name, kind, parent, child);
        joint.origin = frame(given.position, given.quaternion, &format!("joint \"{name}\""))?;
        joint.axis = given.axis.into();
        joint.limits = match (given.lower.is_nan(), given.upper.is_nan()) {
            (true, true) => None,
            (false, false) => Some(Limits { lower: given.lower, upper: given.upper }),
            _ => {
                let message =
                    format_args!("joint \"{name}\" has one limit; expected lower and upper, or NaN for both");
                return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
            }
        };
        let count = usize::try_from(given.armature_count).ok().and_then(|count| given.armature.get(..count));
        joint.armature = count
            .ok_or_else(|| {
                let message = format_args!("armature_count is {}; expected 0 to 6", given.armature_count);
                Failure::new(PERCUSS_ERROR_ARGUMENT, message)
            })?
            .to_vec();
        if !given.mimics.is_null() {
            let master = input_text(given.mimics, "mimics")?.to_owned();
            let (multiplier, offset) = (given.multiplier, given.offset);
            joint.mimic = Some(MimicDescription { joint: master, multiplier, offset });
        }
        extend(builder, |found| Ok(found.joint(joint)))
    })
}

/// Adds a closure between two links.
///
/// Errors: PERCUSS_ERROR_ARGUMENT: an unknown kind, a quaternion that is not of unit length.
///
/// # Safety
/// builder is a handle; description is null or points to a description.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_builder_closure(
    builder: *mut percuss_builder,
    description: *const percuss_closure_description,
) -> percuss_status {
    guard_call(|| {
        let given = argument_ref(description, "description")?;
        let name = input_text(given.name, "name")?;
        let kind = enumeration_value(&ClosureKind::ALL, given.kind, "kind")?;
        let predecessor = input_text(given.predecessor, "predecessor")?;
        let mut closure =
            ClosureDescription::new(name, kind, predecessor, input_text(given.successor, "successor")?);
        let place = format!("closure \"{name}\"");
        closure.predecessor_frame = frame(given.predecessor_position, given.predecessor_quaternion, &place)?;
        closure.successor_frame = frame(given.successor_position, given.successor_quaternion, &place)?;
        (closure.axis, closure.axis2) = (given.axis.into(), given.axis2.into());
        closure.distance = Some(given.distance).filter(|distance| !distance.is_nan());
        extend(builder, |found| Ok(found.closure(closure)))
    })
}

/// The model of a builder, which stays usable. Free it with percuss_model_free.
///
/// Errors: PERCUSS_ERROR_LOAD; the message has every error of the description.
///
/// # Safety
/// builder is a handle; model is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_builder_model(
    builder: *mut percuss_builder,
    model: *mut *mut percuss_model,
) -> percuss_status {
    guard_call(|| {
        clear_handle(model)?;
        let described = lock_object(object_of(builder)?, "percuss_builder")?.clone();
        let built = described.build().map_err(Failure::with_status(PERCUSS_ERROR_LOAD))?;
        let findings = built.findings.iter();
        let findings = findings.map(|(subject, problem)| DiagnosticTexts::from_problem(subject, problem));
        let findings = findings.collect();
        write_handle(Arc::new(Model::new(Arc::new(built.mechanism), &[], None, findings)), model)
    })
}
