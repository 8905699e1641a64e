// SPDX-License-Identifier: Apache-2.0
// Distinguishes copies of one component that run together. It finds the copy to which each sequential component of a
// run belongs, and the copy that performs an event of the whole process. Machines of different copies have the same
// name in the model, so the copy is appended to the name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "counterexample/timeline.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::runs {

class Copies {
public:
    /// `meaning` must outlive this object. If it has no value, no copies are distinguished.
    explicit Copies(const std::optional<csp_emit::CopiesMeaning>& meaning) : meaning_(meaning) {}

    /// Returns the copy that performs an event. `name`: the name of the event in the whole process.
    [[nodiscard]] std::optional<std::uint32_t> of_event(const std::string& name) const;
    /// Returns the action of the copy in words if the component's own events do not show it. Returns no value
    /// otherwise.
    [[nodiscard]] std::optional<std::string> words_for(const std::string& name) const;
    /// Numbers the leaves. For each leaf, `of_model` says whether the leaf is in definitions of the model. Every copy
    /// must have the same number of such leaves, in the order of the copies.
    void number_leaves(const std::vector<bool>& of_model);
    /// Must be called if it is unknown which leaves belong to which copy.
    void forget_leaves() { leaves_.clear(); }
    [[nodiscard]] std::optional<std::uint32_t> of_leaf(Leaf leaf) const;
    /// Returns "P::M::c::s of robot 1", or "robot 1" if the event belongs to no component of the copy. Without a copy,
    /// returns the name unchanged.
    [[nodiscard]] std::string name_with_copy(const std::string& component, std::optional<std::uint32_t> copy) const;

private:
    const std::optional<csp_emit::CopiesMeaning>& meaning_;
    std::vector<std::optional<std::uint32_t>> leaves_;
};

}  // namespace robochart::runs
