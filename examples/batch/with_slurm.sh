#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Computes the risk of all trees of a tiled forest with Slurm: an array of jobs, one per row of tiles, and a final job that
# merges the results. Paths must be the same on all nodes. To continue after failed jobs, start it again.
# Usage: with_slurm.sh WORLD FOLDER OUTPUT [RISK_OPTION...]      prints the number of the last job
set -euo pipefail
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
world=$(realpath "$1") folder=$(realpath -m "$2") output=$(realpath -m "$3")
shift 3
rows=$("$here/begin.sh" "$world" "$folder" "$@")
array=$(sbatch --parsable --job-name=risk --array="0-$((rows - 1))" --output="$folder/%a.log" --wrap \
    "OSGTREEWIND_THREADS=\$SLURM_CPUS_ON_NODE $(printf '%q ' "$here/row.sh" "$world" "$folder")\$SLURM_ARRAY_TASK_ID $(printf '%q ' "$@")")
sbatch --parsable --job-name=merge --dependency="afterok:$array" --kill-on-invalid-dep=yes --output="$folder/merge.log" \
    --wrap "$(printf '%q ' "$here/merge.sh" "$world" "$folder" "$output" "$rows")"
