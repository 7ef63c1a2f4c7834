//! The C interface: its functions called from Rust, the header, and programs in C and C++.

#[macro_use]
mod calls;

// Miri starts no other program.
#[cfg(not(miri))]
mod built;
#[cfg(not(miri))]
mod findings;
#[cfg(not(miri))]
mod header;
#[cfg(not(miri))]
mod julia;
#[cfg(all(unix, not(miri)))]
mod programs;
