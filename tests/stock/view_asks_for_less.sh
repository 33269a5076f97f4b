#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Where the display has no window with as many samples as are asked for, `view` opens one with less, and says so.
# Usage: view_asks_for_less.sh PLUGIN_FOLDER TOOL FILE      exit 77: not possible here
set -euo pipefail
command -v xvfb-run >/dev/null || { echo "skipped: no xvfb-run (script/bootstrap test)"; exit 77; }
# OSG opens a display twice: an Xvfb that starts anew in between (no -noreset) breaks the second one.
said=$(OSG_MULTI_SAMPLES=64 timeout 120 xvfb-run -a -s "-noreset -screen 0 320x240x24" \
    "$2" view "$3" --size 160x120 --frames 3 2>&1) || { echo "failed: $?, $said"; exit 1; }
[[ $said =~ ^"view: this display has no windows with 64 samples per pixel; the window has "(one|[0-9]+)$ ]] ||
    { echo "failed: it said: $said"; exit 1; }
