#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Follows docs/tutorial.md in an empty folder with an installed copy: writes the files it shows, runs the commands between
# them, builds its program. Usage: tutorial.sh PREFIX LIBRARY_FOLDER [FOLDER_FOR_PICTURES]
set -euo pipefail
page=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../docs/tutorial.md")
prefix=$1 library=$1/$2 pictures=${3:+$(realpath "$3")}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PATH=$prefix/bin:$PATH CMAKE_PREFIX_PATH=$prefix HEADLESS=$library/osgTreeWind/libosgTreeWindHeadless.so
export OSG_LIBRARY_PATH=$library PKG_CONFIG_PATH=$library/pkgconfig
unset OSG_FILE_PATH LD_LIBRARY_PATH DISPLAY
cd "$work"

# Files are blocks whose first line is a comment with a name; a table has it before its head, and not in the file.
awk '
/^```/ { if (kind) { kind = ""; file = "" } else { kind = substr($0, 4); first = 1; if (kind == "sh") { ++runs } } next }
!kind || kind == "text" { next }
kind == "sh" { print > sprintf("%02d.run", runs); next }
first { first = 0; file = $2; if (file == "main.cpp") { hadProgram = 1 }; printf "" > file; if (kind == "csv") next }
{ print > file }
END { print runs > "runs" }' "$page"
[[ -s main.cpp && -s storm.treewind && $(<runs) -ge 9 ]] || { echo "tutorial: it has changed, and this does not know how"; exit 1; }
for run in *.run; do
    while IFS= read -r command; do
        case $command in # they open windows
        build/simulator | ./globe) command="LD_LIBRARY_PATH=$library LD_PRELOAD=$HEADLESS $command" ;;
        esac
        bash -c "$command" >said 2>&1 || { echo "tutorial: exit status $?: $command"; cat said; exit 1; }
        [[ $command != *./globe ]] || leans=$(<said)
        if [[ $command != cmake* ]] && grep -iE "^warning|error" said; then
            echo "tutorial: the lines above come of: $command"
            exit 1
        fi
    done <"$run"
done
grep -qE "^the top leans [0-9.]+ mm to the east" <<<"$leans" || { echo "tutorial: on the globe: $leans"; exit 1; }
for written in trees.csv motion.csv risk.csv fallen.csv; do
    [[ $(wc -l <"$written") -ge 2 ]] || { echo "tutorial: nothing in $written"; exit 1; }
done
[[ -z $pictures ]] || for picture in tree wood town storm; do
    cp "$picture.png" "$pictures/"
done
echo "passed: $(cat ./*.run | wc -l) commands"
