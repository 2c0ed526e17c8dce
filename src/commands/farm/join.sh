#!/bin/sh
# join.sh: puts the bands of each picture together.
# ZPG is the program, OUT the folder of the pictures. The bands stay in OUT/parts until you remove them.
set -eu
cd "$(dirname "$0")"
out=${OUT:-out}

# join NAME FRAME: the picture, or the two of a stereo camera.
join() {
    mkdir -p "$(dirname "$out/$1")"
    found=
    for side in "" _left _right; do
        picture=$out/$1$2$side.@ENDING@
        set -- "$1" "$2" "$out/parts/$1"/*[0-9]"$2$side".@ENDING@
        [ -e "$3" ] || continue
        found=$side.
        name=$1 frame=$2
        shift 2
        "${ZPG:-zpg}" join "$@" -o "$picture" --keep
        set -- "$name" "$frame"
    done
    [ -n "$found" ] || { echo "join.sh: nothing is drawn of $1$2" >&2; exit 1; }
}

while [ @TILES@ -gt 1 ] && IFS= read -r scene; do
    if [ @FRAMES@ -gt 1 ]; then
        frame=@FIRST_FRAME@
        while [ "$frame" -lt $((@FIRST_FRAME@ + @FRAMES@)) ]; do
            join "${scene%.*}" "$(printf '.%0@DIGITS@d' "$frame")"
            frame=$((frame + 1))
        done
    else
        join "${scene%.*}" ""
    fi
done <scenes.txt
