// Where the successors of one system are passed on by another.
#pragma once

#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// While this lives, the place has the sink that successors are passed on to; afterwards none.
class SinkInUse {
public:
    SinkInUse(SuccessorSink*& place, SuccessorSink& sink) : place_(place) { place_ = &sink; }
    SinkInUse(const SinkInUse&) = delete;
    SinkInUse& operator=(const SinkInUse&) = delete;
    ~SinkInUse() { place_ = nullptr; }

private:
    SuccessorSink*& place_;
};

}  // namespace robochart::lts
