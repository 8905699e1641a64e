#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Copies corpus/swarm_taxis to FOLDER, with both radii and the patience as constants, for `tune`:
# benchmarks/tunable_taxis.sh FOLDER
# The assertions in CSP blocks are removed, because they name its processes without these constants.
set -eu
folder=${1:?"a folder that is not there yet"}
cp -r "$(dirname "$0")/../corpus/swarm_taxis" "$folder"
sed -i -e 's/= 0.2 else avoidanceRadius = 0.1 end/= farRadius else avoidanceRadius = nearRadius end/' \
    -e 's/since(T) < 25/since(T) < patience/' -e 's/since(T) >= 25/since(T) >= patience/' \
    -e 's/^interface SwarmTaxisIface {/&\n\tconst nearRadius : real = 0.1\n\tconst farRadius : real = 0.2\n\tconst patience : nat = 25/' \
    "$folder/swarm_taxis.rct"
sed -i '/^csp Asked/,$d' "$folder/swarm_taxis.assertions"
