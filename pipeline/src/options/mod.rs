//! The values that configs fill in, and code can, too. Each is checked where it is made;
//! none knows of stages, recipes or places in a config.

mod compare;
mod material;
mod min_quality;
mod on_surface;
mod option_names;
mod per_region;
mod several;
mod value;
mod value_or;

pub use compare::{Compare, Geometry};
pub use material::MaterialKeys;
pub use min_quality::MinQuality;
pub use octruss_base::choice::{Auto, Choice, Named};
pub use octruss_base::suggestion::suggestion;
pub use on_surface::{OnSurface, RobinOnSurface, Springs, VectorOnSurface};
pub use option_names::option_names;
pub use per_region::{PerRegion, Regional};
pub use several::Several;
pub use value::{Degrees, Ends, Fraction, Value, VectorValue};
pub use value_or::{ValueOr, ValueOrVector};

/// A scheme with its usual parameters, by its name.
pub type SchemeName = Named<octruss_mesh::Scheme>;
