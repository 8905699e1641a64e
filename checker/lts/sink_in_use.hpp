// SPDX-License-Identifier: Apache-2.0
// Stores the current sink in a system that forwards the successors of another system.
#pragma once

#include <cassert>

#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// Makes a variable point to the sink that receives the successors. The destructor sets the variable to null again.
class SinkInUse {
public:
    SinkInUse(SuccessorSink*& place, SuccessorSink& sink) : place_(place) {
        assert(place_ == nullptr);
        place_ = &sink;
    }
    SinkInUse(const SinkInUse&) = delete;
    SinkInUse& operator=(const SinkInUse&) = delete;
    ~SinkInUse() { place_ = nullptr; }

private:
    SuccessorSink*& place_;
};

}  // namespace robochart::lts
