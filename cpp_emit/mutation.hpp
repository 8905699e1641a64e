// The seeded fault of one generator run. Emitters ask `hits` at every place a fault applies to;
// the answer is yes at one of them at most, and never in production.
#pragma once

#include <cstdint>

#include "cpp_emit/emit.hpp"

namespace robochart::cpp_emit {

class Mutation {
public:
    Mutation(Fault fault, std::uint32_t site) : fault_(fault), site_(site) {}

    /// Called once at each place that `fault` applies to, in textual order.
    [[nodiscard]] bool hits(Fault fault) {
        if (fault != fault_ || fault == Fault::none) return false;
        return sites_++ == site_;
    }
    /// Places met so far that the requested fault applies to.
    [[nodiscard]] std::uint32_t sites() const { return sites_; }

private:
    Fault fault_;
    std::uint32_t site_;
    std::uint32_t sites_ = 0;
};

}  // namespace robochart::cpp_emit
