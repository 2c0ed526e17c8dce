//! Intersections and differences of a few convex shapes with lanes: where four rays meet the whole first.
//!
//! A ray meets each shape in one chord. It is in all of the first operands from the last way in to the first way out.
//! If the last way in is in a cut, the whole begins where the ray comes out of the cut; if that place is in another
//! cut, the ray has to come out of that, and so on. The crossings are not sorted: only the place that is found is
//! compared with the others.

use super::block::{Shapes, shapes};
use super::expand::Operands;
use super::lanes::{ALL, LANES, Lanes, either, is_greater, is_less, mask};
use super::leaf::{Kind, Leaf};
use super::packet::{Ahead, Packet};
use super::probe::{Chords, Probe};
use super::query::{BENT, Crossing, End, UNKNOWN_FACE};
use crate::geometry::affine::Placement;
use crate::trace::shapes::Root;

/// The operands of an intersection, the cuts last.
#[derive(Debug)]
pub struct Spans(Box<[Operand]>);

/// A shape in all four lanes.
#[derive(Debug)]
struct Operand {
    shapes: Shapes,
    number: u32,
    is_cut: bool,
}

/// The most operands of spans. Intersections with more are walked one ray at a time: most of their operands are far
/// from each ray.
const MAX_OPERANDS: usize = 6;

impl Spans {
    /// How many operands there are.
    pub fn count(&self) -> u32 {
        self.0.len() as u32
    }

    /// `None` unless the intersection consists of a few shapes with lanes, without operations inside.
    pub fn new(leaves: &[Leaf], operands: &Operands) -> Option<Spans> {
        let mut numbers: Vec<u32> = operands.all().take(MAX_OPERANDS + 1).collect();
        let leaf = |number: u32| &leaves[number as usize];
        let has_lanes = |&number: &u32| !matches!(leaf(number).kind, Kind::Other | Kind::Csg);
        let is_simple = operands.gates.len() == 1
            && !operands.firsts.is_empty()
            && numbers.len() <= MAX_OPERANDS
            && numbers.iter().all(has_lanes);
        numbers.sort_by_key(|&number| leaf(number).is_cut);
        let operand = |number: u32| Operand {
            shapes: shapes(&[leaf(number); LANES]),
            number,
            is_cut: leaf(number).is_cut,
        };
        is_simple.then(|| Spans(numbers.into_iter().map(operand).collect()))
    }
}

/// The stretches of four rays in a convex shape. `near` is −∞ for a ray that starts in the shape. A ray that misses it
/// has `near` = ∞ and `far` = −∞.
#[derive(Clone, Copy)]
struct Chord {
    near: Lanes,
    near_error: Lanes,
    far: Lanes,
    far_error: Lanes,
}

impl Chord {
    const NOWHERE: Chord = Chord {
        near: Lanes::new([f64::INFINITY; LANES]),
        near_error: Lanes::ZERO,
        far: Lanes::new([f64::NEG_INFINITY; LANES]),
        far_error: Lanes::ZERO,
    };

    /// The chord of each ray of a packet before t = `to`, and, as bits, the rays whose chords are known. `probe` holds
    /// the rays in the leaf's space.
    #[inline(always)]
    fn new(
        packet: &Packet,
        probe: &Probe<Lanes>,
        (shapes, leaf): (&Shapes, &Leaf),
        to: Lanes,
    ) -> (Chord, u32) {
        let splat = Lanes::splat;
        let here = packet.on(leaf);
        let goes_in = here & packet.goes_in;
        let size = (probe.reach + splat(leaf.extent)) * probe.per_pace + splat(1.0);
        let hair = splat(BENT) * size;
        let Chords {
            maybe,
            sure,
            near,
            far,
        } = shapes.chords(probe, -(packet.skin + hair), to + hair);
        // A ray that leaves a convex leaf does not meet it again.
        let maybe = maybe & !(here & !goes_in);
        if maybe == 0 {
            return (Chord::NOWHERE, ALL);
        }
        let [near_error, far_error] = [
            leaf.errors(probe, near, true),
            leaf.errors(probe, far, false),
        ];
        let [to_near, to_far] = [near_error, far_error].map(|error| packet.skin + error);
        let starts_in = mask(goes_in) | is_less(near, -to_near);
        let is_over = is_less(far, -to_far) & !mask(goes_in);
        // The ray starts on the near end of the chord, which has an error, too.
        let least = either(mask(goes_in), to_far + to_far, to_far);
        let is_told = (starts_in | is_greater(near, to_near)) & (is_over | is_greater(far, least));
        let nowhere = !mask(maybe) | is_over;
        let chord = Chord {
            near: either(
                nowhere,
                splat(f64::INFINITY),
                either(starts_in, splat(f64::NEG_INFINITY), near),
            ),
            near_error: either(nowhere | starts_in, Lanes::ZERO, near_error),
            far: either(nowhere, splat(f64::NEG_INFINITY), far),
            far_error: either(nowhere, Lanes::ZERO, far_error),
        };
        (chord, !maybe | sure & is_told.to_bitmask())
    }
}

/// The places where four rays meet an intersection.
pub struct Entry<'s> {
    pub ahead: Ahead,
    /// The rays for which this simple way finds no answer, as bits.
    pub rest: u32,
    spans: &'s Spans,
    /// The index of the operand that each ray meets there.
    operands: Lanes,
}

impl Entry<'_> {
    /// The place where the ray in a lane meets the whole. The ray has to be in `ahead.met`.
    #[inline(always)]
    pub fn crossing(&self, lane: usize) -> Crossing {
        let [t, error, operand] =
            [self.ahead.t, self.ahead.error, self.operands].map(|lanes| lanes.to_array()[lane]);
        let operand = &self.spans.0[operand as usize];
        Crossing {
            surface: operand.number,
            root: Root {
                t,
                face: UNKNOWN_FACE,
            },
            end: End { t, error },
            is_exit: operand.is_cut,
        }
    }
}

impl Spans {
    /// Finds where `rays` meet the intersection first, before t = `to`. They start outside of it. Places behind `to`
    /// may be missing.
    #[inline(never)]
    pub fn entry(
        &self,
        (leaves, placements): (&[Leaf], &[Placement]),
        packet: &Packet,
        to: Lanes,
        rays: u32,
    ) -> Entry<'_> {
        let splat = Lanes::splat;
        let (zero, infinity) = (Lanes::ZERO, splat(f64::INFINITY));
        let mut chords = [Chord::NOWHERE; MAX_OPERANDS];
        // The rays that surely miss the whole, and the rays that are in doubt, as bits.
        let (mut beside, mut doubt) = (0, 0);
        // The last way in, and bounds: no last way in is before `least`, and no other way in is behind `others`.
        let (mut t, mut error, mut operands) = (-infinity, zero, splat(-1.0));
        let (mut least, mut others) = (-infinity, -infinity);
        // The first way out is between these.
        let (mut out_least, mut out_most) = (infinity, infinity);
        let mut moved = None;
        for (i, (operand, chord)) in self.0.iter().zip(&mut chords).enumerate() {
            if rays & !beside == 0 {
                break;
            }
            let leaf = &leaves[operand.number as usize];
            let probe = packet.in_space(placements, leaf.placement, &mut moved);
            let is_known;
            (*chord, is_known) = Chord::new(packet, probe, (&operand.shapes, leaf), to);
            doubt |= rays & !is_known;
            if operand.is_cut {
                continue;
            }
            let known = mask(is_known);
            let is_missed = is_greater(chord.near, chord.far).to_bitmask();
            beside |= rays & is_known & is_missed;
            let near = either(known, chord.near, -infinity);
            let is_later = is_greater(near, t);
            let other = either(is_later, t + error, near + chord.near_error);
            others = either(is_greater(other, others), other, others);
            t = either(is_later, near, t);
            error = either(is_later, chord.near_error, error);
            operands = either(is_later, splat(i as f64), operands);
            least = least.fast_max(either(known, near - chord.near_error, -infinity));
            let far = |error: Lanes| either(known, chord.far + error, infinity);
            out_least = out_least.fast_min(far(-chord.far_error));
            out_most = out_most.fast_min(far(chord.far_error));
            beside |= rays & is_greater(least, out_most).to_bitmask();
        }
        let starts_in = is_less(t, -packet.skin);
        let is_last = starts_in | is_less(others, t - error);
        t = either(starts_in, zero, t);
        error = either(starts_in, packet.skin, error);
        doubt |= rays & !is_last.to_bitmask();
        let cuts = || self.0.iter().zip(&chords).enumerate();
        let mut open = rays & !beside & !doubt;
        // In each round some ray comes out of a cut for good.
        let mut has_moved = true;
        while std::mem::take(&mut has_moved) && open != 0 {
            for (i, (_, cut)) in cuts().filter(|(_, (operand, _))| operand.is_cut) {
                let number = splat(i as f64);
                let is_here = operands.simd_eq(number);
                let is_behind = is_less(cut.near + cut.near_error, t - error);
                let is_before = is_greater(cut.far - cut.far_error, t + error);
                let is_in = is_behind & is_before & !is_here;
                let is_out = is_greater(cut.near - cut.near_error, t + error)
                    | is_less(cut.far + cut.far_error, t - error);
                let is_told = (is_in | is_out | is_here).to_bitmask();
                doubt |= open & !is_told;
                open &= is_told;
                let goes = mask(open & is_in.to_bitmask());
                has_moved |= goes.any();
                t = either(goes, cut.far, t);
                error = either(goes, cut.far_error, error);
                operands = either(goes, number, operands);
            }
        }
        // A ray that starts in all first operands and in no cut is inside of the whole, although it is said to start
        // outside.
        let is_ahead = !is_less(operands, zero);
        let is_met = is_less(t + error, out_least) & is_ahead;
        let is_over = is_greater(t - error, out_most);
        let met = open & is_met.to_bitmask();
        Entry {
            ahead: Ahead {
                met,
                doubt: 0,
                t,
                error,
            },
            rest: rays & !beside & (doubt | !(is_met | is_over).to_bitmask()),
            spans: self,
            operands,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::vec::Vec3;
    use crate::testing::scene;
    use crate::trace::Tracer;
    use crate::trace::kernel::query::{Start, Tests};
    use crate::trace::kernel::scratch::Scratch;
    use crate::trace::kernel::search::Met;
    use crate::trace::kernel::stage::Stage;
    use crate::trace::kernel::tests::numbers;

    /// An intersection or a difference of a few shapes near the origin, some of them with faces in one plane.
    fn text(seed: usize, number: &mut impl FnMut() -> f64) -> String {
        let shapes = [
            "12 -1 -1 -1 1 1 1",
            "11 0 0 0 1.2",
            "15 1 0 0 0 0 0 0 0 0 0 1 0 0 0 0 -0.5",
            "4 0 1 0 -0.2",
            "16 1.4 1.2",
            "10 1.5 0.7 0.9",
        ];
        let mut text = String::new();
        let count = 2 + seed % 4;
        let mut whole = 2;
        for i in 0..count {
            let (id, shape) = (2 + 2 * i, shapes[(seed / 4 + 5 * i * (1 + seed % 2)) % 6]);
            text += &format!("{id} {shape}\n");
            if !(seed + i).is_multiple_of(3) {
                let mut real = |by: f64| (number() * by * 100.0).round() / 100.0;
                let angle = real(180.0);
                text += &format!("{id} -2 {angle} {}\n", 1 + i % 3);
                text += &format!("{id} -1 {} {} {}\n", real(0.7), real(0.7), real(0.7));
            }
            if i > 0 {
                let operation = match (seed / 2 + i) % 3 {
                    0 => -102,
                    _ => -103,
                };
                text += &format!("{} {operation} {whole} {id}\n", id + 1);
                whole = id + 1;
            }
        }
        format!("{text}1 9999 {whole} 0\n")
    }

    /// Known entries are what the walk through all crossings finds, also for rays that start on the surface.
    #[test]
    fn entries_are_those_of_the_walk() {
        let mut number = numbers();
        let (mut known, mut met, mut all) = (0, 0, 0);
        for seed in 0..96 {
            let scene = scene(&text(seed, &mut number));
            let tracer = Tracer::new(&scene).unwrap();
            let Some(stage) = Stage::new(&tracer.graph, 100) else {
                continue;
            };
            let mut walks = Stage::new(&tracer.graph, 100).expect("as before");
            for csg in &mut walks.csgs {
                csg.spans = None;
            }
            let Some(spans) = stage.csgs.first().and_then(|csg| csg.spans.as_ref()) else {
                continue;
            };
            let (mut scratch, mut tests) = (Scratch::default(), Tests::default());
            for i in 0..400 {
                let mut vector = || Vec3::new(number(), number(), number());
                let (from, to, next) = (vector() * 5.0, vector(), vector());
                let mut direction = to - from;
                if i % 9 == 0 {
                    direction.0[i / 9 % 3] = 0.0;
                }
                let mut start = Start::outside(from, direction);
                for _ in 0..2 {
                    let found = stage.first(&start, &mut scratch, &mut tests);
                    let walked = walks.first(&start, &mut scratch, &mut tests);
                    let packet = Packet::new([&start; LANES], ALL);
                    let far = Lanes::splat(f64::INFINITY);
                    let entry = spans.entry(stage.space(), &packet, far, ALL);
                    all += 1;
                    known += usize::from(entry.rest == 0);
                    assert!(entry.rest == 0 || entry.rest == ALL);
                    let crossing = match (found, walked) {
                        (Met::Nothing, Met::Nothing) => break,
                        (Met::Surface(a, sides), Met::Surface(b, others)) => {
                            let is_near = (a.end.t - b.end.t).abs() <= a.end.error + b.end.error;
                            assert_eq!(
                                (a.surface, a.is_exit),
                                (b.surface, b.is_exit),
                                "{seed} {start:?}"
                            );
                            assert!(is_near && sides == others, "{seed} {start:?} {a:?} {b:?}");
                            assert_eq!(entry.rest == 0, entry.ahead.met == ALL);
                            a
                        }
                        (_, Met::Doubt) => break,
                        (found, walked) => panic!("{seed} {start:?} {found:?} {walked:?}"),
                    };
                    met += 1;
                    // Back from there, about, and so out of the whole.
                    let leaf = &stage.leaves[crossing.surface as usize];
                    let at = Vec3(start.origin) + Vec3(start.direction) * crossing.end.t;
                    let away = next * 0.02 - Vec3(start.direction);
                    (start.origin, start.direction, start.skin) = (at.0, away.0, 1e-14);
                    (start.left, start.goes_in) = (leaf.twin, crossing.is_exit);
                }
            }
        }
        assert!(
            met > 3_000 && known * 100 > all * 90,
            "{met}, {known} of {all}"
        );
    }
}
