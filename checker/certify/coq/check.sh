#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Compiles the proofs, compares the extracted program with the committed one and the assumptions of the theorems with
# assumptions.txt, and has the separate checker coqchk check everything again. `check.sh --write` writes the extracted
# program and the assumptions instead.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
certifier=$here/../certifier
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$here"/*.v "$work"
cd "$work"
if grep -nE 'Admitted|admit|Axiom|Parameter|Conjecture' ./*.v; then
  echo "the proofs must not assume anything" >&2
  exit 1
fi
if [ "$(cat Claims.v Processes.v | wc -l)" -gt 150 ]; then
  echo "Claims.v and Processes.v have more than 150 lines to be believed" >&2
  exit 1
fi
if [ "$(cat Claims.v Terms.v | wc -l)" -gt 190 ]; then
  echo "Claims.v and Terms.v have more than 190 lines to be believed" >&2
  exit 1
fi
for name in $(cat "$here/order.txt") Extract; do
  coqc -q -Q . Certify "$name.v" > "$name.log"
done
grep -oE '^[A-Za-z0-9_.]+$|^[A-Za-z0-9_.]+ ' Extract.log | tr -d ' ' | sort -u > assumptions.txt
for file in verified.ml verified.mli; do
  {
    echo '(* SPDX-License-Identifier: Apache-2.0 *)'
    echo '(* Extracted by Coq from ../coq (check.sh --write). *)'
    cat "$file"
  } > "$file.new"
done
if [ "${1:-}" = --write ]; then
  cp assumptions.txt "$here/assumptions.txt"
  for file in verified.ml verified.mli; do cp "$file.new" "$certifier/$file"; done
  exit 0
fi
diff "$here/assumptions.txt" assumptions.txt
for file in verified.ml verified.mli; do diff "$certifier/$file" "$file.new"; done
coqchk -silent -o -Q . Certify Certify.Scripts > chk.log 2>&1 || { cat chk.log; exit 1; }
grep -A200 'Axioms:' chk.log | grep -vE 'Coq\.(Numbers\.Cyclic\.Int63|Array)\.' | grep -E '^ +[A-Za-z]' | grep -vE '<none>' > other.log || true
if [ -s other.log ]; then
  echo "coqchk lists other assumptions:" >&2
  cat other.log >&2
  exit 1
fi
echo "the proofs are complete; $(wc -l < assumptions.txt) lines of assumptions, all about Coq's primitive integers and arrays"
