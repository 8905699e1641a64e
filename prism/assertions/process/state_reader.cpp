// SPDX-License-Identifier: Apache-2.0
// See state_reader.hpp.
#include "prism/assertions/process/state_reader.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "checker/process/term.hpp"
#include "counterexample/values.hpp"

namespace robochart::probability {

using csp_emit::ParameterKind;

bool Part::in_state(const std::string& machine, const std::string& element) const {
    return std::ranges::any_of(calls, [&](const runs::Call& call) {
        const auto& active = call.definition->active;
        return call.definition->component == machine &&
               std::ranges::any_of(active, [&](const ir::Origin& state) { return state.element == element; });
    });
}

std::optional<Held> Part::find_variable(const std::string& machine, const std::string& name) const {
    std::optional<Held> found;
    for (const runs::Call& call : calls)
        for (std::size_t i = 0; i < call.arguments.size() && i < call.definition->parameters.size(); ++i) {
            const ParameterKind kind = call.definition->kinds[i];
            const bool value = kind == ParameterKind::variable || kind == ParameterKind::constant;
            if (!value || call.definition->component != machine || call.definition->parameters[i] != name) continue;
            if (found && found->text != call.arguments[i]) return std::nullopt;
            found = Held{call.arguments[i], call.definition->types[i]};
        }
    return found;
}

StateReader::StateReader(const lts::TransitionSystem& system, runs::StepReader& reader)
    : compiled_(dynamic_cast<const machine::SupercombinatorSystem*>(&system)), reader_(reader) {
    if (compiled_ == nullptr && !system.states_are_terms())
        throw std::logic_error("states that are neither terms nor those of components");
}

namespace {

bool is_parallel(process::Op op) {
    return op == process::Op::parallel || op == process::Op::alphabetised;
}

/// True for operators whose operands (or at least the first one) contain the components of the process.
bool is_around(process::Op op) {
    return op == process::Op::hide || op == process::Op::rename || op == process::Op::prioritise ||
           op == process::Op::prioritise_order || op == process::Op::sequential || op == process::Op::exception ||
           op == process::Op::interrupt || op == process::Op::sliding || op == process::Op::chase || is_parallel(op);
}

}  // namespace

/// Collects the definitions that the term calls. Initially, a component is inside nested definitions without a meaning
/// in the model, which are unfolded.
void StateReader::collect_calls(process::TermId term, int levels, std::vector<runs::Call>& calls) {
    process::TermStore& terms = reader_.context().session.terms();
    const process::Op op = terms[term].op;
    const bool around = is_around(op);
    if (!around) {
        const std::vector<runs::Call>& known = reader_.calls_of(term);
        calls.insert(calls.end(), known.begin(), known.end());
        if (!known.empty() || op != process::Op::call) return;
    }
    if (levels == 0) return;
    if (!around) return collect_calls(terms.unfold_calls(term, 1), levels - 1, calls);
    const std::vector<process::TermId> operands = terms[term].children;  // a copy, because terms may be added
    for (std::size_t i = 0; i < (is_parallel(op) ? operands.size() : 1); ++i)
        collect_calls(operands[i], levels - 1, calls);
}

std::size_t StateReader::number_of(process::TermId term) {
    const auto [known, added] = numbers_.try_emplace(term, parts_.size());
    if (!added) return known->second;
    constexpr int most_levels = 60;
    Part part;
    collect_calls(term, most_levels, part.calls);
    parts_.push_back(std::move(part));
    return known->second;
}

const std::vector<std::size_t>& StateReader::parts_of_state(lts::StateView state) {
    found_.clear();
    if (compiled_ == nullptr) {
        found_.push_back(number_of(static_cast<process::TermId>(state[0])));
        return found_;
    }
    const machine::Supercombinator& combined = compiled_->combined();
    for (std::size_t slot = 0; slot < combined.components.size(); ++slot) {
        const machine::Field& field = combined.fields[slot];
        const machine::Local local = (state[field.word] >> field.shift) & field.mask;
        if (local < combined.components[slot]->size())
            found_.push_back(number_of(combined.components[slot]->term_of(local)));
    }
    return found_;
}

std::optional<std::int64_t> number_of(const ir::System& system, const ir::Instantiation& instantiation,
                                      const Held& held) {
    if (!held.type.is_valid()) return std::nullopt;
    const ir::Type& type = system.type(held.type);
    switch (type.kind) {
        case ir::TypeKind::boolean:
            if (held.text == "true") return 1;
            return held.text == "false" ? std::optional<std::int64_t>(0) : std::nullopt;
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real: {
            std::int64_t value = 0;
            const char* const end = held.text.data() + held.text.size();
            const auto [stopped, error] = std::from_chars(held.text.data(), end, value);
            if (error != std::errc{} || stopped != end) return std::nullopt;
            return value;
        }
        case ir::TypeKind::enumeration: {
            const std::string literal = runs::value_text(system, instantiation, held.type, held.text);
            const auto found = std::ranges::find(type.labels, literal);
            return found == type.labels.end() ? std::nullopt : std::optional<std::int64_t>(found - type.labels.begin());
        }
        // clang-format off
        case ir::TypeKind::string: case ir::TypeKind::given: case ir::TypeKind::sequence: case ir::TypeKind::set:
        case ir::TypeKind::product: case ir::TypeKind::record: case ir::TypeKind::function:
        case ir::TypeKind::relation: case ir::TypeKind::vector: case ir::TypeKind::matrix: case ir::TypeKind::unit:
            break;
    }
    // clang-format on
    return std::nullopt;
}

}  // namespace robochart::probability
