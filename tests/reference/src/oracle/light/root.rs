//! A root between two points where a function has opposite signs: Newton steps that may not leave the bracket.

/// Where a function is 0, to the last place or until its size is at most `floor`. `f` returns value and slope; it is
/// not positive at the first end and not negative at the second, whichever of them is larger. Starts at `start`.
pub fn bracketed_root(f: impl Fn(f64) -> [f64; 2], ends: [f64; 2], start: f64, floor: f64) -> f64 {
    let [mut below, mut above] = ends;
    let mut x = start;
    for _ in 0..100 {
        let [value, slope] = f(x);
        if value.abs() <= floor {
            // One more step is free: it uses what is known already.
            let last = x - value / slope;
            return if (last - below) * (last - above) < 0.0 { last } else { x };
        }
        if value < 0.0 {
            below = x;
        } else {
            above = x;
        }
        let newton = x - value / slope;
        // Not outside the bracket, and no NaN.
        let next = if (newton - below) * (newton - above) < 0.0 {
            newton
        } else {
            0.5 * (below + above)
        };
        if (next - x).abs() <= 1e-16 * x.abs() || next == below || next == above {
            return next;
        }
        x = next;
    }
    x
}
