#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests the installed tool, plugins and shaders. Usage: tool.sh PREFIX LIBRARY_FOLDER
set -euo pipefail
prefix=$1 library=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset OSG_LIBRARY_PATH OSG_FILE_PATH LD_LIBRARY_PATH DISPLAY

cd "$prefix/share/osgTreeWind/examples"
"$prefix/bin/osgtreewind" info thesis.treewind --json | grep -q '"totalVertices": 38656'
"$prefix/bin/osgtreewind" render thesis.treewind -o "$work/a.png" --size 64x64
OSG_LIBRARY_PATH=$prefix/$library osgconv thesis.treewind "$work/t.osgt" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
grep -q "osgTreeWind::Forest" "$work/t.osgt"
mkdir "$work/shaders"
printf '#version 330 compatibility\nvoid main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }\n' >"$work/shaders/bark.frag"
OSG_FILE_PATH=$work/shaders "$prefix/bin/osgtreewind" render thesis.treewind -o "$work/b.png" --size 64x64
! cmp -s "$work/a.png" "$work/b.png" || { echo "tool: shaders are not overridden"; exit 1; }
