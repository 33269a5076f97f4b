#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests hosts that find the installed package by CMake: examples/embed, one for each backend, and one with all headers.
# Usage: find_package.sh PREFIX LIBRARY_FOLDER [BACKEND...]     (LIBRARY_FOLDER: lib, lib64, ...)
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
prefix=$1 library=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CMAKE_PREFIX_PATH=$prefix CMAKE_BUILD_TYPE=Debug
unset OSG_LIBRARY_PATH OSG_FILE_PATH LD_LIBRARY_PATH DISPLAY

build() {
    { cmake "$@" && cmake --build "$work/build"; } >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
}

build -S "$here/../../examples/embed" -B "$work/build"
LD_PRELOAD=$prefix/$library/osgTreeWind/libosgTreeWindHeadless.so \
    "$work/build/osgtreewind-embed" --frames 5

rm -rf "$work/build"
build -S "$here" -B "$work/build" "-DBACKENDS=$(IFS=';'; echo "$*")"
"$work/build/every_header"
for backend in "$@"; do
    "$work/build/$backend" "$prefix/share/osgTreeWind/examples/thesis.treewind"
done
