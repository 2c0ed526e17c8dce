//! Shapes without lanes: the arbiter's own formulas, one ray at a time.

use super::chain::{self, Local};
use super::geodesic;
use super::lanes::{LANES, Lanes, V3, is_less, mask};
use super::leaf::{Kind, Leaf};
use super::look::Colour;
use super::query::{Ask, Crossed, Crossing, End, Query, Start, Tests};
use super::resolved::Resolved;
use super::scratch::Scratch;
use super::stage::Stage;
use crate::geometry::array::each;
use crate::geometry::line::Line;
use crate::geometry::vec::Vec3;
use crate::scene::Rgb;
use crate::trace::search::hit::beside;
use crate::trace::search::query::Scale;
use crate::trace::search::root_order::{before_left, rough};
use crate::trace::shapes::quick_reject::Pass;
use crate::trace::shapes::{Located, Primitive, Root, Roots};
use crate::trace::stats::Work;
use crate::trace::texture::SurfacePoint;

/// How a ray crosses a shape ahead of its start.
pub enum Raw {
    Nothing,
    /// The ray surely goes through, and nobody has asked where.
    Somewhere,
    /// Rounding may have decided something.
    Doubt,
    /// The ray crosses at the roots. `line` is the ray in the shape's space; `inside`: whether the ray starts inside of
    /// the shape.
    Ahead {
        line: Line,
        inside: bool,
    },
}

impl Stage<'_> {
    /// Maps a line from the scene's space into the space of the leaf below all placements of a chain. `chain` is an
    /// index into `self.chains`.
    #[inline]
    pub fn line_through(&self, line: &Line, chain: u32) -> Line {
        let placements = &self.graph.placements;
        let through = |line: Line, &m: &u32| line.through(&placements[m as usize].back);
        match &self.chains[chain as usize][..] {
            [] => *line,
            [only] => through(*line, only),
            all => all.iter().fold(*line, through),
        }
    }

    /// Finds where a ray crosses a leaf without lanes ahead of its start. The crossings that `ask` asks for are listed
    /// in `scratch.ahead`; those outside of `stretch` may be missing.
    #[inline]
    pub fn meet_single(
        &self,
        query: &Query,
        number: u32,
        stretch: [f64; 2],
        ask: Ask,
        (scratch, tests): (&mut Scratch, &mut Tests),
    ) -> Crossed {
        let leaf = &self.leaves[number as usize];
        if leaf.kind == Kind::Csg {
            return self.boundary(query, number, stretch, ask, scratch, tests);
        }
        let mut roots = std::mem::take(&mut scratch.roots);
        let raw = self.cross(query, number, stretch, ask, &mut roots);
        scratch.roots = roots;
        self.listed(query, number, raw, ask, scratch)
    }

    /// Like [`meet_single`](Self::meet_single), for the first crossing of a ray that does not start on the leaf and
    /// that cheap tests have not ruled out. `line` is the ray in the leaf's space.
    #[inline]
    pub fn meet_on_line(
        &self,
        query: &Query,
        number: u32,
        line: &Line,
        stretch: [f64; 2],
        scratch: &mut Scratch,
    ) -> Crossed {
        let ask = Ask::First;
        let mut roots = std::mem::take(&mut scratch.roots);
        let raw = match line.is_sound() {
            true => self.solve(query, number, line, stretch, ask, &mut roots),
            false => Raw::Doubt,
        };
        scratch.roots = roots;
        self.listed(query, number, raw, ask, scratch)
    }

    /// Lists the crossings that were found with a leaf in `scratch.ahead`. A ray is in doubt if they contradict what it
    /// knows about where it starts.
    #[inline(always)]
    fn listed(
        &self,
        query: &Query,
        number: u32,
        raw: Raw,
        ask: Ask,
        scratch: &mut Scratch,
    ) -> Crossed {
        let leaf = &self.leaves[number as usize];
        scratch.ahead.clear();
        match raw {
            Raw::Nothing => Crossed::Nothing,
            Raw::Somewhere => Crossed::Somewhere,
            Raw::Doubt => Crossed::Doubt,
            Raw::Ahead { inside, .. }
                if leaf.is_solid && inside != query.start.within.has(number) =>
            {
                Crossed::Doubt
            }
            Raw::Ahead { line, inside } => {
                let wanted = if ask == Ask::All { usize::MAX } else { 1 };
                let roots = scratch.roots.list.iter().take(wanted);
                scratch.ahead.extend(roots.map(|&root| Crossing {
                    surface: number,
                    root,
                    end: self.end(leaf, &line, root),
                    is_exit: inside,
                }));
                Crossed::Ahead
            }
        }
    }

    /// Replaces a rough crossing with a convex solid of second degree by the exact one; `false` if the exact one is not
    /// known.
    #[inline(never)]
    pub fn sharpen(&self, start: &Start, crossing: &mut Crossing, roots: &mut Roots) -> bool {
        let query = Query::new(start);
        let everywhere = [-query.skin, f64::INFINITY];
        let crossed = self.cross(&query, crossing.surface, everywhere, Ask::All, roots);
        let root = match crossed {
            Raw::Ahead { inside, .. } => {
                let before = usize::from(crossing.is_exit && !inside);
                let is_side = crossing.is_exit || !inside;
                roots.list.get(before).copied().filter(|_| is_side)
            }
            Raw::Nothing | Raw::Somewhere | Raw::Doubt => None,
        };
        let is_near = |root: &Root| (root.t - crossing.end.t).abs() <= 2.0 * crossing.end.error;
        let Some(root) = root.filter(is_near) else {
            return false;
        };
        crossing.root = root;
        true
    }

    /// A crossing with a leaf without lanes, with a bound on its error.
    #[inline]
    pub fn end(&self, leaf: &Leaf, line: &Line, root: Root) -> End {
        let shape = self.graph.primitives[leaf.primitive as usize].intersect();
        End {
            t: root.t,
            error: rough(shape, Scale::new(line, leaf.extent), line, root),
        }
    }

    /// Finds where a ray crosses a leaf without lanes ahead of its start, and puts the crossings into `roots`.
    /// Crossings outside of `stretch` may be missing; so may those behind the first one, unless `ask` is [`Ask::All`].
    #[inline(never)]
    pub fn cross(
        &self,
        query: &Query,
        number: u32,
        stretch: [f64; 2],
        ask: Ask,
        roots: &mut Roots,
    ) -> Raw {
        let leaf = &self.leaves[number as usize];
        let primitive = &self.graph.primitives[leaf.primitive as usize];
        let start = query.start;
        let is_left = start.left == leaf.twin;
        let goes_out = is_left && !(start.goes_in && leaf.is_solid);
        if goes_out && leaf.is_convex {
            return Raw::Nothing;
        }
        let line = self.line_through(&query.line, leaf.chain);
        if !line.is_sound() {
            return Raw::Doubt;
        }
        let pass = match goes_out {
            true if primitive.shape().is_met_again(&line) => Pass::Perhaps,
            true => Pass::Beside,
            false => primitive.shape().pass(&line, stretch),
        };
        match pass {
            Pass::Beside => return Raw::Nothing,
            Pass::Through if ask == Ask::Any => return Raw::Somewhere,
            Pass::Through | Pass::Perhaps => {}
        }
        self.solve(query, number, &line, stretch, ask, roots)
    }

    /// Finds where a ray crosses a leaf without lanes that cheap tests have not ruled out. `line` is the ray in the
    /// leaf's space.
    #[inline]
    fn solve(
        &self,
        query: &Query,
        number: u32,
        line: &Line,
        stretch: [f64; 2],
        ask: Ask,
        roots: &mut Roots,
    ) -> Raw {
        let leaf = &self.leaves[number as usize];
        let primitive = &self.graph.primitives[leaf.primitive as usize];
        let start = query.start;
        roots.clear();
        let solver = self.graph.solver.as_ref();
        let is_solved = solver.is_some_and(|s| s.crossings(leaf.primitive, line, roots));
        match ask {
            _ if is_solved => {}
            Ask::All => primitive.intersect().crossings(line, roots),
            Ask::First | Ask::Any => {
                (primitive.intersect()).first_crossings(line, -1.5 * stretch[0], roots)
            }
        }
        roots.doubt_blurred(line);
        if roots.uncertain || roots.along.is_some() {
            return Raw::Doubt;
        }
        let passed = roots.list.partition_point(|root| root.t <= 0.0);
        let behind = match start.left == leaf.twin {
            true => before_left(roots, start.goes_in, leaf.is_solid).unwrap_or(passed),
            false => {
                let near =
                    |&root: &Root| root.t.abs() <= query.skin + self.end(leaf, line, root).error;
                let around = &roots.list[passed.saturating_sub(1)..];
                if around.iter().take(2).any(near) {
                    return Raw::Doubt;
                }
                passed
            }
        };
        let inside = roots.inside != (behind % 2 == 1);
        roots.list.drain(..behind);
        Raw::Ahead {
            line: *line,
            inside,
        }
    }

    /// The points where four rays have met leaves without lanes, for the lanes in `live`.
    #[inline(never)]
    pub fn locate(
        &self,
        leaves: [&Leaf; LANES],
        (origin, direction): (V3, V3),
        roots: [Root; LANES],
        live: u32,
        work: &mut Work,
    ) -> Places {
        let chains = self.chains_of(leaves);
        let entered = chains.enter(origin, direction);
        let (mut found, told) = self.located(leaves, &entered, roots);
        let rest = live & !told;
        let lines = (rest != 0).then(|| entered.lines());
        for lane in (0..LANES).filter(|lane| rest >> lane & 1 != 0) {
            let Some(lines) = &lines else { break };
            let (leaf, root) = (leaves[lane], roots[lane]);
            let primitive = &self.graph.primitives[leaf.primitive as usize];
            found[lane] = primitive.intersect().locate(&lines[lane], root);
        }
        let all = |vector: fn(&Located) -> &[f64; 3]| V3::gathered(found.each_ref(), vector);
        let place = chains.leave(chain::Located {
            point: all(|found| &found.point.0),
            error: all(|found| &found.error.0),
            normal: all(|found| &found.normal.0),
            known: mask(live),
        });
        let is_finite = |v: V3| is_less(v.abs().max_component(), Lanes::splat(f64::INFINITY));
        let has_normal = mask(place.normal.any());
        let known = place.known & is_finite(place.point) & is_finite(place.error) & has_normal;
        let local = |lane: usize| (found[lane].point, roots[lane].face);
        let shading = self.smoothed((leaves, live), local, place.normal, work);
        Places {
            resolved: Resolved {
                clear: known,
                t: Lanes::new(each(roots, |root| root.t)),
                point: place.point,
                error: place.error,
                normal: place.normal,
            },
            shading,
            local: each(found, |found| found.point),
        }
    }

    /// The points in the leaves' spaces where four lines meet one geodesic sphere, or its copies, and, as bits, the lines
    /// whose points are known.
    #[inline(always)]
    fn located(
        &self,
        leaves: [&Leaf; LANES],
        entered: &Local,
        roots: [Root; LANES],
    ) -> ([Located; LANES], u32) {
        let number = leaves[0].primitive;
        let is_same = |leaf: &Leaf| leaf.kind == Kind::Other && leaf.primitive == number;
        let nowhere = [NOWHERE; LANES];
        if !leaves.into_iter().all(is_same) {
            return (nowhere, 0);
        }
        let Primitive::GeodesicSphere(sphere) = &self.graph.primitives[number as usize] else {
            return (nowhere, 0);
        };
        let all = geodesic::locate(sphere, entered, each(roots, |root| root.face));
        let [points, errors, normals] = [all.point, all.error, all.normal].map(V3::columns);
        let found = each([0, 1, 2, 3], |lane: usize| {
            let at =
                |columns: &[[f64; LANES]; 3]| Vec3(each([0, 1, 2], |i: usize| columns[i][lane]));
            Located {
                point: at(&points),
                error: at(&errors),
                normal: at(&normals),
            }
        });
        (found, all.clear.to_bitmask())
    }

    /// The unit normals for shading at four points of surfaces. `place` gives for each lane the point in the space of its
    /// shape, and the face; `normal` are the unit normals of the surfaces.
    #[inline]
    pub fn smoothed(
        &self,
        (leaves, live): ([&Leaf; LANES], u32),
        place: impl Fn(usize) -> (Vec3, u32),
        normal: V3,
        work: &mut Work,
    ) -> V3 {
        let mut bent = [None; LANES];
        for lane in (0..LANES).filter(|lane| live >> lane & 1 != 0) {
            if self.graph.without.smooth_normals {
                continue;
            }
            let leaf = leaves[lane];
            let primitive = &self.graph.primitives[leaf.primitive as usize];
            let (point, face) = place(lane);
            let Some(local) = primitive.shape().shading_normal(point, face) else {
                continue;
            };
            work.smooth_normal += 1;
            let placements = self.chains[leaf.chain as usize].iter().rev();
            bent[lane] = Some(placements.fold(local, |normal, &placement| {
                let maps = &self.graph.placements[placement as usize];
                maps.back.unit_normal(normal)
            }));
        }
        if bent.iter().all(Option::is_none) {
            return normal;
        }
        let normals = normal.columns();
        let each_normal = each([0, 1, 2, 3], |lane: usize| {
            let normal = Vec3::new(normals[0][lane], normals[1][lane], normals[2][lane]);
            bent[lane].map_or(normal, |n| beside(n, normal))
        });
        V3::gathered(each_normal.each_ref(), |normal| &normal.0)
    }

    /// The share of diffuse light at a point of a leaf's surface: `point` in the scene's space, `local` in the leaf's
    /// space.
    #[inline(never)]
    pub fn albedo(
        &self,
        leaf: &Leaf,
        face: u32,
        [point, local]: [Vec3; 2],
        work: &mut Work,
    ) -> [f64; 3] {
        let at = SurfacePoint {
            shape: self.graph.primitives[leaf.primitive as usize].shape(),
            point: local,
            face,
        };
        let colour: Rgb = match leaf.look.colour {
            _ if leaf.look.kd == [0.0; 3] => return [0.0; 3],
            Colour::Plain => return leaf.look.albedo,
            Colour::Own => self.graph.unpainted(&at, work),
            Colour::Texture { texture, chain } => {
                let placements = self.chains[chain as usize].iter();
                let into = |p: Vec3, &m: &u32| self.graph.placements[m as usize].back.point(p);
                let painted = || placements.fold(point, into);
                self.graph.painted(texture, &at, painted, work)
            }
        };
        Vec3(leaf.look.kd).times(Vec3(colour)).0
    }
}

/// The points where four rays have met leaves without lanes.
pub struct Places {
    pub resolved: Resolved,
    /// The unit normals for shading, in the scene's space.
    pub shading: V3,
    /// The points in the spaces of their shapes.
    pub local: [Vec3; LANES],
}

/// The point of a lane that holds no ray.
const NOWHERE: Located = Located {
    point: Vec3::ZERO,
    error: Vec3::ZERO,
    normal: Vec3::ZERO,
};
