//! Questions about rays. A walker in the precision asked for answers them. If it cannot decide, a walker in
//! double-double answers.

use super::events::{Event, Kind};
use super::hit::Hit;
use super::query::QueryStatus;
use super::query::Search;
use super::walk::Walker;
use crate::geometry::dd::Dd;
use crate::geometry::vec::Vec3;
use crate::trace::graph::Graph;
use crate::trace::precision::{Doubt, Precision};
use crate::trace::probe::Probe;
use crate::trace::ray::Ray;
use crate::trace::stats::{Intersections, Work};
use crate::trace::tracer::Tracer;

/// The walkers of one thread, which answer questions about rays.
pub struct Walkers<'t, R: Precision = f64> {
    tracer: &'t Tracer,
    walker: Walker<'t, R>,
    /// The walker in double-double, which is made when it is first needed.
    finer: Option<Box<Walker<'t, Dd>>>,
    /// The number of rays with a decision that was closer than the rounding errors of R.
    uncertain: u64,
}

/// A question about a ray.
trait Question {
    type Answer<R: Precision>;

    fn ask<R: Precision>(
        &self,
        tracer: &Tracer,
        walker: &mut Walker<R>,
        ray: &Ray<R>,
    ) -> Self::Answer<R>;

    /// Turns an answer in double-double into the kind of number that was asked for.
    fn cast<R: Precision>(answer: Self::Answer<Dd>) -> Self::Answer<R>;

    /// The answer about the places that both of two rays are in, from the answers about each. Stretches no longer than
    /// `least`, in t, do not count.
    fn common<R: Precision>(answers: [Self::Answer<R>; 2], least: R) -> Self::Answer<R>;
}

impl<'t, R: Precision> Walkers<'t, R> {
    pub(in crate::trace) fn new(tracer: &'t Tracer) -> Walkers<'t, R> {
        Walkers {
            tracer,
            walker: Walker::new(&tracer.graph),
            finer: None,
            uncertain: 0,
        }
    }

    /// The walker in the precision asked for, alone.
    pub(in crate::trace) fn walker(&mut self) -> &mut Walker<'t, R> {
        &mut self.walker
    }

    /// Sets all counts to 0.
    pub fn reset(&mut self) {
        self.uncertain = 0;
        (self.walker.counts, self.walker.work) = Default::default();
        if let Some(finer) = &mut self.finer {
            (finer.counts, finer.work) = Default::default();
        }
    }

    /// Intersection tests since the last reset.
    pub fn intersections(&self) -> Intersections {
        let mut all = self.walker.counts;
        if let Some(finer) = &self.finer {
            all += finer.counts;
        }
        all
    }

    /// The work between rays and their hits since the last reset.
    pub fn work(&self) -> Work {
        let mut all = self.walker.work;
        if let Some(finer) = &self.finer {
            all += finer.work;
        }
        all
    }

    /// The number of rays since the last reset with a decision that was closer than its rounding errors.
    pub fn uncertain(&self) -> u64 {
        self.uncertain
    }

    fn ask<Q: Question>(&mut self, question: &Q, ray: &Ray<R>) -> Q::Answer<R> {
        if R::DOUBT == Doubt::Merges {
            return self.ask_finally(question, ray);
        }
        self.walker.status = QueryStatus::default();
        // A hit is large. With one variable for the answer it is copied less often.
        let mut answer = question.ask(self.tracer, &mut self.walker, ray);
        if self.walker.status.uncertain {
            self.uncertain += 1;
            if R::DOUBT == Doubt::GoesOn {
                answer = self.ask_finer(question, ray);
            }
        }
        answer
    }

    /// Asks the walker of R, whose numbers are final.
    fn ask_finally<Q: Question>(&mut self, question: &Q, ray: &Ray<R>) -> Q::Answer<R> {
        let answer = settled(question, self.tracer, &mut self.walker, ray);
        self.uncertain += u64::from(self.walker.status.uncertain);
        answer
    }

    /// Asks the walker in double-double, whose numbers are final.
    #[cold]
    #[inline(never)]
    fn ask_finer<Q: Question>(&mut self, question: &Q, ray: &Ray<R>) -> Q::Answer<R> {
        let tracer = self.tracer;
        let finer = self
            .finer
            .get_or_insert_with(|| Box::new(Walker::new(&tracer.graph)));
        Q::cast(settled(question, tracer, finer, &ray.cast()))
    }
}

/// The final answer. If the ray lies in a flat face, four rays beside it are asked, one in each quarter around an edge.
/// The places that are in all four are the answer: a line in a surface does not cross it, and between two boxes face to
/// face is no gap.
fn settled<Q: Question, R: Precision>(
    question: &Q,
    tracer: &Tracer,
    walker: &mut Walker<R>,
    ray: &Ray<R>,
) -> Q::Answer<R> {
    let answer = asked_closely(question, tracer, walker, ray);
    let Some(along) = walker.status.along else {
        return answer;
    };
    // The distance is far above the rounding errors of double-double, and far below what doubles can tell apart.
    let by = along.reach * R::ROUNDOFF.sqrt().to_f64() * FACE_OFFSET;
    // The step aside is a little shorter than the normal, so that no shift is at 45° to the face, where another face
    // may be.
    let aside = along.normal.cross(ray.line.direction.cast().unit()).unit() * 0.9;
    let shifts = [along.normal + aside, along.normal - aside];
    let mut answers = shifts
        .into_iter()
        .flat_map(|shift| [shift, -shift])
        .map(|shift| {
            let mut beside = *ray;
            beside.line.origin = ray.line.origin + (shift * by).cast::<R>();
            asked_closely(question, tracer, walker, &beside)
        });
    let first = answers.next().unwrap_or(answer);
    // A curved surface that the ray touches comes between the four rays on a stretch shorter than this.
    let length = ray.line.direction.length();
    let least = R::of(4.0 * (along.reach * by).sqrt()) / length;
    let answer = answers.fold(first, |a, b| Q::common([a, b], least));
    walker.status.uncertain = true;
    answer
}

/// A ray that lies in a face is replaced by rays beside the face. Their distance from it is this number times
/// [`Along::reach`](super::query::Along::reach) times the root of the unit roundoff, which is 2⁻⁵¹ for double-double.
const FACE_OFFSET: f64 = 1.0 / (1u64 << 24) as f64;

/// The answer in numbers that are final. If some surface cannot be told from the one that the ray has left, the
/// question is asked once more, with a better start than the rounded origin: the crossing with the surface that the ray
/// has left.
fn asked_closely<Q: Question, R: Precision>(
    question: &Q,
    tracer: &Tracer,
    walker: &mut Walker<R>,
    ray: &Ray<R>,
) -> Q::Answer<R> {
    (walker.status, walker.start) = (QueryStatus::default(), None);
    let answer = question.ask(tracer, walker, ray);
    let QueryStatus {
        skin_met, start, ..
    } = walker.status;
    if !skin_met || start.is_none() {
        return answer;
    }
    walker.start = start;
    let answer = question.ask(tracer, walker, ray);
    walker.start = None;
    answer
}

impl Tracer {
    /// Makes the walkers of one thread.
    pub fn walker<R: Precision>(&self) -> Walkers<'_, R> {
        Walkers::new(self)
    }

    /// The first visible point on a ray.
    pub fn hit<R: Precision>(&self, walkers: &mut Walkers<R>, ray: &Ray<R>) -> Option<Hit<R>> {
        walkers.first_hit::<true>(ray)
    }

    /// Whether a point is inside some solid of the scene.
    pub fn holds<R: Precision>(&self, walkers: &mut Walkers<R>, point: Vec3<R>) -> bool {
        let up = Vec3::new(R::ZERO, R::ZERO, R::ONE);
        walkers.ask(&StartsInside, &Ray::new(point, up))
    }

    /// The crossings of a ray in the region that is drawn: all with t > 0, ascending, as if every surface let the ray
    /// through. The sides of the region are no surfaces.
    pub fn probe<R: Precision>(&self, walkers: &mut Walkers<R>, ray: &Ray<R>) -> Probe<R> {
        walkers.ask(&Meets { clipped: true }, ray)
    }

    /// All crossings on a ray with t > 0, ascending; the region that is drawn does not apply.
    pub fn crossings<R: Precision>(
        &self,
        walkers: &mut Walkers<R>,
        ray: &Ray<R>,
    ) -> Vec<crate::trace::probe::Crossing<R>> {
        walkers.ask(&Meets { clipped: false }, ray).crossings
    }
}

impl<R: Precision> Walkers<'_, R> {
    /// The first visible point on a ray. Without `GLASS` nothing is transparent.
    pub(in crate::trace) fn first_hit<const GLASS: bool>(
        &mut self,
        ray: &Ray<R>,
    ) -> Option<Hit<R>> {
        self.ask(&FirstHit::<GLASS>, ray)
    }

    /// The face of a solid in which a sheet lies, for a ray that sees that sheet first.
    #[inline(never)]
    pub(in crate::trace) fn face_behind_sheet(&mut self, ray: &Ray<R>) -> Option<Hit<R>> {
        self.ask(&FaceBehindSheet, ray)
    }

    /// The share of light that gets through to a lamp at t = 1: the product of kt over all surfaces on the way. A
    /// surface that the lamp lies on is not on the way ([`AT_LAMP`](Precision::AT_LAMP)).
    pub(in crate::trace) fn visibility<const GLASS: bool>(&mut self, ray: &Ray<R>) -> Vec3 {
        self.ask(&Visibility::<GLASS>, ray)
    }
}

/// The question for the hit that a ray sees first.
struct FirstHit<const GLASS: bool>;

impl<const GLASS: bool> Question for FirstHit<GLASS> {
    type Answer<R: Precision> = Option<Hit<R>>;

    fn ask<R: Precision>(
        &self,
        tracer: &Tracer,
        walker: &mut Walker<R>,
        ray: &Ray<R>,
    ) -> Option<Hit<R>> {
        let clipped = tracer.clip.is_some();
        walker.work.clip += u64::from(clipped);
        let (from, to) = tracer.window(ray, R::INFINITY)?;
        walker.first_hit::<GLASS>(ray, (from, to), clipped)
    }

    fn cast<R: Precision>(answer: Option<Hit<Dd>>) -> Option<Hit<R>> {
        answer.map(|hit| hit.cast())
    }

    /// The later of the two hits: before it, only one of the rays has met something.
    fn common<R: Precision>([a, b]: [Option<Hit<R>>; 2], _: R) -> Option<Hit<R>> {
        let (a, b) = (a?, b?);
        Some(if b.t > a.t { b } else { a })
    }
}

/// The question for the first boundary of a solid behind all sheets.
struct FaceBehindSheet;

impl Question for FaceBehindSheet {
    type Answer<R: Precision> = Option<Hit<R>>;

    fn ask<R: Precision>(
        &self,
        tracer: &Tracer,
        walker: &mut Walker<R>,
        ray: &Ray<R>,
    ) -> Option<Hit<R>> {
        let (from, to) = tracer.window(ray, R::INFINITY)?;
        walker.first_boundary(ray, from, to)
    }

    fn cast<R: Precision>(answer: Option<Hit<Dd>>) -> Option<Hit<R>> {
        answer.map(|hit| hit.cast())
    }

    fn common<R: Precision>(answers: [Option<Hit<R>>; 2], least: R) -> Option<Hit<R>> {
        FirstHit::<true>::common(answers, least)
    }
}

/// The question whether the origin of a ray is in a solid.
struct StartsInside;

impl Question for StartsInside {
    type Answer<R: Precision> = bool;

    fn ask<R: Precision>(&self, _: &Tracer, walker: &mut Walker<R>, ray: &Ray<R>) -> bool {
        let (start, _) = walker.trace_spans(ray, R::ZERO, R::ZERO);
        start.is_some_and(|s| s.inside)
    }

    fn cast<R: Precision>(answer: bool) -> bool {
        answer
    }

    fn common<R: Precision>([a, b]: [bool; 2], _: R) -> bool {
        a && b
    }
}

/// The question about all crossings on a ray.
struct Meets {
    clipped: bool,
}

impl Question for Meets {
    type Answer<R: Precision> = Probe<R>;

    fn ask<R: Precision>(&self, tracer: &Tracer, walker: &mut Walker<R>, ray: &Ray<R>) -> Probe<R> {
        match self.clipped {
            true => tracer.probe_with(walker, ray),
            false => tracer.crossings_with(walker, ray),
        }
    }

    fn cast<R: Precision>(answer: Probe<Dd>) -> Probe<R> {
        answer.cast()
    }

    fn common<R: Precision>([a, b]: [Probe<R>; 2], least: R) -> Probe<R> {
        a.common(b, least)
    }
}

/// The question how much light gets through along a ray to a lamp.
struct Visibility<const GLASS: bool>;

/// The share of light that all surfaces on a way let through.
fn shared<R: Precision>(events: &[Event<R>], graph: &Graph) -> Vec3 {
    let mut share = Vec3::ONE;
    let mut surfaces = events.iter().filter(|e| e.kind != Kind::Silent);
    while let (true, Some(event)) = (share.any(), surfaces.next()) {
        let optics = &graph.optics[event.owner.medium.optics as usize];
        share = share.times(Vec3(optics.kt));
    }
    share
}

impl<const GLASS: bool> Question for Visibility<GLASS> {
    type Answer<R: Precision> = Vec3;

    /// How much light gets through along `ray`. A ray that starts outside and crosses something opaque before anything
    /// transparent is blocked: the first thing it meets is a boundary of the scene, and opaque. It does not matter which
    /// opaque thing the ray meets first, so the search stops at the first one that it finds. If the ray crosses nothing
    /// opaque, only parts that hold something transparent can change its light, and their spans are enough. If something
    /// transparent comes before something opaque, all spans are needed: the opaque thing may be hidden in another solid.
    fn ask<R: Precision>(&self, tracer: &Tracer, walker: &mut Walker<R>, ray: &Ray<R>) -> Vec3 {
        walker.work.clip += u64::from(tracer.clip.is_some());
        let Some((from, to)) = tracer.window(ray, R::of(1.0 - R::AT_LAMP)) else {
            return Vec3::ONE;
        };
        if ray.is_outside && tracer.clip.is_none() {
            if !GLASS {
                return match walker.nearest(ray, (from, to), Search::Any) {
                    Some(_) => Vec3::ZERO,
                    None => Vec3::ONE,
                };
            }
            let Some(opaque) = walker.nearest(ray, (from, to), Search::AnyOpaque) else {
                let events = walker.trace_clear_spans(ray, from, to);
                let (any, share) = (!events.is_empty(), shared(events, &tracer.graph));
                walker.work.transparent_shadow += u64::from(any);
                return share;
            };
            let before = opaque.place.root.t;
            let clear = walker.nearest(ray, (from, before), Search::AnyClear);
            if clear.is_none() {
                return Vec3::ZERO;
            }
        }
        walker.work.transparent_shadow += u64::from(GLASS);
        let (_, events) = walker.trace_spans(ray, from, to);
        shared(events, &tracer.graph)
    }

    fn cast<R: Precision>(answer: Vec3) -> Vec3 {
        answer
    }

    /// Light gets through if it gets past on either side.
    fn common<R: Precision>([a, b]: [Vec3; 2], _: R) -> Vec3 {
        a.zip(b, f64::max)
    }
}
