#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the documents name exists: links and paths in the repository, options in the tool's help, names and keys in the
sources. Usage: names.py TOOL"""

import glob
import os
import re
import subprocess
import sys

tool = os.path.abspath(sys.argv[1])
os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
# Of the thesis, of OpenGL, of how names are made, and of what others write.
elsewhere = {"texCoord", "updateBranch", "GL_MAX_VERTEX_UNIFORM_COMPONENTS", "PascalCase", "camelCase", "_member", "axisX", "grib_ls",
             "height_ft", "lonlat", "E6100000", "OSG_USE_UTF8_FILENAME", "strftime"}
problems = []


def text_of(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


def files_below(*paths, without=()):
    for path in paths:
        if os.path.isfile(path):
            yield path
        for folder, folders, names in os.walk(path):
            folders[:] = [name for name in folders if name not in without]
            yield from (os.path.join(folder, name) for name in names)


def help_of(*words):
    return subprocess.run([tool, *words, "--help"], capture_output=True, text=True, check=True).stdout


words, sources = set(), []  # of all sources; texts of what has classes
for path in files_below("osgTreeWind", "plugins", "shaders", "examples", "tests", "cmake", "script", "CMakeLists.txt",
                        "CMakePresets.json", without=("docs", "data")):
    text = text_of(path)
    names = set(re.findall(r"[A-Za-z_][A-Za-z0-9_]*", text))
    words |= names
    if path.startswith(("osgTreeWind/", "plugins/")):
        sources.append(names)
usage = help_of()
commands = re.findall(r"^  ([a-z]+) ", usage[usage.index("\nSubcommands:"):], re.M)
usage += "".join(help_of(command) for command in commands)


def exists(path):
    """A path is one from the root, from osgTreeWind/ (a module) or from tests/ (a test, whose ending may be left out)."""
    return any(glob.glob(pattern) for pattern in (path, f"osgTreeWind/{path}", f"tests/{path}*"))


def check_quoted(document, token):
    if re.match(r"-|http|build/|share/", token) or "=" in token:
        return
    if token.endswith(".json") or token.startswith(".ci/") or re.match(r"[a-zA-Z].*/", token):
        checked = re.fullmatch(r"[A-Za-z_./*]+", token) and not re.search(r"/[a-z]$", token)
        if checked and not exists(token):
            problems.append(f"{document}: no path {token}")
    elif "::" in token:
        name, member = token.split("::")[0], re.sub(r"\(.*", "", token.split("::")[-1])
        if name.startswith("osg") or name in ("glm", "std"):
            return
        having = [names for names in sources if name in names]
        if not having:
            problems.append(f"{document}: no class {name}")
        elif not any(member in names for names in having):
            problems.append(f"{document}: no {member} in {name}")
    else:
        for word in re.findall(r"[A-Za-z_][A-Za-z0-9_]{2,}", token):
            if word not in words and word not in elsewhere:
                problems.append(f"{document}: no {word} in the sources")


for document in ["README.md", "CONTRIBUTING.md", *sorted(glob.glob("docs/*.md"))]:
    text = text_of(document)
    prose = re.sub(r"^ *```.*?^ *```[^\n]*$", "", text, flags=re.M | re.S)
    for link in re.findall(r"\]\(([^)\n]+)\)", prose):
        target = os.path.join(os.path.dirname(document), link.split("#")[0])
        if not link.startswith(("http", "#")) and not os.path.exists(target):
            problems.append(f"{document}: no file {link}")
    for command in re.findall(r"osgtreewind [^`#|\n]*", text):
        for option in re.findall(r"--[a-z][a-z-]+", command):
            if not re.search(rf"(^|[ ,]){option}\b", usage, re.M):
                problems.append(f"{document}: no option {option} in osgtreewind --help")
    for quoted in re.findall(r"`([^`\n]+)`", prose):
        for token in quoted.split():
            check_quoted(document, token)

print("\n".join(sorted(set(problems))), end="\n" if problems else "")
sys.exit(bool(problems))
