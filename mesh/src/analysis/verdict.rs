//! What a local spectrum says about a scheme at a vertex.

use super::characteristic_map::CharacteristicMap;
use super::no_map::NoMap;
use super::spectrum::Spectrum;

/// Smoothness of a scheme at a vertex, as far as its spectrum and a sample of
/// its characteristic map show it: numerical evidence, no proof.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// λ0 = 1 is simple and all others are smaller.
    pub convergent: bool,
    /// |λ3| > |λ4|.
    pub separated: bool,
    /// What the characteristic map looks like.
    pub map: MapVerdict,
}

/// The verdict on the characteristic map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapVerdict {
    /// The map was sampled.
    Sampled {
        /// No tet of the sample is flat or turned over against the others.
        regular: bool,
        /// No two tets of the sample overlap at a barycentre.
        injective: bool,
        /// How many tets were looked at.
        tets: usize,
    },
    /// There is no such map, and why.
    NotApplicable(NoMap),
}

impl Verdict {
    /// Judges a spectrum and the characteristic map that belongs to it.
    pub fn new(spectrum: &Spectrum, map: &Result<CharacteristicMap, NoMap>) -> Self {
        let map = match map {
            Ok(map) => MapVerdict::Sampled {
                regular: map.is_regular(),
                injective: map.is_injective(),
                tets: map.image.tets.len(),
            },
            Err(none) => MapVerdict::NotApplicable(*none),
        };
        Self { convergent: spectrum.is_convergent(), separated: spectrum.is_separated(), map }
    }
}
