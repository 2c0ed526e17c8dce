#!/bin/sh
# join.sh: puts the bands of each picture together.
# ZPG is the program, OUT the folder of the pictures. The bands stay in OUT/parts until you remove them.
set -eu
cd "$(dirname "$0")"
out=${OUT:-out}

# join NAME FRAME: the picture, or the two of a stereo camera. The brackets keep its variables to itself.
join() (
    name=$1 frame=$2 found=
    mkdir -p "$(dirname "$out/$name")"
    for side in "" _left _right; do
        set -- "$out/parts/$name"/*"-of-@TILES@$frame$side.@ENDING@"
        [ -e "$1" ] || continue
        found=yes
        "${ZPG:-zpg}" join "$@" -o "$out/$name$frame$side.@ENDING@" --keep
    done
    [ -n "$found" ] || { echo "join.sh: nothing is drawn of $name$frame" >&2; exit 1; }
)

while [ @TILES@ -gt 1 ] && IFS= read -r scene; do
    if [ @FRAMED@ = yes ]; then
        frame=@FIRST_FRAME@
        while [ "$frame" -lt $((@FIRST_FRAME@ + @FRAMES@)) ]; do
            join "${scene%.*}" "$(printf '.%0@DIGITS@d' "$frame")"
            frame=$((frame + 1))
        done
    else
        join "${scene%.*}" ""
    fi
done <scenes.txt
