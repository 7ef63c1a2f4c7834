//! Models: mechanisms read from files, the names of their links and joints, their named poses, and findings about the file.

use crate::boundary::arrays::{
    ByteRange, copy_to_caller, input_slice, input_text, output_slice, refuse_overlaps,
};
use crate::boundary::handle::{Handle, argument_mut, clear_handle, free_handle, object_of, write_handle};
use crate::boundary::names::{c_string, element_at};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_LOAD, PERCUSS_ERROR_NAME,
    PERCUSS_ERROR_TEXT, guard_call, percuss_status,
};
#[cfg(feature = "suspensions")]
use percuss::study::DiagnosticRecord;
use percuss::{
    DEFAULT_MAX_SIZE, Diagnostic, JointId, JointKind, LinkId, LoadOptions, Mechanism, NamedPose, Problem,
    QposError, QposLayout, Severity, Source, Subject, load,
};
use std::ffi::{CString, c_char};
use std::ptr::null;
use std::sync::Arc;

/// A mechanism. Immutable, so that threads can share it.
pub struct percuss_model {
    _opaque: [u8; 0],
}

/// A mechanism with its names.
pub(crate) struct Model {
    pub mechanism: Arc<Mechanism>,
    pub links: Vec<LinkId>,
    pub joints: Vec<JointId>,
    /// Offset of each joint's positions and velocities.
    pub first: Vec<(usize, usize)>,
    pub positions: usize,
    pub velocities: usize,
    link_names: Vec<CString>,
    joint_names: Vec<CString>,
    /// Named poses: name, and positions of all joints.
    poses: Vec<(CString, Vec<f64>)>,
    /// Positions of MuJoCo, for a model in MJCF.
    qpos: Option<QposLayout>,
    diagnostics: Vec<DiagnosticTexts>,
    /// The model of percuss_ask.
    #[cfg(feature = "suspensions")]
    pub study: percuss::study::Model,
}

pub(crate) struct DiagnosticTexts {
    severity: i32,
    code: CString,
    message: CString,
    path: CString,
    line: u32,
    column: u32,
}

impl Handle for percuss_model {
    type Object = Arc<Model>;
    const TAG: u64 = 0x7063_5f6d_6f64_656c;
    const NAME: &'static str = "percuss_model";
}

/// Kind of a joint.
pub type percuss_joint_kind = i32;
/// Holds its child: no positions, no velocities.
pub const PERCUSS_FIXED: percuss_joint_kind = 0;
/// A hinge within limits: 1 position, rad.
pub const PERCUSS_REVOLUTE: percuss_joint_kind = 1;
/// A hinge without limits: 1 position, rad.
pub const PERCUSS_CONTINUOUS: percuss_joint_kind = 2;
/// A slide: 1 position, m.
pub const PERCUSS_PRISMATIC: percuss_joint_kind = 3;
/// In a plane: 3 positions x, y (m), θ (rad); 3 velocities.
pub const PERCUSS_PLANAR: percuss_joint_kind = 4;
/// A ball: 4 positions, a unit quaternion w, x, y, z; 3 velocities (rad/s, child's axes).
pub const PERCUSS_SPHERICAL: percuss_joint_kind = 5;
/// Free: 7 positions x, y, z (m), w, x, y, z; 6 velocities, 3 angular then 3 linear (child's axes).
pub const PERCUSS_FLOATING: percuss_joint_kind = 6;

/// A joint.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct percuss_joint {
    /// Its name; valid as long as the model.
    pub name: *const c_char,
    /// A percuss_joint_kind.
    pub kind: percuss_joint_kind,
    /// 1 if the joint has limits.
    pub has_limits: i32,
    /// Least and greatest position (rad or m); NaN without limits.
    pub lower: f64,
    /// See lower.
    pub upper: f64,
    /// Number of positions of the joint, and index of its first position in the mechanism's position vector.
    pub positions: usize,
    /// See positions.
    pub first_position: usize,
    /// Number of velocities of the joint, and index of its first velocity in the mechanism's velocity vector.
    pub velocities: usize,
    /// See velocities.
    pub first_velocity: usize,
    /// Numbers of the parent link and the child link.
    pub parent: usize,
    /// See parent.
    pub child: usize,
}

/// Largest number of named poses in a message.
const LISTED_POSES: usize = 10;

/// Information; nothing is wrong.
pub const PERCUSS_NOTE: i32 = 0;
/// Probable mistake; the message states the value in use.
pub const PERCUSS_WARNING: i32 = 1;

/// Finding about a file or a pose.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct percuss_diagnostic {
    /// PERCUSS_NOTE or PERCUSS_WARNING; errors make the load fail.
    pub severity: i32,
    /// Line, from 1; 0 if unknown.
    pub line: u32,
    /// Column in characters, from 1; 0 if unknown.
    pub column: u32,
    /// Stable short name, for programs. The texts are valid as long as the model or the pose.
    pub code: *const c_char,
    /// The finding.
    pub message: *const c_char,
    /// The file.
    pub path: *const c_char,
}

/// PERCUSS_NOTE or PERCUSS_WARNING.
fn severity_number(severity: Severity) -> i32 {
    match severity {
        Severity::Note => PERCUSS_NOTE,
        Severity::Warning | Severity::Error => PERCUSS_WARNING,
    }
}

impl DiagnosticTexts {
    /// Diagnostic whose texts are valid as long as these.
    pub fn for_c(&self) -> percuss_diagnostic {
        percuss_diagnostic {
            severity: self.severity,
            line: self.line,
            column: self.column,
            code: self.code.as_ptr(),
            message: self.message.as_ptr(),
            path: self.path.as_ptr(),
        }
    }

    /// Diagnostic for C; unknown positions are 0.
    fn from_diagnostic(diagnostic: &Diagnostic) -> Self {
        Self {
            severity: severity_number(diagnostic.severity),
            code: c_string(diagnostic.code),
            message: c_string(&diagnostic.message),
            path: c_string(&diagnostic.path),
            line: diagnostic.line.unwrap_or(0),
            column: diagnostic.column.unwrap_or(0),
        }
    }

    /// Finding of the builder for C, without path, line and column.
    pub fn from_problem(subject: &Subject, problem: &Problem) -> Self {
        Self {
            severity: severity_number(problem.severity()),
            code: c_string(problem.code()),
            message: c_string(&format!("{subject}: {problem}")),
            path: c_string(""),
            line: 0,
            column: 0,
        }
    }

    /// Diagnostic of a suspension for C; unknown positions are 0.
    #[cfg(feature = "suspensions")]
    pub fn from_record(record: &DiagnosticRecord) -> Self {
        Self {
            severity: severity_number(record.severity),
            code: c_string(record.code),
            message: c_string(&record.message),
            path: c_string(record.path.as_deref().unwrap_or_default()),
            line: record.line.unwrap_or(0),
            column: record.column.unwrap_or(0),
        }
    }
}

impl Model {
    /// Reads a model file and prepares its names and texts for C.
    fn load(source: &Source) -> Result<Arc<Self>, Failure> {
        let loaded =
            load(source, &LoadOptions::default()).map_err(Failure::with_status(PERCUSS_ERROR_LOAD))?;
        let diagnostics = loaded.diagnostics.iter().map(DiagnosticTexts::from_diagnostic).collect();
        #[cfg(feature = "suspensions")]
        {
            let qpos = loaded.qpos.clone();
            let study = percuss::study::Model::from_loaded(loaded, source);
            Ok(Self::of_study(study, qpos, diagnostics))
        }
        #[cfg(not(feature = "suspensions"))]
        Ok(Arc::new(Self::new(Arc::new(loaded.mechanism), &loaded.poses, loaded.qpos, diagnostics)))
    }

    /// A model of percuss_ask with its names for C.
    #[cfg(feature = "suspensions")]
    pub fn of_study(
        study: percuss::study::Model,
        qpos: Option<QposLayout>,
        diagnostics: Vec<DiagnosticTexts>,
    ) -> Arc<Self> {
        let model = Self::new(Arc::clone(&study.mechanism), &study.poses, qpos, diagnostics);
        Arc::new(Self { study, ..model })
    }

    /// A mechanism with its names for C.
    pub fn new(
        mechanism: Arc<Mechanism>,
        poses: &[NamedPose],
        qpos: Option<QposLayout>,
        diagnostics: Vec<DiagnosticTexts>,
    ) -> Self {
        let (mut first, mut at) = (Vec::new(), (0, 0));
        for joint in mechanism.joints() {
            first.push(at);
            at = (at.0 + joint.kind().positions(), at.1 + joint.kind().dofs());
        }
        Self {
            #[cfg(feature = "suspensions")]
            study: percuss::study::Model::from_mechanism(Arc::clone(&mechanism)),
            links: mechanism.link_ids().collect(),
            joints: mechanism.joint_ids().collect(),
            first,
            positions: at.0,
            velocities: at.1,
            link_names: mechanism.links().iter().map(|link| c_string(link.name())).collect(),
            joint_names: mechanism.joints().iter().map(|joint| c_string(joint.name())).collect(),
            poses: poses.iter().map(|pose| (c_string(&pose.name), pose.all_positions(&mechanism))).collect(),
            qpos,
            diagnostics,
            mechanism,
        }
    }

    /// Id of link number `index`, from 0.
    pub fn link_id(&self, index: usize) -> Result<LinkId, Failure> {
        element_at(&self.links, index, "link").copied()
    }
}

/// Reads a file of a model: URDF (closed loops and couplings included), MJCF or SDFormat, recognised by its content. path: UTF-8. Free
/// the model with percuss_model_free.
///
/// Errors: PERCUSS_ERROR_LOAD, with every error of the file in the message.
///
/// # Safety
/// path ends with a zero byte; model is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_load_file(
    path: *const c_char,
    model: *mut *mut percuss_model,
) -> percuss_status {
    guard_call(|| {
        clear_handle(model)?;
        let path = input_text(path, "path")?;
        if path == "-" {
            return Err(Failure::new(PERCUSS_ERROR_LOAD, "path is \"-\"; expected the name of a file"));
        }
        let source =
            Source::read(path, DEFAULT_MAX_SIZE).map_err(Failure::with_status(PERCUSS_ERROR_LOAD))?;
        write_handle(Model::load(&source)?, model)
    })
}

/// Reads a model from memory, as percuss_model_load_file: length bytes of UTF-8 without a terminating zero byte. name replaces the file name in
/// messages.
///
/// Errors: as percuss_model_load_file; PERCUSS_ERROR_TEXT.
///
/// # Safety
/// name ends with a zero byte; bytes has length bytes; model is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_load_memory(
    name: *const c_char,
    bytes: *const c_char,
    length: usize,
    model: *mut *mut percuss_model,
) -> percuss_status {
    guard_call(|| {
        clear_handle(model)?;
        let name = input_text(name, "name")?;
        let urdf = input_document(name, bytes, length)?;
        write_handle(Model::load(&Source::from_text(name, urdf))?, model)
    })
}

/// UTF-8 text of a document in the caller's memory, at most as large as a file.
pub(crate) fn input_document<'a>(
    name: &str,
    bytes: *const c_char,
    length: usize,
) -> Result<&'a str, Failure> {
    let bytes: &[u8] = input_slice(bytes.cast(), length, "bytes")?;
    if bytes.len() as u64 > DEFAULT_MAX_SIZE {
        let message = format_args!("{name}: {length} bytes; at most {DEFAULT_MAX_SIZE} are read");
        return Err(Failure::new(PERCUSS_ERROR_LOAD, message));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        Failure::new(PERCUSS_ERROR_TEXT, format_args!("{name}: not UTF-8 at byte {}", error.valid_up_to()))
    })
}

/// Frees a model and sets the handle to null; a null handle is ignored. Objects made from the model stay valid.
///
/// # Safety
/// model is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_free(model: *mut *mut percuss_model) -> percuss_status {
    guard_call(|| free_handle(model))
}

/// Numbers of links, joints, positions of all joints, and velocities of all joints. Each pointer may be null.
///
/// # Safety
/// Every pointer is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_counts(
    model: *const percuss_model,
    links: *mut usize,
    joints: *mut usize,
    positions: *mut usize,
    velocities: *mut usize,
) -> percuss_status {
    guard_call(|| {
        let model = object_of(model)?;
        let counts = [model.links.len(), model.joints.len(), model.positions, model.velocities];
        for (to, count) in [links, joints, positions, velocities].into_iter().zip(counts) {
            if !to.is_null() {
                *argument_mut(to, "a count")? = count;
            }
        }
        Ok(())
    })
}

/// The name of link number index, from 0. Valid as long as the model; null if the call fails.
///
/// # Safety
/// name is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_link_name(
    model: *const percuss_model,
    index: usize,
    name: *mut *const c_char,
) -> percuss_status {
    guard_call(|| {
        let name = argument_mut(name, "name")?;
        *name = null();
        *name = element_at(&object_of(model)?.link_names, index, "link")?.as_ptr();
        Ok(())
    })
}

/// The number of the link of this name. Errors: PERCUSS_ERROR_NAME, with the most similar name.
///
/// # Safety
/// name ends with a zero byte; index is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_find_link(
    model: *const percuss_model,
    name: *const c_char,
    index: *mut usize,
) -> percuss_status {
    guard_call(|| {
        let found = object_of(model)?.mechanism.find_link(input_text(name, "name")?);
        *argument_mut(index, "index")? = found.map_err(Failure::with_status(PERCUSS_ERROR_NAME))?.index();
        Ok(())
    })
}

/// The number of the joint of this name. Errors: PERCUSS_ERROR_NAME, with the most similar name.
///
/// # Safety
/// name ends with a zero byte; index is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_find_joint(
    model: *const percuss_model,
    name: *const c_char,
    index: *mut usize,
) -> percuss_status {
    guard_call(|| {
        let found = object_of(model)?.mechanism.find_joint(input_text(name, "name")?);
        *argument_mut(index, "index")? = found.map_err(Failure::with_status(PERCUSS_ERROR_NAME))?.index();
        Ok(())
    })
}

/// Joint number index, from 0.
///
/// # Safety
/// joint is null or points to storage for a percuss_joint.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_joint(
    model: *const percuss_model,
    index: usize,
    joint: *mut percuss_joint,
) -> percuss_status {
    guard_call(|| {
        let model = object_of(model)?;
        let name = element_at(&model.joint_names, index, "joint")?.as_ptr();
        let found = &model.mechanism.joints()[index];
        let kind = found.kind();
        let (first_position, first_velocity) = model.first[index];
        *argument_mut(joint, "joint")? = percuss_joint {
            name,
            kind: match kind {
                JointKind::Fixed => PERCUSS_FIXED,
                JointKind::Revolute => PERCUSS_REVOLUTE,
                JointKind::Continuous => PERCUSS_CONTINUOUS,
                JointKind::Prismatic => PERCUSS_PRISMATIC,
                JointKind::Planar => PERCUSS_PLANAR,
                JointKind::Spherical => PERCUSS_SPHERICAL,
                JointKind::Floating => PERCUSS_FLOATING,
            },
            has_limits: i32::from(found.limits().is_some()),
            lower: found.limits().map_or(f64::NAN, |limits| limits.lower),
            upper: found.limits().map_or(f64::NAN, |limits| limits.upper),
            positions: kind.positions(),
            first_position,
            velocities: kind.dofs(),
            first_velocity,
            parent: found.parent().index(),
            child: found.child().index(),
        };
        Ok(())
    })
}

/// Number of named poses of the file: keyframes of MJCF.
///
/// # Safety
/// count is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_pose_count(
    model: *const percuss_model,
    count: *mut usize,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(count, "count")? = object_of(model)?.poses.len();
        Ok(())
    })
}

/// The name of named pose number index, from 0. Valid as long as the model; null if the call fails.
///
/// # Safety
/// name is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_pose_name(
    model: *const percuss_model,
    index: usize,
    name: *mut *const c_char,
) -> percuss_status {
    guard_call(|| {
        let name = argument_mut(name, "name")?;
        *name = null();
        *name = element_at(&object_of(model)?.poses, index, "named pose")?.0.as_ptr();
        Ok(())
    })
}

/// Positions of all joints, concatenated in joint order, at the named pose of this name: for percuss_configuration_set_positions,
/// which closes the loops from there. count: the positions of percuss_model_counts; those of mimics are 0.
///
/// Errors: PERCUSS_ERROR_NAME, with the names of the model's poses; PERCUSS_ERROR_LENGTH.
///
/// # Safety
/// name ends with a zero byte; positions has space for count numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_pose_positions(
    model: *const percuss_model,
    name: *const c_char,
    positions: *mut f64,
    count: usize,
) -> percuss_status {
    guard_call(|| {
        let (poses, name) = (&object_of(model)?.poses, input_text(name, "name")?);
        match poses.iter().find(|(own, _)| own.to_bytes() == name.as_bytes()) {
            Some((_, values)) => copy_to_caller(values, positions, count, "positions"),
            None => {
                let known: Vec<_> =
                    poses.iter().take(LISTED_POSES).map(|(own, _)| own.to_string_lossy()).collect();
                let message = format_args!(
                    "the model has no pose \"{name}\"; it has {} named poses: {}",
                    poses.len(),
                    known.join(", ")
                );
                Err(Failure::new(PERCUSS_ERROR_NAME, message))
            }
        }
    })
}

/// Positions of all joints, concatenated in joint order, for the positions qpos of MuJoCo of a model that was read from its MJCF:
/// minus ref for a hinge or a slide, relative to the drawing for a free joint. qpos_count: nq of MuJoCo; count: the positions of
/// percuss_model_counts; those of mimics are as drawn, and not read. Allocates nothing.
///
/// Errors: PERCUSS_ERROR_ARGUMENT: a model of another format, a free body whose frame MuJoCo moves (align), a number that is not finite, a
/// quaternion 0; PERCUSS_ERROR_LENGTH.
///
/// # Safety
/// qpos has qpos_count numbers; positions has space for count numbers; they do not overlap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_positions_of_qpos(
    model: *const percuss_model,
    qpos: *const f64,
    qpos_count: usize,
    positions: *mut f64,
    count: usize,
) -> percuss_status {
    guard_call(|| {
        let written = [ByteRange::of_array(positions, count, "positions")];
        refuse_overlaps(&written, &[ByteRange::of_array(qpos, qpos_count, "qpos")])?;
        let layout = object_of(model)?.qpos.as_ref().ok_or_else(|| {
            let message =
                format_args!("the model was not read from MJCF; expected the file that MuJoCo reads, as qpos has its joints");
            Failure::new(PERCUSS_ERROR_ARGUMENT, message)
        })?;
        let given = input_slice(qpos, qpos_count, "qpos")?;
        let to = output_slice(positions, count, "positions")?;
        layout.convert(given, to).map_err(|error| {
            let status = match error {
                QposError::Count { .. } | QposError::PositionCount { .. } => PERCUSS_ERROR_LENGTH,
                _ => PERCUSS_ERROR_ARGUMENT,
            };
            Failure::new(status, error)
        })
    })
}

/// Number of notes and warnings about the file.
///
/// # Safety
/// count is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_diagnostic_count(
    model: *const percuss_model,
    count: *mut usize,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(count, "count")? = object_of(model)?.diagnostics.len();
        Ok(())
    })
}

/// Note or warning number index, from 0, in the order of the file.
///
/// # Safety
/// diagnostic is null or points to storage for a percuss_diagnostic.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_diagnostic(
    model: *const percuss_model,
    index: usize,
    diagnostic: *mut percuss_diagnostic,
) -> percuss_status {
    guard_call(|| {
        let texts = element_at(&object_of(model)?.diagnostics, index, "diagnostic")?;
        *argument_mut(diagnostic, "diagnostic")? = texts.for_c();
        Ok(())
    })
}
