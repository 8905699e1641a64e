// SPDX-License-Identifier: Apache-2.0
// A robot that implements the operation `beep` in C++: it takes half a second. The stop command of the same cycle must
// leave the node before it.
#include <chrono>
#include <thread>

#include <roam/Roam_node.hpp>

namespace {

class Robot : public roaming::RoamMessages {
public:
    void beep() override { std::this_thread::sleep_for(std::chrono::milliseconds(500)); }
};

}  // namespace

int main(int count, char** words) {
    rclcpp::init(count, words);
    {
        const auto node = std::make_shared<roaming::RoamNode>(rclcpp::NodeOptions(), std::make_unique<Robot>());
        rclcpp::spin(node->get_node_base_interface());
    }
    rclcpp::shutdown();
}
