//! Ownership where pieces of a union overlap: the first piece that holds a point owns it. A boundary inside another
//! medium is given that medium on its other side.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use super::assemble::MeshPart;
use super::csg::{Operation, combine};
use super::parts::Parts;
use super::shape::DROPPED;
use super::triangle_mesh::Mesh;
use super::unite;

/// The optics and refractive index that a part is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Medium {
    /// Index into [`crate::trace::graph::Graph::optics`].
    pub optics: u32,
    /// Index into [`crate::trace::graph::Graph::indices`].
    pub index: u32,
    /// Whether the medium lets light through.
    pub clear: bool,
}

/// The most overlapping pairs of pieces with different media. If there are more, no pair is separated.
const MAX_MEDIA_PAIRS: usize = 20_000;

impl Parts {
    /// Drops pieces that are there twice: those with the same triangles, and those that are the whole of the same
    /// shape in the same place. The triangles of the latter may differ, if the shape is a part of another object.
    pub fn drop_equals(&mut self) {
        let mut seen: HashSet<u64> = HashSet::new();
        let mut wholes: HashSet<(u32, [u64; 16])> = HashSet::new();
        let skins = &self.skins;
        self.pieces.retain(|p| {
            let skin = skins.get(p.inside as usize).filter(|_| p.whole);
            let place = skin.and_then(|s| Some((s.primitive?, s.place())));
            place.is_none_or(|place| wholes.insert(place)) && seen.insert(form(p))
        });
    }

    /// Takes away from each solid what earlier solids of another medium own, if the earlier solid is clear, or always
    /// with `within`. The part of a clear solid's boundary that lies in a later clear solid becomes a piece with the
    /// later one's refractive index around it. `media` has an entry for each of the skins.
    pub fn carve(&mut self, media: &[Medium], within: bool) {
        let medium = |p: &MeshPart| media.get(p.inside as usize).filter(|_| !p.surface).copied();
        if !within && !self.pieces.iter().filter_map(medium).any(|m| m.clear) {
            return;
        }
        let boxes: Vec<_> = self.pieces.iter().map(|p| p.bounds).collect();
        let wanted = |i: usize, j: usize| {
            let Some((a, b)) = medium(&self.pieces[i]).zip(medium(&self.pieces[j])) else {
                return false;
            };
            (a.optics, a.index) != (b.optics, b.index) && (within || a.clear)
        };
        let Some(pairs) = unite::pairs(&boxes, MAX_MEDIA_PAIRS, wanted) else {
            self.troubles.unjoined += 1;
            return;
        };
        let mut seconds: Vec<Option<Mesh>> = vec![None; self.pieces.len()];
        for &(_, j) in &pairs {
            seconds[j].get_or_insert_with(|| tool(&self.pieces[j]));
        }
        // For each solid, what is left of it after it has lost points to earlier solids, and before its boundary is
        // split by later ones. It must not take the points that it has lost: those are for the earlier solid to take.
        let mut firsts: Vec<Option<Option<Mesh>>> = vec![None; self.pieces.len()];
        let mut pieces: Vec<Vec<MeshPart>> = std::mem::take(&mut self.pieces)
            .into_iter()
            .map(|p| vec![p])
            .collect();
        for (first, second) in pairs {
            let of_first = firsts[first].get_or_insert_with(|| pieces[first].first().map(tool));
            let (Some(of_first), Some(of_second)) = (of_first, &seconds[second]) else {
                continue;
            };
            let later = std::mem::take(&mut pieces[second]);
            for piece in later {
                let [_, left] = self.parted(piece, of_first);
                pieces[second].extend(left);
            }
            let [Some(a), Some(b)] = [first, second].map(|k| {
                let inside = pieces[k].first()?.inside;
                media.get(inside as usize).copied()
            }) else {
                continue;
            };
            if a.clear && b.clear && b.index != 0 {
                let earlier = std::mem::take(&mut pieces[first]);
                for piece in earlier {
                    if piece.around.is_some() {
                        pieces[first].push(piece);
                        continue;
                    }
                    let [held, left] = self.parted(piece, of_second);
                    let around = Some(b.index);
                    let held = held.map(|p| MeshPart { around, ..p });
                    pieces[first].extend(left);
                    pieces[first].extend(held);
                }
            }
        }
        self.pieces = pieces.into_iter().flatten().collect();
    }

    /// Splits a piece into the part inside the tool and the part outside; a part that shows no face is `None`. A
    /// piece that lies wholly on one side stays as it is. If the cut fails, the whole piece counts as outside.
    fn parted(&mut self, piece: MeshPart, tool: &Mesh) -> [Option<MeshPart>; 2] {
        let shown = |m: &Mesh| m.labels.iter().any(|l| *l != DROPPED);
        let [held, left] = [Operation::Intersection, Operation::Difference]
            .map(|operation| combine(&piece.mesh, tool, operation));
        let (Ok(held), Ok(left)) = (held, left) else {
            self.troubles.uncut += 1;
            return [None, Some(piece)];
        };
        match (shown(&held), shown(&left)) {
            (true, false) => [Some(piece), None],
            (false, true) => [None, Some(piece)],
            (false, false) => [None, None],
            (true, true) => [held, left].map(|mesh| {
                Some(MeshPart {
                    bounds: mesh.bounds(),
                    mesh,
                    whole: false,
                    ..piece
                })
            }),
        }
    }
}

/// The mesh of a piece as a tool: it cuts others, and all its faces are labelled [`DROPPED`], so that none is seen.
fn tool(piece: &MeshPart) -> Mesh {
    let mut tool = piece.mesh.clone();
    tool.label_all(DROPPED);
    tool
}

/// A hash of a piece's triangles and points, equal for pieces of one form in one place.
fn form(piece: &MeshPart) -> u64 {
    let mut hasher = DefaultHasher::new();
    piece.surface.hash(&mut hasher);
    piece.mesh.triangles.hash(&mut hasher);
    for p in &piece.mesh.points {
        p.map(f64::to_bits).hash(&mut hasher);
    }
    let dropped = piece.mesh.labels.iter().map(|l| *l == DROPPED);
    dropped.for_each(|d| d.hash(&mut hasher));
    hasher.finish()
}
