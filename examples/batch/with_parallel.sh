#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Computes the risk of all trees of a tiled forest with GNU parallel, one job per row of tiles. To continue an interrupted
# run, start it again.
# Usage: with_parallel.sh WORLD FOLDER OUTPUT [RISK_OPTION...]
set -euo pipefail
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
world=$1 folder=$2 output=$3
shift 3
rows=$("$here/begin.sh" "$world" "$folder" "$@")
seq 0 $((rows - 1)) | OSGTREEWIND_THREADS=1 parallel --halt now,fail=1 "$here/row.sh" "$world" "$folder" {} "$@"
"$here/merge.sh" "$world" "$folder" "$output" "$rows"
