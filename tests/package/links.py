#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that all functions declared in installed headers can be linked, and that all types named there are defined there.
Doxygen reads the headers, and a generated program calls each function.
Usage: links.py PREFIX LIBRARY_FOLDER COMPILER [LINKER_ARGUMENT...]"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

prefix, library_folder, compiler = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
include, libraries = prefix / "include", prefix / library_folder
headers = sorted(str(path.relative_to(include)) for path in include.glob("osgTreeWind/**/*.h"))

doxyfile = """
INPUT = {include}
RECURSIVE = YES
OUTPUT_DIRECTORY = {work}
GENERATE_XML = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
QUIET = YES
WARNINGS = NO
WARN_IF_DOC_ERROR = NO
WARN_IF_INCOMPLETE_DOC = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = OSGTREEWIND_EXPORT= META_Node(library,name)= META_Object(library,name)=
"""


def text(element):
    return "".join(element.itertext()).strip() if element is not None else ""


class Function:
    def __init__(self, member, scope):
        self.name, self.scope = text(member.find("name")), scope
        self.types = [text(parameter.find("type")) for parameter in member.findall("param")]
        self.parameters = [f"{kind} a{i}" for i, kind in enumerate(self.types) if kind != "void"]
        self.arguments = ", ".join(f"std::forward<{kind}>(a{i})" for i, kind in enumerate(self.types) if kind != "void")
        self.protected = member.get("prot") == "protected"
        self.static = member.get("static") == "yes"
        self.const = "const " if member.get("const") == "yes" else ""
        self.constructor = self.name == scope.split("::")[-1]
        self.destructor = self.name.startswith("~")

    def program(self, number, aliases):
        """Source of a function that calls this one."""
        call = f"{self.scope}::{self.name}({self.arguments})"
        if self.protected:  # as a derived class may
            known = f"struct Derived{number} : {self.scope} {{"
            if self.constructor:
                return f"{known} Derived{number}({', '.join(self.parameters)}); }};\n" \
                    f"Derived{number}::Derived{number}({', '.join(self.parameters)}) : {self.name}({self.arguments}) {{}}"
            if self.destructor:
                return f"{known} ~Derived{number}(); }};\nDerived{number}::~Derived{number}() {{}}"
            return f"{known} void call({', '.join(self.parameters)}); }};\n" \
                f"void Derived{number}::call({', '.join(self.parameters)}) {{ (void){call}; }}"
        parameters = list(self.parameters)
        if self.constructor:
            call = f"new {self.scope}({self.arguments})"
        elif self.scope != "osgTreeWind" and not self.static:
            parameters.insert(0, f"{self.const}{self.scope}& self")
            call = "self." + call
        # The aliases make the nested types of the class known without its name.
        return f"struct Call{number} {{ {aliases} static void call({', '.join(parameters)}); }};\n" \
            f"void Call{number}::call({', '.join(parameters)}) {{ (void){call}; }}"


def is_declared_only(member):
    argstring = text(member.find("argsstring")).replace(" ", "")
    return (member.get("kind") == "function" and member.get("prot") != "private" and member.get("inline") != "yes" and
            member.get("constexpr") != "yes" and member.get("virt") != "pure-virtual" and
            member.find("templateparamlist") is None and member.find("location").get("bodystart") is None and
            not argstring.endswith(("=default", "=delete", "=0")))


def read(folder):
    """Returns functions with the aliases they need, classes, and the types in public declarations: place and text."""
    functions, classes, declarations = [], [], []
    for file in sorted(folder.glob("*.xml")):
        compound = xml.parse(file).getroot().find("compounddef")
        if compound is None or compound.get("kind") not in ("class", "struct", "namespace"):
            continue
        scope = text(compound.find("compoundname"))
        if not scope.startswith("osgTreeWind") or compound.get("prot") == "private":
            continue
        is_template = compound.find("templateparamlist") is not None
        own = [text(inner).split("::")[-1] for inner in compound.findall("innerclass") if inner.get("prot") == "public"]
        for member in compound.iter("memberdef"):
            if member.get("prot") != "private" and member.get("kind") in ("typedef", "enum") and text(member.find("name")):
                own.append(text(member.find("name")))
        if compound.get("kind") != "namespace":
            if not is_template:
                classes.append(scope)
            declarations += [(scope, text(base)) for base in compound.findall("basecompoundref") if base.get("prot") != "private"]
        aliases = "" if scope == "osgTreeWind" else " ".join(f"using {name} = {scope}::{name};" for name in own)
        for member in compound.iter("memberdef"):
            if member.get("prot") == "private" or member.get("kind") == "friend":
                continue
            place = f"{scope}::{text(member.find('name'))}"
            declarations.append((place, " ".join([text(member.find("type"))] + [text(one.find("type")) for one in member.findall("param")])))
            if is_declared_only(member) and not is_template:
                functions.append((Function(member, scope), aliases))
    return functions, classes, declarations


def undefined_types(defined):
    """Types of the library that headers declare but do not define."""
    declared = set()
    for header in headers:
        declared |= set(re.findall(r"^\s*(?:enum )?(?:class|struct) (?:OSGTREEWIND_EXPORT )?(\w+)(?: : [\w:]+)?;",
                                    (include / header).read_text(), re.M))
    return declared - {name.split("::")[-1] for name in defined}


def program(functions, classes):
    lines = [f"#include <{header}>" for header in headers] + ["#include <typeinfo>", "#include <utility>", "namespace osgTreeWind {"]
    lines += [function.program(number, aliases) for number, (function, aliases) in enumerate(functions)]
    lines += [f"const std::type_info& type{number} = typeid({name});" for number, name in enumerate(classes)]
    return "\n".join(lines + ["}", "int main() {}", ""])


def main(work):
    subprocess.run(["doxygen", "-"], input=doxyfile.format(include=include, work=work), text=True, check=True)
    functions, classes, declarations = read(work / "xml")
    failed = False
    undefined = undefined_types(classes)
    for place, types in declarations:
        for name in sorted({word.removeprefix("osgTreeWind::") for word in re.findall(r"[\w:]+", types)} & undefined):
            print(f"links: {place} uses {name}, which no installed header defines")
            failed = True

    source = work / "links.cpp"
    source.write_text(program(functions, classes))
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", "osgTreeWind"], capture_output=True, text=True, check=True,
                           env={**os.environ, "PKG_CONFIG_PATH": str(libraries / "pkgconfig")}).stdout.split()
    done = subprocess.run([compiler, "-std=c++17", "-O0", "-w", source, "-o", work / "links", f"-L{libraries}", *sys.argv[4:], *flags],
                          capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})
    missing = sorted(set(re.findall(r"undefined reference to `(.*)'", done.stderr)))
    for symbol in missing:
        print(f"links: declared in an installed header, but cannot be linked: {symbol}")
    if done.returncode and not missing:
        print(done.stderr)
    if len(functions) < 100:
        print(f"links: expected at least 100 functions in the headers, found {len(functions)}")
        failed = True
    if failed or done.returncode:
        sys.exit(1)
    print(f"links: {len(functions)} functions of {len(headers)} headers")


with tempfile.TemporaryDirectory() as folder:
    main(pathlib.Path(folder))
