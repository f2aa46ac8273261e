//! The command line: results on stdout, everything else on stderr.
//!
//! Exit codes: 0 good, 1 the run failed or an expectation was missed, 2 wrong
//! usage or config.

mod card;
mod commands;
mod display;
mod entry;
mod how_to_run;
mod interrupt;
mod say;
mod solve_table;
mod sound_mesh;
mod threads;
mod traffic_table;
mod vertex_place;

pub use entry::main;
