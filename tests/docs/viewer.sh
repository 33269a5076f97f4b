#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the program of docs/viewer.md with the CMakeLists.txt of that page against an installed copy, and runs it without a
# display. Usage: viewer.sh PREFIX LIBRARY_FOLDER
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
prefix=$(realpath "$1") library=$(realpath "$1")/$2
forest=$here/../../examples/hosts/forest.treewind
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CMAKE_PREFIX_PATH=$prefix
unset OSG_LIBRARY_PATH OSG_FILE_PATH LD_LIBRARY_PATH DISPLAY
cd "$work"

block() { # LANGUAGE: the lines of the page's block in that language
    sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$here/../../docs/viewer.md" | grep -v '^```'
}
block cpp >main.cpp
block cmake >CMakeLists.txt
[[ -s main.cpp && -s CMakeLists.txt ]] || { echo "viewer: docs/viewer.md has no program"; exit 1; }
{ cmake -S . -B build -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" && cmake --build build; } >log 2>&1 || { cat log; exit 1; }

preload=$library/osgTreeWind/libosgTreeWindHeadless.so
# The notice that growing the trees takes more than a second is no fault.
OSG_NOTIFY_LEVEL=WARN LD_PRELOAD=$preload build/viewer "$forest" 5 >said 2>&1 || { echo "viewer: exit status $?"; cat said; exit 1; }
[[ ! -s said ]] || { echo "viewer: it does not run silently:"; cat said; exit 1; }
status=0
LD_PRELOAD=$preload build/viewer missing.treewind 5 >said 2>&1 || status=$?
if [[ $status -ne 1 ]] || ! grep -q "^missing.treewind" said; then
    echo "viewer: status $status without a file"
    cat said
    exit 1
fi
status=0
build/viewer "$forest" 5 >said 2>&1 || status=$?
[[ $status -eq 1 && -s said ]] || { echo "viewer: status $status without a display"; cat said; exit 1; }
