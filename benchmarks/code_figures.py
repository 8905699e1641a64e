#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Figures of the code base: folders, cycles of units, classes, comments of functions. docs/benchmarks.md quotes them.

Usage: benchmarks/code_figures.py [FOLDER]   (default: the project; works for other source trees with the same conventions)
"""
import collections
import os
import re
import sys

LEFT_OUT = {"build", "out", ".git", "node_modules"}


def sources(root):
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in LEFT_OUT)
        for name in sorted(files):
            if name.endswith((".cpp", ".hpp")):
                yield os.path.relpath(os.path.join(folder, name), root)


def is_program(path):
    return not path.startswith(("tests/", "benchmarks/", "editors/vscode/"))


def strong_components(edges):
    """Tarjan (1972), with an explicit stack."""
    number, low, open_, result = {}, {}, [], []
    for root in edges:
        path = [(root, iter(edges[root]))] if root not in number else []
        if path:
            number[root] = low[root] = len(number)
            open_.append(root)
        while path:
            node, rest = path[-1]
            for to in rest:
                if to not in number:
                    number[to] = low[to] = len(number)
                    open_.append(to)
                    path.append((to, iter(edges[to])))
                    break
                if to in open_:
                    low[node] = min(low[node], number[to])
            else:
                path.pop()
                if path:
                    low[path[-1][0]] = min(low[path[-1][0]], low[node])
                if low[node] == number[node]:
                    component = []
                    while not component or component[-1] != node:
                        component.append(open_.pop())
                    result.append(component)
    return [c for c in result if len(c) > 1]


def include_edges(root, files, node_of):
    edges = collections.defaultdict(set)
    known = set(files)
    for path in files:
        edges[node_of(path)]
        with open(os.path.join(root, path), errors="replace") as text:
            for other in re.findall(r'^#include "([^"]+)"', text.read(), re.M):
                if other in known and node_of(other) != node_of(path):
                    edges[node_of(path)].add(node_of(other))
    return edges


def without_literals(text):
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.S)
    text = re.sub(r"//[^\n]*", "", text)
    return re.sub(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', '""', text)


def classes(text):
    """Names of classes with the number of functions declared in their bodies."""
    text = without_literals(text)
    for head in re.finditer(r"\b(?:class|struct)\s+(\w+)[^;{}()]*\{", text):
        depth, at, statement, count = 1, head.end(), "", 0
        while at < len(text) and depth:
            c = text[at]
            if c == "{":
                if depth == 1 and re.search(r"\w\s*\(", statement) and "=" not in statement.split("(")[0]:
                    count += 1
                statement = ""
                depth += 1
            elif c == "}":
                depth -= 1
                statement = ""
            elif depth == 1:
                if c == ";":
                    before = statement.split("(")[0]
                    if re.search(r"(\w|operator\S+)\s*\(", statement) and "=" not in before.replace("operator", ""):
                        count += 1
                    statement = ""
                else:
                    statement += c
            at += 1
        yield head.group(1), count


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    files = list(sources(root))
    program = [f for f in files if is_program(f)]
    texts = {f: open(os.path.join(root, f), errors="replace").read() for f in files}

    print("folders, by sources:")
    for folder, count in collections.Counter(os.path.dirname(f) for f in files).most_common(6):
        print(f"  {count:4} {folder}")
    cycles = strong_components(include_edges(root, program, lambda f: f.rsplit(".", 1)[0]))
    print(f"cycles of units: {len(cycles)}, by size: {sorted((len(c) for c in cycles), reverse=True)}")
    folders = strong_components(include_edges(root, program, os.path.dirname))
    print(f"cycles of folders: {[sorted(c) for c in folders]}")
    sizes = sorted(((n, name, f) for f in program for name, n in classes(texts[f])), reverse=True)
    print("classes, by functions declared:")
    for n, name, f in sizes[:10]:
        print(f"  {n:4} {name} ({f})")
    lines = [line.strip() for f in program for line in texts[f].split("\n") if line.strip()]
    alone = sum(line.startswith("//") for line in lines)
    trailing = sum("//" in line and not line.startswith("//") and '"' not in line for line in lines)
    print(f"lines of program: {len(lines)}; comments {100 * alone / len(lines):.1f} %, "
          f"with those behind code {100 * (alone + trailing) / len(lines):.1f} %")
    tests = sum(1 for f in files if f.startswith("tests/") for line in texts[f].split("\n") if line.strip())
    print(f"lines of tests: {tests}")


main()
