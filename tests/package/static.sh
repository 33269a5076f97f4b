#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs a static build, and builds and runs programs that link it: they read, write and draw. Also examples/hosts/esmini,
# if the variable ESMINI names the folder of esmini's sources. Usage: static.sh BUILD_FOLDER
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
folder=$(realpath "$1")
cached() { sed -n "s/^$1:[A-Z]*=//p" "$folder/CMakeCache.txt"; }
prefix=$(cached CMAKE_INSTALL_PREFIX) library=$(cached CMAKE_INSTALL_LIBDIR)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CMAKE_PREFIX_PATH=$prefix CMAKE_BUILD_TYPE=Debug PKG_CONFIG_PATH=$prefix/$library/pkgconfig
unset OSG_LIBRARY_PATH OSG_FILE_PATH LD_LIBRARY_PATH DISPLAY
rm -rf "$prefix"
cmake --install "$folder" >/dev/null

# A raster of 7 m, and winds of 6 m/s toward east in a GRIB file from a sample of ecCodes.
cd "$work"
printf 'ncols 3\nnrows 3\nxllcorner 499950\nyllcorner 4999950\ncellsize 50\n%s' "$(printf '7 7 7\n%.0s' 1 2 3)" >ground.asc
gdal_translate -q -a_srs EPSG:32631 ground.asc ground.tif
sample=$(codes_info -s | cut -d: -f1)/regular_ll_sfc_grib2.tmpl
height=typeOfFirstFixedSurface=103,scaleFactorOfFirstFixedSurface=0,scaledValueOfFirstFixedSurface=10
for component in "2 6" "3 0"; do
    grib_set -s "discipline=0,parameterCategory=2,parameterNumber=${component% *},$height" -d "${component#* }" "$sample" part.grib2
    cat part.grib2 >>wind.grib2
done
printf 'version = 1\n[[tree]]\nposition = [0.0, 0.0]\n' >plain.treewind
printf '%s\n' 'version = 1' 'crs = "EPSG:32631"' '[ground]' 'file = "ground.tif"' '[wind]' 'file = "wind.grib2"' \
    '[[tree]]' 'position = [500000.0, 5000000.0]' >weather.treewind

build() { # FOLDER ARGUMENT...
    { cmake -B "$@" && cmake --build "$1"; } >log 2>&1 || { cat log; exit 1; }
}
build cmake -S "$here/static"
read -ra flags < <(pkg-config --static --cflags --libs osgTreeWind)
"${CXX:-c++}" -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror "$here/static/host.cpp" "${flags[@]}" -o host
! ldd cmake/host host | grep libosgTreeWind || { echo "static: expected no shared library, found the line above"; exit 1; }
for program in cmake/host ./host; do
    "$program" plain.treewind weather.treewind copy.osgt
done
cmake/esmini_wind plain.treewind
for backend in OSMesa EGL; do
    [[ -e $prefix/$library/libosgTreeWind$backend.a ]] || continue
    build "$backend" -S "$here" -DBACKENDS=$backend
    "$backend/$backend" "$prefix/share/osgTreeWind/examples/thesis.treewind"
done
mv "$prefix" "$work/moved" # then the programs of the build folder read the files
cmake/host plain.treewind weather.treewind copy.osgt
mv "$work/moved" "$prefix"

[[ -n ${ESMINI:-} ]] || { echo "passed, without esmini"; exit 0; }
xvfb-run -a -s "-noreset -screen 0 1280x720x24" timeout 1800 "$here/../../examples/hosts/esmini/run.sh" "$ESMINI" \
    --fixed_timestep 0.025 >esmini 2>&1 || { cat esmini; exit 1; } # 25 s: 1000 frames
! grep -i "treewind" esmini | grep -v "\[info\]\|bounding box" || { echo "static: esmini printed the lines above"; exit 1; }
echo "passed, with esmini"
