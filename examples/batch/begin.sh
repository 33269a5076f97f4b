#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the folder of the parts, which belongs to one world and one choice of options, and prints how many rows of tiles
# there are.
# Usage: begin.sh WORLD FOLDER [RISK_OPTION...]
set -euo pipefail
world=$1 folder=$2
shift 2
mkdir -p "$folder"
what="$(cksum <"$world") $*"
if [[ -f $folder/what && $(<"$folder/what") != "$what" ]]; then
    echo "$folder: parts of another world or with other options are in it; take another folder" >&2
    exit 2
fi
echo "$what" >"$folder/what"
awk '$1 == "rows" { print $3; exit }' "$world"
