//! Placement of labels beside their points so that no label touches a point, another label, a line, a
//! leader or the frame. Candidates around each point are filtered against what is fixed, then chosen
//! greedily with restarts, then improved one by one. No randomness: equal inputs give equal places.

use super::svg::Rect;

/// A straight piece of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// One end.
    pub a: [f64; 2],
    /// The other end.
    pub b: [f64; 2],
}

impl Segment {
    /// Whether the piece enters a box (Liang-Barsky clipping).
    pub fn meets_rect(&self, r: &Rect) -> bool {
        let d = [self.b[0] - self.a[0], self.b[1] - self.a[1]];
        let (mut t0, mut t1) = (0.0_f64, 1.0_f64);
        for (p, q) in [
            (-d[0], self.a[0] - r.x0),
            (d[0], r.x1 - self.a[0]),
            (-d[1], self.a[1] - r.y0),
            (d[1], r.y1 - self.a[1]),
        ] {
            if p == 0.0 {
                if q <= 0.0 {
                    return false;
                }
            } else if p < 0.0 {
                t0 = t0.max(q / p);
            } else {
                t1 = t1.min(q / p);
            }
        }
        t0 < t1
    }

    /// Whether two pieces cross.
    pub fn meets(&self, other: &Self) -> bool {
        let side = |s: &Self, p: [f64; 2]| (s.b[0] - s.a[0]) * (p[1] - s.a[1]) - (s.b[1] - s.a[1]) * (p[0] - s.a[0]);
        side(self, other.a) * side(self, other.b) < 0.0 && side(other, self.a) * side(other, self.b) < 0.0
    }
}

/// What stands on the chart before the labels come.
pub struct Fixed {
    /// Labels stay inside.
    pub bounds: Rect,
    /// Boxes of markers and of text; the first boxes belong to the labelled points, in order.
    pub rects: Vec<Rect>,
    /// Lines that labels keep off.
    pub segments: Vec<Segment>,
}

/// A text box that wants a place beside a point.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// The point.
    pub anchor: [f64; 2],
    /// Width and height of the text.
    pub size: [f64; 2],
}

/// A label in its place.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Where the text goes.
    pub rect: Rect,
    /// The line from the point to the text, where they stand apart.
    pub leader: Option<Segment>,
    cost: f64,
}

/// Clear distance around a label, in pixels.
pub const CLEARANCE: f64 = 2.0;

const RADII: [f64; 14] = [
    9.0, 12.0, 16.0, 22.0, 30.0, 40.0, 52.0, 66.0, 82.0, 100.0, 124.0, 152.0, 190.0, 240.0,
];
const DIRECTIONS: usize = 32;

fn candidates(index: usize, label: &Label, fixed: &Fixed) -> Vec<Placed> {
    let mut found = Vec::new();
    for radius in RADII {
        for step in 0..DIRECTIONS {
            let angle = step as f64 * std::f64::consts::TAU / DIRECTIONS as f64;
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let [w, h] = label.size;
            let center = [
                label.anchor[0] + radius * cos + 0.5 * w * (1.6 * cos).clamp(-1.0, 1.0),
                label.anchor[1] + radius * sin + 0.5 * h * (1.6 * sin).clamp(-1.0, 1.0),
            ];
            let rect = Rect::around(center, [0.5 * w, 0.5 * h]);
            let clear = rect.grown(CLEARANCE);
            if !clear.is_in(&fixed.bounds)
                || fixed.rects.iter().any(|r| clear.meets(r))
                || fixed.segments.iter().any(|s| s.meets_rect(&clear))
            {
                continue;
            }
            let near = rect.nearest(label.anchor);
            let d = [near[0] - label.anchor[0], near[1] - label.anchor[1]];
            let length = libm::hypot(d[0], d[1]);
            let mut cost = radius - 4.0 * cos.max(0.0) - 2.0 * libm::fabs(cos);
            let leader = (length > 14.0).then(|| Segment {
                a: [
                    label.anchor[0] + d[0] * 6.0 / length,
                    label.anchor[1] + d[1] * 6.0 / length,
                ],
                b: [near[0] - d[0] * 1.5 / length, near[1] - d[1] * 1.5 / length],
            });
            if let Some(line) = leader {
                if fixed
                    .rects
                    .iter()
                    .enumerate()
                    .any(|(i, r)| i != index && !r.holds(line.a) && line.meets_rect(r))
                {
                    continue;
                }
                cost += 10.0 + 25.0 * fixed.segments.iter().filter(|s| s.meets(&line)).count() as f64;
            }
            found.push(Placed { rect, leader, cost });
        }
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found
}

/// Whether two placed labels keep off each other, leaders included.
pub fn apart(a: &Placed, b: &Placed) -> bool {
    let (ra, rb) = (a.rect.grown(CLEARANCE), b.rect.grown(CLEARANCE));
    !ra.meets(&rb)
        && a.leader.is_none_or(|l| !l.meets_rect(&rb))
        && b.leader.is_none_or(|l| !l.meets_rect(&ra))
        && !matches!((a.leader, b.leader), (Some(x), Some(y)) if x.meets(&y))
}

/// Places for all labels, or `None` where the room does not suffice. `fixed.rects[i]` is the marker of label i.
pub fn place(labels: &[Label], fixed: &Fixed) -> Option<Vec<Placed>> {
    let options: Vec<Vec<Placed>> = labels
        .iter()
        .enumerate()
        .map(|(i, l)| candidates(i, l, fixed))
        .collect();
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|&i| options[i].len());
    let mut placed: Vec<Option<Placed>> = vec![None; labels.len()];
    'restart: for _ in 0..20 * labels.len().max(1) {
        placed.fill(None);
        for rank in 0..order.len() {
            let i = order[rank];
            let free = options[i].iter().find(|c| placed.iter().flatten().all(|p| apart(c, p)));
            match free {
                Some(place) => placed[i] = Some(*place),
                None => {
                    order.remove(rank);
                    order.insert(0, i);
                    continue 'restart;
                }
            }
        }
        let mut all: Vec<Placed> = placed.iter().flatten().copied().collect();
        for _ in 0..8 {
            for i in 0..all.len() {
                let better = options[i]
                    .iter()
                    .find(|c| all.iter().enumerate().all(|(j, p)| j == i || apart(c, p)));
                if let Some(place) = better {
                    all[i] = *place;
                }
            }
        }
        return Some(all);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crowded(count: usize) -> (Vec<Label>, Fixed) {
        let bounds = Rect {
            x0: 0.0,
            y0: 0.0,
            x1: 800.0,
            y1: 500.0,
        };
        let mut state = 12345_u64;
        let mut uniform = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let labels: Vec<Label> = (0..count)
            .map(|_| Label {
                anchor: [150.0 + 300.0 * uniform(), 150.0 + 120.0 * uniform()],
                size: [90.0, 14.0],
            })
            .collect();
        let rects = labels.iter().map(|l| Rect::around(l.anchor, [5.0, 5.0])).collect();
        let segments = vec![
            Segment {
                a: [0.0, 200.0],
                b: [800.0, 200.0],
            },
            Segment {
                a: [100.0, 400.0],
                b: [400.0, 100.0],
            },
        ];
        (
            labels,
            Fixed {
                bounds,
                rects,
                segments,
            },
        )
    }

    #[test]
    fn no_label_meets_a_marker_a_line_the_frame_or_another_label() {
        let (labels, fixed) = crowded(24);
        let placed = place(&labels, &fixed).expect("there is room");
        assert_eq!(placed.len(), labels.len());
        for (i, p) in placed.iter().enumerate() {
            assert!(p.rect.is_in(&fixed.bounds));
            assert!(fixed.rects.iter().all(|r| !p.rect.meets(r)), "label {i} on a marker");
            assert!(
                fixed.segments.iter().all(|s| !s.meets_rect(&p.rect)),
                "label {i} on a line"
            );
            for (j, q) in placed.iter().enumerate().skip(i + 1) {
                assert!(!p.rect.meets(&q.rect), "labels {i} and {j}");
                assert!(apart(p, q), "leaders of {i} and {j}");
            }
        }
    }

    #[test]
    fn without_room_there_is_no_placement() {
        let (labels, mut fixed) = crowded(24);
        fixed.bounds = Rect {
            x0: 150.0,
            y0: 150.0,
            x1: 450.0,
            y1: 270.0,
        };
        assert!(place(&labels, &fixed).is_none());
    }

    #[test]
    fn a_segment_meets_the_boxes_it_enters_only() {
        let r = Rect {
            x0: 0.0,
            y0: 0.0,
            x1: 10.0,
            y1: 10.0,
        };
        assert!(
            Segment {
                a: [-5.0, 5.0],
                b: [15.0, 5.0]
            }
            .meets_rect(&r)
        );
        assert!(
            Segment {
                a: [2.0, 2.0],
                b: [3.0, 3.0]
            }
            .meets_rect(&r)
        );
        assert!(
            !Segment {
                a: [-5.0, 11.0],
                b: [15.0, 11.0]
            }
            .meets_rect(&r)
        );
        assert!(
            !Segment {
                a: [-5.0, 4.0],
                b: [4.0, -6.0]
            }
            .meets_rect(&r)
        );
    }
}
