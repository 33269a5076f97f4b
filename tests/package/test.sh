#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs a build, moves it elsewhere, and uses it as a stranger would.
# Usage: tests/package/test.sh BUILD_FOLDER LIBRARY_FOLDER [BACKEND...]     (LIBRARY_FOLDER: lib, lib64, ...)
set -euo pipefail
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
build=$1 library=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/prefix"
prefix=$work/prefix
export CMAKE_PREFIX_PATH=$prefix CMAKE_BUILD_TYPE=Debug
unset OSG_LIBRARY_PATH OSG_FILE_PATH LD_LIBRARY_PATH DISPLAY

echo "package: examples/embed on its own"
cmake -S "$source/examples/embed" -B "$work/embed" >"$work/log" || { cat "$work/log"; exit 1; }
cmake --build "$work/embed" >"$work/log" || { cat "$work/log"; exit 1; }
LD_PRELOAD=$prefix/$library/libosgTreeWindHeadless.so:libOSMesa.so.8 \
    "$work/embed/osgtreewind-embed" --frames 5 | tee "$work/log"
grep -qx "9 trees, 5 frames" "$work/log"

echo "package: headers and backends"
cmake -S "$source/tests/package" -B "$work/user" "-DBACKENDS=$(IFS=';'; echo "$*")" >"$work/log" || { cat "$work/log"; exit 1; }
cmake --build "$work/user" >"$work/log" || { cat "$work/log"; exit 1; }
for backend in "$@"; do
    "$work/user/$backend" "$prefix/share/osgTreeWind/examples/thesis.treewind"
done

echo "package: the installed tool, plugins and shaders"
cd "$prefix/share/osgTreeWind/examples"
"$prefix/bin/osgtreewind" info thesis.treewind --json | grep -q '"totalVertices": 38656'
"$prefix/bin/osgtreewind" render thesis.treewind -o "$work/a.png" --size 64x64
export OSG_LIBRARY_PATH=$prefix/$library
osgconv thesis.treewind "$work/t.osgt" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
grep -q "osgTreeWind::Forest" "$work/t.osgt"
printf '#version 330 compatibility\nvoid main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }\n' \
    >"$prefix/share/osgTreeWind/shaders/bark.frag"
OSG_FILE_PATH=$prefix/share/osgTreeWind/shaders \
    "$prefix/bin/osgtreewind" render thesis.treewind -o "$work/b.png" --size 64x64
cmp -s "$work/a.png" "$work/b.png" && { echo "package: shaders are not overridden"; exit 1; }
echo "package: good"
