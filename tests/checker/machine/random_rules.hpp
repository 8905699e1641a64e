// Random compiled processes: components, regions inside each other, priorities and assignments as no script would
// combine them.
#pragma once

#include <memory>
#include <random>

#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Numbers from one seed, the same on every compiler.
class RandomRules {
public:
    explicit RandomRules(std::uint64_t seed) : numbers_(seed) {}
    /// Two to five components of up to five states, in up to three regions. Visible events are those from first_visible
    /// on, `visible` in number.
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
