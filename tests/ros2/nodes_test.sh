#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds generated packages with ROS 2, with all warnings as errors, and runs them on the loopback interface with the
# programs in `client`. The logs of the nodes must conform to the models. If ROBOCHART_ROS2_SECONDS is set, the runs with
# random inputs take this number of seconds.
# Arguments: the sources, the program, the folder of ROS 2, and optionally a folder for the results.
set -euo pipefail
sources="$1"
program="$2"
ros="$3"
here="$sources/tests/ros2"
suite="${ROBOCHART_SHARED:-$sources/../shared}/suite"
if [ ! -d "$suite/ros2" ]; then
  echo "$suite/ros2 is not there: its models cannot be run"
  exit 77
fi
if [ $# -gt 3 ]; then
  folder="$4"
  mkdir -p "$folder"
else
  folder="$(mktemp -d)"
  trap 'rm -rf "$folder"' EXIT
fi
cd "$folder"
fail() { echo "$*" >&2; exit 1; }

# The scripts of ROS 2 use variables that are not set.
set +u
[ ! -e "$ros/setup.sh" ] || COLCON_CURRENT_PREFIX="$ros" AMENT_CURRENT_PREFIX="$ros" . "$ros/setup.sh"
set -u
export AMENT_PREFIX_PATH="$folder/install:${AMENT_PREFIX_PATH:-$ros}"
export CMAKE_PREFIX_PATH="$folder/install:$ros:${CMAKE_PREFIX_PATH:-}"
export LD_LIBRARY_PATH="$folder/install/lib:$ros/lib:${LD_LIBRARY_PATH:-}"
export ROS_DOMAIN_ID="${ROS_DOMAIN_ID:-$((RANDOM % 90 + 10))}"
# Loopback has no multicast, so Cyclone DDS needs a peer.
export CYCLONEDDS_URI='<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast><Interfaces>
<NetworkInterface name="lo"/></Interfaces></General><Discovery><ParticipantIndex>auto</ParticipantIndex>
<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex><Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>'

rm -rf models
"$sources/tests/packaging/extract.sh" "$sources/docs/ros2.md" models
cp "$here"/models/* "$sources/corpus/aggregation/aggregation.rct" "$suite/claims/warehouse/warehouse.rct" models
for model in order latched; do
  for kind in rct ros2; do
    sed "s/package order/package crossing/; s/stm M /stm ${model^} /; s/ros2 for M /ros2 for ${model^} /" \
      "$suite/ros2/$model/$model.$kind" >models/$model.$kind
  done
done
for kind in rct ros2; do
  sed 's/crossing/crossing_at_once/; s/Order/Quick/' models/order.$kind >models/quick.$kind
done

# Builds and installs a CMake project. Arguments: its folder, options of CMake.
build() {
  local name
  name="$(basename "$1")"
  cmake -S "$1" -B "build/$name" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$folder/install" -DBUILD_TESTING=OFF \
    -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror' "${@:2}" >"$name.log" 2>&1 &&
    cmake --build "build/$name" --parallel 2 >>"$name.log" 2>&1 || { tail -50 "$name.log" >&2; fail "$name does not build"; }
}

# Generates, builds and installs a package. Arguments: the model, options of `emit cpp`.
package() {
  local model="$1"
  shift
  "$program" emit cpp "models/$model.rct" --target ros2 --mapping "models/$model.ros2" --out "emitted/$model" --quiet "$@" \
    >emit.log 2>&1 || { cat emit.log >&2; fail "no package for $model"; }
  build "$(echo "emitted/$model/ros2"/*)" -DROBOCHART_TRACE=ON
  cmake --install "build/$(basename "emitted/$model/ros2"/*)" >>emit.log
}

package roam --const SPEED=0.3
package aggregation
package warehouse
package order
package latched
package quick --dispatch immediate
guide=OFF
if [ -e "$ros/share/nav2_msgs" ]; then
  package guide --const SPEED=0.5 --const TRIES=3
  guide=ON
fi
build "$here/client" -DWITH_GUIDE=$guide

build/client/node_test
[ $guide = OFF ] || build/client/guide_test

conform() { "$program" conform "models/$1.rct" --traces "$2" --quiet; }

seconds="${ROBOCHART_ROS2_SECONDS:-20}"
for model in aggregation warehouse; do
  build/client/round_trip $model "$seconds" 1 "$folder/$model.trace" "$folder/$model.messages"
  conform $model $model.trace
done
# The messages that arrived, instead of the calls in the log. Two messages in another order, or a lost message, are a
# fault.
"$here/messages_in_log.py" warehouse.trace warehouse.messages >arrived.trace
conform warehouse arrived.trace
for fault in swap lose; do
  "$here/messages_in_log.py" warehouse.trace warehouse.messages $fault >$fault.trace
  status=0
  conform warehouse $fault.trace >$fault.log 2>&1 || status=$?
  [ $status -eq 1 ] || { cat $fault.log; fail "the fault '$fault' is not found: exit $status"; }
done
echo "the nodes run on ROS 2"
