//! The nodes of a file and the way from their tags to vertex numbers.

use super::scanner::Scanner;
use super::tags::TagMap;
use crate::problem::Problem;

/// Nodes while they are being read.
#[derive(Debug, Default)]
pub struct NodeList {
    /// The tag of each node.
    pub tags: Vec<u64>,
    /// The position of each node.
    pub points: Vec<[f64; 3]>,
    /// Where in the file the tag of each node is, for messages.
    pub places: Vec<usize>,
}

/// All nodes, numbered in the order of the file.
#[derive(Debug)]
pub struct Nodes {
    /// The position of each node.
    pub points: Vec<[f64; 3]>,
    map: TagMap,
}

impl NodeList {
    /// Checks that there are as many as announced and that each tag occurs once.
    pub fn finish(self, scanner: &Scanner, announced: u64) -> Result<Nodes, Problem> {
        let count = self.points.len();
        if count as u64 != announced {
            return Err(scanner.malformed(format!(
                "{announced} nodes are announced, but the blocks hold {count}; expected the same number"
            )));
        }
        if count >= u32::MAX as usize {
            return Err(Problem::unsupported(format!(
                "{count} nodes are too many: fewer than 2^32 − 1 are read"
            )));
        }
        let (map, twice) = TagMap::new(&self.tags);
        if let Some(index) = twice {
            let tag = self.tags[index];
            return Err(scanner.malformed_at(
                self.places[index],
                format!("the node tag {tag} occurs a second time; expected each tag once"),
            ));
        }
        Ok(Nodes { points: self.points, map })
    }
}

impl Nodes {
    /// The number of the node that is called `tag` at `place` in the file.
    #[inline]
    pub fn index(&self, scanner: &Scanner, place: usize, tag: u64) -> Result<u32, Problem> {
        self.map.index(tag).ok_or_else(|| {
            scanner.malformed_at(
                place,
                format!("node {tag} is referred to, but $Nodes has none of that tag; expected one of its {}", self.points.len()),
            )
        })
    }
}
