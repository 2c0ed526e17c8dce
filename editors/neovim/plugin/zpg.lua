vim.lsp.enable("zpg")

-- Tokens of the server that have no colour of their own.
for token, group in pairs({
  reference = "@variable.parameter",
  coordinate = "@number",
  colour = "@constant",
  angle = "@number.float",
}) do
  vim.api.nvim_set_hl(0, "@lsp.type." .. token .. ".zpg", { link = group, default = true })
end

vim.api.nvim_create_autocmd("LspAttach", {
  callback = function(args)
    local client = vim.lsp.get_client_by_id(args.data.client_id)
    if client and client.name == "zpg" then
      vim.lsp.inlay_hint.enable(true, { bufnr = args.buf })
    end
  end,
})

-- :ZpgRender, :ZpgConvert pov, :ZpgPlan, :ZpgCrosscheck, :ZpgAccuracy
for name, command in pairs({
  ZpgRender = "zpg.render",
  ZpgConvert = "zpg.convert",
  ZpgPlan = "zpg.plan",
  ZpgCrosscheck = "zpg.crosscheck",
  ZpgAccuracy = "zpg.accuracy",
}) do
  vim.api.nvim_create_user_command(name, function(options)
    local client = vim.lsp.get_clients({ bufnr = 0, name = "zpg" })[1]
    if client then
      local arguments = vim.list_extend({ vim.uri_from_bufnr(0) }, options.fargs)
      client:exec_cmd({ title = name, command = command, arguments = arguments }, { bufnr = 0 })
    end
  end, { nargs = "*" })
end
