//! Exact truth.
