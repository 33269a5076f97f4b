#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A stock osgconv turns a .treewind file into OSG's own formats, reads them again, and back into a .treewind.
# Usage: osgconv_converts.sh PLUGIN_FOLDER FILE      exit 77: not possible here
set -euo pipefail
command -v osgconv >/dev/null || { echo "skipped: no osgconv (script/bootstrap test)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OSG_LIBRARY_PATH=$1

{
    osgconv "$2" "$work/forest.osgt"
    osgconv "$work/forest.osgt" "$work/forest.osgb"
    osgconv "$work/forest.osgb" "$work/again.osgt"
    osgconv "$2" "$work/forest.treewind"
    osgconv "$work/forest.osgt" "$work/again.treewind"
} >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
cat "$work/said"
! grep -iE "warning|error" "$work/said" || exit 1
grep -q "osgTreeWind::Forest {" "$work/again.osgt" || { echo "failed: no forest left"; exit 1; }
cmp "$work/forest.osgt" "$work/again.osgt"
cmp "$work/forest.treewind" "$work/again.treewind"
