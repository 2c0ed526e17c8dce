# Scenes in the ZPG scene language; needs kak-lsp 17 or later.

hook global BufCreate .*\.zpg %{
    set-option buffer filetype zpg
}

hook global WinSetOption filetype=zpg %{
    set-option window comment_block_begin '0 # ~ '
    set-option window comment_block_end ' #'
    add-highlighter window/zpg regions
    add-highlighter window/zpg/code default-region group
    add-highlighter window/zpg/comment region '#' '#' fill comment
    add-highlighter window/zpg/code/ regex '^\h*(\d+)\h+(-?\d+)(?!\S)' 1:function 2:type
    add-highlighter window/zpg/code/ regex '(?<!\S)[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(?!\S)' 0:value
    hook -once -always window WinSetOption filetype=.* %{ remove-highlighter window/zpg }
}

hook global BufSetOption filetype=zpg %{
    set-option buffer lsp_servers %{
        [zpg]
        root_globs = ["zpg.toml", ".git"]
        command = "zpg"
        args = ["lsp"]
    }
}
