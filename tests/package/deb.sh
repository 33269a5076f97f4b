#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests the Debian packages of a build: lintian finds no error, no file is in two packages, dependencies are declared, and
# the unpacked files show a forest in a stock osgviewer.
# Usage: deb.sh BUILD_FOLDER LIBRARY_FOLDER      exit 77: skipped
set -euo pipefail
build=$1 library=$2
for program in cpack dpkg-shlibdeps lintian help2man xvfb-run osgviewer; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (script/bootstrap test package)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CPACK_COMPRESSION_TYPE=gzip
cpack --config "$build/CPackConfig.cmake" -G DEB -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip -B "$work" >"$work/log" 2>&1 ||
    { tail "$work/log"; exit 1; }
lintian --fail-on error "$work"/*.deb >"$work/lintian" || { cat "$work/lintian"; exit 1; }
root=$work/root
for package in "$work"/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -t | grep -v '/$' >>"$work/files"
    dpkg-deb -x "$package" "$root"
done
twice=$(sort "$work/files" | uniq -d)
[[ -z $twice ]] || { echo "deb: in two packages: $twice"; exit 1; }
needs() { # PACKAGE DEPENDENCY
    dpkg-deb -f "$work"/"$1"_*.deb Depends | grep -q "$2" || { echo "deb: $1 does not depend on $2"; exit 1; }
}
needs libosgtreewind2.0 libopenscenegraph161
needs libosgtreewind-dev "libosgtreewind2.0 (= "
needs osgtreewind-plugin libosgtreewind2.0
opengl=libosmesa6
! grep -q "^OSMesa_LIBRARY:.*NOTFOUND" "$build/CMakeCache.txt" || opengl=libegl1
needs osgtreewind $opengl
find "$root/usr/bin" "$root/usr/$library" -type f -exec sh -c 'readelf -d "$1" 2>/dev/null | grep -E "R(UN)?PATH" && echo "$1"' _ {} \; >"$work/paths"
[[ ! -s $work/paths ]] || { cat "$work/paths"; echo "deb: expected no RPATH or RUNPATH, found the lines above"; exit 1; }
unset OSG_FILE_PATH
export LD_LIBRARY_PATH=$root/usr/$library
# OSG opens the display twice; without -noreset, Xvfb would reset in between and break the second connection.
OSG_LIBRARY_PATH=$root/usr/$library OSG_RUN_FRAME_COUNT=3 xvfb-run -a -s "-noreset -screen 0 320x240x24" \
    osgviewer "$root/usr/share/osgTreeWind/examples/forest.treewind" >"$work/output" 2>&1 || { cat "$work/output"; exit 1; }
! grep -iE "warning|error" "$work/output" || { echo "deb: osgviewer printed the lines above"; exit 1; }
for command in "" $("$root/usr/bin/osgtreewind" --help | sed -n '/^Subcommands:/,/^$/ s/^  \([a-z]*\) .*/-\1/p'); do
    zcat "$root/usr/share/man/man1/osgtreewind$command.1.gz" | grep -q "^osgtreewind$command .- [a-z]" ||
        { echo "deb: no manual page of osgtreewind$command"; exit 1; }
done
"$root/usr/bin/osgtreewind" info "$root/usr/share/osgTreeWind/examples/forest.treewind" >/dev/null
echo "passed: $(wc -l <"$work/files") files in $(ls "$work"/*.deb | wc -l) packages"
