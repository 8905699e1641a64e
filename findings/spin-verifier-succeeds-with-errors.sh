#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A verifier that SPIN generates has exit code 0 when an assertion is violated, and when it did not search everything.
#
# Expected: a model checker that finds a violated assertion fails, so that `./pan && deploy` does not deploy; the
#   simulator, `spin MODEL`, does so. A search that stops at a limit does not say `errors: 0` and succeed.
# Observed: `pan`, and `spin -run`, have exit code 0 for a violated assertion. With a limit of depth (`-m`) below the
#   depth of the violation, `pan` prints `error: max search depth too small`, then `errors: 0`, and has exit code 0.
# Why it matters: a pipeline that verifies a robot's controller and trusts exit codes passes each controller. It has to
#   read both lines of the output: `errors: 0`, and neither `max search depth too small` nor `Search not completed`.
# usage: findings/spin-verifier-succeeds-with-errors.sh; needs gcc and Debian 12's apt to download a package; exit code 0
# if the behaviour is as described.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q spin=6.5.2+dfsg-1 >/dev/null 2>&1
dpkg -x spin_*.deb .
spin=$folder/usr/bin/spin
"$spin" -V

cat > drive.pml <<'END'
byte moves;

active proctype Drive() {
    do
    :: moves < 200 -> moves++
    :: moves == 200 -> break
    od;
    assert(moves < 200)
}
END
"$spin" -a drive.pml
gcc -O1 -w -o pan pan.c

code() {
  status=0
  "$@" > out.txt 2>&1 || status=$?
  echo "$status"
}

simulation=$(code "$spin" drive.pml)
echo "spin drive.pml:      exit code $simulation"
generated=$(code "$spin" -run drive.pml)
echo "spin -run drive.pml: exit code $generated"
whole=$(code ./pan)
grep -q 'assertion violated' out.txt
echo "./pan:               exit code $whole, $(grep -o 'errors: [0-9]*' out.txt)"
limited=$(code ./pan -m50)
grep -q 'max search depth too small' out.txt
errors=$(grep -o 'errors: [0-9]*' out.txt)
echo "./pan -m50:          exit code $limited, $errors, $(grep -o 'max search depth too small' out.txt)"
[ "$simulation" -ne 0 ] && [ "$generated" -eq 0 ] && [ "$whole" -eq 0 ] && [ "$limited" -eq 0 ] && [ "$errors" = "errors: 0" ]
