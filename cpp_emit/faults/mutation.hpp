// SPDX-License-Identifier: Apache-2.0
// Stores the seeded fault of one generator run: its kind, and the place to which it applies.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "cpp_emit/plan/fault.hpp"

namespace robochart::cpp_emit {

/// Decides where the seeded fault applies. Code that could contain a fault calls `hits` at every place to which the
/// fault applies. The answer is true for at most one place, and always false in production. First the code that
/// rewrites the model calls `hits` (faulty_model.hpp). Then the emitters call it, for faults that the IR cannot
/// express.
class Mutation {
public:
    Mutation(Fault fault, std::uint32_t site) : fault_(fault), site_(site) {}

    /// Returns whether the fault applies to this place. Must be called once for each place to which `fault` applies, in
    /// textual order.
    [[nodiscard]] bool hits(Fault fault) { return is_seeded(fault) && sites_++ == site_; }
    /// Like `hits`, for a part of the model whose code is written more than once because machines run in several
    /// places. The answer for a part is always the same.
    [[nodiscard]] bool hits(Fault fault, const void* use, const void* part) {
        if (!is_seeded(fault)) return false;
        const auto [place, fresh] = known_.emplace(std::pair(use, part), sites_);
        if (fresh) ++sites_;
        return place->second == site_;
    }
    /// Returns whether this run has the fault at some place.
    [[nodiscard]] bool is_seeded(Fault fault) const { return fault == fault_ && fault != Fault::none; }
    /// This run's kind of fault; `none` in production.
    [[nodiscard]] Fault fault() const { return fault_; }
    /// Returns the number of places found so far to which the requested fault applies.
    [[nodiscard]] std::uint32_t site_count() const { return sites_; }

private:
    Fault fault_;
    std::uint32_t site_;
    std::uint32_t sites_ = 0;
    std::map<std::pair<const void*, const void*>, std::uint32_t> known_;  ///< never iterated
};

}  // namespace robochart::cpp_emit
