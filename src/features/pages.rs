//! The pages of findings and of record types, as Markdown: what `zpg explain` prints and editors show.

use std::fmt::Write as _;

use crate::diagnostics::{Code, Language, Value};
use crate::syntax::describe::Group;
use crate::syntax::table::RecordType;

/// The page of a finding.
pub fn code_page(code: Code, language: Language) -> String {
    format!(
        "# {} ({})\n\n{}\n",
        code.name(),
        code.as_str(),
        code.explanation(language).trim_end()
    )
}

/// The page of a record type.
pub fn type_page(ty: &RecordType, language: Language) -> String {
    let say = |message| language.say(message, &[]);
    let mut page = format!("# {} ({})\n\n", language.name(ty.title), ty.code);
    let signature = format!("ID {} {}", ty.code, ty.signature());
    let values = [
        ("family", Value::Term(ty.family.title())),
        ("keyword", ty.keyword.into()),
        ("effect", ty.effect_text(language).into()),
    ];
    // Writing to a string cannot fail.
    let _ = write!(
        page,
        "{}\n\n    {}\n\n{}\n",
        language.say("record-page", &values),
        signature.trim_end(),
        ty.summary(language)
    );
    let parameters = parameters(ty, language);
    if !parameters.is_empty() {
        let _ = write!(page, "\n## {}\n\n{parameters}", say("record-parameters"));
    }
    let _ = write!(
        page,
        "\n## {}\n\n    {}\n",
        say("record-example"),
        ty.example
    );
    page
}

/// A line for each parameter, in columns.
fn parameters(ty: &RecordType, language: Language) -> String {
    let width = |text: &str| text.chars().count();
    let rows: Vec<_> = ty
        .described()
        .map(|(group, p)| (group, p.name, language.name(p.doc), p.rule_text(language)))
        .collect();
    let names = rows.iter().map(|r| width(r.1)).max().unwrap_or(0);
    let docs = rows.iter().map(|r| width(&r.2)).max().unwrap_or(0);
    let mut out = String::new();
    let mut last = Group::Fixed;
    for (group, name, doc, rule) in rows {
        if group != last {
            let heading = match group {
                Group::Fixed => String::new(),
                Group::Repeated(0) => language.say("record-repeated", &[]),
                Group::Repeated(_) => language.say("record-repeated-again", &[]),
                Group::Optional => language.say("record-optional", &[]),
            };
            let _ = writeln!(out, "  {heading}");
            last = group;
        }
        let _ = writeln!(out, "    {name:names$}  {doc:docs$}  {rule}");
    }
    out
}
