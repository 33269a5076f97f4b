#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and runs a DART program with trees in the wind of its world. CMake finds an installed osgTreeWind, or one in
# CMAKE_PREFIX_PATH. Usage: run.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
build=${1:-../../../build/dart}
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release >/dev/null ||
    { echo "DART: apt-get install --no-install-recommends libdart-gui-osg-dev libdart-external-ikfast-dev libdart-external-lodepng-dev libdart-external-imgui-dev" >&2; exit 1; }
cmake --build "$build"
if [[ -n ${CMAKE_PREFIX_PATH:-} ]]; then # the plugin of that installation
    export OSG_LIBRARY_PATH=${OSG_LIBRARY_PATH:-$(find "$CMAKE_PREFIX_PATH" -name 'osgPlugins-*' -printf %h -quit)}
fi
"$build/windy-world" ../forest.treewind
