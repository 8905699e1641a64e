// SPDX-License-Identifier: Apache-2.0
// A system that passes on the successors of another system stores its current sink with this class.
#pragma once

#include <cassert>

#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// Makes a variable point to the sink that receives successors. The destructor sets the variable to null.
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
