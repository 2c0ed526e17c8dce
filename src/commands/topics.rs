//! What people want to make, which is no type of record: a page each of `zpg explain`, with a scene that does it.

use crate::diagnostics::Language;
use crate::syntax::words::plain;

/// A page.
pub(super) struct Topic {
    /// In English and in Czech.
    titles: [&'static str; 2],
    /// What else leads here, without accents and in lower case.
    words: &'static [&'static str],
    /// Text and a scene, in English and in Czech.
    texts: [&'static str; 2],
}

/// The pages of a topic, which are called after it.
macro_rules! texts {
    ($name:literal) => {
        [
            include_str!(concat!("topics/", $name, ".md")),
            include_str!(concat!("topics/", $name, ".cs.md")),
        ]
    };
}

pub(super) const TOPICS: [Topic; 5] = [
    Topic {
        titles: ["glass", "sklo"],
        words: &["transparent", "transparency", "pruhledny", "pruhlednost"],
        texts: texts!("glass"),
    },
    Topic {
        titles: ["mirror", "zrcadlo"],
        words: &["reflection", "zrcadleni"],
        texts: texts!("mirror"),
    },
    Topic {
        titles: ["prism", "hranol"],
        words: &[],
        texts: texts!("prism"),
    },
    Topic {
        titles: ["shadow", "stín"],
        words: &["shadows", "stiny"],
        texts: texts!("shadow"),
    },
    Topic {
        titles: ["checkerboard", "šachovnice"],
        words: &["checker", "chessboard"],
        texts: texts!("checkerboard"),
    },
];

impl Topic {
    /// The topic of a word.
    pub(super) fn of(word: &str) -> Option<&'static Topic> {
        let word = plain(word);
        let is_its = |topic: &&Topic| {
            let mut titles = topic.titles.iter().map(|title| plain(title));
            titles.any(|title| title == word) || topic.words.contains(&word.as_str())
        };
        TOPICS.iter().find(is_its)
    }

    /// What it is called.
    pub(super) fn title(&self, language: Language) -> &'static str {
        self.titles[usize::from(language == Language::Czech)]
    }

    /// What is to be said of it, as Markdown.
    pub(super) fn text(&self, language: Language) -> &'static str {
        self.texts[usize::from(language == Language::Czech)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Analysis;
    use crate::diagnostics::Code;
    use crate::trace::plan::{Effect, Plan};

    /// Every page has one scene, which is right and needs what the page is about.
    #[test]
    fn scenes_do_what_they_are_for() {
        for (topic, effect) in TOPICS.iter().zip([
            Some(Effect::Refraction),
            Some(Effect::Reflection),
            None,
            Some(Effect::Shadows),
            Some(Effect::Checkerboard),
        ]) {
            let mut scenes = Vec::new();
            for language in [Language::English, Language::Czech] {
                let text = topic.text(language);
                let title = topic.title(language);
                let (_, rest) = text.split_once("```zpg\n").expect(title);
                let (scene, rest) = rest.split_once("```\n").expect(title);
                assert!(!rest.contains("```"), "{title}");
                let analysis = Analysis::new("a.zpg", scene.into());
                // It is seen with a camera and by a light of our own.
                let is_right = |code| matches!(code, Code::N602 | Code::N603);
                let found = analysis.findings().iter().map(|d| d.code);
                let wrong: Vec<Code> = found.filter(|code| !is_right(*code)).collect();
                assert_eq!(wrong, [], "{title}");
                let plan = Plan::of_picture(&analysis.scene).expect(title);
                assert!(effect.is_none_or(|effect| plan.on(effect)), "{title}");
                // The same records in both languages.
                let numbers = |line: &str| line.split('#').next().unwrap_or("").trim().to_owned();
                scenes.push(scene.lines().map(numbers).collect::<Vec<_>>());
            }
            assert_eq!(scenes[0], scenes[1]);
        }
    }
}
