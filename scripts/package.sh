#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes build/package/packages/*.deb and *.tar.gz, and tests them. The archive is unpacked in a temporary folder and run
# from another one in an empty environment. The package is installed in a fresh Debian 12, made with mmdebstrap if this
# is available; otherwise the package is unpacked and its libraries are looked up. Prints the seconds from installation
# to verdict.
set -euo pipefail
cd "$(dirname "$0")/.."
sources="$PWD"
scripts/setup.sh package
cmake --preset package >/dev/null
cmake --build --preset package --target robochart-verify robochart-replay robochart_library robochart_certifier
rm -rf build/package/packages
(cd build/package && cpack >cpack.log) || { cat build/package/cpack.log >&2; exit 1; }
deb="$(echo "$sources"/build/package/packages/robochart-verify_*.deb)"
library="$(echo "$sources"/build/package/packages/librobochart-verify-dev_*.deb)"
archive="$(echo "$sources"/build/package/packages/robochart-verify-[0-9]*.tar.gz)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

seconds_since() { # nanoseconds of `date`
  local passed=$(( $(date +%s%N) - $1 ))
  printf '%d.%02d' $(( passed / 1000000000 )) $(( passed / 10000000 % 100 ))
}

# Without a compiler, the program must give the verdicts and the reason, and exit with 3. With a compiler, all works.
try() { # prefix
  local examples="$1/share/doc/robochart-verify/examples" status=0
  env -i "$1/bin/robochart-verify" check "$examples/aggregation" -q
  env -i PATH=/nonexistent "$1/bin/robochart-verify" "$examples/aggregation" --out "$folder/out" >"$folder/report" || status=$?
  [ "$status" -eq 3 ] || { echo "exit $status without a compiler, 3 expected" >&2; exit 1; }
  grep -F 'conformance was not checked' "$folder/report"
  "$1/bin/robochart-verify" conform "$examples/swarm_taxis" -q --no-cache
  env -i "$1/bin/robochart-certify" "$examples/aggregation/certificates"
  env -i "$1/bin/robochart-verify" check "$examples/aggregation" --no-cache --certify "$folder/certificates-$(basename "$1")" >"$folder/report"
  grep -F 'holds (certified: term level, unreduced, ' "$folder/report" >/dev/null
  "$1/bin/robochart-verify" conform "$examples/aggregation" -q --no-cache --certify "$folder/code-$(basename "$1")"
  "$1/bin/robochart-replay" "$folder/code-$(basename "$1")"/1-*
  "$1/bin/robochart-verify" simulate "$examples/aggregation/aggregation.scenario" --no-pictures -q --no-cache
}

echo "== $(basename "$archive")"
start="$(date +%s%N)"
mkdir "$folder/elsewhere" "$folder/unpacked"
tar -C "$folder/unpacked" --strip-components 1 -xzf "$archive"
cd "$folder/elsewhere"
env -i "$folder/unpacked/bin/robochart-verify" check "$folder/unpacked/share/doc/robochart-verify/examples/aggregation" -q
echo "from unpacking to the verdict: $(seconds_since "$start") s"
"$sources/tests/packaging/symbols.sh" --alone "$folder/unpacked/bin/robochart-verify"
try "$folder/unpacked"

echo "== $(basename "$deb")"
dpkg-deb -f "$deb" Package Version Architecture Depends Recommends
cat >"$folder/try.sh" <<'TRY'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
start="$(date +%s%N)"
apt-get install -q -y --no-install-recommends /tmp/robochart-verify.deb >/tmp/install.log 2>&1 || { cat /tmp/install.log; exit 1; }
cd /tmp
robochart-verify check /usr/share/doc/robochart-verify/examples/aggregation -q
robochart-certify /usr/share/doc/robochart-verify/examples/aggregation/certificates
passed=$(( $(date +%s%N) - start ))
printf 'from install to the verdict: %d.%02d s\n' $(( passed / 1000000000 )) $(( passed / 10000000 % 100 ))
status=0
robochart-verify /usr/share/doc/robochart-verify/examples/aggregation >/tmp/report || status=$?
[ "$status" -eq 3 ] || { echo "exit $status without a compiler, 3 expected"; exit 1; }
grep -F 'conformance was not checked' /tmp/report
TRY
if command -v mmdebstrap >/dev/null; then
  cp "$deb" "$folder/robochart-verify.deb"
  mmdebstrap --quiet --variant=minbase \
    --customize-hook="copy-in $folder/robochart-verify.deb $folder/try.sh /tmp" \
    --customize-hook='chroot "$1" sh /tmp/try.sh' bookworm /dev/null
  echo "installed in a fresh Debian 12"
else
  dpkg-deb -x "$deb" "$folder/root"
  if ldd "$folder/root/usr/bin/robochart-verify" | grep -F 'not found'; then exit 1; fi
  try "$folder/root/usr"
  echo "unpacked only: mmdebstrap, which makes a fresh Debian, is not installed"
fi

echo "== $(basename "$library")"
dpkg-deb -f "$library" Package Version Architecture Depends Recommends
if command -v mmdebstrap >/dev/null; then
  cp "$library" "$folder/library.deb"
  "$sources/tests/packaging/extract.sh" "$sources/docs/library.md" "$folder/program"
  cat >"$folder/build.sh" <<'BUILD'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
apt-get install -q -y --no-install-recommends /tmp/robochart-verify.deb /tmp/library.deb g++ cmake make >/tmp/install.log 2>&1 ||
  { cat /tmp/install.log; exit 1; }
cd /tmp/program
cmake -S . -B build >/tmp/build.log && cmake --build build >>/tmp/build.log || { cat /tmp/build.log; exit 1; }
build/patrol >printed || [ $? -eq 1 ]
diff expected printed
BUILD
  mmdebstrap --quiet --variant=minbase \
    --customize-hook="copy-in $folder/robochart-verify.deb $folder/library.deb $folder/program $folder/build.sh /tmp" \
    --customize-hook='chroot "$1" sh /tmp/build.sh' bookworm /dev/null
  echo "the program of docs/library.md was built and ran in a fresh Debian 12"
fi
