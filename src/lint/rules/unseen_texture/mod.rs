//! W331: a texture that no picture shows.
//!
//! A paint gives its texture to all below it that no other paint above covers. The texture is seen where the optics are
//! diffuse, on a part that a ray of a camera may meet.

mod given;
mod instead;
mod unions;

use rustc_hash::{FxHashMap, FxHashSet};

use super::overridden_property::{self, MAX_PROPOSED};
use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::scene::{Node, NodeId, Origin, Scene, fold_up};
use crate::solids::named;
use crate::syntax::Item;
use crate::syntax::table::RecordKind;
use crate::trace::plan::unseen::view::{USUAL, beside_all_views};
use crate::trace::plan::unseen::{LeftOut, Unseen, Why as UnseenReason};
use crate::trace::plan::visible_aspects::{Showing, VisibleAspects};
use crate::trace::plan::{Effect, Plan};
use given::{Given, Painting, textures};
use instead::Instead;
use unions::unions;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let Some(sightings) = Sightings::new(context) else {
        return;
    };
    let Sightings { given, found, .. } = &sightings;
    let colours = sightings.colours(context);
    let (in_unions, findings) = sightings.unions(context, &colours);
    out.extend(findings);
    let mut proposed = 0;
    for (i, (given, found)) in given.iter().zip(found).enumerate() {
        let said = found.said(given).filter(|_| !in_unions.contains(&i));
        let is_told = |d: &Diagnostic| {
            let is_cut = d.case == Why::Removed.case() && colours.differs(i);
            !given.is_colour || is_cut || d.case == Why::Dark.case()
        };
        out.extend(said.filter(is_told).map(|mut d| {
            if d.case == Why::Covered.case()
                && let Some(again) = found.again.filter(|_| proposed < MAX_PROPOSED)
                && let Some(at) = context.document.item_at(again.start)
                && let Item::Record(second) = &context.document.items[at]
            {
                proposed += 1;
                d.fixes = overridden_property::neighbours(context, second);
            }
            match (given.is_colour, d.case == Why::Dark.case()) {
                (true, true) => d.case("dark-colour"),
                (true, false) => d.case("colour"),
                (false, _) => d,
            }
        }));
    }
}

/// The nodes of the paints whose textures W331 reports as hidden.
pub(super) fn hidden(context: &Context) -> Vec<NodeId> {
    let Some(sightings) = Sightings::new(context) else {
        return Vec::new();
    };
    let is_hidden = |texture: usize| {
        let (given, found) = (&sightings.given[texture], &sightings.found[texture]);
        let is_hidden = found.reasons == [Why::Hidden] && found.is_hidden_otherwise;
        !given.is_colour && !found.is_seen && is_hidden
    };
    let paintings = sightings.paintings.iter();
    let hidden = paintings.filter(|p| p.texture.is_some_and(is_hidden));
    hidden.map(|p| p.node).collect()
}

/// All textures and colours of a scene, with the facts that are found about each.
struct Sightings<'a> {
    given: Vec<Given<'a>>,
    paintings: Vec<Painting>,
    found: Vec<TextureSightings>,
    views: Views<'a>,
}

impl<'a> Sightings<'a> {
    /// `None` if there is nothing that the rule could report.
    fn new(context: &Context<'a>) -> Option<Sightings<'a>> {
        let has_textures = context.document.contents.has(super::TEXTURES);
        let has = |kinds: &[RecordKind]| context.document.contents.has(kinds);
        if !has_textures && !has(super::DIFFERENCES) && !has(OPTICS) {
            return None;
        }
        let (given, paintings) = textures(context);
        let views = (!given.is_empty()).then(|| Views::new(context, has_textures));
        let mut sightings = Sightings {
            found: given.iter().map(|_| TextureSightings::default()).collect(),
            given,
            paintings,
            views: views??,
        };
        sightings.look(context);
        Some(sightings)
    }

    fn look(&mut self, context: &Context) {
        let Sightings {
            given,
            paintings,
            found,
            views,
        } = self;
        let is_drawn = |p: &Painting| views.showing(p) != Showing::Absent;
        // For each painting whether it is drawn, or a later painting that goes on from it.
        let mut drawn = vec![false; paintings.len()];
        let overriding = overridden_property::overriding(context);
        for (i, painting) in paintings.iter().enumerate().rev() {
            let next = painting.next.filter(|&next| drawn[next]);
            drawn[i] = is_drawn(painting) || next.is_some();
            let Some(texture) = painting.texture else {
                continue;
            };
            let found = &mut found[texture];
            found.is_used = true;
            match next.filter(|_| !is_drawn(painting)) {
                Some(next) if paintings[next].texture != painting.texture => {
                    found.cover(views.scene, painting, paintings[next].node, &overriding);
                }
                Some(_) => {}
                None => views.judge(painting, &overriding, found),
            }
        }
        for i in (0..given.len()).rev() {
            // A texture that is replaced before any object has it counts as covered.
            if !found[i].is_used
                && let Some(next) = given[i].replaced
                && found[next].is_used
            {
                found[i].is_used = true;
                found[i].add(Why::Covered, Some(given[next].params.span()));
            }
        }
        // Colours that checkerboards and other textures name count as seen.
        let named = (context.records()).filter(|r| super::TEXTURES.contains(&r.kind));
        let named: FxHashSet<u32> = named.flat_map(|r| context.references(r)).collect();
        for (given, found) in given.iter().zip(found) {
            found.is_seen |= given.is_colour && named.contains(&given.params.id);
        }
    }

    /// The nodes that give colours which are only cut away, each with the index of its record.
    fn removed(&self) -> impl Iterator<Item = (NodeId, usize)> {
        let is_removed =
            |found: &TextureSightings| !found.is_seen && found.reasons == [Why::Removed];
        let is_asked = move |i: usize| self.given[i].is_colour && is_removed(&self.found[i]);
        (self.paintings.iter())
            .filter_map(move |p| Some((p.node, p.texture.filter(|&i| is_asked(i))?)))
    }

    /// The colours that are cut away, held against those of the cuts.
    fn colours(&self, context: &Context) -> Instead {
        let is_drawn = |node| self.views.all.reaches(node);
        Instead::new(context.scene, self.removed(), is_drawn)
    }

    /// The indices of the colours that a union in place of a difference would show, and findings about these
    /// differences.
    fn unions(&self, context: &Context, colours: &Instead) -> (FxHashSet<usize>, Vec<Diagnostic>) {
        let differing = self.removed().filter(|&(_, i)| colours.differs(i));
        let differing: Vec<(usize, NodeId)> = differing.map(|(node, i)| (i, node)).collect();
        unions(context, &differing, |node| self.views.all.reaches(node))
    }
}

/// A reason why a texture is not to be seen.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Why {
    Covered,
    Removed,
    Dark,
    Hidden,
    Beside,
}

impl Why {
    fn case(self) -> &'static str {
        match self {
            Why::Covered => "covered",
            Why::Removed => "removed",
            Why::Dark => "dark",
            Why::Hidden => "hidden",
            Why::Beside => "beside",
        }
    }
}

/// The facts about the use of a texture.
#[derive(Default)]
struct TextureSightings {
    /// Whether an object is painted with the texture, drawn or not.
    is_used: bool,
    /// Whether a picture shows the texture somewhere.
    is_seen: bool,
    /// The reasons why the texture is not seen, each once.
    reasons: Vec<Why>,
    /// The paint that covers the texture.
    cover: Option<Span>,
    /// A record that covers the texture, is about the same object, and is in no other finding.
    again: Option<Span>,
    /// Whether an object with the texture is hidden in another way than by lying inside of a solid.
    is_hidden_otherwise: bool,
}

impl TextureSightings {
    fn add(&mut self, why: Why, cover: Option<Span>) {
        if !self.reasons.contains(&why) {
            self.reasons.push(why);
        }
        self.cover = self.cover.or(cover);
    }

    /// Adds that the paint `cover` covers the texture, unless W334 reports that the object takes the texture back.
    fn cover(
        &mut self,
        scene: &Scene,
        painting: &Painting,
        cover: NodeId,
        overriding: &FxHashMap<u32, bool>,
    ) {
        let origin = |node: NodeId| scene.origins[node as usize];
        let Origin { id, span } = origin(cover);
        let is_own = origin(painting.node).id == id;
        match overriding.get(&span.start) {
            Some(true) if is_own => {}
            None if is_own => {
                self.add(Why::Covered, Some(span));
                self.again = self.again.or(Some(span));
            }
            _ => self.add(Why::Covered, Some(span)),
        }
    }

    /// Whether all objects with the texture are hidden inside of solids, which W335 reports.
    fn is_in_solids(&self) -> bool {
        self.reasons == [Why::Hidden] && !self.is_hidden_otherwise
    }

    fn said(&self, given: &Given) -> Option<Diagnostic> {
        if self.is_seen || self.is_in_solids() {
            return None;
        }
        let case = match self.reasons[..] {
            [] => return None,
            [why] => why.case(),
            _ => "",
        };
        let d = Diagnostic::new(Code::W331, given.params.span())
            .case(case)
            .with("type", Value::Term(given.params.ty.title))
            .with("width", USUAL[0].to_string())
            .with("height", USUAL[1].to_string());
        Some(match self.cover {
            Some(cover) if case == Why::Covered.case() => d.label(cover, "cover"),
            _ => d,
        })
    }
}

/// The records that may leave an object without a diffuse part.
const OPTICS: &[RecordKind] = &[RecordKind::Optics, RecordKind::OpticsRgb];

/// Number of nodes above which hidden parts and parts out of view are not looked for: that takes too long for an
/// editor.
const MAX_NODES: usize = 5000;

/// The aspects of a scene that can be seen, with more and more of the scene left out.
struct Views<'a> {
    scene: &'a Scene,
    /// The aspects that can be seen of all that is drawn.
    all: VisibleAspects,
    /// The aspects that a ray of a camera may meet.
    met: Option<VisibleAspects>,
    /// The aspects that cameras may see in pictures of the usual size.
    viewed: Option<VisibleAspects>,
    /// For each node that is drawn a paint above it that gives a texture.
    covers: Vec<Option<NodeId>>,
    /// For each node the reason why a part around it, or within it, is not seen.
    unseen: Vec<Option<UnseenReason>>,
}

impl<'a> Views<'a> {
    fn new(context: &Context<'a>, has_textures: bool) -> Option<Views<'a>> {
        let scene = context.scene;
        let root = scene.render?.root;
        let all = VisibleAspects::new(scene, root, &LeftOut::default());
        let mut views = Views {
            scene,
            covers: covers(scene, root, &all),
            all,
            met: None,
            viewed: None,
            unseen: Vec::new(),
        };
        if !has_textures || scene.nodes.len() > MAX_NODES {
            return Some(views);
        }
        let plan = Plan::of_picture(scene)?;
        let reach = |left_out: &LeftOut| VisibleAspects::new(scene, root, left_out);
        // If nothing at all is to be seen, the textures are not to blame.
        let met = reach(&plan.left_out);
        views.unseen = unseen_parts(scene, &plan.unseen);
        views.met = (!plan.left_out.all() && met.shows(root)).then_some(met);
        if !plan.on(Effect::Reflection) && !plan.on(Effect::Refraction) {
            let beside = beside_all_views(scene, context.bounds(), root, &plan.left_out);
            let viewed = beside.map(|beside| reach(&beside));
            views.viewed = viewed.filter(|v| v.shows(root));
        }
        Some(views)
    }

    fn showing(&self, painting: &Painting) -> Showing {
        self.all.showing(self.scene, painting.node)
    }

    /// Adds to `found` whether a painting is to be seen, and if not, why.
    fn judge(
        &self,
        painting: &Painting,
        overriding: &FxHashMap<u32, bool>,
        found: &mut TextureSightings,
    ) {
        let is_lost = |reach: &Option<VisibleAspects>| {
            let shows = |r: &VisibleAspects| r.showing(self.scene, painting.node) == Showing::Shown;
            reach.as_ref().is_some_and(|r| !shows(r))
        };
        match self.showing(painting) {
            Showing::Absent => {}
            Showing::Removed => found.add(Why::Removed, None),
            Showing::Covered => match self.covers[painting.node as usize] {
                Some(cover) => found.cover(self.scene, painting, cover, overriding),
                None => found.add(Why::Covered, None),
            },
            Showing::Dark => found.add(Why::Dark, None),
            Showing::Shown if is_lost(&self.met) => {
                found.add(Why::Hidden, None);
                let why = self.unseen.get(painting.node as usize).copied().flatten();
                found.is_hidden_otherwise |= !matches!(why, Some(UnseenReason::Inside(_)));
            }
            Showing::Shown if is_lost(&self.viewed) => found.add(Why::Beside, None),
            Showing::Shown => found.is_seen = true,
        }
    }
}

/// For each node that is drawn the nearest paint with a texture on one of the ways down to the node.
fn covers(scene: &Scene, root: NodeId, reach: &VisibleAspects) -> Vec<Option<NodeId>> {
    let mut covers = vec![None; root as usize + 1];
    // Children stand before their parents.
    for node in (0..=root).rev().filter(|&n| reach.reaches(n)) {
        let own = match scene.nodes[node as usize] {
            Node::Paint { paint, .. } => scene.paints[paint as usize].texture.is_some(),
            _ => false,
        };
        let cover = if own {
            Some(node)
        } else {
            covers[node as usize]
        };
        for child in scene.nodes[node as usize].children() {
            let below = &mut covers[child as usize];
            *below = below.or(cover);
        }
    }
    covers
}

/// For each node the reason why a part around it, or within it, is not seen.
fn unseen_parts(scene: &Scene, unseen: &[Unseen]) -> Vec<Option<UnseenReason>> {
    let mut parts = vec![None; scene.nodes.len()];
    // W335 reports only parts that have a name.
    for part in unseen.iter().filter(|p| named(scene, p.node).is_some()) {
        parts[part.node as usize] = Some(part.why);
    }
    // Children stand before their parents.
    for (i, node) in scene.nodes.iter().enumerate().rev() {
        let above = parts[i];
        for child in node.children() {
            let below = &mut parts[child as usize];
            *below = below.or(above);
        }
    }
    fold_up(&scene.nodes, |id, node, done: &[Option<UnseenReason>]| {
        let mut below = node.children().map(|n| done[n as usize]);
        parts[id as usize].or_else(|| below.find_map(|why| why))
    })
}
