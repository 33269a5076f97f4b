#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs a build and moves it, because the package must be relocatable. Usage: install.sh BUILD_FOLDER PREFIX
set -euo pipefail
rm -rf "$2" "$2.first"
cmake --install "$1" --prefix "$2.first" >/dev/null
mv "$2.first" "$2"
