//! Properties of functions together that are held to a figure: the energy of base and scratches, the integral of a density.

use iridescence::diffraction::{depth_term, depth_term_squared, energy_blend};
use iridescence::sampling::von_mises_fisher_pdf;
use reference::generate::random::Random;
use reference::generate::surfaces;
use reference::simpson::simpson;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// Surfaces tried.
const ROWS: usize = 20_000;
const SEED: u64 = 31;
/// Steps of the integral over a cone; a power of two, so that the cosines are exact.
const STEPS: i32 = 1 << 16;

/// The largest difference of the two energies of [`energy_blend`] from those of the transfer function 1 - rho D of unit
/// modulus: |1 - rho D|^2 for the base, the rest for the scratches; over random area densities and depths.
pub fn energy_defect() -> f64 {
    static DEFECT: LazyLock<f64> = LazyLock::new(|| {
        let mut random = Random::new(SEED);
        let rows = (surfaces::DEPTH.rows)(SEED, ROWS);
        let defect = |row: &[f64]| {
            let [depth, gamma_sum, lambda] = [row[0], row[1], row[2]];
            let density = random.uniform(0.0, 1.0);
            let blend = energy_blend(density, depth_term_squared(depth, gamma_sum, lambda));
            let kept = (1.0 - density * depth_term(depth, gamma_sum, lambda)).norm_sqr();
            (blend.base - kept).abs().max((blend.scattered - (1.0 - kept)).abs())
        };
        rows.chunks_exact(3).map(defect).fold(0.0, f64::max)
    });
    *DEFECT
}

/// The largest difference from 1 of the integral of a density over the sphere, for concentrations of 1e-12 to 1e6.
fn cone_defect(density: impl Fn(f64, f64) -> f64) -> f64 {
    let integral = |concentration: f64| {
        // The density falls by exp(-40) and more within a power of two.
        let range = libm::exp2(libm::ceil(libm::log2(40.0 / concentration))).min(2.0);
        TAU * simpson(|below| density(concentration, 1.0 - below), [0.0, range], STEPS)
    };
    let defects = (-12..=6).map(|k| (integral(libm::pow(10.0, f64::from(k))) - 1.0).abs());
    defects.fold(0.0, |worst, defect| {
        if defect > worst || defect.is_nan() {
            defect
        } else {
            worst
        }
    })
}

/// That of [`von_mises_fisher_pdf`].
pub fn von_mises_fisher_defect() -> f64 {
    static DEFECT: LazyLock<f64> = LazyLock::new(|| cone_defect(von_mises_fisher_pdf));
    *DEFECT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energy_and_normalisation_hold_to_rounding_and_a_density_that_is_off_or_overflows_is_found() {
        assert!((1e-17..1e-14).contains(&energy_defect()), "{:e}", energy_defect());
        assert!(von_mises_fisher_defect() < 1e-12, "{:e}", von_mises_fisher_defect());
        let off = cone_defect(|k, c| von_mises_fisher_pdf(k, c) * (1.0 + 1e-11));
        assert!(off > 5e-12 && off < 2e-11, "{off:e}");
        // As printed: kappa/(4 pi sinh kappa) exp(kappa cos).
        assert!(cone_defect(|k, c| k / (2.0 * TAU * k.sinh()) * (k * c).exp()).is_nan());
    }
}
