// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Float64 that generated nodes use, for tests.
#pragma once

namespace std_msgs::msg {

struct Float64 {
    double data{};
};

}  // namespace std_msgs::msg
