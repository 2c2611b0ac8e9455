//! Rows of the responses of scratches, of the bare surface, of the area density and of the sampling densities. The columns
//! are those of the oracles.

use super::random::Random;
use super::scratches::{direction, energy, kept, phase, profile, radius, recorded, single, wavelength};
use super::{Generator, fill};

/// sigma, lambda, xi1, xi2, s_b.
pub const INFINITE_PHASE: Generator = Generator {
    name: "spatial_phase_infinite",
    domain: "sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi| <= 2, half of them in the lobe, s_b to 40 sigma",
    columns: 5,
    rows: |seed, n| {
        fill(seed, n, 5, phase_rows(false), |r, rows| {
            rows.extend(infinite_phase(r));
        })
    },
};

/// The same at f32 values.
pub const INFINITE_PHASE_F32: Generator = Generator {
    name: "spatial_phase_infinite_f32",
    domain: "f32: sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi| <= 2, half of them in the lobe, s_b to 40 sigma",
    columns: 5,
    rows: |seed, n| {
        fill(seed, n, 5, phase_rows(true), |r, rows| {
            rows.extend(infinite_phase(r).map(single));
        })
    },
};

/// depth, gamma_sum, lambda.
pub const DEPTH: Generator = Generator {
    name: "depth_term",
    domain: "depth 0..20 um, gamma_sum 0..2, lambda 0.38..0.78 um",
    columns: 3,
    rows: |seed, n| {
        fill(seed, n, 3, depth_rows(false), |r, rows| {
            let [_, depth, _, gamma_sum, lambda] = profile(r);
            rows.extend([depth, gamma_sum, lambda]);
        })
    },
};

/// The same at f32 values.
pub const DEPTH_F32: Generator = Generator {
    name: "depth_term_f32",
    domain: "f32: depth 0..20 um, gamma_sum 0..2, lambda 0.38..0.78 um",
    columns: 3,
    rows: |seed, n| {
        fill(seed, n, 3, depth_rows(true), |r, rows| {
            let [_, depth, _, gamma_sum, lambda] = profile(r);
            rows.extend([depth, gamma_sum, lambda].map(single));
        })
    },
};

/// sigma, lambda, xi1, xi2.
pub const BASE: Generator = Generator {
    name: "base_response",
    domain: "sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi| <= 2, half of them in the lobe",
    columns: 4,
    rows: |seed, n| {
        fill(seed, n, 4, recorded("base_response", false).concat(), |r, rows| {
            rows.extend(base(r));
        })
    },
};

/// The same at f32 values.
pub const BASE_F32: Generator = Generator {
    name: "base_response_f32",
    domain: "f32: sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi| <= 2, half of them in the lobe",
    columns: 4,
    rows: |seed, n| {
        fill(seed, n, 4, recorded("base_response", true).concat(), |r, rows| {
            rows.extend(base(r).map(single));
        })
    },
};

/// sigma, lambda, width, depth, xi1, xi2, gamma_sum, mean.
pub const SCRATCH: Generator = Generator {
    name: "scratch_squared",
    domain: "sigma 10, 60 or log-uniform in 1..100 um, widths and depths of the profiles, |xi| <= 2, half of them in the lobe, means 0..1",
    columns: 8,
    rows: |seed, n| {
        fill(seed, n, 8, recorded("scratch_squared", false).concat(), |r, rows| {
            rows.extend(scratch(r));
        })
    },
};

/// The same at f32 values.
pub const SCRATCH_F32: Generator = Generator {
    name: "scratch_squared_f32",
    domain: "f32: sigma 10, 60 or log-uniform in 1..100 um, widths and depths of the profiles, |xi| <= 2, half of them in the lobe, means 0..1",
    columns: 8,
    rows: |seed, n| {
        fill(seed, n, 8, recorded("scratch_squared", true).concat(), |r, rows| {
            rows.extend(scratch(r).map(single));
        })
    },
};

/// sigma, lambda, width, depth, xi1, xi2, gamma_sum, s_t, s_b, l1, l2.
pub const WINDOWED: Generator = Generator {
    name: "response_rectangle_windowed",
    domain: "the scenes of the spatial phase, their ends finite, with the widths and depths of the profiles",
    columns: 11,
    rows: |seed, n| {
        fill(
            seed,
            n,
            11,
            recorded("response_rectangle_windowed", false).concat(),
            |r, rows| {
                let [width, depth, _, gamma_sum, _] = profile(r);
                let [sigma, lambda, xi1, xi2, s_t, s_b, l1, l2] = phase(r);
                let ends = [l1, l2].map(|l| l.clamp(-1e6, 1e6));
                rows.extend([
                    sigma, lambda, width, depth, xi1, xi2, gamma_sum, s_t, s_b, ends[0], ends[1],
                ]);
            },
        )
    },
};

/// width, offset, sigma.
pub const DENSITY: Generator = Generator {
    name: "area_density",
    domain: "widths log-uniform in 0.1..100 um, offsets to 30 sigma, sigma 10, 60 or log-uniform in 1..100 um",
    columns: 3,
    rows: |seed, n| {
        fill(seed, n, 3, recorded("area_density", false).concat(), |r, rows| {
            rows.extend(density(r));
        })
    },
};

/// The same at f32 values.
pub const DENSITY_F32: Generator = Generator {
    name: "area_density_f32",
    domain: "f32: widths log-uniform in 0.1..100 um, offsets to 30 sigma, sigma 10, 60 or log-uniform in 1..100 um",
    columns: 3,
    rows: |seed, n| {
        fill(seed, n, 3, recorded("area_density", true).concat(), |r, rows| {
            rows.extend(density(r).map(single));
        })
    },
};

/// concentration, cosine.
pub const CONE: Generator = Generator {
    name: "von_mises_fisher",
    domain: "concentrations 0 and log-uniform in 1e-12..1e6, any cosine, half of them in the lobe",
    columns: 2,
    rows: |seed, n| {
        fill(seed, n, 2, cone_rows(), |r, rows| {
            let concentration = r.log_uniform(1e-12, 1e6);
            let within = (20.0 / concentration).min(2.0);
            let cosine = if r.chance(0.5) {
                1.0 - r.uniform(0.0, within)
            } else {
                r.uniform(-1.0, 1.0)
            };
            rows.extend([concentration, cosine]);
        })
    },
};

/// u.
pub const GAUSSIAN_U: Generator = Generator {
    name: "gaussian_probabilities",
    domain: "u half uniform in (0, 1), half u or 1 - u log-uniform in 1e-300..0.5",
    columns: 1,
    rows: |seed, n| {
        fill(seed, n, 1, recorded("gaussian_inverse", false).concat(), |r, rows| {
            let tail = if r.chance(0.5) {
                r.log_uniform(1e-300, 0.5)
            } else {
                1.0 - r.log_uniform(1e-16, 0.5)
            };
            let uniform = r.uniform(1e-16, 1.0 - 1e-16);
            rows.push(if r.chance(0.5) { uniform } else { tail });
        })
    },
};

/// The same at f32 values.
pub const GAUSSIAN_U_F32: Generator = Generator {
    name: "gaussian_probabilities_f32",
    domain: "f32: u half uniform in (0, 1), half u or 1 - u log-uniform in 3e-8..0.5 and 1e-7..0.5",
    columns: 1,
    rows: |seed, n| {
        fill(seed, n, 1, recorded("gaussian_inverse", true).concat(), |r, rows| {
            let tail = if r.chance(0.5) {
                r.log_uniform(3e-8, 0.5)
            } else {
                1.0 - r.log_uniform(1e-7, 0.5)
            };
            let uniform = r.uniform(1e-7, 1.0 - 1e-7);
            rows.push(single(if r.chance(0.5) { uniform } else { tail }));
        })
    },
};

/// sigma, lambda, xi1, xi2: half of the scenes within 6 widths of the lobe.
fn light(random: &mut Random) -> [f64; 4] {
    let (sigma, lambda) = (radius(random), wavelength(random));
    let [xi1, xi2] = direction(random);
    let lobe = 6.0 * lambda / (std::f64::consts::TAU * sigma);
    let near = random.uniform(-lobe, lobe).clamp(-2.0, 2.0);
    let xi1 = if random.chance(0.5) { near } else { xi1 };
    [sigma, lambda, xi1, xi2]
}

fn infinite_phase(random: &mut Random) -> [f64; 5] {
    let [sigma, lambda, xi1, xi2] = light(random);
    let wide = random.uniform(-40.0, 40.0);
    let near = random.uniform(-4.0, 4.0);
    let across = if random.chance(0.2) { wide } else { near };
    [sigma, lambda, xi1, xi2, across * sigma]
}

fn base(random: &mut Random) -> [f64; 4] {
    let [sigma, lambda, xi1, xi2] = light(random);
    let xi2 = if random.chance(0.5) {
        xi1 * random.uniform(-1.0, 1.0)
    } else {
        xi2
    };
    [sigma, lambda, xi1, xi2]
}

fn scratch(random: &mut Random) -> [f64; 8] {
    let [sigma, lambda, xi1, _] = light(random);
    let [width, depth, xi2, gamma_sum, _] = profile(random);
    let mean = random.uniform(0.0, 1.0);
    [sigma, lambda, width, depth, xi1, xi2, gamma_sum, mean]
}

fn density(random: &mut Random) -> [f64; 3] {
    let [sigma, ..] = energy(random);
    let wide = random.uniform(-30.0, 30.0);
    let near = random.uniform(-4.0, 4.0);
    let offset = if random.chance(0.2) { wide } else { near };
    [random.log_uniform(0.1, 100.0), offset * sigma, sigma]
}

fn phase_rows(f32_only: bool) -> Vec<f64> {
    let mut rows = recorded("spatial_phase_infinite", f32_only);
    for sigma in [10.0, 60.0] {
        for xi1 in [0.0, -0.0, 1e-30, 1e-3, -2.0] {
            for s_b in [0.0, -0.0, 1e-30, sigma, -40.0 * sigma] {
                rows.push(vec![sigma, 0.55, xi1, 0.0, s_b]);
                rows.push(vec![sigma, 0.55, xi1, -0.3, s_b]);
            }
        }
    }
    kept(rows, f32_only)
}

fn depth_rows(f32_only: bool) -> Vec<f64> {
    let mut rows = recorded("depth_term", f32_only);
    for depth in [0.0, 1e-30, 0.275, 0.55, 20.0, -0.3] {
        for gamma_sum in [0.0, -0.0, 1e-30, 0.5, 1.0, 2.0] {
            rows.push(vec![depth, gamma_sum, 0.55]);
        }
    }
    kept(rows, f32_only)
}

fn cone_rows() -> Vec<f64> {
    let mut rows = recorded("von_mises_fisher_pdf", false);
    for concentration in [0.0, 1e-12, 1.0, 710.0, 1e6] {
        rows.extend([-1.0, 0.0, 1.0].map(|cosine| vec![concentration, cosine]));
    }
    kept(rows, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_scenes_lie_in_the_lobe_and_offsets_reach_beyond_the_window() {
        let rows = (INFINITE_PHASE.rows)(1, 20_000);
        let share =
            |condition: fn(&[f64]) -> bool| rows.chunks_exact(5).filter(|row| condition(row)).count() as f64 / 20_000.0;
        assert!(share(|r| r[0] / r[1] * r[2].abs() < 1.0) > 0.4);
        assert!(share(|r| r[4].abs() > 6.0 * r[0]) > 0.1 && share(|r| r[4].abs() < r[0]) > 0.1);
    }

    #[test]
    fn probabilities_lie_inside_and_reach_both_ends() {
        for (generator, least) in [(GAUSSIAN_U, 1e-15), (GAUSSIAN_U_F32, 2e-7)] {
            let rows = (generator.rows)(1, 20_000);
            assert!(rows.iter().all(|&u| 0.0 < u && u < 1.0), "{}", generator.name);
            assert!(rows.iter().any(|&u| u < least) && rows.iter().any(|&u| 1.0 - u < least));
        }
    }
}
