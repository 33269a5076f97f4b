#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds esmini with trees beside ESMINI, the folder of its sources, and runs a scenario. CMake finds an installed static
# osgTreeWind, or one in CMAKE_PREFIX_PATH. Usage: run.sh ESMINI [OPTION OF ESMINI...]    e.g. run.sh ~/esmini --pause
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
esmini=$(realpath "$1")
build=$esmini-trees
shift
git -C "$esmini" apply --reverse --check "$here/esmini.patch" 2>/dev/null || git -C "$esmini" apply "$here/esmini.patch"
cmake -S "$esmini" -B "$build" -DCMAKE_PROJECT_INCLUDE="$here/trees.cmake" -DDOWNLOAD_EXTERNALS=OFF -DUSE_OSI=OFF \
    -DUSE_SUMO=OFF -DUSE_IMPLOT=OFF -DUSE_GTEST=OFF -DBUILD_EXAMPLES=OFF >/dev/null
cmake --build "$build" --target esmini --parallel "$(nproc)" >/dev/null
"$build/EnvironmentSimulator/Applications/esmini/esmini" --osc "$here/street.xosc" --path "$here" \
    --enforce_generate_model --ground_plane on --window 60 60 960 540 "$@"
