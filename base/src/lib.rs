//! What meshes and matrices are made with, and no word of either: parallel work
//! that gives the same bits for any number of threads, memory for large arrays,
//! grouping by a key, vectors of three numbers, choices by name.
//!
//! ```
//! use octruss_base::groups::Groups;
//! // Which of four tets touch each of five vertices: entries keep the order of
//! // their sources, however many threads there are.
//! let tets = [[0, 1, 2, 3], [1, 2, 3, 4], [0, 2, 3, 4], [0, 1, 3, 4]];
//! let groups = Groups::new(5, tets.len(), |t| tets[t].map(|vertex| (vertex, t as u32)));
//! assert_eq!(groups.of(0), [0, 2, 3]);
//! ```

pub mod choice;
pub mod chunks;
pub mod disjoint_sets;
pub mod groups;
pub mod large_array;
pub mod ragged;
pub mod suggestion;
pub mod vector3;
pub mod workspaces;
