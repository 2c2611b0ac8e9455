//! Area lights over the lobe of a scratch: spheres and polygons in closed form, with as many chords as the light needs
//! (VWH18 3.4).

pub mod chord;
mod gauss_rule;
mod outline_integral;
pub mod form_factor;
pub mod polygon;
pub mod published;
pub mod scratch_lobe;
pub mod sphere;
mod wave;

#[doc(inline)]
pub use chord::{polygon_light_chords, sphere_light_chords};
#[doc(inline)]
pub use outline_integral::LightIntegral;
pub use polygon::*;
pub use published::{polygon_light_vwh18, sphere_light_vwh18};
pub use scratch_lobe::ScratchLobe;
pub use sphere::*;
