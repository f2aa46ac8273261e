//! Data of a problem that differ from region to region.

use crate::error::Error;
use crate::problem::scalar::Scalar;
use octruss_mesh::TetMesh;

/// A value for each region, by region id.
#[derive(Debug, Clone, PartialEq)]
pub struct ByRegion<T = Scalar> {
    /// Holds in regions that are not listed.
    pub default: T,
    /// Regions with a value of their own; the last entry for an id counts.
    pub regions: Vec<(i32, T)>,
}

impl<T> ByRegion<T> {
    /// The value in one region.
    #[inline]
    pub fn of(&self, region: i32) -> &T {
        let listed = self.regions.iter().rev().find(|(id, _)| *id == region);
        listed.map_or(&self.default, |(_, value)| value)
    }

    /// Whether all values, also those of no region, are such.
    pub(crate) fn all(&self, such: impl Fn(&T) -> bool) -> bool {
        such(&self.default) && self.regions.iter().all(|(_, value)| such(value))
    }

    /// Checks that every listed region has tets.
    pub(crate) fn check(&self, mesh: &TetMesh) -> Result<(), Error> {
        for &(id, _) in &self.regions {
            if !mesh.regions().contains(&id) {
                return Err(Error::UnknownRegion { id, known: mesh.raw().ids(3) });
            }
        }
        Ok(())
    }
}

impl<T> From<T> for ByRegion<T> {
    fn from(default: T) -> Self {
        Self { default, regions: Vec::new() }
    }
}

impl From<f64> for ByRegion<Scalar> {
    fn from(value: f64) -> Self {
        Self::from(Scalar::from(value))
    }
}
