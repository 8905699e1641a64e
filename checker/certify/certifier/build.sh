#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds robochart-certify: `build.sh FOLDER` compiles everything in this folder and writes FOLDER/robochart-certify.
# A second argument names a source that uses the same modules instead of the main program (tests), a third the result.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
compiler=${OCAMLOPT:-ocamlopt}
out=$1
main=${2:-$here/robochart_certify.ml}
name=${3:-robochart-certify}
work=$out/$name.build
mkdir -p "$work"
cp "$here"/*.ml "$here"/*.mli "$work"
cp "$main" "$work"
sh "$here/proofs.sh" "$here/../coq" > "$work/proofs.ml"
cd "$work"
"$compiler" -inline 200 -w -a -o "$name" uint63.ml parray.ml sha256.ml verified.mli verified.ml \
  formats.ml search.ml splitter.ml follow.ml symmetric.ml certificate_check.ml proofs.ml coq_form.ml "$(basename "$main")"
mv "$name" "../$name.new"
cd ..
rm -rf "$name.build"
mv "$name.new" "$name"
