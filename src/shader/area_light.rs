//! Area lights over the lobe of an infinite scratch, whatever part of the band they cover, in f32.
//!
//! The f32 forms of [`light`](crate::light): the integral of the lobe over a light as an integral along the light's outline,
//! whose arcs are cut to the band of the Gaussian and summed by panels of 8 Gauss-Legendre nodes. Lights that miss the
//! line xi_t = 0, end in the band or lie inside it are right like all others; where a light covers the band with room to
//! spare, the one chord of [`sphere_light_chord`](super::sphere_light_chord) costs far less.

use super::elementary::{TWO_PI, exponential};
use super::gpu::{abs, ceil, max, min, select, sqrt};
use super::light::*;
use super::sinc_squared_integral::{ARC_PI, arc_of_extent};

/// |sigma k xi_t| at the end of the band.
pub(super) const BAND_END: f32 = 3.5;
/// Measure of a panel of 8 nodes.
pub(super) const BAND_PANEL_LIMIT: f32 = 4.0;
/// Gauss-Legendre, 8 points: nodes and weights from the middle out.
pub(super) const BAND_NODE_A: f32 = 0.18343464;
/// The second node.
pub(super) const BAND_NODE_B: f32 = 0.52553242;
/// The third node.
pub(super) const BAND_NODE_C: f32 = 0.7966665;
/// The outer node.
pub(super) const BAND_NODE_D: f32 = 0.96028984;
/// Weight of the first node.
pub(super) const BAND_WEIGHT_A: f32 = 0.36268377;
/// Weight of the second node.
pub(super) const BAND_WEIGHT_B: f32 = 0.31370664;
/// Weight of the third node.
pub(super) const BAND_WEIGHT_C: f32 = 0.22238104;
/// Weight of the outer node.
pub(super) const BAND_WEIGHT_D: f32 = 0.101228535;

/// The lobe in the units of its two factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightBand {
    /// sigma k.
    pub(super) along: f32,
    /// k W/2.
    pub(super) width: f32,
    /// The view's tangent component.
    pub(super) view_t: f32,
    /// The view's bitangent component.
    pub(super) view_b: f32,
    /// The bitangent cosine from which the integral of sinc^2 counts.
    pub(super) reference: f32,
}

/// A circle on the unit sphere, projected: t = t0 + reach cos, b = b0 + cosine cos + sine sin of an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightCircle {
    /// t0.
    pub(super) centre_t: f32,
    /// b0.
    pub(super) centre_b: f32,
    /// Half the extent along the tangent.
    pub(super) reach: f32,
    /// The coefficient of the cosine in b.
    pub(super) across_cosine: f32,
    /// The coefficient of the sine in b.
    pub(super) across_sine: f32,
}

/// Cosine and sine of an angle on such a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightAngle {
    /// Cosine.
    pub(super) c: f32,
    /// Sine.
    pub(super) s: f32,
}

/// Returns the band of a view and a scratch, its reference at the direction of these bitangent components.
#[inline(always)]
pub(super) fn light_band(
    radius: f32,
    wavelength: f32,
    width: f32,
    view_t: f32,
    view_b: f32,
    reference: f32,
) -> LightBand {
    LightBand {
        along: TWO_PI * (radius / wavelength),
        width: ARC_PI * (width / wavelength),
        view_t,
        view_b,
        reference: reference + view_b,
    }
}

/// Returns the factor from sums along an outline to the integral over the light, 1 over k W/2.
#[inline(always)]
pub(super) fn light_band_scale(wavelength: f32, width: f32) -> f32 {
    wavelength / (ARC_PI * width)
}

/// Returns -exp(-t^2) Phi dt for one node of a panel, at the half-angle tangent v from the middle of a piece.
#[inline(always)]
pub(super) fn light_band_node(band: LightBand, circle: LightCircle, middle: LightAngle, v: f32) -> f32 {
    let inverse = 1.0 / (1.0 + v * v);
    let cosine = (1.0 - v * v) * inverse;
    let sine = (v + v) * inverse;
    let c = middle.c * cosine - middle.s * sine;
    let s = middle.s * cosine + middle.c * sine;
    let t = band.along * ((circle.centre_t + band.view_t) + circle.reach * c);
    let b = (circle.centre_b + band.view_b) + (circle.across_cosine * c + circle.across_sine * s);
    let way = b - band.reference;
    let phi = arc_of_extent(band.width * band.reference, band.width * b, band.width * abs(way));
    ((circle.reach * s) * (inverse + inverse)) * (exponential(-(t * t)) * phi)
}

/// Returns the integral of -exp(-t^2) Phi dt over the part in the band of a piece whose ends lie on one half turn.
pub(super) fn light_band_piece(band: LightBand, circle: LightCircle, start: LightAngle, stop: LightAngle) -> f32 {
    let offset = circle.centre_t + band.view_t;
    let t_start = band.along * (offset + circle.reach * start.c);
    let t_stop = band.along * (offset + circle.reach * stop.c);
    if min(t_start, t_stop) >= BAND_END || max(t_start, t_stop) <= -BAND_END {
        return 0.0;
    }
    let height = start.s + stop.s;
    let upper = height > 0.0 || (height == 0.0 && start.c > stop.c);
    let high = min(max((BAND_END / band.along - offset) / circle.reach, -1.0), 1.0);
    let low = min(max((-BAND_END / band.along - offset) / circle.reach, -1.0), 1.0);
    let high_s = sqrt((1.0 - high) * (1.0 + high));
    let low_s = sqrt((1.0 - low) * (1.0 + low));
    let a_c = select(select(start.c, high, t_start > BAND_END), low, t_start < -BAND_END);
    let a_size = select(
        select(abs(start.s), high_s, t_start > BAND_END),
        low_s,
        t_start < -BAND_END,
    );
    let z_c = select(select(stop.c, high, t_stop > BAND_END), low, t_stop < -BAND_END);
    let z_size = select(
        select(abs(stop.s), high_s, t_stop > BAND_END),
        low_s,
        t_stop < -BAND_END,
    );
    let a_s = select(-a_size, a_size, upper);
    let z_s = select(-z_size, z_size, upper);
    // Middle and half of the angle between: by the sum of the ends, or across their difference where they lie opposite.
    let sum_c = a_c + z_c;
    let sum_s = a_s + z_s;
    let way_c = z_c - a_c;
    let way_s = z_s - a_s;
    let length_sum = sqrt(sum_c * sum_c + sum_s * sum_s);
    let length_way = sqrt(way_c * way_c + way_s * way_s);
    let by_sum = length_sum > length_way;
    let size = 1.0 / select(length_way, length_sum, by_sum);
    let middle = LightAngle {
        c: size * select(way_s, sum_c, by_sum),
        s: size * select(-way_c, sum_s, by_sum),
    };
    // tan of half of half the angle.
    let reach_v = length_way / (2.0 + length_sum);
    let angle = 4.0 * reach_v;
    let steepest = select(max(a_size, z_size), 1.0, a_c * z_c < 0.0);
    let swing = sqrt(circle.across_cosine * circle.across_cosine + circle.across_sine * circle.across_sine);
    let slope = min(
        swing,
        abs(circle.across_sine * middle.c - circle.across_cosine * middle.s) + swing * reach_v,
    );
    let measure = 1.5 * ((band.along * circle.reach) * (steepest * angle)) + 0.5 * (band.width * (slope * angle));
    let panels = min(max(ceil(measure / BAND_PANEL_LIMIT), 1.0), 16.0);
    let panel = reach_v / panels;
    let mut sum = 0.0;
    for i in 0..16u32 {
        if (i as f32) < panels {
            let centre = (2.0 * (i as f32) + (1.0 - panels)) * panel;
            sum += BAND_WEIGHT_A
                * (light_band_node(band, circle, middle, centre - BAND_NODE_A * panel)
                    + light_band_node(band, circle, middle, centre + BAND_NODE_A * panel));
            sum += BAND_WEIGHT_B
                * (light_band_node(band, circle, middle, centre - BAND_NODE_B * panel)
                    + light_band_node(band, circle, middle, centre + BAND_NODE_B * panel));
            sum += BAND_WEIGHT_C
                * (light_band_node(band, circle, middle, centre - BAND_NODE_C * panel)
                    + light_band_node(band, circle, middle, centre + BAND_NODE_C * panel));
            sum += BAND_WEIGHT_D
                * (light_band_node(band, circle, middle, centre - BAND_NODE_D * panel)
                    + light_band_node(band, circle, middle, centre + BAND_NODE_D * panel));
        }
    }
    sum * panel
}

/// Returns the integral of -exp(-t^2) Phi dt over an arc run through in the direction of growing angles; `reflex` is 1 for an
/// arc longer than half a turn, else 0.
pub(super) fn light_band_arc(
    band: LightBand,
    circle: LightCircle,
    start: LightAngle,
    stop: LightAngle,
    reflex: f32,
) -> f32 {
    let turn = start.c * stop.s - start.s * stop.c;
    let along = start.c * stop.c + start.s * stop.s;
    let mut sum = 0.0;
    let mut at = start;
    let all_round = reflex > 0.0;
    let mut falling = start.s > 0.0 || (start.s == 0.0 && start.c > 0.0);
    let stop_falling = stop.s > 0.0 || (stop.s == 0.0 && stop.c < 0.0);
    // An arc that ends before it begins, but for rounding, has no length: by the angle between, or by t.
    let back = falling == stop_falling && select(stop.c - start.c, start.c - stop.c, falling) < 0.0;
    let mut open = all_round || along <= 0.0 || (turn > 0.0 && !back);
    let mut ends = !all_round && !back;
    for k in 0..3u32 {
        if open && k < 3u32 {
            let last = falling == stop_falling && ends;
            let corner = LightAngle {
                c: select(1.0, -1.0, falling),
                s: 0.0,
            };
            let next = LightAngle {
                c: select(corner.c, stop.c, last),
                s: select(corner.s, stop.s, last),
            };
            sum += light_band_piece(band, circle, at, next);
            at = next;
            falling = !falling;
            // Behind a turn the end is ahead, whatever its cosine is rounded to.
            ends = true;
            open = !last;
        }
    }
    sum
}

/// Returns an angle of this cosine and sine, which share a factor.
#[inline(always)]
pub(super) fn light_angle(c: f32, s: f32) -> LightAngle {
    let size = 1.0 / sqrt(c * c + s * s);
    LightAngle {
        c: c * size,
        s: s * size,
    }
}

/// Returns the angle of one turned by another, which share a factor.
#[inline(always)]
pub(super) fn light_turned(c: f32, s: f32, along: f32, aside: f32) -> LightAngle {
    light_angle(c * along - s * aside, s * along + c * aside)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a sphere, dimensionless
/// (VWH18 3.4.1, for any place of the light).
///
/// `x`, `y`, `z` is the sphere's centre, outside which the shaded point lies.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn sphere_light(
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
    let far = sqrt((x * x + y * y) + z * z);
    let sine = min(sphere_radius / far, 1.0);
    let cosine = sqrt((1.0 - sine) * (1.0 + sine));
    let cx = x / far;
    let cy = y / far;
    let cz = z / far;
    let tilt = sqrt(cy * cy + cz * cz);
    let level = sqrt(cx * cx + cy * cy);
    let flat_b = select(-(cx * cy) / tilt, cx, tilt == 0.0);
    let flat_n = select(-(cx * cz) / tilt, 0.0, tilt == 0.0);
    let side_b = select(cz / tilt, 0.0, tilt == 0.0);
    let side_n = select(-cy / tilt, 1.0, tilt == 0.0);
    let circle = LightCircle {
        centre_t: cosine * cx,
        centre_b: cosine * cy,
        reach: sine * tilt,
        across_cosine: sine * flat_b,
        across_sine: sine * side_b,
    };
    let band = light_band(radius, wavelength, width, view_t, view_b, cosine * cy);
    let highest = sine * level + cosine * cz;
    let lowest = cosine * cz - sine * level;
    let root = sqrt(max(-(lowest * highest), 0.0));
    let whole = lowest >= 0.0;
    // The circle above the horizon, from its highest point either way, and the horizon that closes it.
    let down = -(cosine * cz);
    let left = LightAngle { c: -1.0, s: 0.0 };
    let right = LightAngle { c: 1.0, s: 0.0 };
    let rise = light_turned(flat_n, side_n, down, -root);
    let setting = light_turned(flat_n, side_n, down, root);
    let mut sum = 0.0;
    if whole {
        sum = light_band_piece(band, circle, right, left) + light_band_piece(band, circle, left, right);
    } else if highest > 0.0 {
        let horizon = LightCircle {
            centre_t: 0.0,
            centre_b: 0.0,
            reach: 1.0,
            across_cosine: 0.0,
            across_sine: 1.0,
        };
        sum = light_band_arc(band, circle, rise, setting, select(0.0, 1.0, down < 0.0))
            + light_band_arc(
                band,
                horizon,
                light_turned(cx, cy, cosine, -root),
                light_turned(cx, cy, cosine, root),
                0.0,
            );
    }
    light_band_scale(wavelength, width) * max(sum, 0.0)
}

/// The outline of a polygon met so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LightOutline {
    /// The integral along it.
    pub(super) sum: f32,
    /// Where it went below the horizon, if it has not come back.
    pub(super) setting: LightPoint,
    /// 1 if it has not, else 0.
    pub(super) below: f32,
    /// Where it came up first.
    pub(super) rise: LightPoint,
    /// 1 if it came up before it went down, else 0.
    pub(super) risen: f32,
}

/// Returns the integral of -exp(-t^2) Phi dt along the visible arc from one point to another.
pub(super) fn light_outline_arc(band: LightBand, start: LightPoint, stop: LightPoint) -> f32 {
    let dx = stop.x - start.x;
    let dy = stop.y - start.y;
    let dz = stop.z - start.z;
    let nx = start.y * dz - start.z * dy;
    let ny = start.z * dx - start.x * dz;
    let nz = start.x * dy - start.y * dx;
    let tilt = sqrt(ny * ny + nz * nz);
    let size = sqrt((nx * nx + ny * ny) + nz * nz);
    let mut sum = 0.0;
    if tilt > 0.0 {
        let circle = LightCircle {
            centre_t: 0.0,
            centre_b: 0.0,
            reach: tilt / size,
            across_cosine: -(nx / size) * (ny / tilt),
            across_sine: nz / tilt,
        };
        let first = light_angle(start.x * size, nz * start.y - ny * start.z);
        let last = light_angle(stop.x * size, nz * stop.y - ny * stop.z);
        sum = light_band_arc(band, circle, first, last, 0.0);
    }
    sum
}

/// Returns the outline after one more edge of a polygon.
pub(super) fn light_outline_edge(
    outline: LightOutline,
    band: LightBand,
    start: LightPoint,
    stop: LightPoint,
) -> LightOutline {
    let mut next = outline;
    let crossing = light_horizon(start, stop);
    let up = start.z >= 0.0;
    let stays = stop.z >= 0.0;
    let first = LightPoint {
        x: select(crossing.x, start.x, up),
        y: select(crossing.y, start.y, up),
        z: select(crossing.z, start.z, up),
    };
    let last = LightPoint {
        x: select(crossing.x, stop.x, stays),
        y: select(crossing.y, stop.y, stays),
        z: select(crossing.z, stop.z, stays),
    };
    if up || stays {
        next.sum += light_outline_arc(band, first, last);
    }
    if stays && !up {
        if next.below > 0.0 {
            next.sum += light_outline_arc(band, next.setting, crossing);
            next.below = 0.0;
        } else {
            next.rise = crossing;
            next.risen = 1.0;
        }
    }
    if up && !stays {
        next.setting = crossing;
        next.below = 1.0;
    }
    next
}

/// Returns an empty outline.
#[inline(always)]
pub(super) fn light_outline() -> LightOutline {
    let none = LightPoint { x: 0.0, y: 0.0, z: 0.0 };
    LightOutline {
        sum: 0.0,
        setting: none,
        below: 0.0,
        rise: none,
        risen: 0.0,
    }
}

/// Returns the integral along a closed outline.
#[inline(always)]
pub(super) fn light_outline_closed(outline: LightOutline, band: LightBand) -> f32 {
    let mut sum = outline.sum;
    if outline.below > 0.0 && outline.risen > 0.0 {
        sum += light_outline_arc(band, outline.setting, outline.rise);
    }
    abs(sum)
}

/// Returns the bitangent component of the direction of a point, or of its projection where it is below the horizon.
#[inline(always)]
pub(super) fn light_bitangent(p: LightPoint) -> f32 {
    let far = sqrt((p.x * p.x + p.y * p.y) + p.z * p.z);
    select(p.y / far, 0.0, far == 0.0)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a triangle, dimensionless
/// (VWH18 3.4.2, for any place of the light).
///
/// The three vertices follow, either way round.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn triangle_light(
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
    let a = LightPoint { x: ax, y: ay, z: az };
    let b = LightPoint { x: bx, y: by, z: bz };
    let c = LightPoint { x: cx, y: cy, z: cz };
    let reference = light_bitangent(LightPoint {
        x: (ax + bx) + cx,
        y: (ay + by) + cy,
        z: (az + bz) + cz,
    });
    let band = light_band(radius, wavelength, width, view_t, view_b, reference);
    let mut outline = light_outline_edge(light_outline(), band, a, b);
    outline = light_outline_edge(outline, band, b, c);
    outline = light_outline_edge(outline, band, c, a);
    light_band_scale(wavelength, width) * light_outline_closed(outline, band)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a quadrilateral,
/// dimensionless (VWH18 3.4.2, for any place of the light).
///
/// The four vertices follow in order, either way round, convex or not.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn quad_light(
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
    let a = LightPoint { x: ax, y: ay, z: az };
    let b = LightPoint { x: bx, y: by, z: bz };
    let c = LightPoint { x: cx, y: cy, z: cz };
    let d = LightPoint { x: dx, y: dy, z: dz };
    let reference = light_bitangent(LightPoint {
        x: (ax + bx) + (cx + dx),
        y: (ay + by) + (cy + dy),
        z: (az + bz) + (cz + dz),
    });
    let band = light_band(radius, wavelength, width, view_t, view_b, reference);
    let mut outline = light_outline_edge(light_outline(), band, a, b);
    outline = light_outline_edge(outline, band, b, c);
    outline = light_outline_edge(outline, band, c, d);
    outline = light_outline_edge(outline, band, d, a);
    light_band_scale(wavelength, width) * light_outline_closed(outline, band)
}

/// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a polygon of three to eight
/// vertices, dimensionless (VWH18 3.4.2, for any place of the light).
///
/// `count` is the number of vertices; the vertices follow in order, either way round, convex or not; those beyond the
/// count are not read.
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn polygon_light(
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
    let a = LightPoint { x: ax, y: ay, z: az };
    let band = light_band(radius, wavelength, width, view_t, view_b, light_bitangent(a));
    let mut outline = light_outline();
    let mut last = a;
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
            outline = light_outline_edge(outline, band, last, place);
            last = place;
        }
    }
    outline = light_outline_edge(outline, band, last, a);
    light_band_scale(wavelength, width) * light_outline_closed(outline, band)
}
