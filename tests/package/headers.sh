#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The installed headers are those of the list. Each compiles alone with strict warnings, and all together as C++20.
# Usage: headers.sh PREFIX LIST COMPILER      (LIST: cmake/PublicHeaders.cmake)
set -euo pipefail
export prefix=$1 compiler=$3
cd "$prefix/include"
diff <(grep -o 'osgTreeWind/.*\.h' "$2" | sort) <(find osgTreeWind -name '*.h' | sort) ||
    { echo "headers: the list (<) differs from the installed headers (>)"; exit 1; }
compile() { # STANDARD: the code from standard input
    "$compiler" -std="$1" -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Werror -I. -x c++ -
}
alone() {
    compile c++17 <<<"#include <$1>" || { echo "headers: $1 cannot be included alone"; return 1; }
}
export -f compile alone
find osgTreeWind -name '*.h' -print0 | xargs -0 -n 1 -P "$(nproc)" bash -c 'alone "$1"' -
find osgTreeWind -name '*.h' -printf '#include <%p>\n' | compile c++20
