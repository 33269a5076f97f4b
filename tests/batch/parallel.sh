#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A world through examples/batch/with_parallel.sh, cut short and run again; all is the same as in one run of the tool.
# Usage: parallel.sh TOOL FOREST      exit 77: not possible here
set -euo pipefail
tool=$(realpath "$1") forest=$(realpath "$2")
batch=$(dirname "$(realpath "${BASH_SOURCE[0]}")")/../../examples/batch
PATH=$(dirname "$tool"):$PATH
command -v parallel >/dev/null || { echo "skipped: no parallel (script/bootstrap test)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$tool" tile "$forest" -o "$work/world" --size 50 >/dev/null
again() { "$batch/with_parallel.sh" "$work/world/world.treewind" "$work/parts" "$work/all.csv" --speed 20; }
mv "$work/world/tiles/0_1.trees" "$work/aside"
if again >/dev/null 2>"$work/said"; then
    echo "failed: a tile is missing and nobody minds"
    exit 1
fi
grep -q "0_1.trees" "$work/said" || { cat "$work/said"; echo "failed: not said what is missing"; exit 1; }
[[ ! -f $work/all.csv ]] || { echo "failed: a table without row 1"; exit 1; }
mv "$work/aside" "$work/world/tiles/0_1.trees"
again >/dev/null
if "$batch/with_parallel.sh" "$work/world/world.treewind" "$work/parts" "$work/else.csv" --speed 25 2>/dev/null; then
    echo "failed: parts of another wind are taken for these"
    exit 1
fi
"$tool" risk "$work/world/world.treewind" -o "$work/whole.csv" --speed 20 >/dev/null
cmp "$work/all.csv" "$work/whole.csv"
echo "passed: $(($(wc -l <"$work/all.csv") - 1)) trees"
