#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a stock program of OpenSceneGraph for a few frames without a display: it has to end well, and to say nothing of
# warnings or errors.
# Usage: program_runs.sh PLUGIN_FOLDER HEADLESS_LIBRARY PROGRAM [ARGUMENT...]      exit 77: not possible here
set -euo pipefail
folder=$1 headless=$2
shift 2
command -v "$1" >/dev/null || { echo "skipped: no $1 (script/bootstrap test)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cd "$work" # some write files
status=0
OSG_LIBRARY_PATH=$folder OSG_RUN_FRAME_COUNT=${frames:-10} OSG_WINDOW="0 0 160 120" DISPLAY='' \
    LD_PRELOAD=$headless timeout 120 "$@" >said 2>&1 || status=$?
cat said
[[ $status -eq 0 ]] || { echo "failed: exit status $status"; exit 1; }
! grep -iE "warning|error|fail" said || { echo "failed: the lines above were said"; exit 1; }
