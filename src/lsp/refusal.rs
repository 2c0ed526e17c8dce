//! Refusals of requests, with their reasons.

use lsp_server::{ErrorCode, ResponseError};

pub(super) type Refusal = ResponseError;

pub(super) fn refusal(code: ErrorCode, message: impl Into<String>) -> Refusal {
    ResponseError {
        code: code as i32,
        message: message.into(),
        data: None,
    }
}
