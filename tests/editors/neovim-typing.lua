-- nvim --headless -u NONE -l neovim-typing.lua SCENE, in a home that has the package installed: records are typed, key by
-- key, into another Neovim, with its own completion as it comes and as its manual turns it on.
local records = {
  "2 11 0 1 0 1",
  "3 12 -1 -1 -1 1 1 1",
  "33 9 0.5 # ball #",
  "2 -701 0.9 0.2 0.1",
  "4 -101 2 3",
  "5 -102 4 33",
  "6 -101 5 2",
  "1 9999 6 0",
}
local delays = { 60, 200, 90, 60, 120, 60, 100, 60 }

local function typed(setup)
  local nvim = vim.fn.jobstart({ vim.v.progpath, "--embed", "--headless", "-n" }, { rpc = true })
  local function call(name, ...)
    return vim.rpcrequest(nvim, name, ...)
  end
  call("nvim_exec_lua", "vim.cmd.edit(...)", { arg[1] })
  local attached = vim.wait(20000, function()
    return call("nvim_exec_lua", "local c = vim.lsp.get_clients({ bufnr = 0 })[1] return c and c.initialized", {}) == true
  end, 50)
  assert(attached, "the server is not attached")
  call("nvim_exec_lua", "vim.lsp.inlay_hint.enable(false) " .. setup, {})
  call("nvim_input", "ggVGc")
  for i, record in ipairs(records) do
    for key in (record .. "\r"):gmatch(".") do
      call("nvim_input", key == "\r" and "<CR>" or key == "<" and "<lt>" or key)
      vim.wait(delays[i])
    end
  end
  call("nvim_input", "<Esc>")
  vim.wait(200)
  local lines = call("nvim_buf_get_lines", 0, 0, -1, false)
  vim.fn.jobstop(nvim)
  return lines
end

local ways = {
  { "as it comes", "" },
  { "turned on", [[
    vim.opt.completeopt = { "menuone", "noselect", "popup" }
    local client = vim.lsp.get_clients({ bufnr = 0 })[1]
    vim.lsp.completion.enable(true, client.id, 0, { autotrigger = true })
  ]] },
  { "turned on, with the options as they come", [[
    local client = vim.lsp.get_clients({ bufnr = 0 })[1]
    vim.lsp.completion.enable(true, client.id, 0, { autotrigger = true })
  ]] },
}
local wanted = table.concat(records, "\n") .. "\n"
for _, way in ipairs(ways) do
  local name, setup = way[1], way[2]
  local text = table.concat(typed(setup), "\n")
  if text ~= wanted then
    io.write("not ok - " .. name .. "\n" .. text)
    os.exit(1)
  end
  io.write("ok - " .. name .. "\n")
end
os.exit(0)
