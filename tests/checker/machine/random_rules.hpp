// SPDX-License-Identifier: Apache-2.0
// Makes random compiled processes with components, nested regions, priorities and assignments, in combinations that no
// script produces.
#pragma once

#include <memory>
#include <random>

#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// A random generator whose sequence depends only on the seed, not on the compiler.
class RandomRules {
public:
    explicit RandomRules(std::uint64_t seed) : numbers_(seed) {}
    /// Returns a process of two to five components with up to five states each, in up to three regions. It has
    /// `visible` visible events, which start at first_visible.
    std::shared_ptr<const Supercombinator> next(const process::TermId& meaning);
    static constexpr Event visible = 4;

private:
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(numbers_() % end); }
    bool chance(std::uint32_t percent) { return below(100) < percent; }
    Event event(std::uint32_t taus);
    ComponentPtr component(TermId meaning);
    Region region(const std::vector<Participant>& participants, const std::vector<std::uint32_t>& slots);
    std::vector<std::uint32_t> levels();

    std::mt19937_64 numbers_;
    Supercombinator made_;
};

}  // namespace robochart::machine
