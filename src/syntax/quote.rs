//! The user's text in messages.

/// The longest part of the user's text that a message quotes, in characters.
const QUOTE_MAX: usize = 24;

/// A token's text for a message: shortened, control characters made visible.
pub fn quote(text: &str) -> String {
    let mut out: String = text
        .chars()
        .take(QUOTE_MAX)
        .flat_map(|c| {
            if c.is_control() {
                c.escape_default().collect::<Vec<_>>()
            } else {
                vec![c]
            }
        })
        .collect();
    if text.chars().nth(QUOTE_MAX).is_some() {
        out.push('…');
    }
    format!("`{out}`")
}
