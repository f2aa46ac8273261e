//! `$Entities` and `$PartitionedEntities` of MSH 4.1: the groups of each
//! geometric entity. Geometry and topology of the entities are passed over.

use super::scanner::Scanner;
use crate::problem::Problem;

/// The groups of entities, by dimension and tag.
#[derive(Debug, Default)]
pub struct Entities {
    /// Sorted by dimension and tag.
    groups: Vec<((i32, i32), Vec<i32>)>,
}

impl Entities {
    /// The groups of an entity, in the order of the file; none for an unknown one.
    /// A negative group contains the entity the other way round.
    pub fn groups(&self, dimension: i32, tag: i32) -> &[i32] {
        match self.groups.binary_search_by_key(&(dimension, tag), |entry| entry.0) {
            Ok(at) => &self.groups[at].1,
            Err(_) => &[],
        }
    }

    /// Reads `$Entities` and adds what it says.
    pub fn read(&mut self, scanner: &mut Scanner) -> Result<(), Problem> {
        self.read_all(scanner, |_| Ok(()))
    }

    /// Reads `$PartitionedEntities` and adds what it says. The entities of the
    /// parts of a mesh have tags of their own.
    pub fn read_partitioned(&mut self, scanner: &mut Scanner) -> Result<(), Problem> {
        scanner.size("the number of partitions")?;
        scanner.end_record("the number of partitions")?;
        let ghosts = scanner.size("the number of ghost entities")?;
        scanner.end_record("the number of ghost entities")?;
        for _ in 0..ghosts {
            scanner.int("a ghost entity")?;
            scanner.int("the partition of a ghost entity")?;
            scanner.end_record("the ghost entity")?;
        }
        self.read_all(scanner, |scanner| {
            scanner.int("the dimension of a parent entity")?;
            scanner.int("the tag of a parent entity")?;
            skip_ints(scanner, "a partition of an entity")
        })
    }

    fn read_all(
        &mut self,
        scanner: &mut Scanner,
        skip_partitions: impl Fn(&mut Scanner) -> Result<(), Problem>,
    ) -> Result<(), Problem> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = scanner.size("the number of entities of a dimension")?;
        }
        scanner.end_record("the entity counts")?;
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                let tag = scanner.int("an entity tag")?;
                skip_partitions(scanner)?;
                // A point has coordinates, others have two corners of a box.
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    scanner.double("a coordinate of an entity")?;
                }
                let groups = groups(scanner)?;
                if dimension > 0 {
                    skip_ints(scanner, "a bounding entity")?;
                }
                scanner.end_record("the entity")?;
                self.groups.push(((dimension, tag), groups));
            }
        }
        self.groups.sort();
        Ok(())
    }
}

fn groups(scanner: &mut Scanner) -> Result<Vec<i32>, Problem> {
    let mut groups = Vec::new();
    for _ in 0..scanner.size("the number of physical groups of an entity")? {
        groups.push(scanner.int("a physical group of an entity")?);
    }
    groups.retain(|&group| group != 0);
    Ok(groups)
}

fn skip_ints(scanner: &mut Scanner, what: &str) -> Result<(), Problem> {
    for _ in 0..scanner.size("a count")? {
        scanner.int(what)?;
    }
    Ok(())
}
