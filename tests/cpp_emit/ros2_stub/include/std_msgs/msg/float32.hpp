// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Float32 that generated nodes use, for tests.
#pragma once

namespace std_msgs::msg {

struct Float32 {
    float data{};
};

}  // namespace std_msgs::msg
