#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `cmake --install` writes the required files and no others. The installed program runs in an empty environment from
# another folder, and needs no newer C library than packages may. Arguments: the sources, the build tree.
set -euo pipefail
sources="$1"
build="$2"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# Saves the manifest, which `uninstall` needs for the user's installation.
manifest="$build/install_manifest.txt"
[ ! -e "$manifest" ] || cp "$manifest" "$folder/users"
cmake --install "$build" --prefix "$folder/usr" >/dev/null
mv "$manifest" "$folder/ours"
[ ! -e "$folder/users" ] || cp "$folder/users" "$manifest"

library="$(sed -n 's/^CMAKE_INSTALL_LIBDIR:[A-Z]*=//p' "$build/CMakeCache.txt")"
expected="$(
  {
    echo bin/robochart-verify
    [ ! -e "$build/app/mpi/robochart-verify-mpi" ] || echo bin/robochart-verify-mpi
    [ ! -e "$build/checker/certify/certifier/robochart-certify" ] || echo bin/robochart-certify
    echo bin/robochart-replay
    echo include/robochart_verify.hpp
    [ ! -e "$build/librobochart_driver.a" ] || echo "$library/librobochart_driver.a"
    echo share/bash-completion/completions/robochart-verify
    echo share/zsh/vendor-completions/_robochart-verify
    echo share/fish/vendor_completions.d/robochart-verify.fish
    echo share/man/man1/robochart-verify.1.gz
    echo share/robochart-verify/cmake/robochart-driver.cmake
    echo share/robochart-verify/cmake/robochart-verify-config.cmake
    echo share/doc/robochart-verify/AUTHORS
    echo share/doc/robochart-verify/CITATION.cff
    echo share/doc/robochart-verify/LICENSE
    echo share/doc/robochart-verify/copyright
    (cd "$sources/corpus" && find . -type f | sed 's|^\.|share/doc/robochart-verify/examples|')
    echo share/doc/robochart-verify/README.md
    echo share/doc/robochart-verify/CHANGELOG.md
    echo share/doc/robochart-verify/DOCUMENTS.md
    (cd "$sources/docs" && find . -maxdepth 1 -name '*.md' ! -name README.md | sed 's|^\.|share/doc/robochart-verify|')
    (cd "$sources/docs" && find pictures -type f | sed 's|^|share/doc/robochart-verify/|')
    (cd "$sources/docs/rules" && find . -name '*.md' | sed 's|^\.|share/doc/robochart-verify/rules|')
    (cd "$sources/frontend/toolkits/library" && find . -name '*.rct' | sed 's|^\.|share/robochart-verify/library|')
  } | sort
)"
found="$(cd "$folder/usr" && find . -type f -o -type l | sed 's|^\./||' | sort)"
diff <(echo "$expected") <(echo "$found") || { echo "other files are installed than expected" >&2; exit 1; }

gzip -dc "$folder/usr/share/man/man1/robochart-verify.1.gz" | cmp - "$sources/docs/robochart-verify.1"

# Links in the documents lead to installed files.
links=0
while IFS=: read -r page link; do
  links=$((links + 1))
  [ -e "$(dirname "$page")/$link" ] || { echo "$page: $link leads nowhere" >&2; exit 1; }
done < <(grep -roE --include='*.md' '\]\([^)#: ]+' "$folder/usr/share/doc/robochart-verify" | sed 's/\](//' |
  grep -vE ':(https?|CODE\.md)$')  # the pattern in rules/README.md
[ "$links" -gt 500 ] || { echo "only $links links are found" >&2; exit 1; }

mkdir "$folder/elsewhere"
cd "$folder/elsewhere"
run=(env -i "$folder/usr/bin/robochart-verify")
"${run[@]}" check "$folder/usr/share/doc/robochart-verify/examples/aggregation" -q | grep -q 'checks hold$'
[ "$("${run[@]}" version)" = "$("$build/app/robochart-verify" --version)" ]
grep -q "^project(robochart-verify VERSION $("${run[@]}" version | cut -d ' ' -f 2) " "$sources/CMakeLists.txt"
"${run[@]}" explain RC-W07 | grep -q 'RC-W07'
[ -z "$(ls)" ]  # `check` writes no files

"$sources/tests/packaging/symbols.sh" "$folder/usr/bin/robochart-verify"

cmake -DMANIFEST="$folder/ours" -P "$sources/scripts/cmake/uninstall.cmake" >/dev/null 2>&1
[ -z "$(find "$folder/usr" -type f)" ] || { echo "uninstall leaves files" >&2; exit 1; }
echo "what is installed is complete and runs"
