#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the tool under Wine with the native one, on three examples and on a forest whose files have names outside of
any code page: texts, motion and tiles must be equal, and pictures of which at most 0.01 % of the bytes may differ, by at
most 9 of 255. Without a native tool, the commands must only succeed.

Usage: compare.py SOURCE_FOLDER WINDOWS_TOOL [NATIVE_TOOL]      (under Xvfb, with WINEPREFIX set)
"""
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

MAX_DIFFERENCE, MAX_SHARE = 9, 1e-4
source, windows_tool = sys.argv[1], sys.argv[2]
native_tool = sys.argv[3] if len(sys.argv) > 3 else None


def run(tool, arguments):
    """Output of the tool, with the ends of lines of Linux."""
    command = ["wine", tool] if tool.endswith(".exe") else [tool]
    done = subprocess.run(command + arguments, cwd=source, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600)
    if done.returncode != 0:
        raise RuntimeError(f"{arguments}: {done.returncode}\n{done.stderr.decode(errors='replace')}")
    return done.stdout.replace(b"\r\n", b"\n")


def pixels(path):
    """Bytes of the pixels of a PNG of 8 bits a channel."""
    data = pathlib.Path(path).read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    step = {2: 3, 6: 4}[color]
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        kind, line = raw[start], bytearray(raw[start + 1:start + 1 + width * step])
        for x in range(len(line)):
            left = line[x - step] if x >= step else 0
            corner = before[x - step] if x >= step else 0
            up = before[x]
            if kind == 1:
                line[x] = line[x] + left & 255
            elif kind == 2:
                line[x] = line[x] + up & 255
            elif kind == 3:
                line[x] = line[x] + (left + up) // 2 & 255
            elif kind == 4:
                guess = left + up - corner
                line[x] = line[x] + min((left, up, corner), key=lambda value: abs(guess - value)) & 255
        rows.append(bytes(line))
        before = line
    return b"".join(rows)


failed = False


def report(name, good, text):
    global failed
    failed = failed or not good
    print(f"{'equal ' if good else 'DIFFERS'} {name}: {text}", flush=True)


def compare_text(name, arguments):
    here = run(windows_tool, arguments)
    if native_tool:
        there = run(native_tool, arguments)
        lines = sum(a != b for a, b in zip(here.splitlines(), there.splitlines()))
        report(name, here == there, f"{len(here.splitlines())} lines, {lines} differ")


def compare_pictures(name, ours, theirs):
    here, there = pixels(ours), pixels(theirs)
    off = [abs(a - b) for a, b in zip(here, there) if a != b]
    share, largest = len(off) / len(there), max(off, default=0)
    report(name, len(here) == len(there) and share <= MAX_SHARE and largest <= MAX_DIFFERENCE,
           f"{100 * (1 - share):.4f} % of the bytes are equal, the largest difference is {largest} of 255")


# Each key that names a file without a reader program has a path from the root, on Windows with a drive.
NAMED_FOREST = """version = 1
[wind]
kind = "series"
file = 'FOLDER/ветер.csv'
columns = { time = "t", speed = "s", direction_from = "d" }
[[species]]
name = "linde"
scan = ['FOLDER/стволы.swc']
[species.appearance]
bark_image = 'FOLDER/кора.png'
[inventory]
file = 'FOLDER/деревья.csv'
columns = { x = "x", y = "y", height = "h" }
"""


def use_names(root, tool):
    """All that the tool tells and writes for a forest with names in Cyrillic, with blanks and of 250 characters."""
    is_windows = tool.endswith(".exe")
    folder = pathlib.Path(root) / ("windows" if is_windows else "native") / "Лес и ветер" / ("long" * 60)
    folder.mkdir(parents=True)
    given = ("Z:" if is_windows else "") + str(folder)
    (folder / "лес.treewind").write_text(NAMED_FOREST.replace("FOLDER", given), encoding="utf-8")
    (folder / "ветер.csv").write_text("t,s,d\n0,3,200\n10,7,220\n20,4,210\n")
    (folder / "деревья.csv").write_text("x,y,h\n0,0,5\n8,3,6\n-4,9,4.5\n")
    (folder / "стволы.swc").write_bytes(pathlib.Path(source, "tests/data/scan/sapling.swc").read_bytes())
    (folder / "кора.png").write_bytes(pathlib.Path(source, "docs/habit/internode.png").read_bytes())
    forest = f"{given}/лес.treewind"
    texts = [run(tool, ["validate", forest]), run(tool, ["info", forest]),
             run(tool, ["simulate", forest, "--duration", "1", "-o", f"{given}/движение.csv"]),
             run(tool, ["render", forest, "--size", "320x180", "-o", f"{given}/вид.png"]),
             run(tool, ["tile", forest, "-o", f"{given}/мир"])]
    texts += [path.name.encode() + path.read_bytes() for path in sorted(folder.rglob("*"))
              if path.is_file() and path.suffix not in (".png", ".swc")]
    return b"\n".join(texts).replace(given.encode(), b"FOLDER"), folder / "вид.png"


with tempfile.TemporaryDirectory() as folder:
    for example in ("thesis", "forest", "helicopter"):
        file = f"examples/{example}.treewind"
        compare_text(f"info {example}", ["info", file])
        compare_text(f"validate {example}", ["validate", file])
        tools = {"windows": windows_tool} | ({"native": native_tool} if native_tool else {})
        for name, tool in tools.items():
            drive = "Z:" if tool.endswith(".exe") else ""
            run(tool, ["simulate", file, "--duration", "1", "--fps", "10", "-o", f"{drive}{folder}/{name}.csv"])
            run(tool, ["render", file, "--size", "480x270", "-o", f"{drive}{folder}/{name}.png"])
        if native_tool:
            here, there = (pathlib.Path(f"{folder}/{name}.csv").read_bytes().splitlines() for name in ("windows", "native"))
            count = sum(a != b for a, b in zip(here, there))
            report(f"simulate {example}", here == there, f"{count} of {len(there)} rows differ")
            compare_pictures(f"render {example}", f"{folder}/windows.png", f"{folder}/native.png")
    here, picture = use_names(folder, windows_tool)
    if native_tool:
        there, other = use_names(folder, native_tool)
        report("files with any names", here == there, f"{len(here)} bytes")
        compare_pictures("render with any names", picture, other)
    compare_text("sway", ["sway", "--species", "oak", "--dbh", "40", "--height", "18"])
sys.exit(failed)
