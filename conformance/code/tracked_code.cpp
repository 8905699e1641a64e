// SPDX-License-Identifier: Apache-2.0
#include "conformance/code/tracked_code.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "semantics/ir/number_parts.hpp"

namespace robochart::conformance {

bool TrackedCode::set_values(const ir::ValueModel& model) const {
    for (std::uint32_t t = 0; t < types_.size(); ++t) {
        const auto found = std::ranges::find(model.types, types_[t], &ir::ExploredValues::type);
        if (found == model.types.end()) return false;
        std::vector<std::int64_t> numbers;
        for (const std::vector<std::int64_t>& value : found->values)
            numbers.insert(numbers.end(), value.begin(), value.end());
        const auto count = static_cast<std::uint32_t>(found->values.size());
        if (code_.tracking->set_values(t, count, numbers.data()) == 0) return false;
    }
    return true;
}

std::vector<ir::Cut> TrackedCode::comparisons(std::int64_t scale) const {
    const rc_comparison* list = nullptr;
    const std::uint32_t count = code_.tracking->comparisons(&list);
    std::vector<ir::Cut> result;
    for (const rc_comparison& comparison : std::span(list, count)) {
        const ir::TypeId type = types_.at(comparison.type);
        const std::vector<ir::NumberPart> parts = ir::number_parts(system_, type);
        ir::Cut cut{type, {comparison.coefficient, comparison.coefficient + parts.size()}, comparison.constant};
        const auto first = std::ranges::find_if(cut.coefficients, [](std::int64_t number) { return number != 0; });
        const auto part = static_cast<std::size_t>(first - cut.coefficients.begin());
        if (parts.at(part).kind != ir::TypeKind::real) cut.constant *= scale;
        result.push_back(normalized(std::move(cut)));
    }
    std::ranges::sort(result);
    return result;
}

std::string TrackedCode::loss() const {
    const std::uint32_t losses = code_.tracking->losses();
    if ((losses & RC_TRACKED_INEXACT) != 0) return "the code computes with inputs";
    if ((losses & RC_TRACKED_RELATION) != 0) return "the code compares two inputs with each other";
    if ((losses & RC_TRACKED_OUTPUT) != 0) return "the code computes an output from an input";
    if ((losses & RC_TRACKED_NATIVE) != 0) return "an index, a duration or a loop of the code depends on an input";
    return "";
}

void list_tracked_values(Interface& interface, const rc_interface& code) {
    for (std::uint32_t i = 0; i < code.inputs && code.tracking != nullptr; ++i) {
        if (code.tracking->input[i] < 0) continue;
        Register& input = interface.inputs[i];
        input.texts = input.carrier.names;
        input.values.resize(input.texts.size());
        std::iota(input.values.begin(), input.values.end(), 0);
    }
}

}  // namespace robochart::conformance
