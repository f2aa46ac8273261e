//! Damaged files of every flavour: reading returns, with a dataset or an error.

use octruss_meshio::{Values, parse};
use proptest::prelude::*;

const VALID: [&[u8]; 8] = [
    include_bytes!("data/gmsh/fields-ascii.msh"),
    include_bytes!("data/gmsh/fields-binary.msh"),
    include_bytes!("data/gmsh/fields-2.2-binary.msh"),
    include_bytes!("data/gmsh/sparse-tags.msh"),
    include_bytes!("data/gmsh/blocks-2.2-ascii.msh"),
    include_bytes!("data/gmsh/blocks-2.2-binary.msh"),
    include_bytes!("data/gmsh/partitioned.msh"),
    include_bytes!("data/gmsh/partitioned-binary.msh"),
];

/// Reads the bytes; what comes back can be no larger than the bytes account for.
fn read(bytes: &[u8]) {
    let Ok(dataset) = parse("damaged.msh".as_ref(), bytes) else { return };
    let mesh = &dataset.mesh;
    assert_eq!(mesh.tets.len(), mesh.regions.len());
    assert!(mesh.points.len() <= bytes.len() && mesh.tets.len() <= bytes.len());
    assert!(mesh.tets.as_flattened().iter().all(|&vertex| (vertex as usize) < mesh.points.len()));
    for (fields, owners) in
        [(&dataset.point_fields, mesh.points.len()), (&dataset.cell_fields, mesh.tets.len())]
    {
        for field in fields {
            assert!(matches!(&field.values, Values::Float(_)));
            assert_eq!(field.tuples(), owners);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn overwritten_bytes(
        file in prop::sample::select(&VALID[..]),
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut bytes = file.to_vec();
        for (at, byte) in edits {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        read(&bytes);
    }

    #[test]
    fn digits_for_digits(
        file in prop::sample::select(&VALID[..]),
        edits in prop::collection::vec((any::<prop::sample::Index>(), "[-0-9 .\n$]{1,20}"), 1..4),
    ) {
        let mut bytes = file.to_vec();
        for (at, text) in edits {
            let at = at.index(bytes.len());
            bytes.splice(at..at + 1, text.into_bytes());
        }
        read(&bytes);
    }

    #[test]
    fn cut_anywhere(
        file in prop::sample::select(&VALID[..]),
        end in any::<prop::sample::Index>(),
    ) {
        read(&file[..end.index(file.len())]);
    }

    #[test]
    fn without_a_piece(
        file in prop::sample::select(&VALID[..]),
        from in any::<prop::sample::Index>(),
        length in 1..200_usize,
    ) {
        let from = from.index(file.len());
        let mut bytes = file.to_vec();
        bytes.drain(from..(from + length).min(file.len()));
        read(&bytes);
    }
}
