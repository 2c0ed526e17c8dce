-- nvim --headless -u NONE -l neovim.lua SCENE, in a home that has the package installed; ends with 1 at the first
-- step that fails.
local scene = arg[1]
local steps = 0

local function wait(what, check)
  local result
  local done = vim.wait(20000, function()
    result = check()
    return result
  end, 20)
  if not done then
    error("timed out: " .. what)
  end
  return result
end

local function step(name, run)
  local ok, err = xpcall(run, debug.traceback)
  io.write((ok and "ok - " or "not ok - ") .. name .. "\n")
  steps = steps + 1
  if not ok then
    io.write(err .. "\n")
    os.exit(1)
  end
end

local function lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, false)
end

local function ask(method, params)
  local client = vim.lsp.get_clients({ bufnr = 0 })[1]
  local answer = assert(client:request_sync(method, params, 20000, 0))
  assert(not answer.err, vim.inspect(answer.err))
  return answer.result
end

local function here()
  local client = vim.lsp.get_clients({ bufnr = 0 })[1]
  return vim.lsp.util.make_position_params(0, client.offset_encoding)
end

step("the server is attached", function()
  vim.cmd("packloadall")
  vim.cmd("filetype plugin on")
  vim.cmd.edit(scene)
  assert(vim.bo.filetype == "zpg", vim.bo.filetype)
  wait("client", function()
    local client = vim.lsp.get_clients({ bufnr = 0 })[1]
    return client and client.initialized
  end)
end)

step("diagnostics", function()
  local all = wait("diagnostics", function()
    local all = vim.diagnostic.get(0, { severity = vim.diagnostic.severity.ERROR })
    return #all > 0 and all
  end)
  assert(all[1].code == "E003" and all[1].lnum == 2, vim.inspect(all[1]))
end)

step("hints", function()
  vim.lsp.inlay_hint.enable(true)
  local all = wait("hints", function()
    local all = vim.lsp.inlay_hint.get({ bufnr = 0 })
    return #all > 0 and all
  end)
  assert(all[1].inlay_hint.label == "sphere", vim.inspect(all[1]))
end)

step("tokens", function()
  wait("tokens", function()
    return vim.lsp.semantic_tokens.get_at_pos(0, 0, 0)[1]
  end)
  assert(vim.lsp.semantic_tokens.get_at_pos(0, 0, 2)[1].type == "type")
  assert(vim.lsp.semantic_tokens.get_at_pos(0, 4, 7)[1].type == "reference")
end)

step("hover", function()
  vim.api.nvim_win_set_cursor(0, { 5, 7 })
  local text = ask("textDocument/hover", here()).contents.value
  assert(text:find("sphere", 1, true) and text:find("ball", 1, true), text)
end)

step("completion", function()
  local found = ask("textDocument/completion", here())
  assert(#found.items >= 2, vim.inspect(found))
end)

step("a fix is applied", function()
  vim.api.nvim_win_set_cursor(0, { 3, 7 })
  vim.lsp.buf.code_action({
    apply = true,
    filter = function(action)
      return action.isPreferred
    end,
  })
  wait("fix", function()
    return lines()[3]:find("0.5", 1, true)
  end)
  wait("no errors", function()
    return #vim.diagnostic.get(0, { severity = vim.diagnostic.severity.ERROR }) == 0
  end)
end)

step("rename", function()
  vim.api.nvim_win_set_cursor(0, { 1, 0 })
  vim.lsp.buf.rename("77")
  wait("rename", function()
    return lines()[5]:find("-101 77 3", 1, true) and lines()[2]:find("77 -701", 1, true)
  end)
end)

step("format", function()
  vim.lsp.buf.format({ timeout_ms = 20000 })
  -- Vectors are set off by two blanks.
  assert(lines()[1] == "77 11  0 1 0  1  # ball #", lines()[1])
end)

step("definition", function()
  vim.api.nvim_win_set_cursor(0, { 5, 8 })
  vim.lsp.buf.definition()
  wait("jump", function()
    return vim.api.nvim_win_get_cursor(0)[1] == 1
  end)
end)

-- As people type it: with the mappings.
local function type(keys)
  vim.api.nvim_feedkeys(vim.api.nvim_replace_termcodes(keys, true, false, true), "mtx", false)
end

local function out(first, last)
  for i, line in ipairs(lines()) do
    local is_out = vim.startswith(line, "0 # ~ ")
    assert(is_out == (first <= i and i <= last), vim.inspect(lines()))
  end
end

step("comment out and in", function()
  local scene = lines()
  for keys, where in pairs({ gcc = { 1, 1 }, gcj = { 1, 2 }, ["3gcc"] = { 1, 3 }, gcG = { 1, 7 }, ["Vjjgc"] = { 1, 3 } }) do
    vim.api.nvim_win_set_cursor(0, { 1, 3 })
    type(keys)
    out(unpack(where))
    assert(lines()[1] == "0 # ~ 77 11  0 1 0  1  ~~ ball ~~ #", lines()[1])
    vim.api.nvim_win_set_cursor(0, { 1, 3 })
    type(keys)
    assert(vim.deep_equal(lines(), scene), keys .. vim.inspect(lines()))
  end
  vim.api.nvim_win_set_cursor(0, { 2, 0 })
  type("gcc.")
  assert(vim.deep_equal(lines(), scene), "repeated: " .. vim.inspect(lines()))
end)

step("symbols", function()
  local found = ask("textDocument/documentSymbol", { textDocument = here().textDocument })
  local top = found[#found]
  assert(top.name:find("render", 1, true) and #top.children > 0, vim.inspect(found))
end)

step("render", function()
  vim.cmd("write")
  vim.cmd("ZpgRender 32x24")
  local picture = scene:gsub("%.zpg$", ".png")
  wait("picture", function()
    return vim.uv.fs_stat(picture)
  end)
end)

step("saved and stopped", function()
  vim.cmd("write")
  vim.lsp.stop_client(vim.lsp.get_clients())
  wait("end", function()
    return #vim.lsp.get_clients() == 0
  end)
end)

io.write(steps .. " steps\n")
os.exit(0)
