#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles the code in the comments of the public headers and in docs/viewer.md (c++). Expects some above each exported class.

Usage: snippets.py SOURCE_FOLDER COMPILER [FLAGS]
"""
import pathlib
import re
import subprocess
import sys

source, compiler = pathlib.Path(sys.argv[1]), sys.argv[2:]
headers = re.findall(r"osgTreeWind/\S+\.h", (source / "cmake/PublicHeaders.cmake").read_text())
# What the code may use without saying where it is from.
given = """
extern osg::ref_ptr<osg::Group> root, scene;
extern osg::ref_ptr<osg::Node> nest;
extern osg::ref_ptr<osg::StateSet> ours;
osg::Node* drawingOf(const ForestSimulation& simulation);
void moveDrawing(const ForestSimulation& simulation);
extern osg::ref_ptr<Forest> forest;
extern osgViewer::Viewer viewer;
extern osgUtil::LineSegmentIntersector::Intersection hit;
extern ForestDescription description;
extern TreeId tree;
extern WindSource helicopter;
extern GridWind::Grid grid;
extern std::vector<float> velocities;
void report(const Diagnostics& problems);
int fail(const Diagnostics& problems);
template <typename... Values> void use(Values&&...);
"""


def snippets(text):
    """Each block of indented lines in a comment, and the line below that comment."""
    for comment in re.finditer(r"(?:^ *///.*\n)+", text, re.M):
        lines = [line.strip()[3:] for line in comment.group().splitlines()]
        block = [line[5:] if line.startswith("     ") else "" for line in lines]
        below = text[comment.end():].split("\n", 2)
        if any(block):
            yield "\n".join(block).strip("\n"), " ".join(below[:2])


functions, bare = [], []
for header in headers:
    text = (source / header).read_text()
    shown = list(snippets(text))
    for code, _ in shown:
        functions.append(f"void snippet{len(functions)}() {{ // {header}\n{code}\n}}")
    for name in re.findall(r"^class (?:OSGTREEWIND_EXPORT|\[\[nodiscard\]\]) (\w+)", text, re.M):
        if not any(re.search(rf"\bclass (OSGTREEWIND_EXPORT|\[\[nodiscard\]\]) {name}\b", below) for _, below in shown):
            bare.append(f"{header}: expected lines of code that use it in the comment above {name}")

for code in re.findall(r"```c\+\+\n(.*?)```", (source / "docs/viewer.md").read_text(), re.S):
    functions.append(f"int snippet{len(functions)}() {{ // docs/viewer.md\n{code}\nreturn 0;\n}}")

program = "\n".join([f"#include <{header}>" for header in headers]
                    + [f"#include <{header}>" for header in ("cmath", "osgDB/WriteFile", "osgUtil/LineSegmentIntersector", "osgViewer/Viewer")]
                    + ["using namespace osgTreeWind;", given] + functions)
compiled = subprocess.run(compiler + ["-std=c++17", f"-I{source}", "-fsyntax-only", "-x", "c++", "-"], input=program, text=True)
print("\n".join(bare + [f"{len(functions)} pieces of code in {len(headers)} headers"]))
sys.exit(compiled.returncode or bool(bare))
