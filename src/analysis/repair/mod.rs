//! Proposals: fixes that are tried in order to find what a person most likely meant.
//!
//! A candidate for a line ([`candidates`]) or for many lines at once ([`whole`]) is written into the text, and the
//! scene is read again. The candidate that leaves the fewest findings comes first ([`judge`]); of equally good ones,
//! the most frequent slip comes first ([`Habit`]). The number of trials is a function of the text alone: the same file
//! always gets the same proposals.

mod aim;
mod candidates;
mod characters;
mod definitions;
mod early;
mod elsewhere;
mod heads;
mod in_comments;
mod judge;
mod lamp_operand;
mod leading_zeros;
mod missing;
mod retell;
mod slashes;
mod surplus;
mod switched_off;
mod unused_operand;
mod whole;

use rustc_hash::FxHashSet;

use super::{Analysis, lone_signs};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, SourceFile, Span, Value, fixes};
use crate::scene::names;
use crate::syntax::Item;
use candidates::{Candidate, Habit, LineContext};
pub use judge::draws_nothing;
use judge::{Left, ends_on_line, errors_at, has_error_at, hidden};

/// The most texts that are tried for one file.
const TRIALS: usize = 64;
/// The most tokens that are read for one file in all trials together.
const TOKENS: usize = 100_000;
/// The cost, in tokens, of a token that is read by trying all ways to cut the text.
const SEARCHED: usize = 8;
/// The most proposals for one finding.
const PROPOSALS: usize = 3;

/// Returns the findings of a scene; the first fix of each is what a person most likely meant. Of several errors that
/// one fix repairs, one is left.
pub fn proposals(analysis: &Analysis) -> Vec<Diagnostic> {
    proposals_for(analysis, analysis.findings().to_vec())
}

/// Like [`proposals`], but takes the findings by value: where there are millions, that saves a copy of them.
pub fn proposals_for(analysis: &Analysis, findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let document = &analysis.document;
    let tokens = document.tokens.len() + SEARCHED * document.searched;
    let mut engine = Engine {
        analysis,
        findings,
        trials: TRIALS.min(TOKENS / tokens.max(1)),
        postponed: None,
    };
    if analysis.is_records() && engine.findings.iter().any(is_tried) {
        engine.leading_zeros();
        heads::retell(engine.analysis, &mut engine.findings);
        in_comments::retell(engine.analysis, &mut engine.findings);
        engine.switched_off();
        engine.copied();
        engine.lamp_operands();
        missing::retell(engine.analysis, &mut engine.findings);
        unused_operand::add(engine.analysis, &mut engine.findings);
        surplus::retell(engine.analysis, &mut engine.findings);
        engine.whole();
        engine.elsewhere();
        engine.lines();
        engine.lacking();
        engine.behind_comments();
        lone_signs::retell(&analysis.source, &analysis.document, &mut engine.findings);
    }
    engine.findings
}

/// Whether trials may find fixes for a finding. An error about a profile's radius (E208) has all its fixes already.
pub fn is_tried(d: &Diagnostic) -> bool {
    d.is_error() && d.code != Code::E208 || matches!(d.code, Code::W319 | Code::S505)
}

struct Engine<'a> {
    analysis: &'a Analysis,
    findings: Vec<Diagnostic>,
    /// How many trials are left.
    trials: usize,
    /// Findings that wait until other lines have their proposals, and are then tried again. `None` outside of `lines`.
    postponed: Option<Vec<Diagnostic>>,
}

/// A candidate that was tried, the scene that it makes, and the span of the line in the text of that scene.
struct Trial {
    candidate: Candidate,
    scene: Analysis,
    line: Span,
    /// The number of errors in the scene, without those that are [hidden] or that the candidate only brought to light.
    errors: usize,
}

impl Engine<'_> {
    /// Applies a fix, and those of `others` that do not overlap it, and reads the scene. `None` if no trials are left.
    fn attempt<'f>(&mut self, fix: Option<&'f Fix>, others: &'f [Fix]) -> Option<Analysis> {
        Some(self.attempt_at(fix, others, Span::default())?.0)
    }

    /// Like `attempt`, and also returns the span of `line` in the new text.
    fn attempt_at<'f>(
        &mut self,
        fix: Option<&'f Fix>,
        others: &'f [Fix],
        line: Span,
    ) -> Option<(Analysis, Span)> {
        self.trials = self.trials.checked_sub(1)?;
        let source = &self.analysis.source;
        let (edits, _) = fixes::edits(&source.text, fix.into_iter().chain(others));
        let text = fixes::edited(&source.text, &edits);
        let moved = |at: u32| {
            let before = edits.iter().filter(|e| e.span.end <= at);
            let grown = before.map(|e| e.text.len() as i64 - (e.span.range().len() as i64));
            u32::try_from(i64::from(at) + grown.sum::<i64>()).unwrap_or(at)
        };
        let line = Span::new(moved(line.start), moved(line.end));
        Some((Analysis::trial(source.with_text(text)), line))
    }

    /// Tries slips that affect many lines at once. One that proves right gets one finding in place of its many errors.
    fn whole(&mut self) {
        for find in whole::ALL {
            if let Some(matter) = find(self.analysis, &self.findings) {
                self.settle(matter);
            }
        }
        for matter in definitions::slips(self.analysis, &self.findings) {
            self.settle(matter);
        }
        for matter in early::definitions(self.analysis, &self.findings) {
            self.settle(matter);
        }
        for matter in early::properties(self.analysis, &self.findings) {
            self.settle(matter);
        }
        whole::cycles(self.analysis, &mut self.findings);
    }

    /// Replaces the errors on many lines by the one finding of `matter`, if its fix leaves fewer errors.
    fn settle(&mut self, matter: whole::Matter) {
        let Some(scene) = self.attempt(matter.finding.fixes.first(), &[]) else {
            return;
        };
        let after = judge::errors(&scene);
        if after >= judge::errors(self.analysis) {
            return;
        }
        let all = after == 0;
        let is_part = |d: &Diagnostic| {
            let touched = matter.spans.iter().any(|s| s.touches(d.span));
            d.is_error() && (all || touched && !has_safe_fix(d))
        };
        self.findings.retain(|d| !is_part(d));
        if all {
            self.keep_what_stays(&scene);
        }
        self.findings.push(matter.finding);
        crate::diagnostics::sort(&mut self.findings);
    }

    /// Drops the warnings and notes that come from misreading the text: those that the scene with the fix does not have
    /// on the same line.
    fn keep_what_stays(&mut self, scene: &Analysis) {
        // Lines are the same by their numbers or, where the fix adds some, by their texts.
        let is_longer = scene.source.line_count() != self.analysis.source.line_count();
        fn key<'a>(a: &'a Analysis, d: &Diagnostic, is_longer: bool) -> (Code, usize, &'a str) {
            let line = a.source.line_index(a.source.floor(d.span.start));
            match is_longer {
                true => (d.code, 0, &a.source.text[a.source.line_span(line).range()]),
                false => (d.code, line, ""),
            }
        }
        let said: FxHashSet<_> = (scene.findings().iter())
            .map(|d| key(scene, d, is_longer))
            .collect();
        (self.findings)
            .retain(|d| d.is_error() || said.contains(&key(self.analysis, d, is_longer)));
    }

    /// Tries lines that may be to blame for errors on other lines. If one is, a finding about it replaces those errors.
    fn elsewhere(&mut self) {
        if self.trials == 0 {
            return;
        }
        for suspect in elsewhere::suspects(self.analysis, &self.findings) {
            let mut trials: Vec<(usize, Left, Fix, Analysis)> = Vec::new();
            for candidate in suspect.candidates {
                let Some(scene) = self.attempt(Some(&candidate.fix), &[]) else {
                    break;
                };
                trials.push((
                    judge::errors(&scene),
                    judge::left(&scene),
                    candidate.fix,
                    scene,
                ));
            }
            trials.sort_by_key(|t| (t.0, t.1));
            let errors = judge::errors(self.analysis);
            let Some((left, _, fix, scene)) = trials.into_iter().next() else {
                continue;
            };
            if left + suspect.least > errors {
                continue;
            }
            let line = |source: &SourceFile, span: Span| source.position(span.start).line;
            let source = &self.analysis.source;
            self.findings.retain(|d| {
                let is_left = |&(code, span): &(Code, Span)| {
                    code == d.code && line(&scene.source, span) == line(source, d.span)
                };
                let misread = suspect.misread.touches(d.span);
                !misread && (!d.is_error() || scene.errors.iter().any(is_left))
            });
            self.findings.push(suspect.finding.fix(fix));
            crate::diagnostics::sort(&mut self.findings);
        }
    }

    /// Finds proposals for single lines, one after the other. A line with several equally good guesses waits until
    /// other lines have proposals: a scene with other errors tells little about which guess is right.
    fn lines(&mut self) {
        self.postponed = Some(Vec::new());
        let mut mended: Option<Span> = None;
        let mut at = 0;
        while at < self.findings.len() && self.trials > 1 {
            let finding = &self.findings[at];
            let done = mended.is_some_and(|line| line.touches(finding.span));
            let settled = has_safe_fix(finding)
                || finding.code == Code::S505
                || leading_zeros::is_told(finding)
                || whole::is_of_many(finding)
                || in_comments::is_told(finding)
                || switched_off::is_told(finding)
                || missing::is_told(finding)
                || early::is_told(finding)
                || definitions::is_told(finding);
            if is_tried(finding)
                && !done
                && !settled
                && let Some(line) = self.mend_line(at)
            {
                mended = Some(line);
                // Earlier findings may be gone, so the index is found anew.
                at = self.findings.partition_point(|d| d.span.start <= line.end);
                continue;
            }
            at += 1;
        }
        for finding in self.postponed.take().unwrap_or_default() {
            if let Some(at) = self.findings.iter().position(|d| *d == finding) {
                self.mend_line(at);
            }
        }
    }

    /// Finds proposals for the line of a finding, or postpones that. Returns the span of the line, or `None` if there
    /// is nothing to propose.
    fn mend_line(&mut self, at: usize) -> Option<Span> {
        let places = LineContext::both(self.analysis, self.findings[at].span.start);
        let place = places.iter().find(|place| self.mend(at, place))?;
        Some(place.line())
    }

    /// Adds to findings about records with too few numbers which parameters are missing.
    fn lacking(&mut self) {
        let few = |d: &&mut Diagnostic| d.code == Code::E008 && d.case.is_empty();
        for d in self.findings.iter_mut().filter(few).take(TRIALS) {
            let places = LineContext::both(self.analysis, d.span.start);
            let lacking = places.first().and_then(LineContext::lacking);
            // A fix already says which number may be missing.
            if let Some((note, values)) = lacking.filter(|l| l.0 == "lack" || d.fixes.is_empty()) {
                d.values.extend(values);
                d.notes.push(note);
            }
        }
    }

    /// Adds a note to findings about surplus numbers behind a comment, as in `# ball #1`: it says where the comment
    /// ends.
    fn behind_comments(&mut self) {
        let text = &self.analysis.source.text;
        let many = |d: &&mut Diagnostic| d.code == Code::E009 && !d.notes.contains(&"comment-ends");
        for d in self.findings.iter_mut().filter(many) {
            let before = text[..d.span.start as usize].trim_end_matches([' ', '\t']);
            if before.ends_with('#') {
                d.notes.push("comment-ends");
            }
        }
    }

    /// Tries the candidates for a finding and keeps the best as its fixes. Returns whether the finding is done with: it
    /// has fixes, is dropped as a consequence of another error, or is postponed.
    fn mend(&mut self, at: usize, place: &LineContext) -> bool {
        let finding = self.findings[at].clone();
        let is_pointless = |fix: &Fix| place.is_behind_use(fix) || place.is_held(&finding, fix);
        (self.findings[at].fixes).retain(|fix| !is_pointless(fix));
        let finding = self.findings[at].clone();
        let undefined = undefined(&self.findings);
        let fixes = self.findings.iter().flat_map(|d| &d.fixes);
        let taken: Vec<u32> = fixes.flat_map(candidates::new_ids).collect();
        let mut candidates = place.candidates(&finding, &undefined, &taken);
        let is_new = candidates.iter().any(|c| {
            let same = |f: &Fix| f.edits == c.fix.edits;
            !finding.fixes.iter().any(same)
        });
        // A definition that is to be moved is settled, unless another ID may be meant.
        if finding.code == Code::E107 && !finding.fixes.is_empty() && !is_new {
            return false;
        }
        // An error elsewhere that has no proposal may be a consequence of this one.
        let is_hopeless = |d: &Diagnostic| d.is_error() && d.fixes.is_empty() && *d != finding;
        let is_undefined = finding.code == Code::E101;
        let is_asked = is_new || self.findings.iter().any(is_hopeless);
        if !is_asked && !is_undefined {
            return false;
        }
        let knows_characters = candidates.iter().any(|c| c.habit == Habit::Characters);
        for fix in &finding.fixes {
            // The title of the fix may use the values of its finding.
            let mut fix = fix.clone();
            if fix.values.is_empty() {
                fix.values.clone_from(&finding.values);
            }
            match candidates.iter_mut().find(|c| c.fix.edits == fix.edits) {
                // The title of a candidate that writes a type names the type, so the candidate stays.
                Some(same) if same.ty.is_some() => {}
                Some(same) => same.fix = fix,
                // The finding's own fix knows less about mistyped characters than the candidates.
                None if knows_characters => {}
                None => candidates.push(Candidate {
                    habit: Habit::Proposed,
                    fix,
                    ty: None,
                }),
            }
        }
        let line = place.line();
        // A fix that moves definitions would take this line to another place.
        let moves = |d: &Diagnostic| d.code == Code::E107;
        // A safe fix for another finding on the same line is applied, too: it is not in question here.
        let certain = |d: &Diagnostic| d.code == Code::E003 && has_safe_fix(d) && *d != finding;
        // An undefined ID may be the one that cannot be read at the start of this line.
        let is_word = matches!(finding.code, Code::E003 | Code::E012);
        let is_head = is_word && finding.span.start == line.start;
        let is_named = |d: &Diagnostic| is_head && d.code == Code::E101;
        let elsewhere = |d: &&Diagnostic| {
            d.is_error() && (!line.touches(d.span) || certain(d)) && !moves(d) && !is_named(d)
        };
        let is_included = |f: &&Fix| candidates.iter().any(|c| c.includes(f));
        let others: Vec<Fix> = (self.findings.iter().filter(elsewhere))
            .filter_map(|d| d.applicable_fix(true).or(d.fixes.first()))
            .filter(|fix| !is_included(fix))
            .cloned()
            .collect();
        if !is_asked && others.is_empty() {
            return false;
        }
        let Some((base, own_line)) = self.attempt_at(None, &others, line) else {
            return false;
        };
        // A fix for a finding on another line also defines this ID, so this finding goes.
        let is_choice = |f: &Fix| f.applicability == Applicability::Choice;
        let is_same = |d: &Diagnostic| d.code == Code::E101 && d.values == finding.values;
        let is_for_it = |d: &Diagnostic| is_same(d) && *d != finding && !d.fixes.is_empty();
        if is_undefined
            && !has_error_at(&base, own_line)
            && !others.iter().any(is_choice)
            && !self.findings.iter().any(is_for_it)
        {
            self.findings.remove(at);
            return true;
        }
        if !is_asked {
            return false;
        }
        let errors_before = judge::errors(&base);
        let mut trials: Vec<Trial> = Vec::new();
        for candidate in candidates {
            let attempt = self.attempt_at(Some(&candidate.fix), &others, line);
            let Some((scene, own_line)) = attempt else {
                break;
            };
            let hidden = hidden(&finding, &candidate, &scene, own_line);
            let again = judge::redefined(&finding, &candidate, &base, &scene);
            let errors = judge::errors(&scene) - hidden - again;
            let least = trials.first().map_or(usize::MAX, |t| t.errors);
            let better = match finding.is_error() {
                true => errors < errors_before,
                false => errors <= errors_before,
            };
            // A candidate that is not the finding's own proposal must leave no error on the line.
            let mends = match candidate.habit {
                Habit::Proposed => true,
                // A record that lacks numbers would take those of the next line, behind the comment.
                Habit::Comment => !has_error_at(&scene, own_line) && ends_on_line(&scene, own_line),
                _ => errors_at(&scene, own_line) == hidden,
            };
            if !better || errors > least || finding.is_error() && !mends {
                continue;
            }
            // A transformation that does nothing is not what was meant.
            let is_pointless = |d: &Diagnostic| d.code == Code::W327 && own_line.touches(d.span);
            if candidate.ty.is_some() && scene.findings().iter().any(is_pointless) {
                continue;
            }
            if errors < least {
                trials.clear();
            }
            trials.push(Trial {
                candidate,
                scene,
                line: own_line,
                errors,
            });
        }
        // A mere change of sign or of a digit, or a space, wins over another type.
        let is_slight = |t: &Trial| {
            use Habit::*;
            matches!(t.candidate.habit, Sign | Digit | Glued | GluedAsBeside)
        };
        if trials.iter().any(is_slight) {
            trials.retain(is_slight);
        }
        let is_open = |d: &Diagnostic| is_hopeless(d) && !line.touches(d.span);
        if trials.len() > 1
            && self.findings.iter().any(is_open)
            && let Some(postponed) = &mut self.postponed
        {
            postponed.push(finding);
            return true;
        }
        let is_choice = trials.len() > 1 || !finding.is_error();
        let mut judged: Vec<(Left, Trial)> = (trials.into_iter())
            .map(|t| match is_choice {
                true => (judge::left(&t.scene), t),
                false => (Left::default(), t),
            })
            .collect();
        judged.sort_by_key(|(left, t)| {
            let (c, doubt) = (&t.candidate, (left.in_vain, left.warnings));
            let (untold, own) = (!place.tells(c), place.puts_own_id(&finding, &c.fix));
            (untold, doubt, own, c.habit, left.notes)
        });
        if !finding.is_error() {
            let before = judge::left(&base);
            judged.retain(|(left, _)| *left < before);
        }
        let is_either = aim::settle(&mut judged, place.id());
        let Some((_, best)) = judged.first() else {
            return false;
        };
        // A number may be lost in several places: all are named, or none.
        let fits = |j: &&(Left, Trial)| {
            (j.0.in_vain, j.0.warnings) == (judged[0].0.in_vain, judged[0].0.warnings)
        };
        let places = match best.candidate.habit {
            Habit::Lost => judged.iter().filter(fits).count(),
            _ => 1,
        };
        if places > PROPOSALS {
            return false;
        }
        let clean = !has_error_at(&best.scene, best.line);
        let alone = clean && others.is_empty() && judge::is_right(&best.scene);
        let alone = alone
            || clean
                && (self.attempt(Some(&best.candidate.fix), &[]))
                    .is_some_and(|scene| judge::is_right(&scene));
        let mut index = 0;
        self.findings.retain(|d| {
            let is_included = d.fixes.iter().any(|f| best.candidate.includes(f));
            let on_line = clean && line.touches(d.span) && (!has_safe_fix(d) || is_included);
            let own = index == at;
            index += 1;
            own || d.code == judge::NO_PICTURE
                || !(d.is_error() && (alone || on_line || best.candidate.renames(d)))
        });
        if alone && finding.is_error() && others.is_empty() {
            self.keep_what_stays(&judged[0].1.scene);
        }
        let at = (self.findings.iter().position(|d| *d == finding)).unwrap_or(at);
        // A candidate that leaves more objects without use is not proposed beside the best one.
        let least = judged[0].0.in_vain;
        // While there are other errors, nobody can tell which object is left over.
        let names_another = |j: &&(Left, Trial)| j.1.candidate.habit.names_another();
        let is_lost = finding.code == Code::E101
            && matches!(
                judged[0].1.candidate.habit,
                Habit::Shifted | Habit::Reference | Habit::Id
            )
            && (named(&finding).is_some_and(|id| is_lost(self.analysis, id))
                || place.is_of_others(&finding, &judged[0].1.candidate))
            && !defines(&judged[0].1.scene, named(&finding));
        // An assignment of an object to itself may mean any of the IDs that fit equally well.
        let of_itself = place.assigns_itself(&finding)
            && (judged.iter().filter(names_another).filter(fits)).count() > 1;
        let is_open = place.is_operation()
            && judge::errors(&judged[0].1.scene) > 0
            && judged.first().is_some_and(|j| names_another(&j))
            && judged.iter().filter(names_another).count() > 1
            || of_itself;
        let is_place = |j: &&(Left, Trial)| j.1.candidate.habit != Habit::Lost || fits(j);
        // Beside a shift of both IDs, a proposal that keeps the right one of the two is shown, too.
        let keeps_one = |j: &(Left, Trial)| j.1.candidate.habit == Habit::Reference;
        let kept = judged.iter().position(keeps_one);
        let kept = kept.filter(|_| finding.code == Code::E104);
        let is_best =
            |&(i, j): &(usize, &(Left, Trial))| is_open || j.0.in_vain == least || Some(i) == kept;
        let best = judged.iter().enumerate().filter(is_best).map(|(_, j)| j);
        // Different edits may make the same text: it is proposed once.
        let mut made: FxHashSet<String> = FxHashSet::default();
        let is_other = |j: &&(Left, Trial)| {
            let words: Vec<&str> = j.1.scene.source.text.split_whitespace().collect();
            made.insert(words.join(" "))
        };
        let best = best.filter(is_place).filter(is_other);
        // Of several ways to write the words as a comment, the first is enough.
        let mut comments = 0;
        let best = best.map(|j| &j.1.candidate).filter(|c| {
            comments += usize::from(c.habit == Habit::Comment);
            c.habit != Habit::Comment || comments == 1
        });
        let best: Vec<&Candidate> = best.take(PROPOSALS).collect();
        // If a comment says that the object that is cut from is no hole, swapping the operands is doubtful.
        let is_doubted = finding.code == Code::W319 && place.cuts_what_is_no_hole();
        let finding = &mut self.findings[at];
        retell::retell(finding, &best, place);
        if is_open || places > 1 {
            finding.notes.push("choose");
        }
        // The best proposal would not lower the number of errors.
        let is_hidden = finding.is_error() && judge::errors(&judged[0].1.scene) >= errors_before;
        if is_lost {
            finding.notes.push("lost");
        }
        if is_open || places > 1 || is_hidden || is_lost || is_either || is_doubted {
            (finding.fixes.iter_mut()).for_each(|f| f.applicability = Applicability::Choice);
        }
        true
    }
}

/// The ID that a finding speaks of.
fn named(d: &Diagnostic) -> Option<u32> {
    match d.values.iter().find(|v| v.0 == "id") {
        Some((_, Value::Text(text))) => text.parse().ok(),
        _ => None,
    }
}

/// Whether an undefined ID rather lacks its definition than is miswritten: several records name or change the ID, or
/// the next smaller and the next larger ID are both defined.
fn is_lost(analysis: &Analysis, id: u32) -> bool {
    let document = &analysis.document;
    let records = || document.items.iter().filter_map(Item::record);
    let changed = records().filter(|r| r.id == id).count();
    let named = records().flat_map(|r| names::references(document, r));
    let is_defined = |id: Option<u32>| analysis.scene.entities.iter().any(|e| Some(e.id) == id);
    changed + named.filter(|&named| named == id).take(2).count() > 1
        || is_defined(id.checked_sub(1)) && is_defined(id.checked_add(1))
}

/// Whether a scene defines an ID.
fn defines(analysis: &Analysis, id: Option<u32>) -> bool {
    analysis
        .scene
        .entities
        .iter()
        .any(|e| Some(e.id) == id && e.kind.is_some())
}

/// The IDs that are used but defined nowhere, ascending, of the first [`TRIALS`] findings that have no other
/// explanation.
fn undefined(findings: &[Diagnostic]) -> Vec<u32> {
    let mut all: Vec<u32> = (findings.iter())
        .filter(|d| d.code == Code::E101 && !in_comments::is_told(d) && !missing::is_told(d))
        .filter(|d| !switched_off::is_told(d))
        .filter_map(named)
        .take(TRIALS)
        .collect();
    all.sort_unstable();
    all.dedup();
    all
}

fn has_safe_fix(d: &Diagnostic) -> bool {
    (d.fixes.iter()).any(|f| f.applicability == Applicability::Safe)
}
