#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Trees on the runway of Keflavik in FlightGear, north of the aircraft, a flying saucer.
# Usage: run.sh [OPTION OF FGFS...]     e.g. run.sh --disable-clouds3d --disable-random-objects --geometry=640x400
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
PATH=$PATH:/usr/games
command -v fgfs >/dev/null || { echo "no FlightGear; apt-get install --no-install-recommends flightgear (1.8 GB)" >&2; exit 1; }
# The plugin of this build if it exists, else of the installed package.
if [[ -d ../../../build/lib/osgPlugins-3.6.5 ]]; then export OSG_LIBRARY_PATH=${OSG_LIBRARY_PATH:-$(realpath ../../../build/lib)}; fi

fgfs --aircraft=ufo --lat=63.9830 --lon=-22.6054 --heading=0 --timeofday=noon --disable-terrasync --disable-sound \
    --prop:/models/model[0]/path="$(realpath ../forest.treewind)" \
    --prop:/models/model[0]/latitude-deg=63.9833 --prop:/models/model[0]/longitude-deg=-22.6054 \
    --prop:/models/model[0]/elevation-ft-prop=/position/ground-elev-ft --prop:/models/model[0]/heading-deg=270 "$@"
