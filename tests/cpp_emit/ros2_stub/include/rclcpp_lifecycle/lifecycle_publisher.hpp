// SPDX-License-Identifier: Apache-2.0
// A publisher that publishes only while its node is active, for tests.
#pragma once

#include <memory>

#include "rclcpp/rclcpp.hpp"

namespace rclcpp_lifecycle {

class ManagedEntity {
public:
    virtual ~ManagedEntity() = default;
    void on_activate() { activated_ = true; }
    void on_deactivate() { activated_ = false; }
    [[nodiscard]] bool is_activated() const { return activated_; }

private:
    bool activated_ = false;
};

template <class Message>
class LifecyclePublisher : public ManagedEntity, public rclcpp::Publisher<Message> {
public:
    using SharedPtr = std::shared_ptr<LifecyclePublisher>;

    using rclcpp::Publisher<Message>::Publisher;
    void publish(const Message& message) override {
        if (is_activated())
            rclcpp::Publisher<Message>::publish(message);
        else
            rclcpp::Network::get().log.emplace_back("published while it was not active");
    }
};

}  // namespace rclcpp_lifecycle
