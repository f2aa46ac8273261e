//! Materials as configs give them.

use octruss_base::suggestion::suggestion;
use toml::Spanned;

use super::option_names::option_names;
use super::per_region::{PerRegion, Regional};
use super::value::Value;
use super::value_or::ValueOr;

/// An isotropic elastic material.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct MaterialKeys {
    /// Young's modulus, above 0.
    pub young: Value,
    /// Poisson's ratio, above −1 and below 1/2.
    pub poisson: Value,
    /// Mass per unit of volume, 0 where none is given; only gravity asks for it.
    #[serde(default = "MaterialKeys::massless")]
    pub density: Value,
}

impl Regional for MaterialKeys {
    const WHAT: &'static str = "a table with `young`, `poisson` and perhaps `density`";
    type Entry = ValueOr<Self>;
    fn from_table(table: Vec<(Spanned<String>, ValueOr<Self>)>) -> Result<PerRegion<Self>, String> {
        MaterialKeys::one_or_by_region(table)
    }
}

impl MaterialKeys {
    fn massless() -> Value {
        Value::Number(0.0)
    }

    /// A table of materials, or of the numbers of one.
    fn one_or_by_region(
        table: Vec<(Spanned<String>, ValueOr<Self>)>,
    ) -> Result<PerRegion<Self>, String> {
        let (mut named, mut numbers) = (Vec::new(), Vec::new());
        for (name, entry) in table {
            match entry {
                ValueOr::Other(material) => named.push((name, material)),
                ValueOr::One(number) => numbers.push((name.into_inner(), number)),
            }
        }
        if let (Some((region, _)), Some((key, _))) = (named.first(), numbers.first()) {
            return Err(format!(
                "`{key}` is a number, but `{}` a table: give one material for all regions, or a \
                 table for each",
                region.get_ref()
            ));
        }
        if !named.is_empty() {
            return Ok(PerRegion::Named(named));
        }
        let keys = option_names::<Self>();
        if let Some((key, _)) = numbers.iter().find(|(key, _)| !keys.contains(&&**key)) {
            return Err(format!("unknown key `{key}`{}", suggestion(key, keys)));
        }
        let mut of = |key: &str| {
            let found = numbers.iter().position(|(name, _)| name == key);
            found.map(|index| numbers.swap_remove(index).1)
        };
        let (young, poisson, density) = (of("young"), of("poisson"), of("density"));
        match (young, poisson) {
            (Some(young), Some(poisson)) => {
                let density = density.unwrap_or_else(Self::massless);
                Ok(PerRegion::Uniform(Self { young, poisson, density }))
            }
            (None, _) => Err("a material needs `young`, Young's modulus".into()),
            (_, None) => Err("a material needs `poisson`, Poisson's ratio".into()),
        }
    }
}
