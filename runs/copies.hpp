// Copies of one component that run together, distinguished: which of them the sequential components of a run are in,
// and which an event of the whole is of. Machines of different copies have one name in the model; behind it stands the
// copy.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/emit.hpp"
#include "runs/timeline.hpp"

namespace robochart::runs {

class Copies {
public:
    /// Outlives it. None: nothing is distinguished.
    explicit Copies(const std::optional<csp_emit::CopiesMeaning>& meaning) : meaning_(meaning) {}

    /// The copy that acts in an event of the whole, by its name there.
    [[nodiscard]] std::optional<std::uint32_t> of_event(const std::string& name) const;
    /// What it does where the component's own events do not say it: nothing where they do.
    [[nodiscard]] std::optional<std::string> words(const std::string& name) const;
    /// `of_model`: of each leaf, whether it is in definitions of the model. Every copy has as many of them, and they
    /// stand in the order of the copies.
    void number(const std::vector<bool>& of_model);
    /// The leaves cannot be distinguished.
    void forget() { leaves_.clear(); }
    [[nodiscard]] std::optional<std::uint32_t> of_leaf(Leaf leaf) const;
    /// "P::M::c::s of robot 1", "robot 1" where it is nobody's event but the copy's; as it is without a copy.
    [[nodiscard]] std::string named(const std::string& component, std::optional<std::uint32_t> copy) const;

private:
    const std::optional<csp_emit::CopiesMeaning>& meaning_;
    std::vector<std::optional<std::uint32_t>> leaves_;
};

}  // namespace robochart::runs
