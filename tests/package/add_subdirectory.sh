#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests a host that includes the sources by add_subdirectory(). It configures the host and compiles only the host's own
# source, because building the library again takes minutes.
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
