//! Layout of the names of points in a diagram: beside their points, and not on each other.

/// A part of the picture: left, top, right and bottom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LabelBox(pub [f64; 4]);

/// A name to be placed.
#[derive(Debug, Clone)]
pub(super) struct Label {
    /// The number of the label's point.
    pub point: usize,
    /// Width of the label.
    pub width: f64,
    /// Whether the label is placed, however crowded the place is.
    pub needed: bool,
}

/// The things in a diagram that names make room for.
#[derive(Debug, Clone)]
pub(super) struct Surroundings {
    /// The box that names stay inside of.
    pub within: LabelBox,
    /// The places of the points' marks.
    pub points: Vec<[f64; 2]>,
    /// Lines that had better stay legible, each with the cost of covering it. A name that is one mark farther from its
    /// point costs 1.
    pub lines: Vec<([[f64; 2]; 2], f64)>,
}

/// A name in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placed {
    pub frame: LabelBox,
    /// A line from the point to the name, if the name is far away or would be taken for another point's.
    pub leader: Option<[[f64; 2]; 2]>,
}

/// The height of a name.
const HEIGHT: f64 = 11.0;
/// Half the width of a mark.
const MARK: f64 = 5.5;

/// Distance of a name from the middle of its mark.
const LABEL_OFFSET: f64 = 9.5;
/// The additional distances from the mark that are tried.
const FARTHER: [f64; 5] = [0.0, 9.0, 19.0, 31.0, 45.0];
/// The shifts up and down that are tried.
const HIGHER: [f64; 6] = [0.0, 8.0, 15.0, 23.0, 32.0, 42.0];

/// The distance below which two points look like one.
const ONE: f64 = 3.0;

/// The boxes that a name may take near its point, each with its cost above that of the best box.
fn places([x, y]: [f64; 2], width: f64) -> Vec<(f64, LabelBox)> {
    let (w, h) = (width / 2.0, HEIGHT / 2.0);
    let around = |cx: f64, cy: f64| LabelBox([cx - w, cy - h, cx + w, cy + h]);
    let mut out = Vec::new();
    for farther in FARTHER {
        let cost = farther / 9.0;
        let out_to = LABEL_OFFSET + farther;
        for higher in HIGHER {
            // A name above or below comes nearer: its corner is then about as near as its edge would be.
            let across = if higher > 0.0 {
                out_to - 0.3 * LABEL_OFFSET
            } else {
                out_to
            };
            let cost = cost + higher / 12.0;
            for (side, up, more) in [
                (1.0, -1.0, 0.0),
                (1.0, 1.0, 0.1),
                (-1.0, -1.0, 0.3),
                (-1.0, 1.0, 0.4),
            ] {
                out.push((
                    cost + more,
                    around(x + side * (across + w), y + up * higher),
                ));
            }
        }
        out.push((cost + 0.6, around(x, y - out_to - h)));
        out.push((cost + 0.7, around(x, y + out_to + h)));
    }
    out
}

impl LabelBox {
    fn meets(self, other: LabelBox) -> bool {
        let (LabelBox([l, t, r, b]), LabelBox([ol, ot, or, ob])) = (self, other);
        l < or && ol < r && t < ob && ot < b
    }

    fn holds(self, other: LabelBox) -> bool {
        let (LabelBox([l, t, r, b]), LabelBox([ol, ot, or, ob])) = (self, other);
        l <= ol && or <= r && t <= ot && ob <= b
    }

    /// The point of the box that is nearest to a place.
    fn nearest(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let LabelBox([l, t, r, b]) = self;
        [x.clamp(l, r), y.clamp(t, b)]
    }

    fn distance(self, place: [f64; 2]) -> f64 {
        let [x, y] = self.nearest(place);
        (x - place[0]).hypot(y - place[1])
    }

    /// Whether a line runs through the box (Liang and Barsky, 1984).
    fn is_crossed(self, [[x0, y0], [x1, y1]]: [[f64; 2]; 2]) -> bool {
        let LabelBox([l, t, r, b]) = self;
        let (dx, dy) = (x1 - x0, y1 - y0);
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for (d, q) in [(-dx, x0 - l), (dx, r - x0), (-dy, y0 - t), (dy, b - y0)] {
            if d == 0.0 && q < 0.0 {
                return false;
            }
            if d < 0.0 {
                from = from.max(q / d);
            } else if d > 0.0 {
                to = to.min(q / d);
            }
        }
        from < to
    }
}

/// Places names one after the other, the needed ones first; `None` for a name that finds no room.
pub(super) fn place(labels: &[Label], around: &Surroundings) -> Vec<Option<Placed>> {
    let mut out: Vec<Option<Placed>> = vec![None; labels.len()];
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|&i| !labels[i].needed);
    for i in order {
        let taken: Vec<Placed> = out.iter().flatten().copied().collect();
        out[i] = best(&labels[i], around, &taken);
    }
    out
}

fn best(label: &Label, around: &Surroundings, taken: &[Placed]) -> Option<Placed> {
    let mut best: Option<(f64, Placed)> = None;
    for (farther, frame) in places(around.points[label.point], label.width) {
        if !around.within.holds(frame) {
            continue;
        }
        let (cost, placed) = judged(label, around, taken, frame);
        if best.is_none_or(|(least, _)| cost + farther < least) {
            best = Some((cost + farther, placed));
        }
    }
    let (cost, placed) = best?;
    (cost < COVERED || label.needed).then_some(placed)
}

/// Cost of covering a mark or another name: more than all other costs together.
const COVERED: f64 = 1e3;

/// Cost of a name that is nearer to another point than to its own.
const ASTRAY: f64 = 3.0;

fn judged(
    label: &Label,
    around: &Surroundings,
    taken: &[Placed],
    frame: LabelBox,
) -> (f64, Placed) {
    let own = around.points[label.point];
    let distance = frame.distance(own);
    let mut cost = 0.0;
    let others = || {
        let is_other = |p: &&[f64; 2]| (p[0] - own[0]).hypot(p[1] - own[1]) > ONE;
        around.points.iter().filter(is_other)
    };
    for &[x, y] in &around.points {
        if frame.meets(LabelBox([x - MARK, y - MARK, x + MARK, y + MARK])) {
            cost += COVERED;
        }
    }
    let is_astray = others().any(|p| frame.distance(*p) < distance + 2.0);
    if is_astray {
        cost += ASTRAY;
    }
    let leader = (is_astray || distance > 2.0 * LABEL_OFFSET).then(|| {
        // The leader begins at the edge of the mark.
        let end = frame.nearest(own);
        let share = MARK / distance.max(MARK);
        [[0, 1].map(|i| own[i] + share * (end[i] - own[i])), end]
    });
    if let Some(line) = leader {
        let mark = MARK - ONE / 2.0;
        let is_crossed =
            |[x, y]: &[f64; 2]| LabelBox([x - mark, y - mark, x + mark, y + mark]).is_crossed(line);
        if others().any(is_crossed) {
            cost += COVERED;
        }
    }
    for other in taken {
        let covers = other.leader.is_some_and(|line| frame.is_crossed(line));
        let covered = leader.is_some_and(|line| other.frame.is_crossed(line));
        if frame.meets(other.frame) || covers || covered {
            cost += COVERED;
        }
    }
    for &(line, weight) in &around.lines {
        if frame.is_crossed(line) {
            cost += weight;
        }
    }
    (cost, Placed { frame, leader })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn around(points: &[[f64; 2]]) -> Surroundings {
        Surroundings {
            within: LabelBox([0.0, 0.0, 300.0, 200.0]),
            points: points.to_vec(),
            lines: Vec::new(),
        }
    }

    fn label(point: usize, width: f64) -> Label {
        Label {
            point,
            width,
            needed: false,
        }
    }

    /// Checks the invariants of names wherever they are placed.
    fn check(labels: &[Label], around: &Surroundings) -> Vec<Option<Placed>> {
        let all = place(labels, around);
        for (label, placed) in labels.iter().zip(&all) {
            let Some(placed) = placed else { continue };
            assert!(around.within.holds(placed.frame));
            let own = around.points[label.point];
            let is_nearest = around.points.iter().all(|p| {
                (p[0] - own[0]).hypot(p[1] - own[1]) <= ONE
                    || placed.frame.distance(*p) > placed.frame.distance(own)
            });
            assert!(is_nearest || placed.leader.is_some(), "{label:?}");
        }
        let frames: Vec<LabelBox> = all.iter().flatten().map(|p| p.frame).collect();
        for (i, a) in frames.iter().enumerate() {
            assert!(frames[i + 1..].iter().all(|b| !a.meets(*b)));
        }
        all
    }

    #[test]
    fn one_stands_at_the_right_or_where_there_is_room() {
        let LabelBox([left, top, right, bottom]) =
            check(&[label(0, 30.0)], &around(&[[100.0, 100.0]]))[0]
                .unwrap()
                .frame;
        assert_eq!((left, right), (109.5, 139.5));
        assert_eq!((top + bottom) / 2.0, 100.0);
        let LabelBox([_, _, right, _]) = check(&[label(0, 30.0)], &around(&[[290.0, 100.0]]))[0]
            .unwrap()
            .frame;
        assert_eq!(right, 280.5);
        // A line at its right is worse than a place a little higher.
        let mut lined = around(&[[100.0, 100.0]]);
        lined.lines.push(([[105.0, 100.0], [200.0, 100.0]], 1.0));
        let frame = check(&[label(0, 30.0)], &lined)[0].unwrap().frame;
        assert!(!frame.is_crossed(lined.lines[0].0));
    }

    /// Two marks nearly on each other: each name has its own, and both are there.
    #[test]
    fn names_of_points_that_are_near_each_other_are_told_apart() {
        let points = [[28.0, 100.0], [28.0, 108.0]];
        let all = check(&[label(0, 56.0), label(1, 19.0)], &around(&points));
        assert!(all.iter().all(Option::is_some));
    }

    /// Four marks in a column: no leader runs through another's mark.
    #[test]
    fn leaders_lead_to_one_point() {
        let points = [[28.0, 100.0], [28.0, 107.0], [28.0, 107.1], [28.0, 90.0]];
        let labels: Vec<Label> = (0..4).map(|i| label(i, 60.0)).collect();
        let all = check(&labels, &around(&points));
        for (label, placed) in labels.iter().zip(all) {
            let Some(line) = placed.unwrap().leader else {
                continue;
            };
            for [x, y] in points {
                let is_other = (y - points[label.point][1]).abs() > ONE;
                assert!(
                    !is_other || !LabelBox([x - 3.0, y - 3.0, x + 3.0, y + 3.0]).is_crossed(line)
                );
            }
        }
    }

    #[test]
    fn in_a_crowd_some_are_left_out_but_never_those_that_are_needed() {
        let points: Vec<[f64; 2]> = (0..60)
            .map(|i| {
                [
                    100.0 + f64::from(i % 8) * 9.0,
                    80.0 + f64::from(i / 8) * 8.0,
                ]
            })
            .collect();
        let mut labels: Vec<Label> = (0..60).map(|i| label(i, 40.0)).collect();
        labels[37].needed = true;
        let all = check(&labels, &around(&points));
        assert!(all[37].is_some());
        let count = all.iter().flatten().count();
        assert!((8..40).contains(&count), "{count}");
    }

    #[test]
    fn lines_and_frames() {
        let frame = LabelBox([0.0, 0.0, 10.0, 10.0]);
        for (line, is_crossed) in [
            ([[-5.0, 5.0], [15.0, 5.0]], true),
            ([[-5.0, -5.0], [15.0, 15.0]], true),
            ([[4.0, 4.0], [5.0, 5.0]], true),
            ([[-5.0, 11.0], [15.0, 11.0]], false),
            ([[-5.0, 5.0], [-1.0, 5.0]], false),
            ([[-6.0, 2.0], [2.0, -6.0]], false),
        ] {
            assert_eq!(frame.is_crossed(line), is_crossed, "{line:?}");
        }
    }
}
