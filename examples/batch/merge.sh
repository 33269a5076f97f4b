#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Merges the results of all rows of a tiled forest, from south to north.
# Usage: merge.sh WORLD FOLDER OUTPUT ROWS
set -euo pipefail
world=$1 folder=$2 output=$3 rows=$4
mapfile -t parts < <(seq -f "$folder/%.0f.csv" 0 $((rows - 1)))
osgtreewind merge "${parts[@]}" -o "$output" --world "$world"
