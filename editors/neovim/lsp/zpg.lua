-- What Neovim 0.11 and later start for scenes; `vim.lsp.enable("zpg")` in plugin/zpg.lua turns it on.
return {
  cmd = { "zpg", "lsp" },
  filetypes = { "zpg" },
  root_markers = { "zpg.toml", ".git" },
}
