//! Floating-point environment of a call.
//!
//! The library divides by zero in lanes that are masked afterwards, and computes with NaN. In a caller's environment
//! with traps (`feenableexcept`), another rounding mode or denormal numbers flushed to zero, it would be ended by a
//! signal or return other numbers. Each call therefore runs in the default environment: no traps, rounding to nearest,
//! denormal numbers kept. If the caller's environment is the default, the cost is one read of the control register
//! (about 2 ns); otherwise the environment is replaced, and restored with its flags at the end (about 20 ns). Threads
//! of a batch start in the default environment.

/// Guard that sets the default environment until it is dropped.
#[must_use]
pub(crate) struct DefaultEnvironment(Option<control::Register>);

impl DefaultEnvironment {
    /// Sets the default environment, if it differs, and keeps that of the caller.
    #[inline]
    pub fn enter() -> Self {
        let found = control::read_register();
        if found & !control::FLAGS == control::DEFAULT {
            return Self(None);
        }
        control::write_register(control::DEFAULT);
        Self(Some(found))
    }
}

impl Drop for DefaultEnvironment {
    #[inline]
    fn drop(&mut self) {
        if let Some(found) = self.0 {
            control::write_register(found);
        }
    }
}

#[cfg(all(target_arch = "x86_64", not(miri)))]
mod control {
    use std::arch::asm;

    pub type Register = u32;
    /// All exceptions masked, rounding to nearest.
    pub const DEFAULT: u32 = 0x1f80;
    /// Exception flags: they persist while no trap is enabled.
    pub const FLAGS: u32 = 0x3f;

    /// Bits of the floating-point control register.
    #[inline]
    pub fn read_register() -> u32 {
        let mut register = 0_u32;
        // SAFETY: the instruction stores four bytes at the address of a local number.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut register, options(nostack, preserves_flags)) };
        register
    }

    /// Sets the floating-point control register.
    #[inline]
    pub fn write_register(register: u32) {
        // SAFETY: the instruction loads four bytes from a local number, a value of this register or its default: no
        // reserved bit is set.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const register, options(nostack, preserves_flags)) };
    }
}

#[cfg(all(target_arch = "aarch64", not(miri)))]
mod control {
    use std::arch::asm;

    pub type Register = u64;
    /// No traps, rounding to nearest.
    pub const DEFAULT: u64 = 0;
    /// The flags are in a separate register.
    pub const FLAGS: u64 = 0;

    /// Bits of the floating-point control register.
    #[inline]
    pub fn read_register() -> u64 {
        let register: u64;
        // SAFETY: the instruction reads the control register of floating-point arithmetic.
        unsafe { asm!("mrs {}, fpcr", out(reg) register, options(nostack, preserves_flags)) };
        register
    }

    /// Sets the floating-point control register.
    #[inline]
    pub fn write_register(register: u64) {
        // SAFETY: a value of this register, or its default.
        unsafe { asm!("msr fpcr, {}", in(reg) register, options(nostack, preserves_flags)) };
    }
}

/// Other processors, and Miri, which runs no instructions: the caller's environment stays in force.
#[cfg(any(miri, not(any(target_arch = "x86_64", target_arch = "aarch64"))))]
mod control {
    pub type Register = u32;
    pub const DEFAULT: u32 = 0;
    pub const FLAGS: u32 = 0;

    /// Bits of the floating-point control register.
    #[inline]
    pub fn read_register() -> u32 {
        DEFAULT
    }

    /// Does nothing.
    #[inline]
    pub fn write_register(_: u32) {}
}
