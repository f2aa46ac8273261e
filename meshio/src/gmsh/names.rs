//! `$PhysicalNames`: dimension, id and name of each named group.

use octruss_mesh::Group;

use super::scanner::Scanner;
use crate::problem::Problem;
use crate::text::{parse_text, quoted};

/// Reads the section, text in binary files, too.
pub fn read(scanner: &mut Scanner) -> Result<Vec<Group>, Problem> {
    let count: u64 = scanner.number_line("the number of physical names")?;
    let mut groups: Vec<Group> = Vec::new();
    for _ in 0..count {
        let start = scanner.position();
        let line = scanner.line("a physical name")?;
        let group = group(line).ok_or_else(|| {
            scanner.malformed_at(
                start,
                format!(
                    "found {} where a physical name was expected: dimension (0 to 3), \
                     id and name in quotes",
                    quoted(line)
                ),
            )
        })?;
        groups.push(group);
    }
    check_unique(scanner, &groups)?;
    Ok(groups)
}

fn group(line: &[u8]) -> Option<Group> {
    let line = line.strip_suffix(b"\"")?;
    let quote = line.iter().position(|&byte| byte == b'"')?;
    let (numbers, name) = (&line[..quote], &line[quote + 1..]);
    let mut words = numbers.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let dimension = parse_text(words.next()?).filter(|&dimension: &u8| dimension <= 3)?;
    let id = parse_text(words.next()?)?;
    let name = String::from_utf8_lossy(name).into_owned();
    words.next().is_none().then_some(Group { dimension, id, name })
}

fn check_unique(scanner: &Scanner, groups: &[Group]) -> Result<(), Problem> {
    let mut keys: Vec<(u8, i32)> = groups.iter().map(|g| (g.dimension, g.id)).collect();
    keys.sort_unstable();
    match keys.windows(2).find(|pair| pair[0] == pair[1]) {
        None => Ok(()),
        Some(pair) => Err(scanner.malformed(format!(
            "the physical group {} of dimension {} has two names; expected one: \
             delete the other",
            pair[0].1, pair[0].0
        ))),
    }
}
