#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A copy of corpus/swarm_taxis in which both radii and the patience are constants, for `tune`: scripts/tunable_taxis.sh FOLDER
# The claims in blocks of CSP name its processes without these constants; they are left out.
set -eu
folder=${1:?"a folder that is not there yet"}
cp -r "$(dirname "$0")/../corpus/swarm_taxis" "$folder"
sed -i -e 's/= 0.2 else avoidanceRadius = 0.1 end/= farRadius else avoidanceRadius = nearRadius end/' \
    -e 's/since(T) < 25/since(T) < patience/' -e 's/since(T) >= 25/since(T) >= patience/' \
    -e 's/^interface SwarmTaxisIface {/&\n\tconst nearRadius : real = 0.1\n\tconst farRadius : real = 0.2\n\tconst patience : nat = 25/' \
    "$folder/swarm_taxis.rct"
sed -i '/^csp Asked/,$d' "$folder/swarm_taxis.assertions"
