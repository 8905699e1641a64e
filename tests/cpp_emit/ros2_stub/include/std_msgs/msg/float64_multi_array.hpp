// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Float64MultiArray that generated nodes use, for tests.
#pragma once

#include <vector>

namespace std_msgs::msg {

struct Float64MultiArray {
    std::vector<double> data{};
};

}  // namespace std_msgs::msg
