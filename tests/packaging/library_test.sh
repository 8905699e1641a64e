#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The program in docs/library.md compiles against the installed library, without the sources, and prints what the page
# shows. Arguments: the sources, the build tree.
set -euo pipefail
sources="$1"
build="$2"
page="$sources/docs/library.md"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

[ -e "$build/librobochart_driver.a" ] || { echo "build the target robochart_library first" >&2; exit 1; }
manifest="$build/install_manifest.txt"
[ ! -e "$manifest" ] || cp "$manifest" "$folder/users"
cmake --install "$build" --prefix "$folder/usr" >/dev/null
[ ! -e "$folder/users" ] || cp "$folder/users" "$manifest"

"$sources/tests/packaging/extract.sh" "$page" "$folder/program"

setting() { sed -n "s|^$1:[A-Z]*=||p" "$build/CMakeCache.txt"; }
flags="$(setting CMAKE_CXX_FLAGS)"
sanitizers="$(setting ROBOCHART_SANITIZE)"
[ -z "$sanitizers" ] || flags="$flags -fsanitize=$sanitizers"
cmake -S "$folder/program" -B "$folder/program/build" -DCMAKE_PREFIX_PATH="$folder/usr" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_COMPILER="$(setting CMAKE_CXX_COMPILER)" -DCMAKE_CXX_FLAGS="$flags -Wall -Wextra -Werror" >"$folder/log" ||
  { cat "$folder/log" >&2; exit 1; }
cmake --build "$folder/program/build" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }

cd "$folder/program"
status=0
build/patrol >printed || status=$?
[ "$status" -eq 1 ] || { echo "exit $status, 1 expected" >&2; exit 1; }
diff expected printed || { echo "the program prints other lines than docs/library.md shows" >&2; exit 1; }

# With a missing file it reports this and ends.
rm patrol.rct
status=0
build/patrol >printed 2>errors || status=$?
[ "$status" -eq 2 ] && grep -q 'patrol.rct' errors && [ ! -s printed ] ||
  { echo "a missing model is not reported" >&2; exit 1; }
echo "the program of docs/library.md prints what the page shows"
