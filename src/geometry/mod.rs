//! Lights as a surface sees them: directions, their projection on the surface, outlines and chords.
//!
//! A direction is a unit vector (x, y, z) away from the surface: x along the tangent, y along the bitangent, z along the
//! normal. Its projection (x, y) lies in the unit disc, and an element of the disc is the cosine-weighted solid angle
//! dx dy = z domega. Whatever is lit, a light is an area of the disc.
//!
//! | item | what it is | page |
//! |---|---|---|
//! | [`Arc`] | an arc of a circle on the unit sphere, projected: a piece of a light's outline | [`mod@arc`] |
//! | [`Cone`], [`cone_outline`], [`cone_chords`] | the tangent cone of a sphere, its outline above the horizon, its chords | [`mod@cone`] |
//! | [`polygon_outline`], [`polygon_crossings`] | the outline of a polygon above the horizon, its crossings with a line | [`mod@polygon`] |

pub mod arc;
pub mod cone;
pub mod polygon;
pub(crate) mod vector;

#[doc(inline)]
pub use arc::Arc;
#[doc(inline)]
pub use cone::{Cone, cone_chords, cone_outline};
#[doc(inline)]
pub use polygon::{Crossing, polygon_crossings, polygon_outline};
