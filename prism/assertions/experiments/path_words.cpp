// SPDX-License-Identifier: Apache-2.0
// See path_words.hpp.
#include "prism/assertions/experiments/path_words.hpp"

#include <fmt/format.h>

namespace robochart::probability {
namespace {

std::string value_text(const Wording::Variable& variable, const prism::Layout::Field& field, std::int32_t value) {
    const auto named = variable.values.find(value);
    if (named != variable.values.end()) return named->second;
    if (field.type == prism::Type::boolean) return value != 0 ? "true" : "false";
    return fmt::format("{}", value);
}

/// Lists the variables whose values differ from `before`, or all variables if `before` is null.
std::string changes_text(const Unexplored& model, const std::vector<std::int32_t>* before,
                         const std::vector<std::int32_t>& after) {
    const auto& fields = model.instance.layout().fields();
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto known = model.wording.variables.find(fields[i].name);
        if (known == model.wording.variables.end() || (before != nullptr && (*before)[i] == after[i])) continue;
        text += (text.empty() ? "" : ", ") + known->second.begin + value_text(known->second, fields[i], after[i]);
    }
    return text;
}

std::string cause_text(const prism::RandomPath::Step& step, const Wording& wording) {
    if (const auto event = wording.actions.find(step.action); event != wording.actions.end()) return event->second;
    std::string text = step.action;
    for (const std::string& module : step.modules) {
        const auto machine = wording.modules.find(module);
        text += (text.empty() ? "" : ", ") + (machine == wording.modules.end() ? module : machine->second);
    }
    return text;
}

}  // namespace

Path in_words(const prism::RandomPath& path, const Unexplored& model) {
    Path result{changes_text(model, nullptr, path.initial), {}, path.deadlock};
    const std::vector<std::int32_t>* before = &path.initial;
    for (const prism::RandomPath::Step& step : path.steps) {
        result.steps.push_back({cause_text(step, model.wording), changes_text(model, before, step.values)});
        before = &step.values;
    }
    return result;
}

}  // namespace robochart::probability
