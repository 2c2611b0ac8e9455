//! Area lights over the lobe of a scratch: spheres and polygons in closed form, with as many chords as the light needs
//! (VWH18 3.4).

mod gauss_rule;
mod outline_integral;
// pub mod form_factor;
pub mod polygon;
pub mod scratch_lobe;
pub mod sphere;
mod wave;

pub use outline_integral::LightIntegral;
pub use polygon::*;
pub use scratch_lobe::ScratchLobe;
pub use sphere::*;
