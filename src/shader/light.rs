//! Area lights over the lobe of an infinite scratch, one chord each, in f32.
//!
//! The f32 forms of [`light`](crate::light). Where the light covers the band |xi_t| < 3/(sqrt 2 sigma k) with room to
//! spare, the integral of the lobe over it is a Gaussian's times an integral of sinc^2 along the chord xi_t = 0 (VWH18 Eq. 27).
//! Chords are algebraic and keep the digits of tiny lights; parts below the horizon are cut off. The view is the
//! direction towards the eye projected on the surface, positions are relative to the shaded point; lengths of the scratch
//! share one unit with the wavelength, positions may have another.

use super::gpu::{abs, max, min, select, sqrt};
use super::sinc_squared_integral::{ARC_PI, arc_of_extent};

/// 1/(2 sqrt(pi)).
pub(super) const LIGHT_HALF_INVERSE_ROOT_PI: f32 = 0.2820948;

/// A point or a direction relative to the shaded point: tangent, bitangent, normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightPoint {
    /// Along the tangent.
    pub(super) x: f32,
    /// Along the bitangent.
    pub(super) y: f32,
    /// Along the normal.
    pub(super) z: f32,
}

/// The line xi_t = 0 across a light, and what counts along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightLine {
    /// The tangent component of the light's direction on the line.
    pub(super) x: f32,
    /// 1 - x^2.
    pub(super) rest: f32,
    /// The view's bitangent component.
    pub(super) view: f32,
    /// k W/2.
    pub(super) width: f32,
}

/// The chords of a polygon met so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightChords {
    /// The integral over the complete ones.
    pub(super) sum: f32,
    /// Where the last one begins, if it has no end yet: the bitangent component of the direction.
    pub(super) begin_b: f32,
    /// The normal component.
    pub(super) begin_n: f32,
    /// Whether it has none: then 1, else 0.
    pub(super) open: f32,
    /// Where the outline went below the horizon, if it has not come back.
    pub(super) setting: LightPoint,
    /// 1 if it has not, else 0.
    pub(super) below: f32,
    /// Where the outline came up first.
    pub(super) rise: LightPoint,
    /// 1 if it came up before it went down, else 0.
    pub(super) risen: f32,
}

/// Returns the line xi_t = 0 for a view and a scratch.
#[inline(always)]
pub(super) fn light_line(wavelength: f32, width: f32, view_t: f32, view_b: f32) -> LightLine {
    LightLine {
        x: -view_t,
        rest: max((1.0 - view_t) * (1.0 + view_t), 0.0),
        view: view_b,
        width: ARC_PI * (width / wavelength),
    }
}

/// Returns the band's Gaussian integral over k W/2: what turns an arc of sinc^2 into the integral over a light.
#[inline(always)]
pub(super) fn light_scale(radius: f32, wavelength: f32, width: f32) -> f32 {
    LIGHT_HALF_INVERSE_ROOT_PI * (wavelength / radius) * (wavelength / (ARC_PI * width))
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a sphere that covers the band, by the chord at
/// xi_t = 0, dimensionless (VWH18 3.4.1 with the true tangent cone).
///
/// `x`, `y`, `z` is the sphere's centre. A sphere that the line misses gives 0; one that contains the shaded point has
/// no chord.
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn sphere_light_chord(
    radius: f32,
    wavelength: f32,
    width: f32,
    view_t: f32,
    view_b: f32,
    x: f32,
    y: f32,
    z: f32,
    sphere_radius: f32,
) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    // All in squares of lengths: the distance itself is not needed.
    let tilt = y * y + z * z;
    let square = x * x + tilt;
    let tangent = sqrt(max(square - sphere_radius * sphere_radius, 0.0));
    let per_square = 1.0 / square;
    let per_tilt = 1.0 / tilt;
    // The distance of the line from the axis, against how far the cone reaches.
    let p = cut.x - (tangent * per_square) * x;
    let sine = sphere_radius * per_square;
    let discriminant = (sine * sine) * tilt - p * p;
    let root = sqrt(max(discriminant, 0.0) * square) * per_tilt;
    let level = tangent * per_square - (p * per_tilt) * x;
    let centre_b = y * level;
    let reach_b = z * root;
    let left_z = z * level + y * root;
    let right_z = z * level - y * root;
    let met = discriminant > 0.0;
    let left_up = left_z >= 0.0 && met;
    let right_up = right_z >= 0.0 && met;
    let above = left_up && right_up;
    let mut left = centre_b - reach_b;
    let mut right = centre_b + reach_b;
    let mut extent = abs(reach_b + reach_b);
    let mut gap = 0.0;
    let mut seen = true;
    if !above || reach_b < 0.0 {
        let edge = sqrt(cut.rest);
        // Without an end above the horizon the line is all inside the cone or all outside.
        let depth = level * tilt;
        let inside = select(depth, depth + abs(y) * edge, met) < 0.0;
        seen = left_up || right_up || inside;
        left = select(-edge, min(max(left, -edge), edge), left_up);
        right = select(edge, min(max(right, -edge), edge), right_up);
        extent = select(abs(right - left), extent, above);
        if above {
            // A light that goes down at both ends is the whole line less the gap.
            gap = arc_of_extent(
                cut.width * (cut.view - edge),
                cut.width * (cut.view + edge),
                cut.width * (edge + edge),
            );
        }
    }
    let arc = arc_of_extent(
        cut.width * (left + cut.view),
        cut.width * (right + cut.view),
        cut.width * extent,
    );
    let value = select(0.0, gap + arc, seen);
    light_scale(radius, wavelength, width) * max(value, 0.0)
}

/// Returns where an outline has met the line once more, at a direction of these two components: the chord it ends, or
/// the beginning of the next.
#[inline(always)]
pub(super) fn light_crossing(chords: LightChords, cut: LightLine, b: f32, n: f32, direction: f32) -> LightChords {
    let mut next = chords;
    if chords.open > 0.0 {
        next.begin_b = b;
        next.begin_n = n;
        next.open = 0.0;
    } else {
        // Both lie on the circle b^2 + n^2 = 1 - x^2: near the horizon the difference of the normals says more.
        let sum_b = abs(b + chords.begin_b);
        let sum_n = abs(n + chords.begin_n);
        let by_normals = abs(n - chords.begin_n) * sum_n / sum_b;
        let extent = select(abs(b - chords.begin_b), by_normals, sum_n < sum_b);
        let arc = arc_of_extent(
            cut.width * (chords.begin_b + cut.view),
            cut.width * (b + cut.view),
            cut.width * extent,
        );
        next.sum = chords.sum + direction * arc;
        next.open = 1.0;
    }
    next
}

/// Returns on which side of the line a point is: 1 or -1.
#[inline(always)]
pub(super) fn light_side(cut: LightLine, p: LightPoint) -> f32 {
    select(
        -1.0,
        1.0,
        p.x - cut.x * sqrt((p.x * p.x + p.y * p.y) + p.z * p.z) >= 0.0,
    )
}

/// Returns the chords after the visible arc from one point to another, whose sides are known.
pub(super) fn light_arc(
    chords: LightChords,
    cut: LightLine,
    start: LightPoint,
    stop: LightPoint,
    start_side: f32,
    stop_side: f32,
) -> LightChords {
    let mut next = chords;
    // The normal of the great circle, by the difference of its ends: exact for near ones.
    let dx = stop.x - start.x;
    let dy = stop.y - start.y;
    let dz = stop.z - start.z;
    let nx = start.y * dz - start.z * dy;
    let ny = start.z * dx - start.x * dz;
    let nz = start.x * dy - start.y * dx;
    let tilt = ny * ny + nz * nz;
    let offset = cut.x * nx;
    let discriminant = tilt * cut.rest - offset * offset;
    // The motion in x at the ends: towards the line at the first, away from it at the second.
    let leaving = start_side * (nz * start.y - ny * start.z);
    let returning = start_side * (nz * stop.y - ny * stop.z);
    let twice = start_side == stop_side && discriminant > 0.0 && leaving > 0.0 && returning < 0.0;
    if twice || start_side != stop_side {
        let root = sqrt(max(discriminant, 0.0));
        let inverse = 1.0 / tilt;
        // The first crossing leaves the side of the first end.
        let base_b = -(offset * ny);
        let base_n = -(offset * nz);
        let move_b = start_side * (nz * root);
        let move_n = start_side * (ny * root);
        let no_plane = tilt == 0.0;
        let b = select((base_b + move_b) * inverse, start.y, no_plane);
        let n = select((base_n - move_n) * inverse, start.z, no_plane);
        next = light_crossing(next, cut, b, n, start_side);
        if twice {
            next = light_crossing(
                next,
                cut,
                (base_b - move_b) * inverse,
                (base_n + move_n) * inverse,
                -start_side,
            );
        }
    }
    next
}

/// Returns the point of an edge at the horizon: between its ends, and of their size.
#[inline(always)]
pub(super) fn light_horizon(start: LightPoint, stop: LightPoint) -> LightPoint {
    let whole = abs(stop.z) + abs(start.z);
    let a = abs(stop.z) / whole;
    let b = abs(start.z) / whole;
    LightPoint {
        x: start.x * a + stop.x * b,
        y: start.y * a + stop.y * b,
        z: 0.0,
    }
}

/// Returns the chords after one more edge of a polygon.
pub(super) fn light_edge(
    chords: LightChords,
    cut: LightLine,
    start: LightPoint,
    stop: LightPoint,
    start_side: f32,
    stop_side: f32,
) -> LightChords {
    let mut next = chords;
    if start.z >= 0.0 && stop.z >= 0.0 {
        next = light_arc(next, cut, start, stop, start_side, stop_side);
    } else if start.z >= 0.0 {
        let setting = light_horizon(start, stop);
        next = light_arc(next, cut, start, setting, start_side, light_side(cut, setting));
        next.setting = setting;
        next.below = 1.0;
    } else if stop.z >= 0.0 {
        let rise = light_horizon(start, stop);
        let side = light_side(cut, rise);
        if next.below > 0.0 {
            next = light_arc(next, cut, next.setting, rise, light_side(cut, next.setting), side);
            next.below = 0.0;
        } else {
            next.rise = rise;
            next.risen = 1.0;
        }
        next = light_arc(next, cut, rise, stop, side, stop_side);
    }
    next
}

/// Returns no chords.
#[inline(always)]
pub(super) fn light_chords() -> LightChords {
    let none = LightPoint { x: 0.0, y: 0.0, z: 0.0 };
    LightChords {
        sum: 0.0,
        begin_b: 0.0,
        begin_n: 0.0,
        open: 1.0,
        setting: none,
        below: 0.0,
        rise: none,
        risen: 0.0,
    }
}

/// Returns the integral over all chords of a closed outline.
#[inline(always)]
pub(super) fn light_closed(chords: LightChords, cut: LightLine) -> f32 {
    let mut inside = chords;
    if inside.below > 0.0 && inside.risen > 0.0 {
        inside = light_arc(
            inside,
            cut,
            inside.setting,
            inside.rise,
            light_side(cut, inside.setting),
            light_side(cut, inside.rise),
        );
    }
    abs(inside.sum)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a triangle that covers the band, by the chord at
/// xi_t = 0, dimensionless (VWH18 3.4.2).
///
/// The three vertices follow, either way round. A triangle that the line misses gives 0.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn triangle_light_chord(
    radius: f32,
    wavelength: f32,
    width: f32,
    view_t: f32,
    view_b: f32,
    ax: f32,
    ay: f32,
    az: f32,
    bx: f32,
    by: f32,
    bz: f32,
    cx: f32,
    cy: f32,
    cz: f32,
) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let a = LightPoint { x: ax, y: ay, z: az };
    let b = LightPoint { x: bx, y: by, z: bz };
    let c = LightPoint { x: cx, y: cy, z: cz };
    let side_a = light_side(cut, a);
    let side_b = light_side(cut, b);
    let side_c = light_side(cut, c);
    let first = light_edge(light_chords(), cut, a, b, side_a, side_b);
    let second = light_edge(first, cut, b, c, side_b, side_c);
    let third = light_edge(second, cut, c, a, side_c, side_a);
    light_scale(radius, wavelength, width) * light_closed(third, cut)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a quadrilateral that covers the band, by the
/// chords at xi_t = 0, dimensionless (VWH18 3.4.2).
///
/// The four vertices follow in order, either way round, convex or not. A quadrilateral that the line misses gives 0.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn quad_light_chord(
    radius: f32,
    wavelength: f32,
    width: f32,
    view_t: f32,
    view_b: f32,
    ax: f32,
    ay: f32,
    az: f32,
    bx: f32,
    by: f32,
    bz: f32,
    cx: f32,
    cy: f32,
    cz: f32,
    dx: f32,
    dy: f32,
    dz: f32,
) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let a = LightPoint { x: ax, y: ay, z: az };
    let b = LightPoint { x: bx, y: by, z: bz };
    let c = LightPoint { x: cx, y: cy, z: cz };
    let d = LightPoint { x: dx, y: dy, z: dz };
    let side_a = light_side(cut, a);
    let side_b = light_side(cut, b);
    let side_c = light_side(cut, c);
    let side_d = light_side(cut, d);
    let first = light_edge(light_chords(), cut, a, b, side_a, side_b);
    let second = light_edge(first, cut, b, c, side_b, side_c);
    let third = light_edge(second, cut, c, d, side_c, side_d);
    let fourth = light_edge(third, cut, d, a, side_d, side_a);
    light_scale(radius, wavelength, width) * light_closed(fourth, cut)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a polygon of three to eight vertices that covers
/// the band, by the chords at xi_t = 0, dimensionless (VWH18 3.4.2).
///
/// `count` is the number of vertices; the vertices follow in order, either way round, convex or not; those beyond the
/// count are not read. A polygon that the line misses gives 0.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn polygon_light_chord(
    radius: f32,
    wavelength: f32,
    width: f32,
    view_t: f32,
    view_b: f32,
    count: f32,
    ax: f32,
    ay: f32,
    az: f32,
    bx: f32,
    by: f32,
    bz: f32,
    cx: f32,
    cy: f32,
    cz: f32,
    dx: f32,
    dy: f32,
    dz: f32,
    ex: f32,
    ey: f32,
    ez: f32,
    fx: f32,
    fy: f32,
    fz: f32,
    gx: f32,
    gy: f32,
    gz: f32,
    hx: f32,
    hy: f32,
    hz: f32,
) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let a = LightPoint { x: ax, y: ay, z: az };
    let first_side = light_side(cut, a);
    let mut chords = light_chords();
    let mut last = a;
    let mut last_side = first_side;
    for i in 1..8u32 {
        if (i as f32) < count {
            let x = select(
                select(select(bx, cx, i == 2u32), select(dx, ex, i == 4u32), i > 2u32),
                select(fx, select(gx, hx, i == 7u32), i > 5u32),
                i > 4u32,
            );
            let y = select(
                select(select(by, cy, i == 2u32), select(dy, ey, i == 4u32), i > 2u32),
                select(fy, select(gy, hy, i == 7u32), i > 5u32),
                i > 4u32,
            );
            let z = select(
                select(select(bz, cz, i == 2u32), select(dz, ez, i == 4u32), i > 2u32),
                select(fz, select(gz, hz, i == 7u32), i > 5u32),
                i > 4u32,
            );
            let place = LightPoint { x, y, z };
            let side = light_side(cut, place);
            chords = light_edge(chords, cut, last, place, last_side, side);
            last = place;
            last_side = side;
        }
    }
    chords = light_edge(chords, cut, last, a, last_side, first_side);
    light_scale(radius, wavelength, width) * light_closed(chords, cut)
}
