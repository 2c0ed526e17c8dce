#!/bin/sh
# Queues the drawing, and the joining for when all is drawn. Options for sbatch may follow, such as --partition=NAME.
set -eu
cd "$(dirname "$0")"
mkdir -p log
job=$(sbatch --parsable "$@" draw.slurm)
echo "drawing: job $job"
echo "joining: job $(sbatch --parsable "$@" --dependency="afterok:${job%%;*}" --kill-on-invalid-dep=yes join.slurm)"
