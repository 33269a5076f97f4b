#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A stock osgviewer given a broken file says where it is broken, at each place, and fails.
# Usage: osgviewer_refuses.sh PLUGIN_FOLDER      exit 77: not possible here
set -euo pipefail
command -v osgviewer >/dev/null || { echo "skipped: no osgviewer (script/bootstrap test)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf 'version = 1\n[wind]\nkind = "gale"\n[[tree]]\nposition = 0\n' >"$work/broken.treewind"

status=0
OSG_LIBRARY_PATH=$1 DISPLAY= timeout 60 osgviewer "$work/broken.treewind" >"$work/said" 2>&1 || status=$?
cat "$work/said"
[[ $status -eq 1 ]] || { echo "failed: exit status $status, expected 1"; exit 1; }
for place in "3:8: wind.kind" "5:12: tree.position"; do
    grep -qF "broken.treewind:$place: expected" "$work/said" || { echo "failed: not said that $place"; exit 1; }
done
