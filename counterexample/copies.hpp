// SPDX-License-Identifier: Apache-2.0
// Distinguishes copies of one component that run together. It finds the copy to which each sequential component of a
// run belongs, and the copy that performs an event of the whole process. Machines of different copies have the same
// name in the model; the copy is appended.
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
    /// `meaning` must outlive the object. Without a value, no copies are distinguished.
    explicit Copies(const std::optional<csp_emit::CopiesMeaning>& meaning) : meaning_(meaning) {}

    /// The copy that performs an event, given the event's name in the whole process.
    [[nodiscard]] std::optional<std::uint32_t> of_event(const std::string& name) const;
    /// The action of the copy in words, if the component's own events do not show it; otherwise no value.
    [[nodiscard]] std::optional<std::string> words_for(const std::string& name) const;
    /// For each leaf, `of_model` tells whether it is in definitions of the model. Every copy has the same number of
    /// leaves, in the order of the copies.
    void number_leaves(const std::vector<bool>& of_model);
    /// Must be called if the leaves cannot be distinguished.
    void forget_leaves() { leaves_.clear(); }
    [[nodiscard]] std::optional<std::uint32_t> of_leaf(Leaf leaf) const;
    /// "P::M::c::s of robot 1"; "robot 1" if the event belongs to no component of the copy; unchanged without a copy.
    [[nodiscard]] std::string name_with_copy(const std::string& component, std::optional<std::uint32_t> copy) const;

private:
    const std::optional<csp_emit::CopiesMeaning>& meaning_;
    std::vector<std::optional<std::uint32_t>> leaves_;
};

}  // namespace robochart::runs
