#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The installed headers are those of the list, and each compiles alone with strict warnings as C++17 and C++20.
# Usage: headers.sh PREFIX LIST COMPILER      (LIST: cmake/PublicHeaders.cmake)
set -euo pipefail
export prefix=$1 compiler=$3
cd "$prefix/include"
diff <(grep -o 'osgTreeWind/.*\.h' "$2" | sort) <(find osgTreeWind -name '*.h' | sort) ||
    { echo "headers: the list (<) differs from the installed headers (>)"; exit 1; }
alone() {
    for standard in 17 20; do
        "$compiler" -std=c++$standard -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Werror -I. -x c++ - <<<"#include <$1>" ||
            { echo "headers: $1 cannot be included alone as C++$standard"; return 1; }
    done
}
export -f alone
find osgTreeWind -name '*.h' -print0 | xargs -0 -n 1 -P "$(nproc)" bash -c 'alone "$1"' -
