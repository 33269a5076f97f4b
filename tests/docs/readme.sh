#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The C++ of README.md compiles against the installed headers. Usage: readme.sh PREFIX LIBRARY_FOLDER COMPILER
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^```cpp$/,/^```$/p' "$here/../../README.md" | grep -v '^```' >"$work/readme.inc"
[[ -s $work/readme.inc ]] || { echo "readme: README.md has no C++"; exit 1; }
read -ra flags < <(PKG_CONFIG_PATH=$1/$2/pkgconfig pkg-config --cflags osgTreeWind)
"$3" -std=c++17 -fsyntax-only -Wall -Wextra -Werror -Wno-unused "-I$work" "${flags[@]}" "$here/Readme.cpp"
