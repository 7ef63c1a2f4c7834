//! Nothing: the packages are fetched for the headers that they carry.
