// SPDX-License-Identifier: Apache-2.0
// Packs the values of variables into the words of a state. A value takes as many bits as its range needs and does not
// cross a word boundary.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "prism/checks/checked.hpp"
#include "prism/explore/code.hpp"

namespace robochart::prism {

class Layout {
public:
    struct Field {
        std::string name;
        Type type = Type::integer;
        std::int64_t low = 0, high = 0;
        bool bounded = true;  ///< has a declared range, or is a bool
        std::uint32_t word = 0, shift = 0;
        std::uint32_t mask = 0;  ///< mask of the value's bits, before the shift
    };

    /// Evaluates the ranges. Throws EvaluationError.
    Layout(const std::vector<Variable>& variables, Code& code);

    [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }
    [[nodiscard]] std::size_t words() const { return words_; }
    void unpack(lts::StateView state, std::int32_t* values) const;
    void pack(const std::int32_t* values, lts::Word* state) const;
    /// Writes one value, which must be in its range.
    void set(lts::Word* state, std::uint32_t variable, std::int64_t value) const {
        const Field& field = fields_[variable];
        const auto bits = static_cast<std::uint32_t>(value - field.low);
        state[field.word] = (state[field.word] & ~(field.mask << field.shift)) | bits << field.shift;
    }
    /// Returns a text such as "x=1, y=false".
    [[nodiscard]] std::string state_text(const std::int32_t* values) const;
    /// Returns the text of the variables whose values differ from `before`. If `before` is null, the text contains all
    /// variables.
    [[nodiscard]] std::string changes_text(const std::int32_t* before, const std::int32_t* after) const;

private:
    std::vector<Field> fields_;
    std::size_t words_ = 1;
};

}  // namespace robochart::prism
