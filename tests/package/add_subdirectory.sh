#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A strict host that has the sources below its own. The library and the programs beside it are not built again, which
# takes minutes: the host is configured, and its own source compiled as its build would.
# Usage: add_subdirectory.sh SOURCE_FOLDER
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake -G Ninja -S "$(dirname "${BASH_SOURCE[0]}")/subproject" -B "$work" "-DOSGTREEWIND=$1" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
python3 - "$work" <<END
import json, subprocess, sys
commands = json.load(open(sys.argv[1] + "/compile_commands.json"))
own = [command for command in commands if command["file"].endswith("/host.cpp")]
assert len(own) == 1, own
subprocess.run(own[0]["command"] + " -fsyntax-only", shell=True, check=True, cwd=own[0]["directory"])
END
