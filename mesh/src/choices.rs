//! The closed choices of this crate, by name.

use crate::{AffineCorrection, CurveEnds, Diagonal, GroupBorders, InterfaceRows, Marking, Scheme};
use octruss_base::choice::Choice;

macro_rules! choices {
    ($($choice:ident: $what:literal,)*) => {$(
        impl Choice for $choice {
            const WHAT: &'static str = $what;
            const ALL: &'static [Self] = &$choice::ALL;
            fn name(self) -> &'static str {
                $choice::name(self)
            }
        }
    )*};
}

choices! {
    Scheme: "scheme",
    Marking: "marking",
    Diagonal: "diagonal",
    CurveEnds: "choice of curve ends",
    GroupBorders: "choice of group borders",
    AffineCorrection: "affine correction",
    InterfaceRows: "choice of interface rows",
}
