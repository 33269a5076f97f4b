#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Computes the risk of one row of tiles, unless an earlier run has written it.
# Usage: row.sh WORLD FOLDER ROW [RISK_OPTION...]
set -euo pipefail
world=$1 folder=$2 row=$3
shift 3
[[ ! -f $folder/$row.csv ]] || exit 0
osgtreewind risk "$world" --tiles "0,$row,99999,$row" -o "$folder/$row.csv" "$@"
