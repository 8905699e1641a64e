#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# scripts/vsix.py makes an archive that VS Code can install: manifest, content types, the files that package.json names,
# and an executable program. The packages of the client and the program are stand-ins. Exit code 77 (skipped) without
# python3.
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v python3 >/dev/null || { echo "python3 is not installed" >&2; exit 77; }
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/modules/vscode-languageclient/browser"
echo '{}' >"$folder/modules/vscode-languageclient/package.json"
echo 'code' >"$folder/modules/vscode-languageclient/node.js"
echo 'text' >"$folder/modules/vscode-languageclient/node.d.ts"
echo 'code' >"$folder/modules/vscode-languageclient/browser/main.js"
printf '#!/bin/sh\n' >"$folder/program"

make_it() { scripts/vsix.py --program "$folder/program" --modules "$folder/modules" --out "$1" >"$folder/log" 2>&1; }
make_it "$folder/a.vsix" || { cat "$folder/log" >&2; exit 1; }
make_it "$folder/b.vsix"
cmp "$folder/a.vsix" "$folder/b.vsix"

python3 - "$folder/a.vsix" <<'PYTHON'
import json, sys, zipfile
import xml.etree.ElementTree as xml
archive = zipfile.ZipFile(sys.argv[1])
names = set(archive.namelist())
package = json.loads(archive.read("extension/package.json"))
manifest = xml.fromstring(archive.read("extension.vsixmanifest"))
space = "{http://schemas.microsoft.com/developer/vsx-schema/2011}"
identity = manifest.find(f"{space}Metadata/{space}Identity")
assert identity.get("Id") == package["name"] and identity.get("Version") == package["version"]
assert identity.get("TargetPlatform") == "linux-x64"
for asset in manifest.iter(f"{space}Asset"):
    assert asset.get("Path") in names, asset.get("Path")
types = xml.fromstring(archive.read("[Content_Types].xml"))
endings = {each.get("Extension") for each in types if each.get("Extension")}
parts = {each.get("PartName") for each in types if each.get("PartName")}
for name in names - {"[Content_Types].xml"}:
    assert "/" + name in parts or "." + name.rsplit(".", 1)[-1] in endings, name
for name in [package["main"], package["icon"]]:
    assert "extension/" + name.removeprefix("./") in names, name
assert archive.getinfo("extension/server/robochart-verify").external_attr >> 16 & 0o111 == 0o111
assert "extension/node_modules/vscode-languageclient/node.js" in names
for name in names:
    assert not name.endswith((".d.ts", ".svg")) and "/browser/" not in name and "/tests/" not in name, name
PYTHON

# An archive that is too large or incomplete is rejected with the reason, and no file is left.
head -c 700000 /dev/urandom >"$folder/modules/vscode-languageclient/large.js"
if make_it "$folder/c.vsix"; then echo "a client of 700 kB was accepted" >&2; exit 1; fi
grep -q "at most 500 kB" "$folder/log"
test ! -e "$folder/c.vsix"
rm -r "$folder/modules/vscode-languageclient"
if make_it "$folder/d.vsix"; then echo "a client without its packages was accepted" >&2; exit 1; fi
grep -q "has no vscode-languageclient" "$folder/log"
