//! Empty crate: cargo fetches its dependencies for their C++ headers.
