#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles the C++ of README.md against an installed copy and runs it. Usage: readme.sh PREFIX LIBRARY_FOLDER COMPILER
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^```cpp$/,/^```$/p' "$here/../../README.md" | grep -v '^```' >"$work/readme.inc"
[[ -s $work/readme.inc ]] || { echo "readme: README.md has no C++"; exit 1; }
library=$(realpath "$1")/$2
read -ra flags < <(PKG_CONFIG_PATH=$library/pkgconfig pkg-config --cflags --libs osgTreeWind openscenegraph)
"$3" -std=c++17 -Wall -Wextra -Werror "-I$work" "$here/Readme.cpp" -o "$work/readme" "${flags[@]}"
cd "$here/../../examples" # forest.treewind
LD_LIBRARY_PATH=$library "$work/readme"
