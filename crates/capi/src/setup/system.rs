//! Systems (a mechanism under conditions) and assemblies (systems with closed loops).

use crate::boundary::handle::{
    Handle, argument_mut, clear_handle, free_handle, lock_object, object_of, write_handle,
};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ASSEMBLY, PERCUSS_ERROR_CONDITIONS, guard_call, percuss_status,
};
use crate::setup::conditions::percuss_conditions;
use crate::setup::configuration::percuss_configuration;
use crate::setup::model::{Model, percuss_model};
use percuss::{Assembly, Conditions, System};
use std::sync::Arc;

/// A mechanism under conditions. Immutable, so that threads can share it.
pub struct percuss_system {
    _opaque: [u8; 0],
}

/// A mechanism under conditions, with the names of its links and joints.
#[derive(Clone)]
pub(crate) struct NamedSystem {
    pub model: Arc<Model>,
    pub system: System,
}

impl Handle for percuss_system {
    type Object = NamedSystem;
    const TAG: u64 = 0x7063_5f73_7973_7465;
    const NAME: &'static str = "percuss_system";
}

/// A system with assembled loops. Immutable, so that threads can share it.
pub struct percuss_assembly {
    _opaque: [u8; 0],
}

/// An assembly, with the names of its links and joints.
pub(crate) struct NamedAssembly {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
}

impl Handle for percuss_assembly {
    type Object = NamedAssembly;
    const TAG: u64 = 0x7063_5f61_7373_656d;
    const NAME: &'static str = "percuss_assembly";
}

/// Compiles a mechanism with the conditions of an analysis; null conditions: fixed base, every joint free. The model
/// and the conditions may be freed afterwards. Free the system with percuss_system_free.
///
/// Errors: PERCUSS_ERROR_CONDITIONS.
///
/// # Safety
/// model is a handle; conditions is null or a handle; system is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_system_new(
    model: *const percuss_model,
    conditions: *const percuss_conditions,
    system: *mut *mut percuss_system,
) -> percuss_status {
    guard_call(|| {
        clear_handle(system)?;
        let model = object_of(model)?;
        let conditions = match conditions.is_null() {
            true => Conditions::new(),
            false => lock_object(object_of(conditions)?, "percuss_conditions")?.clone(),
        };
        let compiled = System::new(Arc::clone(&model.mechanism), &conditions)
            .map_err(Failure::with_status(PERCUSS_ERROR_CONDITIONS))?;
        write_handle(NamedSystem { model: Arc::clone(model), system: compiled }, system)
    })
}

/// Frees a system and sets the handle to null; a null handle is ignored. Objects made from the system stay valid.
///
/// # Safety
/// system is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_system_free(system: *mut *mut percuss_system) -> percuss_status {
    guard_call(|| free_handle(system))
}

/// Number of coordinates: independent velocities of the tree, without locked joints and mimics; a floating base adds
/// six. Order: the base first, then the joints from the root.
///
/// # Safety
/// coordinates is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_system_coordinates(
    system: *const percuss_system,
    coordinates: *mut usize,
) -> percuss_status {
    guard_call(|| {
        *argument_mut(coordinates, "coordinates")? = object_of(system)?.system.coordinates();
        Ok(())
    })
}

/// Assembles the loops: from all joints at 0 if configuration is null, else from its guesses. A mechanism without loops
/// has one assembly. Free it with percuss_assembly_free.
///
/// Errors: PERCUSS_ERROR_ASSEMBLY, with the name of the open loop.
///
/// # Safety
/// system is a handle; configuration is null or a handle; assembly is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_assembly_new(
    system: *const percuss_system,
    configuration: *const percuss_configuration,
    assembly: *mut *mut percuss_assembly,
) -> percuss_status {
    guard_call(|| {
        clear_handle(assembly)?;
        let compiled = object_of(system)?;
        let found = match configuration.is_null() {
            true => compiled.system.reference().map(Arc::clone),
            false => {
                let configuration = lock_object(object_of(configuration)?, "percuss_configuration")?;
                configuration.check_model(&compiled.model)?;
                compiled.system.assemble(&configuration.values)
            }
        };
        let found = found.map_err(Failure::with_status(PERCUSS_ERROR_ASSEMBLY))?;
        write_handle(NamedAssembly { model: Arc::clone(&compiled.model), assembly: found }, assembly)
    })
}

/// Frees an assembly and sets the handle to null; a null handle is ignored. Objects made from the assembly stay valid.
///
/// # Safety
/// assembly is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_assembly_free(assembly: *mut *mut percuss_assembly) -> percuss_status {
    guard_call(|| free_handle(assembly))
}

/// Degrees of freedom at a generic pose (a floating base counts 6), and number of redundant rows of A at that pose.
/// Each pointer may be null.
///
/// # Safety
/// Every pointer is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_assembly_mobility(
    assembly: *const percuss_assembly,
    degrees_of_freedom: *mut usize,
    redundant_constraints: *mut usize,
) -> percuss_status {
    guard_call(|| {
        let assembly = &object_of(assembly)?.assembly;
        let counts = [assembly.degrees_of_freedom(), assembly.redundant_constraints()];
        for (to, count) in [degrees_of_freedom, redundant_constraints].into_iter().zip(counts) {
            if !to.is_null() {
                *argument_mut(to, "a count")? = count;
            }
        }
        Ok(())
    })
}
