// SPDX-License-Identifier: Apache-2.0
#include "counterexample/evaluation_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/utf8.hpp"
#include "semantics/ir/element_at.hpp"
#include "semantics/ir/open_constants.hpp"

namespace robochart::runs {
namespace {

/// Returns the remark "; the constant speed has no value in the model and is 0 (--const speed=1 gives it one)" if a
/// divisor contains such a constant, otherwise "".
std::string open_constants(const cspm::EvaluationError& error, const ir::System& system) {
    if (std::string_view(error.what()).find("by zero") == std::string_view::npos) return "";
    const std::vector<std::string> names = ir::open_divisors(system, error.span);
    if (names.empty()) return "";
    std::vector<std::string> options;
    for (const std::string& name : names) options.push_back(fmt::format("--const {}=1", name));
    const bool one = names.size() == 1;
    return fmt::format("; the constant{} {} {} no value in the model and {} 0 ({} gives {})", one ? "" : "s",
                       fmt::join(names, ", "), one ? "has" : "have", one ? "is" : "are", fmt::join(options, " "),
                       one ? "it one" : "them one");
}

/// Returns the first argument of a call such as "f(<1, 2>, 3)" if it is a sequence, otherwise "".
std::string_view sequence_in(std::string_view call) {
    const std::size_t begin = call.find('(') + 1;
    std::size_t depth = 0;
    for (std::size_t at = begin; at < call.size(); ++at) {
        if (call[at] == '<') ++depth;
        if (call[at] == '>' && depth > 0) --depth;
        if (depth == 0) return at == begin ? "" : call.substr(begin, at + 1 - begin);
    }
    return "";
}

/// Returns the last argument of such a call if it is a number. Returns no value otherwise.
std::optional<std::string_view> number_in(std::string_view call) {
    const std::size_t before = call.rfind(", ");
    if (before == std::string_view::npos || !call.ends_with(')')) return std::nullopt;
    const std::string_view number = call.substr(before + 2, call.size() - before - 3);
    if (number.empty() || number.find_first_not_of("-0123456789") != std::string_view::npos) return std::nullopt;
    return number;
}

/// The maximal number of calls in the call stack of an error (Work::fail).
constexpr std::size_t longest_stack = 30;

/// Returns the message "the sequence <1, 2> has no element 3" if a function of the scripts' library failed because it
/// looked for a missing element, and "" for any other error. The library function calls itself with the rest of the
/// sequence, so the outermost of its calls shows the whole sequence.
std::string missing_element(const cspm::EvaluationError& error) {
    for (const std::string_view function : {"access_", "update_"}) {
        if (!std::string_view(error.what()).starts_with(fmt::format("no clause of '{}'", function))) continue;
        const std::string begin = fmt::format("{}(", function);
        const auto first = error.stack.begin();
        const auto other =
            std::ranges::find_if_not(error.stack, [&](const std::string& call) { return call.starts_with(begin); });
        if (other == first) return "there is no element of this index in the sequence";
        const std::string_view sequence = sequence_in(*(other - 1));
        const auto number = number_in(*(other - 1));
        if (sequence == "<>") return "the sequence is empty, it has no element to read or to replace";
        const bool cut = other == error.stack.end() && error.stack.size() >= longest_stack;
        if (sequence.empty() || !number || cut) return "there is no element of this index in the sequence";
        return fmt::format("the sequence {} has no element {}: the first is element 1", sequence, *number);
    }
    return "";
}

constexpr std::string_view outside = " is not a value of its field";

/// Returns the message "a value leaves its carrier: <1, 2, 3>", or "" for any other error.
std::string value_outside(std::string_view message) {
    constexpr std::size_t longest = 80;
    const std::size_t end = message.find(outside);
    if (end == std::string_view::npos) return "";
    const std::string_view value = message.substr(0, end);
    return fmt::format("a value leaves its carrier: {}{}", diagnostics::beginning_of(value, longest),
                       value.size() > longest ? "..." : "");
}

}  // namespace

std::string failure_text(const cspm::EvaluationError& error, const ir::System& system) {
    const std::string element = ir::element_at(system, error.span);
    std::string what = missing_element(error);
    if (what.empty()) what = value_outside(error.what());
    return (what.empty() ? error.what() : what) + (element.empty() ? "" : ", in " + element) +
           open_constants(error, system);
}

std::string placed_failure(const cspm::EvaluationError& error, const ir::System& system,
                           const diagnostics::SourceManager& sources) {
    const std::string place = sources.path_and_line(error.span);
    return (place.empty() ? "" : diagnostics::escape_for_display(place) + ": ") + failure_text(error, system);
}

bool leaves_carriers(std::string_view message) {
    return message.find(outside) != std::string_view::npos ||
           message.find("more than 5000000") != std::string_view::npos;
}

}  // namespace robochart::runs
