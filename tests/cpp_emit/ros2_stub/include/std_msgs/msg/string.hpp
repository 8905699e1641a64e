// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/String that generated nodes use, for tests.
#pragma once

#include <string>

namespace std_msgs::msg {

struct String {
    std::string data{};
};

}  // namespace std_msgs::msg
