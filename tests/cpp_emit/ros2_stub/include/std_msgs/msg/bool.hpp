// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Bool that generated nodes use, for tests.
#pragma once

namespace std_msgs::msg {

struct Bool {
    bool data{};
};

}  // namespace std_msgs::msg
