-- Signs at both ends are no way to comment out what has comments within; the server knows one.
vim.bo.commentstring = ""
vim.bo.comments = ""
local function map(modes, keys, run)
  vim.keymap.set(modes, keys, run, { buffer = true, expr = true, desc = "Comment out or in" })
end
map({ "n", "x" }, "gc", function()
  return require("zpg.comment").operator()
end)
map("n", "gcc", function()
  return require("zpg.comment").operator() .. "_"
end)

-- A number goes on as it is typed: nothing that completion proposes stands in its place unasked.
vim.bo.completeopt = vim.o.completeopt .. ",noselect"
-- Colours from the grammar, where the parser is installed; the server adds its own.
pcall(vim.treesitter.start)
