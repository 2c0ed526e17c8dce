vim.bo.commentstring = "# %s #"
vim.bo.comments = ""
-- Colours from the grammar, where the parser is installed; the server adds its own.
pcall(vim.treesitter.start)
