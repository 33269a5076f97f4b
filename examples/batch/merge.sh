#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puts the rows of a world together, from south to north, once all of them are there.
# Usage: merge.sh WORLD FOLDER OUTPUT ROWS
set -euo pipefail
world=$1 folder=$2 output=$3 rows=$4
mapfile -t parts < <(seq -f "$folder/%.0f.csv" 0 $((rows - 1)))
osgtreewind merge "${parts[@]}" -o "$output" --world "$world"
