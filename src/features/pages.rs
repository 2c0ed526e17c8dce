//! The pages of findings and of record types, as Markdown: what `zpg explain` prints and editors show.

use std::fmt::Write as _;

use crate::diagnostics::Code;
use crate::syntax::describe::Group;
use crate::syntax::table::RecordType;

/// The page of a finding.
pub fn code_page(code: Code) -> String {
    format!(
        "# {} ({})\n\n{}\n",
        code.name(),
        code.as_str(),
        code.explanation().trim_end()
    )
}

/// The page of a record type.
pub fn type_page(ty: &RecordType) -> String {
    let mut page = format!("# {} ({})\n\n", ty.title, ty.code);
    let signature = format!("ID {} {}", ty.code, ty.signature());
    // Writing to a string cannot fail.
    let _ = write!(
        page,
        "{}; keyword `{}`. {}\n\n    {}\n\n{}\n",
        ty.family.title(),
        ty.keyword,
        ty.effect_text(),
        signature.trim_end(),
        ty.summary
    );
    let parameters = parameters(ty);
    if !parameters.is_empty() {
        let _ = write!(page, "\n## Parameters\n\n{parameters}");
    }
    let _ = write!(page, "\n## Example\n\n    {}\n", ty.example);
    page
}

/// A line for each parameter, in columns.
fn parameters(ty: &RecordType) -> String {
    let width = |text: &str| text.chars().count();
    let rows: Vec<_> = ty
        .described()
        .map(|(group, p)| (group, p.name, p.doc, p.rule_text()))
        .collect();
    let names = rows.iter().map(|r| width(r.1)).max().unwrap_or(0);
    let docs = rows.iter().map(|r| width(r.2)).max().unwrap_or(0);
    let mut out = String::new();
    let mut last = Group::Fixed;
    for (group, name, doc, rule) in rows {
        if group != last {
            let heading = match group {
                Group::Fixed => "",
                Group::Repeated(0) => "then N times:",
                Group::Repeated(_) => "then N times again:",
                Group::Optional => "then all of these or none, on the record's last line:",
            };
            let _ = writeln!(out, "  {heading}");
            last = group;
        }
        let _ = writeln!(out, "    {name:names$}  {doc:docs$}  {rule}");
    }
    out
}
