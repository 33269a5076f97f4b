#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A strict host that has the sources below its own. The library is not built again, which takes minutes: the host
# is configured, and its own source compiled. Usage: add_subdirectory.sh SOURCE_FOLDER
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{ cmake -G Ninja -S "$(dirname "${BASH_SOURCE[0]}")/subproject" -B "$work" "-DOSGTREEWIND=$1" &&
    cmake --build "$work" --target host_objects; } >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
