//! Proposals: what a person most likely meant is found by trying it.
//!
//! What may have been meant by a line ([`candidates`]) or by many at once ([`whole`]) is written into the text, the
//! scene is read again, and what leaves the least to be said comes first ([`judge`]). Of as good ones that comes
//! first which people do most ([`Habit`]). The number of trials is a function of the text alone: the same file
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
use judge::{Left, ends_on_line, errors_at, has_error_at, hidden};

/// So many texts are tried for one file at most.
const TRIALS: usize = 64;
/// So many tokens are read for one file in all trials together.
const TOKENS: usize = 100_000;
/// A token that is read by trying all ways to cut the text counts as so many.
const SEARCHED: usize = 8;
/// So many proposals are made for one finding.
const PROPOSALS: usize = 3;

/// The findings of a scene with what a person most likely meant as the first fix of each. Of several errors
/// that one fix mends, one is left.
pub fn proposals(analysis: &Analysis) -> Vec<Diagnostic> {
    proposals_for(analysis, analysis.findings().to_vec())
}

/// As [`proposals`], made of the findings themselves: of millions there is then one copy less.
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

/// Whether something may be proposed for a finding that has to be tried.
pub fn is_tried(d: &Diagnostic) -> bool {
    d.is_error() || matches!(d.code, Code::W319 | Code::S505)
}

/// Whether it is proved that nothing of the scene is drawn.
pub fn draws_nothing(analysis: &Analysis) -> bool {
    let Some(render) = &analysis.scene.render else {
        return false;
    };
    let root = ("id", Value::from(render.root_id.to_string()));
    let is_empty = |d: &Diagnostic| d.code == Code::W319 && d.values.contains(&root);
    analysis.findings().iter().any(is_empty)
}

struct Engine<'a> {
    analysis: &'a Analysis,
    findings: Vec<Diagnostic>,
    /// How many trials are left.
    trials: usize,
    /// The findings to be mended again when those on other lines have their proposals, while such ones are looked for.
    postponed: Option<Vec<Diagnostic>>,
}

/// A candidate, the scene that it makes, and where the line is in that.
struct Trial {
    candidate: Candidate,
    scene: Analysis,
    line: Span,
    /// How many errors are left that are not [hidden].
    errors: usize,
}

impl Engine<'_> {
    /// The scene with a fix and, where they do not meet it, with others.
    fn attempt<'f>(&mut self, fix: Option<&'f Fix>, others: &'f [Fix]) -> Option<Analysis> {
        Some(self.attempt_at(fix, others, Span::default())?.0)
    }

    /// The same, and where a line is then.
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

    /// Settles what is wrong with many lines at once.
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

    /// Says what is wrong with many lines in place of what is said of each, if its fix leaves fewer errors.
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

    /// Drops what is said of the text as it was misread: what is no error, and is not said of the scene that a fix
    /// makes.
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

    /// Settles what is wrong with lines whose errors are on others.
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

    /// Settles what is wrong with single lines, one after the other. A choice between guesses waits for those of other
    /// lines: a scene with an error tells little of them.
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
                // What came before may be gone.
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

    /// Mends the line of a finding, or postpones that: the line, if there is something to be proposed.
    fn mend_line(&mut self, at: usize) -> Option<Span> {
        let places = LineContext::both(self.analysis, self.findings[at].span.start);
        let place = places.iter().find(|place| self.mend(at, place))?;
        Some(place.line())
    }

    /// Says of records with too few numbers which these are.
    fn lacking(&mut self) {
        let few = |d: &&mut Diagnostic| d.code == Code::E008 && d.case.is_empty();
        for d in self.findings.iter_mut().filter(few).take(TRIALS) {
            let places = LineContext::both(self.analysis, d.span.start);
            let lacking = places.first().and_then(LineContext::lacking);
            // A fix says which it may be.
            if let Some((note, values)) = lacking.filter(|l| l.0 == "lack" || d.fixes.is_empty()) {
                d.values.extend(values);
                d.notes.push(note);
            }
        }
    }

    /// Says of numbers too many behind a comment, as in `# ball #1`, where that comment ends.
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

    /// Puts the fixes of a finding into order. Whether there is one that mends the line.
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
        // What is to be moved is settled, unless it may be of another object.
        if finding.code == Code::E107 && !finding.fixes.is_empty() && !is_new {
            return false;
        }
        // An error that has no proposal may come of this one.
        let is_hopeless = |d: &Diagnostic| d.is_error() && d.fixes.is_empty() && *d != finding;
        let is_undefined = finding.code == Code::E101;
        let is_asked = is_new || self.findings.iter().any(is_hopeless);
        if !is_asked && !is_undefined {
            return false;
        }
        let knows_characters = candidates.iter().any(|c| c.habit == Habit::Characters);
        for fix in &finding.fixes {
            // The title may speak of what the finding proposes.
            let mut fix = fix.clone();
            if fix.values.is_empty() {
                fix.values.clone_from(&finding.values);
            }
            match candidates.iter_mut().find(|c| c.fix.edits == fix.edits) {
                // What writes a type says which.
                Some(same) if same.ty.is_some() => {}
                Some(same) => same.fix = fix,
                // It knows less of characters.
                None if knows_characters => {}
                None => candidates.push(Candidate {
                    habit: Habit::Proposed,
                    fix,
                    ty: None,
                }),
            }
        }
        let line = place.line();
        // What moves lines would take this one to another place.
        let moves = |d: &Diagnostic| d.code == Code::E107;
        // What is certain on the line itself is no matter of this finding either.
        let certain = |d: &Diagnostic| d.code == Code::E003 && has_safe_fix(d) && *d != finding;
        // An ID that is not defined may be the one that cannot be read here.
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
        // A guess on another line defines it: one that mends something else, too.
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
            // What a finding does not propose itself mends the line, or is no proposal.
            let mends = match candidate.habit {
                Habit::Proposed => true,
                // Behind a comment a record that lacks numbers would take those of the next line.
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
        judged
            .sort_by_key(|(left, t)| (left.in_vain, left.warnings, t.candidate.habit, left.notes));
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
        // What leaves an object in vain is no proposal beside one that does not.
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
        // What an object is given instead of itself may be any of what is as good.
        let of_itself = place.assigns_itself(&finding)
            && (judged.iter().filter(names_another).filter(fits)).count() > 1;
        let is_open = place.is_operation()
            && judge::errors(&judged[0].1.scene) > 0
            && judged.first().is_some_and(|j| names_another(&j))
            && judged.iter().filter(names_another).count() > 1
            || of_itself;
        let is_place = |j: &&(Left, Trial)| j.1.candidate.habit != Habit::Lost || fits(j);
        // Beside IDs that are all off by one, the right one of two may stay.
        let keeps_one = |j: &(Left, Trial)| j.1.candidate.habit == Habit::Reference;
        let kept = judged.iter().position(keeps_one);
        let kept = kept.filter(|_| finding.code == Code::E104);
        let is_best =
            |&(i, j): &(usize, &(Left, Trial))| is_open || j.0.in_vain == least || Some(i) == kept;
        let best = judged.iter().enumerate().filter(is_best).map(|(_, j)| j);
        // What people read may be the same, by whatever edits.
        let mut made: FxHashSet<String> = FxHashSet::default();
        let is_other = |j: &&(Left, Trial)| {
            let words: Vec<&str> = j.1.scene.source.text.split_whitespace().collect();
            made.insert(words.join(" "))
        };
        let best = best.filter(is_place).filter(is_other);
        // One comment is as good as another.
        let mut comments = 0;
        let best = best.map(|j| &j.1.candidate).filter(|c| {
            comments += usize::from(c.habit == Habit::Comment);
            c.habit != Habit::Comment || comments == 1
        });
        let best: Vec<&Candidate> = best.take(PROPOSALS).collect();
        // By its comment, what is cut from is no hole.
        let is_doubted = finding.code == Code::W319 && place.cuts_what_is_no_hole();
        let finding = &mut self.findings[at];
        retell::retell(finding, &best, place);
        if is_open || places > 1 {
            finding.notes.push("choose");
        }
        // There would be more errors than before.
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

/// Whether the definition of an ID is rather missing than that a record names another: several records name the ID, or
/// the IDs before and behind it are defined.
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

/// The IDs that are used and defined nowhere, the first ones.
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
