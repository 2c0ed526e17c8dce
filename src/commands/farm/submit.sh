#!/bin/sh
# Queues the drawing, and the joining for when all is drawn. Options for sbatch may follow and are for both, such as
# --partition=NAME.
set -eu
cd "$(dirname "$0")"
mkdir -p log
draw=$(sbatch --parsable "$@" draw.slurm)
draw=${draw%%;*}
join=$(sbatch --parsable "$@" --dependency="afterok:$draw" --kill-on-invalid-dep=yes join.slurm)
join=${join%%;*}
echo "drawing: job $draw, log/${draw}_*.txt"
echo "joining: job $join, log/${join}_join.txt"
