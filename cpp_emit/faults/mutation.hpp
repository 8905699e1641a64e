// The seeded fault of one generator run: which kind, and at which of the places that it applies to.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "cpp_emit/plan/fault.hpp"

namespace robochart::cpp_emit {

/// Whoever could do something wrong asks `hits` at every place a fault applies to; the answer is yes at one of them at
/// most, and never in production. The rewriting of the model asks first (faulty_model.hpp), then the emitters about
/// what the IR cannot express.
class Mutation {
public:
    Mutation(Fault fault, std::uint32_t site) : fault_(fault), site_(site) {}

    /// Called once at each place that `fault` applies to, in textual order.
    [[nodiscard]] bool hits(Fault fault) { return seeded(fault) && sites_++ == site_; }
    /// The same for a part of the model whose code is written more than once: the answer is the same each time. A
    /// part has several uses where machines run in several places.
    [[nodiscard]] bool hits(Fault fault, const void* use, const void* part) {
        if (!seeded(fault)) return false;
        const auto [place, fresh] = known_.emplace(std::pair(use, part), sites_);
        if (fresh) ++sites_;
        return place->second == site_;
    }
    /// Whether this run has the fault, wherever.
    [[nodiscard]] bool seeded(Fault fault) const { return fault == fault_ && fault != Fault::none; }
    /// The kind of this run; `none` in production.
    [[nodiscard]] Fault fault() const { return fault_; }
    /// Places met so far that the requested fault applies to.
    [[nodiscard]] std::uint32_t sites() const { return sites_; }

private:
    Fault fault_;
    std::uint32_t site_;
    std::uint32_t sites_ = 0;
    std::map<std::pair<const void*, const void*>, std::uint32_t> known_;  ///< never iterated
};

}  // namespace robochart::cpp_emit
