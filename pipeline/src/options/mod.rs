//! The values that configs fill in, and code can, too. Each is checked where it is made;
//! none knows of stages or recipes. A name of the mesh keeps its place in the config, since
//! only a stage can check it.

mod compare;
mod group_borders;
mod material;
mod min_quality;
mod on_surface;
mod option_names;
mod per_region;
mod several;
mod value;
mod value_or;

pub use compare::{Compare, Geometry};
pub use group_borders::GroupBordersKey;
pub use material::MaterialKeys;
pub use min_quality::MinQuality;
pub use on_surface::{OnSurface, RobinOnSurface, Springs, VectorOnSurface};
pub use option_names::option_names;
pub use per_region::{PerRegion, Regional};
pub use several::Several;
pub use value::{Degrees, Ends, Fraction, Value, VectorValue};
pub use value_or::{ValueOr, ValueOrVector};

/// A scheme with its usual parameters, by its name.
pub type SchemeName = octruss_base::choice::Named<octruss_mesh::Scheme>;
