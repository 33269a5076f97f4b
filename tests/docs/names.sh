#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the documents name exists: links and paths in the repository, options in the tool's help, names and keys in the
# sources. Usage: names.sh TOOL
set -euo pipefail
tool=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
failed=0
fail() { echo "$1: $2"; failed=1; }

words=$(mktemp)
trap 'rm -f "$words"' EXIT
sources=(osgTreeWind plugins shaders examples tests cmake script CMakeLists.txt CMakePresets.json)
grep -rohE --exclude-dir=docs --exclude-dir=data '[A-Za-z_][A-Za-z0-9_]+' "${sources[@]}" | sort -u >"$words"
options=$("$tool" --help
    for command in $("$tool" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]*\) .*/\1/p'); do "$tool" "$command" --help; done)

# A path is one from the root, from osgTreeWind/ (a room) or from tests/ (a test, whose ending may be left out).
exists() {
    compgen -G "$1" >/dev/null || compgen -G "osgTreeWind/$1" >/dev/null || compgen -G "tests/$1*" >/dev/null
}
# Of the thesis, of OpenGL, and of how names are made.
elsewhere=" texCoord updateBranch GL_MAX_VERTEX_UNIFORM_COMPONENTS PascalCase camelCase _member "
known() {
    grep -qxF -- "$1" "$words" || [[ $elsewhere == *" $1 "* ]]
}

for document in README.md CONTRIBUTING.md docs/*.md; do
    while read -r link; do
        [[ $link == http* || $link == \#* || -e $(dirname "$document")/${link%%#*} ]] || fail "$document" "no file $link"
    done < <(awk '/^ *```/ { code = !code; next } !code' "$document" | grep -oE '\]\([^)]+\)' | sed 's/^](//; s/)$//')

    while read -r option; do
        grep -qE -- "(^|[ ,])$option\b" <<<"$options" || fail "$document" "no option $option in osgtreewind --help"
    done < <(grep -oE 'osgtreewind [^`#|]*' "$document" | grep -oE -- '--[a-z][a-z-]+' | sort -u)

    # In backquotes, blocks of code left out.
    while read -r quoted; do
        for token in $quoted; do
            case $token in
            -* | http* | build/* | share/* | *=*) continue ;;
            *.json | .ci/* | [a-zA-Z]*/*) [[ ! $token =~ ^[A-Za-z_./*]+$ || $token == */[a-z] || $token == 1/* ]] ||
                exists "$token" || fail "$document" "no path $token" ;;
            *::*)
                class=${token%%::*} member=${token##*::} member=${member%%(*}
                [[ $class == osg* || $class == glm || $class == std ]] && continue
                files=$(grep -rlw -- "$class" osgTreeWind plugins) || { fail "$document" "no class $class"; continue; }
                grep -qw -- "$member" $files || fail "$document" "no $member in $class"
                ;;
            *)
                while read -r word; do
                    known "$word" || fail "$document" "no $word in the sources"
                done < <(grep -oE '[A-Za-z_][A-Za-z0-9_]{2,}' <<<"$token")
                ;;
            esac
        done
    done < <(awk '/^ *```/ { code = !code; next } !code' "$document" | grep -oE '`[^`]+`' | tr -d '`' | sort -u)
done
exit $failed
