//! The footprint and the area density of VWH18 sections 3.2 and 3.3, and its blends.

use std::f64::consts::PI;

/// An elliptic footprint and an infinite scratch at a distance from its centre, lengths in one unit.
#[derive(Clone, Copy, Debug)]
pub struct Crossed {
    /// Half axes a1 and a2 of the footprint.
    pub axes: [f64; 2],
    /// Cosine of the angle between the first axis and the tangent of the scratch.
    pub cos_phi: f64,
    /// s_b, the distance of the scratch from the centre.
    pub offset: f64,
    /// Coherence radius sigma.
    pub sigma: f64,
}

impl Crossed {
    /// A_P, "a factor which normalizes the integral to the covered area".
    pub fn area(&self) -> f64 {
        self.axes[0] * self.axes[1] * PI
    }

    /// Half the extent of the ellipse across the scratch.
    pub fn half_width(&self) -> f64 {
        let [a1, a2] = self.axes;
        (a1.powi(2) * (1.0 - self.cos_phi.powi(2)) + a2.powi(2) * self.cos_phi.powi(2)).sqrt()
    }

    /// l_contained: the length of the scratch's centre line in the ellipse, "the accurate contained geometric length".
    pub fn contained(&self) -> f64 {
        let h = self.half_width();
        let inside = 1.0 - (self.offset / h).powi(2);
        2.0 * self.axes[0] * self.axes[1] / h * inside.max(0.0).sqrt()
    }

    /// alpha = min(A_P/(2 A_C), 1) of VWH18 Eq. 16.
    pub fn alpha(&self) -> f64 {
        (0.5 * self.area() / (PI * self.sigma.powi(2))).min(1.0)
    }
}

/// VWH18 Eq. 15, right member: |eta_P|^2 for a wide footprint.
pub fn footprint_wide_vwh18_15(x: &Crossed) -> f64 {
    2.0 * x.sigma.powi(3) / (x.axes[0] * x.axes[1]) * PI.sqrt() * x.contained()
}

/// VWH18 Eq. 16: |eta_P|^2 as a blend of two limits.
pub fn footprint_blend_vwh18_16(x: &Crossed) -> f64 {
    footprint_blend_with_factor(x, 1.0)
}

/// VWH18 Eq. 16 with a factor before its second term: 1 is the printed formula, pi the one with the right limit.
pub fn footprint_blend_with_factor(x: &Crossed, factor: f64) -> f64 {
    let alpha = x.alpha();
    let point = (-x.offset.powi(2) / x.sigma.powi(2)).exp();
    2.0 * x.sigma.powi(2) / x.area()
        * (alpha * x.sigma * PI.powi(3).sqrt() * x.contained() + (1.0 - alpha) * x.area() * point * factor)
}

/// VWH18 Eq. 17, last member: the share rho_c of scratches of one width at the distances `offsets`.
pub fn area_density_vwh18_17(width: f64, sigma: f64, offsets: impl Iterator<Item = f64>) -> f64 {
    let sum: f64 = offsets
        .map(|s_b| width * (2.0 * PI).sqrt() * sigma * (-s_b.powi(2) / (2.0 * sigma.powi(2))).exp())
        .sum();
    sum / (PI * sigma.powi(2))
}

/// VWH18 Eq. 18, last member: the share rho_P of scratches of one width in a footprint.
pub fn area_density_vwh18_18(width: f64, footprints: impl Iterator<Item = Crossed>) -> f64 {
    footprints.map(|x| 2.0 / x.area() * width * x.contained()).sum()
}

/// VWH18 Eq. 6, second member: the energy of base and scratches together, (1 - rho) of the base and all of |S|^2.
pub fn blended_vwh18_6(density: f64, base_squared: f64, scratch_squared: f64) -> f64 {
    (1.0 - density) * base_squared + scratch_squared
}
