#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds examples/hosts/dart against the installed package and draws a few frames on a virtual display.
# Usage: dart.sh PREFIX      exit 77: skipped
set -euo pipefail
run=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../examples/hosts/dart/run.sh")
[[ -e /usr/include/dart/gui/osg/osg.hpp ]] || { echo "skipped: no DART (script/bootstrap hosts)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset OSG_LIBRARY_PATH OSG_FILE_PATH LD_LIBRARY_PATH
export CMAKE_PREFIX_PATH=$1 OSG_RUN_FRAME_COUNT=5
xvfb-run -a -s "-noreset -screen 0 1024x768x24" timeout 300 "$run" "$work/build" >"$work/log" 2>&1 ||
    { cat "$work/log"; exit 1; }
if grep -iE "error|warning" "$work/log"; then
    echo "dart: expected no errors or warnings, found the lines above"
    exit 1
fi
