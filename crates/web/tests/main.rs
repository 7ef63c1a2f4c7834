//! Tests of the engine of the explorer.
