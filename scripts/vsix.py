#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Packs the VS Code extension and the program into one .vsix for linux-x64 that needs no other files.

Usage: scripts/vsix.py [--program FILE] [--modules FOLDER] [--out FILE]
  --program   robochart-verify as it is shipped (default: build/package/app/robochart-verify, made by scripts/package.sh)
  --modules   node_modules with the client's dependencies (default: `npm ci --omit=dev` in build/vsix, which needs a registry)
  --out       default: build/robochart-linux-x64.vsix

A .vsix is a zip of the extension, a manifest and a list of content types. The same inputs give the same bytes.
Exits with 1 and the reason if a file is missing, or if the client has more than 500 kB or the whole more than 20 MB.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import zipfile
from xml.sax.saxutils import escape, quoteattr

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SOURCE = os.path.join(ROOT, "editors", "vscode")
LEFT_OUT = {"tests", "node_modules", ".gitignore", ".vscodeignore", "package-lock.json", "icon.svg"}
MOST_OF_CLIENT = 500_000
MOST_OF_ALL = 20_000_000

CONTENT_TYPES = """<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
{}</Types>
"""

MANIFEST = """<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id={id} Version={version} Publisher={publisher} TargetPlatform="linux-x64"/>
    <DisplayName>{name}</DisplayName>
    <Description xml:space="preserve">{description}</Description>
    <Tags>{tags}</Tags>
    <Categories>{categories}</Categories>
    <License>extension/LICENSE</License>
    <Icon>extension/icon.png</Icon>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value={engine}/>
    </Properties>
  </Metadata>
  <Installation>
    <InstallationTarget Id="Microsoft.VisualStudio.Code"/>
  </Installation>
  <Dependencies/>
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Content.Changelog" Path="extension/CHANGELOG.md" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Icons.Default" Path="extension/icon.png" Addressable="true"/>
  </Assets>
</PackageManifest>
"""


def fail(why):
    sys.exit(f"vsix: {why}")


def files_of(folder, left_out):
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(each for each in folders if each not in left_out)
        for name in sorted(names):
            if name not in left_out:
                path = os.path.join(place, name)
                yield os.path.relpath(path, folder), path


def is_needed(name):
    """Selects the files of a package that Node runs, and its licence."""
    return name.endswith((".js", "package.json")) or "license" in os.path.basename(name).lower()


def modules_from_registry():
    folder = os.path.join(ROOT, "build", "vsix")
    os.makedirs(folder, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(os.path.join(SOURCE, name), folder)
    try:
        subprocess.run(["npm", "ci", "--omit=dev", "--no-audit", "--no-fund"], cwd=folder, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        fail(f"the client's packages could not be installed ({error}); give them with --modules")
    return os.path.join(folder, "node_modules")


def manifest_of(package):
    return MANIFEST.format(id=quoteattr(package["name"]), version=quoteattr(package["version"]),
                           publisher=quoteattr(package["publisher"]), name=escape(package["displayName"]),
                           description=escape(package["description"]), tags=escape(",".join(package["keywords"])),
                           categories=escape(",".join(package["categories"])),
                           engine=quoteattr(package["engines"]["vscode"]))


def content_types(names):
    """A content type for each extension; files without an extension are listed by name."""
    types = {".json": "application/json", ".js": "application/javascript", ".md": "text/markdown",
             ".png": "image/png", ".css": "text/css", ".vsixmanifest": "text/xml"}
    lines = set()
    for name in names:
        ending = os.path.splitext(name)[1]
        kind = types.get(ending, "application/octet-stream")
        lines.add(f"  <Default Extension={quoteattr(ending)} ContentType={quoteattr(kind)}/>\n" if ending else
                  f"  <Override PartName={quoteattr('/' + name)} ContentType={quoteattr(kind)}/>\n")
    return CONTENT_TYPES.format("".join(sorted(lines)))


def add(archive, name, data, mode=0o644):
    """The packed size."""
    entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
    entry.create_system = 3  # Unix, so that the mode is used
    entry.external_attr = (0o100000 | mode) << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    archive.writestr(entry, data, compresslevel=9)
    return entry.compress_size


def contents(path):
    with open(path, "rb") as file:
        return file.read()


def build(program, modules, out):
    client = dict(files_of(SOURCE, LEFT_OUT))
    for name, path in files_of(modules, {"browser", "esm", ".bin", "typings"}):
        if is_needed(name):
            client["node_modules/" + name] = path
    package = json.loads(contents(client["package.json"]))
    missing = [each for each in package["dependencies"] if f"node_modules/{each}/package.json" not in client]
    if missing:
        fail(f"{modules} has no {', '.join(missing)}")
    names = ["extension/" + name for name in sorted(client)]
    server = "extension/server/robochart-verify"
    with zipfile.ZipFile(out, "w") as archive:
        add(archive, "extension.vsixmanifest", manifest_of(package))
        add(archive, "[Content_Types].xml", content_types(names + [server, "extension.vsixmanifest"]))
        size = sum(add(archive, name, contents(path)) for name, (_, path) in zip(names, sorted(client.items())))
        add(archive, server, contents(program), 0o755)
    return size, os.path.getsize(out)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "package", "app", "robochart-verify"))
    parser.add_argument("--modules")
    parser.add_argument("--out", default=os.path.join(ROOT, "build", "robochart-linux-x64.vsix"))
    options = parser.parse_args()
    if not os.path.isfile(options.program):
        fail(f"there is no program {options.program}; scripts/package.sh makes it, or give another with --program")
    modules = options.modules or modules_from_registry()
    client, whole = build(options.program, modules, options.out)
    print(f"{options.out}: client {client // 1000} kB, with the program {whole / 1e6:.1f} MB")
    if client > MOST_OF_CLIENT or whole > MOST_OF_ALL:
        os.remove(options.out)
        fail(f"at most {MOST_OF_CLIENT // 1000} kB and {MOST_OF_ALL // 1_000_000} MB are allowed")


main()
