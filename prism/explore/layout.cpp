// SPDX-License-Identifier: Apache-2.0
// See layout.hpp.
#include "prism/explore/layout.hpp"

#include <fmt/format.h>

#include <bit>
#include <limits>

#include "prism/explore/rules.hpp"

namespace robochart::prism {
namespace {

constexpr unsigned word_bits = std::numeric_limits<lts::Word>::digits;

}  // namespace

Layout::Layout(const std::vector<Variable>& variables, Code& code) {
    unsigned used = 0;
    for (const Variable& variable : variables) {
        Field field;
        field.name = variable.name.text;
        field.type = variable.type;
        field.bounded = variable.low != nullptr || variable.type == Type::boolean;
        field.low = std::numeric_limits<std::int32_t>::min();
        field.high = std::numeric_limits<std::int32_t>::max();
        if (variable.type == Type::boolean) {
            field.low = 0;
            field.high = 1;
        } else if (variable.low) {
            field.low = code.integer(code.compile(variable.low), nullptr);
            field.high = code.integer(code.compile(variable.high), nullptr);
        }
        if (field.low > field.high)
            throw EvaluationError(rules::empty_range, variable.low->span,
                                  {field.name, fmt::format("{}", field.low), fmt::format("{}", field.high)});
        const auto width = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(field.high - field.low)));
        if (used + width > word_bits) {
            ++words_;
            used = 0;
        }
        field.word = static_cast<std::uint32_t>(words_ - 1);
        field.shift = width == 0 ? 0 : used;
        field.mask = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
        used += width;
        fields_.push_back(std::move(field));
    }
}

void Layout::unpack(lts::StateView state, std::int32_t* values) const {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const Field& field = fields_[i];
        values[i] = static_cast<std::int32_t>((state[field.word] >> field.shift & field.mask) + field.low);
    }
}

void Layout::pack(const std::int32_t* values, lts::Word* state) const {
    for (std::size_t i = 0; i < words_; ++i) state[i] = 0;
    for (std::size_t i = 0; i < fields_.size(); ++i) set(state, static_cast<std::uint32_t>(i), values[i]);
}

std::string Layout::state_text(const std::int32_t* values) const {
    return changes_text(nullptr, values);
}

std::string Layout::changes_text(const std::int32_t* before, const std::int32_t* after) const {
    std::string result;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        if (before != nullptr && before[i] == after[i]) continue;
        std::string value;
        if (fields_[i].type == Type::boolean)
            value = after[i] != 0 ? "true" : "false";
        else
            value = fmt::format("{}", after[i]);
        result += fmt::format("{}{}={}", result.empty() ? "" : ", ", fields_[i].name, value);
    }
    return result;
}

}  // namespace robochart::prism
