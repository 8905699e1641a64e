// SPDX-License-Identifier: Apache-2.0
#include "conformance/code/tracked_code.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>

#include "base/diagnostics/containers.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::conformance {

bool TrackedCode::set_values(const ir::ValueModel& model) const {
    for (std::uint32_t t = 0; t < types_.size(); ++t) {
        const auto found = std::ranges::find(model.types, types_[t], &ir::ExploredValues::type);
        if (found == model.types.end()) return false;
        std::vector<std::int64_t> numbers;
        for (const std::vector<std::int64_t>& value : found->values) {
            if (ir::is_number_sequence(system_, types_[t])) numbers.push_back(static_cast<std::int64_t>(value.size()));
            numbers.insert(numbers.end(), value.begin(), value.end());
        }
        const auto count = static_cast<std::uint32_t>(found->values.size());
        if (code_.tracking->set_values(t, count, numbers.data()) == 0) return false;
    }
    return true;
}

namespace {

/// Multiplies the constant by the scale. Then divides the form by the common divisor of its coefficients and the scale.
bool convert_constant(ir::Cut& cut, std::int64_t scale) {
    std::int64_t common = scale;
    for (const std::int64_t coefficient : cut.coefficients) common = std::gcd(common, coefficient);
    for (std::int64_t& coefficient : cut.coefficients) coefficient /= common;
    const auto constant = ir::checked_multiply(cut.constant, scale / common);
    if (constant) cut.constant = *constant;
    return constant.has_value();
}

/// Returns the number of a sequence that a comparison reads, or no value if it reads several.
std::optional<ir::Cut> sequence_cut(ir::TypeId type, const rc_comparison& comparison,
                                    std::span<const rc_window> windows) {
    std::optional<std::uint32_t> part;
    for (std::uint32_t p = 0; p < ROBOCHART_MAX_PARTS; ++p) {
        if (comparison.coefficient[p] == 0) continue;
        if (part) return std::nullopt;
        part = p;
    }
    if (!part) return std::nullopt;
    ir::Cut cut{type, {comparison.coefficient[*part]}, comparison.constant};
    for (const rc_window& window : windows) {
        if (window.type != comparison.type || window.part != *part) continue;
        cut.window = ir::SequenceWindow{{}, window.greatest != 0};
        for (std::int64_t bit = 0; bit < ROBOCHART_MAX_PLACES; ++bit)
            if ((window.places[bit / 64] >> (bit % 64) & 1U) != 0) cut.window->places.push_back(bit + 1);
    }
    return cut;
}

}  // namespace

std::optional<std::vector<ir::Cut>> TrackedCode::comparisons(std::int64_t scale) const {
    const rc_comparison* list = nullptr;
    const std::uint32_t count = code_.tracking->comparisons(&list);
    const rc_window* windows = nullptr;
    const std::uint32_t window_count = code_.tracking->windows(&windows);
    std::vector<ir::Cut> result;
    for (const rc_comparison& comparison : std::span(list, count)) {
        const ir::TypeId type = types_.at(comparison.type);
        if (ir::is_number_sequence(system_, type)) {
            auto cut = sequence_cut(type, comparison, std::span(windows, window_count));
            if (!cut) return std::nullopt;
            result.push_back(normalized(std::move(*cut)));
            continue;
        }
        const std::vector<ir::NumberPart> parts = ir::number_parts(system_, type);
        ir::Cut cut{type, {comparison.coefficient, comparison.coefficient + parts.size()}, comparison.constant};
        std::set<bool> real;  // for the parts that the form reads
        for (std::size_t part = 0; part < parts.size(); ++part)
            if (cut.coefficients[part] != 0) real.insert(parts[part].kind == ir::TypeKind::real);
        if (real.size() != 1 || (!real.contains(true) && !convert_constant(cut, scale))) return std::nullopt;
        result.push_back(normalized(std::move(cut)));
    }
    diagnostics::sort_unique(result);
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
