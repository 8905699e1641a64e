// SPDX-License-Identifier: Apache-2.0
// A list that two threads share.
#pragma once

#include <mutex>
#include <vector>

#include "robot.hpp"

namespace robochart::ros2_client {

/// A list that the thread of the client fills.
template <class Value>
class Shared {
public:
    void add(const Value& value) {
        const std::lock_guard lock(mutex_);
        values_.push_back(value);
    }
    [[nodiscard]] std::vector<Value> values() const {
        const std::lock_guard lock(mutex_);
        return values_;
    }
    [[nodiscard]] bool reaches(std::size_t size) const {
        return wait_until([&] { return values().size() >= size; });
    }

private:
    mutable std::mutex mutex_;
    std::vector<Value> values_;
};

}  // namespace robochart::ros2_client
