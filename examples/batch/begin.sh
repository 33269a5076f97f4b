#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Creates the folder for the results of one tiled forest with one set of options, and prints the number of rows of tiles.
# Usage: begin.sh WORLD FOLDER [RISK_OPTION...]
set -euo pipefail
world=$1 folder=$2
shift 2
mkdir -p "$folder"
what="$(cksum <"$world") $*"
if [[ -f $folder/what && $(<"$folder/what") != "$what" ]]; then
    echo "$folder: contains results of another world or with other options; use another folder" >&2
    exit 2
fi
echo "$what" >"$folder/what"
awk '$1 == "rows" { print $3; exit }' "$world"
