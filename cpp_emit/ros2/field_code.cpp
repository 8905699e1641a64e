// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/field_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace robochart::cpp_emit::ros2 {

namespace {

std::string value_of(const Filled& field) {
    if (!field.scalar) return field.literal;
    return field.scalar->kind == ScalarKind::enumeration
               ? fmt::format("static_cast<std::int64_t>({})", field.scalar->place)
               : field.scalar->place;
}

/// Writes code that fills one array with several numbers.
void fill_array(CodeWriter& out, const Outgoing& outgoing, const std::string& message) {
    std::vector<std::string> numbers;
    for (const Filled& field : outgoing.fields)
        numbers.push_back(fmt::format("static_cast<double>({})", field.scalar->place));
    out.line(fmt::format("{}.data = {{{}}};", message, fmt::join(numbers, ", ")));
}

}  // namespace

std::string fill_message(CodeWriter& out, const Outgoing& outgoing, const std::string& message,
                         const std::string& now) {
    if (outgoing.array) {
        fill_array(out, outgoing, message);
        return "";
    }
    std::vector<std::string> conditions;
    for (const Filled& field : outgoing.fields) {
        const std::string place = fmt::format("{}.{}", message, field.field);
        if (field.now)
            out.line(fmt::format("{} = {};", place, now));
        else if (field.literal.starts_with('"'))
            out.line(fmt::format("{} = {};", place, field.literal));
        else
            conditions.push_back(fmt::format("::robochart::ros2::put({}, {})", place, value_of(field)));
    }
    return fmt::format("{}", fmt::join(conditions, " && "));
}

}  // namespace robochart::cpp_emit::ros2
