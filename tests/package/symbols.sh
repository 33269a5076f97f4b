#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The library exports only what the installed headers mark, and weak instances of standard library templates.
# Usage: symbols.sh PREFIX LIBRARY
set -euo pipefail
marked=$(grep -rhE -A 1 'OSGTREEWIND_EXPORT ' "$1/include/osgTreeWind" | tr '\n' ' ' |
    grep -oE '(class|struct) OSGTREEWIND_EXPORT [A-Za-z]+|OSGTREEWIND_EXPORT [^;(]*\(' | sed -E 's/.*[ &*]([A-Za-z]+)\(?$/\1/')
[[ -n $marked ]] || { echo "symbols: no header marks a symbol for export"; exit 1; }
failed=0
while read -r _ kind symbol; do
    case $symbol in
    osgTreeWind::* | "vtable for osgTreeWind::"* | "typeinfo for osgTreeWind::"* | "typeinfo name for osgTreeWind::"* | \
        *"thunk to osgTreeWind::"* | "VTT for osgTreeWind::"* | "construction vtable for "*"osgTreeWind::"*)
        name=${symbol#*osgTreeWind::}
        name=${name%%[^A-Za-z]*}
        grep -qx "$name" <<<"$marked" && continue
        ;;
    __bss_start | _edata | _end) continue ;;
    *std::* | *__gnu_cxx::*) [[ $kind == [WVu] ]] && continue ;;
    esac
    echo "symbols: exported, but not marked in an installed header: $kind $symbol"
    failed=1
done < <(nm -D --defined-only -C "$2")
exit $failed
