//! Area density, blend, reflectances and the scratch loop's term.

use crate::scenes::{profile_row, segment_row, single, wide};
use crate::worst::Worst;
use iridescence::diffraction::{self, AreaKernel, Coherence, Profile};
use iridescence::{Complex, shader};
use reference::generate::random::Random;
use std::f64::consts::PI;

#[test]
fn the_reflectance_its_blend_and_the_scratch_loop_hold_their_bounds() {
    let mut random = Random::new(406);
    let mut density = Worst::of("area density");
    let mut scattered = Worst::of("scattered");
    let mut incoherent = Worst::of("incoherent");
    let mut coherent = Worst::of("coherent");
    let mut squared = Worst::of("scratch squared");
    for _ in 0..500_000 {
        let [radius, wavelength, xi_t, _, _, s_b, ..] = segment_row(&mut random);
        let [width, depth, xi_b, gamma, _] = profile_row(&mut random);
        let row = [radius, wavelength, width, depth, 0.02 * xi_t, xi_b, gamma];
        let [sigma, lambda, w, d, x, y, g] = wide(row);
        let coherence = Coherence {
            radius: sigma,
            wavelength: lambda,
        };
        let truth = diffraction::area_density(AreaKernel::Energy, w, f64::from(s_b), sigma);
        let peak = (w / sigma).max(1e-30);
        density.add(
            (f64::from(shader::area_density(width, s_b, radius)) - truth).abs() / peak,
            &[width, s_b, radius],
        );
        let (rho, contrast) = (single(random.uniform(0.0, 1.0)), single(random.uniform(0.0, 4.0)));
        let blend = diffraction::energy_blend(f64::from(rho), f64::from(contrast));
        let error = f64::from(shader::energy_blend_scattered(rho, contrast)) - blend.scattered;
        scattered.add(error.abs(), &[rho, contrast]);
        let error = f64::from(shader::energy_blend_base(rho, contrast)) - blend.base;
        scattered.add(error.abs(), &[rho, contrast]);
        let error = f64::from(shader::energy_blend_scratches(rho)) - blend.scratches;
        scattered.add(error.abs(), &[rho, contrast]);
        let size = random.log_uniform(1e-3, 1e4);
        let sum = [size, random.uniform(-2.0, 2.0) * size, random.uniform(-2.0, 2.0) * size].map(single);
        let [base, re, im] = wide(sum);
        let truth = diffraction::reflectance_coherent(coherence, base, Complex::new(re, im));
        let ours = f64::from(shader::reflectance_coherent(radius, wavelength, sum[0], sum[1], sum[2]));
        // The difference B - S may cancel: its terms are the measure.
        let terms = diffraction::reflectance_coherent(coherence, base.abs() + re.abs(), Complex::new(0.0, im));
        coherent.add((ours - truth).abs() / terms, &sum);
        let truth = diffraction::reflectance_incoherent(coherence, base);
        let ours = f64::from(shader::reflectance_incoherent(radius, wavelength, sum[0]));
        incoherent.add((ours - truth).abs() / truth, &[radius, wavelength, sum[0]]);
        let mean = single(random.uniform(0.0, 1.0));
        let profile = Profile { width: w, depth: d };
        let truth = diffraction::scratch_squared(coherence, profile, [x, y, g], f64::from(mean));
        let ours = shader::scratch_squared(radius, wavelength, width, depth, row[4], xi_b, gamma, mean);
        let peak = (8.0 * PI * (w * sigma).powi(2)).max(1e-30);
        squared.add((f64::from(ours) - truth).abs() / peak, &row);
    }
    density.hold(3e-7);
    scattered.hold(2e-7);
    incoherent.hold(6e-7);
    coherent.hold(1e-6);
    squared.hold(8e-7);
}
