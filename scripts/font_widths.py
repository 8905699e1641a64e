#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints frontend/diagrams/layout/font_tables.cpp: the advance widths of DejaVu Sans and DejaVu Sans Bold, from their tables `cmap`
and `hmtx` (OpenType). Debian: fonts-dejavu-core."""
import struct
import sys

FOLDER = sys.argv[1] if len(sys.argv) > 1 else "/usr/share/fonts/truetype/dejavu"
RANGES = [(0x20, 0x17F), (0x370, 0x3FF), (0x2190, 0x21FF), (0x2200, 0x22FF)]


def number(data, at, size=2):
    return int.from_bytes(data[at:at + size], "big")


def widths(path):
    """The units per em, and the width of every character of the basic plane."""
    data = open(path, "rb").read()
    tables = {}
    for i in range(number(data, 4)):
        tag, _, offset, _ = struct.unpack(">4sIII", data[12 + 16 * i:28 + 16 * i])
        tables[tag.decode()] = offset
    units = number(data, tables["head"] + 18)
    advances = [number(data, tables["hmtx"] + 4 * i) for i in range(number(data, tables["hhea"] + 34))]
    result = {}
    for i in range(number(data, tables["cmap"] + 2)):
        platform, _, offset = struct.unpack(">HHI", data[tables["cmap"] + 4 + 8 * i:tables["cmap"] + 12 + 8 * i])
        start = tables["cmap"] + offset
        if platform == 3 and number(data, start) == 4:
            result.update(characters(data, start, advances))
    return units, result


def characters(data, start, advances):
    """The segments of a table of format 4."""
    count = number(data, start + 6) // 2
    for i in range(count):
        end = number(data, start + 14 + 2 * i)
        begin = number(data, start + 16 + 2 * count + 2 * i)
        delta = number(data, start + 16 + 4 * count + 2 * i)
        at = start + 16 + 6 * count + 2 * i
        offset = number(data, at)
        for character in range(begin, min(end, 0xFFFE) + 1):
            glyph = (character + delta) & 0xFFFF
            if offset:
                glyph = number(data, at + offset + 2 * (character - begin))
                glyph = (glyph + delta) & 0xFFFF if glyph else 0
            yield character, advances[min(glyph, len(advances) - 1)]


def rows(values):
    lines, line = [], "   "
    for value in values:
        if len(line) + len(f" {value},") > 116:
            lines.append(line)
            line = "   "
        line += f" {value},"
    return "\n".join(lines + [line])


def main():
    print("// Advance widths of DejaVu Sans 2.37 in units of an em, as its tables `hmtx` and `cmap` state them; printed by")
    print("// scripts/font_widths.py.")
    print('#include "frontend/diagrams/layout/font_tables.hpp"\n\nnamespace robochart::diagrams::layout {\nnamespace {\n')
    print("// clang-format off")
    tables = {}
    for name, file in (("regular", "DejaVuSans.ttf"), ("bold", "DejaVuSans-Bold.ttf")):
        units, table = widths(f"{FOLDER}/{file}")
        assert units == 2048
        tables[name] = table
        for first, last in RANGES:
            values = [table.get(c, units) for c in range(first, last + 1)]
            print(f"constexpr std::uint16_t {name}_{first:x}[] = {{\n{rows(values)}\n}};\n")
    print("constexpr WidthRange ranges[] = {")
    for first, last in RANGES:
        print(f"    {{0x{first:x}, 0x{last:x}, regular_{first:x}, bold_{first:x}}},")
    print("};\n// clang-format on\n\n}  // namespace\n")
    print("std::span<const WidthRange> width_ranges() {\n    return ranges;\n}\n")
    print("}  // namespace robochart::diagrams::layout")


main()
