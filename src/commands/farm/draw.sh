#!/bin/sh
# draw.sh FIRST [LAST]: draws these of the @TASKS@ tasks. A task is a picture, or a band of rows of one.
# ZPG is the program, OUT the folder of the pictures, THREADS the threads of a task.
set -eu
task=$1 last=${2:-$1}
cd "$(dirname "$0")"
out=${OUT:-out}
while [ "$task" -le "$last" ]; do
    picture=$(((task - 1) / @TILES@))
    tile=$(((task - 1) % @TILES@ + 1))
    scene=$(sed -n "$((picture / @FRAMES@ + 1))p" scenes.txt)
    set -- "scenes/$scene" --resume --threads "${THREADS:-@CORES@}" @OPTIONS@
    if [ @FRAMED@ = yes ]; then
        set -- "$@" --only $((@FIRST_FRAME@ + picture % @FRAMES@))
    fi
    if [ @TILES@ -gt 1 ]; then
        file=$out/parts/${scene%.*}/$tile-of-@TILES@.@ENDING@
        set -- "$@" --tile "$tile/@TILES@"
    else
        file=$out/${scene%.*}.@ENDING@
    fi
    mkdir -p "$(dirname "$file")"
    "${ZPG:-zpg}" render "$@" -o "$file"
    task=$((task + 1))
done
