#!/usr/bin/env bash
# Drives Helix in tmux, in a home with the settings of editors/helix/README.md. Ends with 1 at the first step that
# fails. usage: helix.sh HX SCENE
set -uo pipefail
hx=$1 scene=$2
tmux="tmux -L zpg-helix-$$"
export TERM=xterm-256color COLORTERM=truecolor LANG=C.UTF-8
$tmux -f /dev/null new-session -d -x 110 -y 24 "$hx $scene"
trap '$tmux kill-server' EXIT

want() {
    for _ in $(seq 200); do
        if $tmux capture-pane -p | grep -qE -- "$2"; then
            echo "ok - $1"
            return
        fi
        sleep 0.1
    done
    echo "not ok - $1"
    $tmux capture-pane -p
    exit 1
}

key() {
    $tmux send-keys "$@"
    sleep 0.3
}

want "the scene is open" 'a\.zpg'
want "a diagnostic" '● 1'
key g g 2 j
want "the cursor is on its line" '3:1'
key '[' Escape
key ']' d
key Space a
want "a fix is offered" 'write `0\.5`'
key Enter
want "the fix is applied" '0\.5'
want "hints" '11 ?sphere'
key g g
key Space k
want "hover" 'Used once'
key Escape
key Space r
key C-u
$tmux send-keys -l 77
key Enter
want "rename" '-101.*77.*3'
key : f o r m a t Enter
want "format" '77 11.* {2,}.*# ball #'
key g g
key Space a
want "commenting out is offered" 'Comment out'
# A key that comes with Escape would be another one.
key Escape
key C-c
# Its own way is right for lines without comments, and comes back for all.
want "a line is out" '0 # ~ 77 11'
key C-c
want "and in" '^ *[^0]* 1 +77 11'
key : 5 Enter
key /
$tmux send-keys -l 77
key Enter
want "the reference" ' 5:[0-9]+ *$'
key g d
want "definition" ' 1:1 *$'
key : w q ! Enter
for _ in $(seq 50); do
    grep -q '^77 11  0 1 0  1  # ball #' "$scene" && break
    sleep 0.1
done
grep '^77 11  0 1 0  1  # ball #' "$scene"
