#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A forest beside a street in SUMO, and birches as vehicles.
# Usage: run.sh [OPTION OF SUMO-GUI...]     e.g. run.sh --end 20 --quit-on-end
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
command -v sumo-gui >/dev/null || { echo "no SUMO; apt-get install --no-install-recommends sumo" >&2; exit 1; }
# The plugin of this build if it exists, else of the installed package.
if [[ -d ../../../build/lib/osgPlugins-3.6.5 ]]; then export OSG_LIBRARY_PATH=${OSG_LIBRARY_PATH:-$(realpath ../../../build/lib)}; fi

net=$(mktemp --suffix=.net.xml)
trap 'rm -f "$net"' EXIT
netconvert -n street.nod.xml -e street.edg.xml -o "$net" >/dev/null
[[ " $* " == *" --delay "* ]] || set -- --delay 1000 "$@" # milliseconds per simulated second: real time
sumo-gui --osg-view -n "$net" -r street.rou.xml -g view.xml --start --step-length 0.1 "$@"
