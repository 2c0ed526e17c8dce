vim.filetype.add({ extension = { zpg = "zpg" } })
