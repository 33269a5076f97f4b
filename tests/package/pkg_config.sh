#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds a host with pkg-config and strict warnings. Usage: pkg_config.sh PREFIX LIBRARY_FOLDER COMPILER
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PKG_CONFIG_PATH=$1/$2/pkgconfig
read -ra flags < <(pkg-config --cflags --libs osgTreeWind)
"$3" -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror "$here/host.cpp" "${flags[@]}" -o "$work/host"
LD_LIBRARY_PATH=$1/$2 "$work/host"
