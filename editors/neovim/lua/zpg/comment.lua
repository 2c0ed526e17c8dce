-- Comments out and in by the server: a comment begins and ends with one sign, and does not nest.
local M = {}

-- The lines from one to another, counted from 1.
function M.lines(first, last)
  local buffer = vim.api.nvim_get_current_buf()
  local client = vim.lsp.get_clients({ bufnr = buffer, name = "zpg" })[1]
  if not client then
    vim.notify("zpg comments out, and its server does not run", vim.log.levels.WARN)
    return
  end
  local range = { start = { line = first - 1, character = 0 }, ["end"] = { line = last, character = 0 } }
  local document = vim.lsp.util.make_text_document_params(buffer)
  local params = { textDocument = document, ranges = { range } }
  local answer, why = client:request_sync("zpg/comment", params, 10000, buffer)
  if not answer or answer.err then
    vim.notify("zpg: " .. (why or answer.err.message), vim.log.levels.ERROR)
    return
  end
  local view = vim.fn.winsaveview()
  vim.lsp.util.apply_text_edits(answer.result, buffer, client.offset_encoding)
  vim.fn.winrestview(view)
end

-- For a mapping with `expr`: the next motion says which lines.
function M.operator()
  vim.o.operatorfunc = "v:lua.require'zpg.comment'.moved_over"
  return "g@"
end

function M.moved_over()
  M.lines(vim.fn.line("'["), vim.fn.line("']"))
end

return M
