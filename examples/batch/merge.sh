#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puts the rows of a world together, from south to north, once all of them are there.
# Usage: merge.sh WORLD FOLDER OUTPUT
set -euo pipefail
world=$1 folder=$2 output=$3
rows=$(awk '$1 == "rows" { print $3; exit }' "$world")
missing=0
for ((row = 0; row < rows; ++row)); do
    [[ -f $folder/$row.csv ]] || { echo "merge: no $folder/$row.csv" >&2; missing=1; }
done
[[ $missing -eq 0 ]] || exit 1
{
    head -n 1 "$folder/0.csv"
    for ((row = 0; row < rows; ++row)); do
        tail -n +2 "$folder/$row.csv"
    done
} >"$output.part"
mv "$output.part" "$output"
