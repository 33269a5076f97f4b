#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and runs an osgEarth program with a forest on a hilly map, whose heights and image it makes with GDAL's tools. CMake
# finds osgEarth, the OSG of osgEarth (OSG_DIR) and an osgTreeWind on the same OSG, or those in CMAKE_PREFIX_PATH.
# Usage: run.sh [OPTION...]    (main.cpp), with BUILD_FOLDER in the environment
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
build=${BUILD_FOLDER:-../../../build/osgearth}
command -v gdal_translate >/dev/null || { echo "GDAL: apt-get install --no-install-recommends gdal-bin" >&2; exit 1; }
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$build"

# 0.24 degrees around 8 E, 48 N: hills, and meadows in three greens.
grid() { # SIZE EXPRESSION
    awk "BEGIN {
        n = $1; srand(1)
        printf \"ncols %d\nnrows %d\nxllcorner 7.88\nyllcorner 47.88\ncellsize %.10f\n\", n, n, 0.24 / n
        for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) {
            x = ((i + 0.5) / n - 0.5) * 17900; y = (0.5 - (j + 0.5) / n) * 26700 # metres
            printf \"%.3f%s\", $2, i < n - 1 ? \" \" : \"\n\"
        }
    }"
}
if [[ ! -e $build/image.tif ]]; then
    grid 1000 '250 + 60 * sin(x / 700 + 0.5) * cos(y / 900) + 6 * sin(x / 90) * cos(y / 70) + 45 * exp(-((x + 200)^2 + (y - 420)^2) / 40000)' >"$build/heights.asc"
    grid 2000 'sin(x / 160 + 2 * sin(y / 300)) + cos(y / 130 + sin(x / 210)) + 0.6 * rand()' >"$build/image.asc"
    gdal_translate -q -a_srs EPSG:4326 -co COMPRESS=DEFLATE -co TILED=YES "$build/heights.asc" "$build/heights.tif"
    printf '%s\n' "-2 56 78 34" "0 66 86 38" "1 82 94 46" "3 106 108 64" >"$build/greens.txt"
    gdaldem color-relief -q -co COMPRESS=DEFLATE -co TILED=YES "$build/image.asc" "$build/greens.txt" "$build/plain.tif"
    gdal_translate -q -a_srs EPSG:4326 -co COMPRESS=DEFLATE -co TILED=YES "$build/plain.tif" "$build/image.tif"
    rm "$build"/{heights,image}.asc "$build/plain.tif"
fi
IFS=: read -ra prefixes <<<"${CMAKE_PREFIX_PATH:-}"
for prefix in "${prefixes[@]}"; do # the plugins of OSG, osgEarth and osgTreeWind
    while read -r folder; do
        OSG_LIBRARY_PATH=${OSG_LIBRARY_PATH:+$OSG_LIBRARY_PATH:}$folder
    done < <(find "$prefix" -name 'osgPlugins-*' -printf '%h\n' 2>/dev/null)
done
export OSG_LIBRARY_PATH=${OSG_LIBRARY_PATH:-}
"$build/forest-on-globe" "$build/heights.tif" "$build/image.tif" forest.treewind "$@"
