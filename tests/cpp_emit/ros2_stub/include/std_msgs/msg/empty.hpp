// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Empty that generated nodes use, for tests.
#pragma once

namespace std_msgs::msg {

struct Empty {};

}  // namespace std_msgs::msg
