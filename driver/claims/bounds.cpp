// SPDX-License-Identifier: Apache-2.0
// Each expression whose bound a run reaches is reported once, with the element that contains the expression.
#include "driver/claims/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>

#include "base/diagnostics/text.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/expressions/clipping.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/component_processes.hpp"
#include "driver/settings/search_context.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/ir/element_at.hpp"
#include "semantics/ir/number_parts.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::driver {
namespace {

/// The number of states is limited, because the evaluation of a term takes much longer than a step of a compiled
/// machine.
constexpr std::size_t most_states = 20'000;

/// The functions that access the elements of a sequence.
constexpr std::array<const char*, 3> of_sequences{"sequence_toolkit_extract", "sequence_toolkit_size", "access_"};

/// The expression as written, on one line.
std::string expression_text(const diagnostics::SourceManager& sources, diagnostics::Span span) {
    return diagnostics::on_one_line(sources.source_text(span.source).substr(span.begin, span.end - span.begin));
}

bool is_inside(diagnostics::Span part, diagnostics::Span whole) {
    return part.source == whole.source && whole.begin <= part.begin && part.end <= whole.end;
}

std::string text_of(const ir::SequenceLimit& limit, const std::string& expression, std::int64_t longest) {
    const std::string sequences = fmt::format("sequences hold at most {} elements here", longest);
    if (limit.kind == ir::SequenceLimit::Kind::length)
        return fmt::format("{}, so `{}` has one answer for all of them", sequences, expression);
    if (limit.first > longest)
        return fmt::format("{}, so `{}` takes none, and a condition that needs one has no value", sequences,
                           expression);
    return fmt::format("{}, so `{}` takes none from place {} on", sequences, expression, longest + 1);
}

}  // namespace

BoundWatch::BoundWatch(const Project& project, const csp_emit::Emission& emission,
                       const ir::Instantiation& instantiation)
    : project_(project),
      emission_(emission),
      instantiation_(instantiation),
      sequence_limits_(ir::sequence_limits(project.system, instantiation)) {}

cspm::CallObserver BoundWatch::observer() {
    std::set<std::string> functions = emission_.bounded;
    if (!sequence_limits_.empty()) functions.insert(of_sequences.begin(), of_sequences.end());
    return {std::move(functions), [this](const cspm::ObservedCall& call) { note_call(call); }};
}

void BoundWatch::note_call(const cspm::ObservedCall& call) {
    // Calls without a place, and those in CSP blocks, are not expressions of the model.
    if (!call.span.is_known() || project_.sources.path(call.span.source).ends_with(".assertions")) return;
    if (std::ranges::find(of_sequences, call.function) != of_sequences.end()) {
        for (const ir::SequenceLimit& limit : sequence_limits_)
            if (is_inside(limit.span, call.span))
                add(limit.span,
                    text_of(limit, expression_text(project_.sources, limit.span), instantiation_.sequence_bound),
                    fmt::format("--range Seq=0..{} lets sequences hold more", limit.needed));
        return;
    }
    const auto text = csp_emit::reached_bound(emission_, instantiation_, call);
    if (!text) return;
    const std::uint64_t at = (static_cast<std::uint64_t>(call.span.source) << 32U) | call.span.begin;
    if (!known_.emplace(call.function, at).second) return;
    const bool chosen = text->find("has no body") != std::string::npos;
    add(call.span, fmt::format("in {}, {}", expression_text(project_.sources, call.span), *text),
        chosen ? "a csp block Instantiations defines functions" : "--range gives types more values");
}

void BoundWatch::add(diagnostics::Span span, std::string text, std::string remedy) {
    const std::string element = ir::element_at(project_.system, span);
    Ground ground;
    ground.text = std::move(text);
    ground.element = project_.label + (element.empty() ? "model" : element);
    ground.remedy = std::move(remedy);
    set_place(project_.sources, span, ground);
    if (std::ranges::find(met_, ground) == met_.end()) met_.push_back(std::move(ground));
}

// ---------------------------------------------------------------- bounds that runs reach

namespace {

using Processes = std::vector<cspm::ExprPtr>;

/// Collects the processes of components in an expression, in the variant that is not compressed.
void add_components(const cspm::ExprPtr& expr, Processes& found) {
    if (!expr) return;
    if (!component_of(*expr).empty()) {
        found.push_back(with_variant(expr, "D__"));
        return;
    }
    for (const cspm::ExprPtr& part : expr->args) add_components(part, found);
}

/// The processes to explore for a claim. If a CSP block defines the process of the claim, the whole process is
/// explored, because the block may restrict a component.
Processes processes_of(const csp_emit::Obligation& claim) {
    Processes sides;
    if (claim.firing) sides.push_back(claim.firing->process);
    if (claim.recurrence) sides.push_back(claim.recurrence->process);
    for (const cspm::DeclPtr& decl : claim.assertions) {
        sides.push_back(decl->assertion.specification);
        if (decl->assertion.kind == cspm::AssertionKind::refinement) sides.push_back(decl->assertion.implementation);
    }
    Processes result;
    for (const cspm::ExprPtr& side : sides) {
        Processes components;
        add_components(side, components);
        const bool of_block = claim.property == ir::no_id && claim.component.empty();
        if (of_block || components.empty()) components = {side};
        result.insert(result.end(), components.begin(), components.end());
    }
    return result;
}

}  // namespace

const ReachedBounds::Visited& ReachedBounds::visit_process(const cspm::ExprPtr& process) {
    const auto [at, added] = visited_.try_emplace(cspm::print(process));
    Visited& result = at->second;
    if (!added) return result;
    // A separate session is necessary, because a session caches values, and the observer does not see the evaluation of
    // cached values.
    cspm::Session session(emission_.script, &search_.services.budget());
    BoundWatch watch(project_, emission_, instantiation_);
    session.set_observer(watch.observer());
    try {
        std::deque<process::TermId> waiting{session.process(process)};
        std::set<process::TermId> seen{waiting.front()};
        for (std::size_t states = 0; !waiting.empty(); waiting.pop_front()) {
            if (++states > most_states) {
                result.all = false;
                break;
            }
            search_.services.budget().poll();
            for (const process::Transition& step : session.transitions(waiting.front()))
                if (seen.insert(step.target).second) waiting.push_back(step.target);
        }
    } catch (const cspm::EvaluationError&) {
        result.all = false;
    } catch (const process::SemanticsError&) {
        result.all = false;
    }
    result.reached = watch.met_bounds();
    return result;
}

/// True if the element belongs to a machine that runs in the component of this process; always true for other
/// processes.
bool ReachedBounds::is_part(const std::string& element, const cspm::ExprPtr& process) const {
    const std::string component = component_of(*process);
    if (component.empty()) return true;
    return std::ranges::any_of(emission_.provenance.definitions, [&](const auto& definition) {
        const csp_emit::DefinitionMeaning& meaning = definition.second;
        const bool runs_there = meaning.component == component || meaning.component.starts_with(component + "::");
        return runs_there && element.starts_with(project_.label + meaning.machine + "::");
    });
}

namespace {

bool is_computation(const ir::Expr& expr) {
    using enum ir::ExprKind;
    return expr.kind == plus || expr.kind == minus || expr.kind == times || expr.kind == divide ||
           expr.kind == modulus || expr.kind == negate || expr.kind == call || expr.kind == apply ||
           expr.kind == index || expr.kind == concat || ir::binds_names(expr.kind);
}

/// The size of a sequence, which other notes are about.
bool reads_size(const ir::Expr& expr) {
    return expr.text == "sequence_toolkit_size" || expr.text == "sequence_toolkit_isNonEmpty";
}

/// Whether the condition depends on more than comparisons of one value with literals and constants.
bool is_uncovered(const ir::System& system, const ir::Machine& machine, const ir::Expr& root) {
    std::set<std::pair<ir::ExprKind, ir::VariableId>> places;
    bool cut = false, computed = false;
    ir::visit_operands(root, [&](const ir::Expr& expr) {
        computed = computed || is_computation(expr) || (expr.kind == ir::ExprKind::toolkit && !reads_size(expr));
        const bool variable = expr.kind == ir::ExprKind::variable;
        if (!variable && expr.kind != ir::ExprKind::trigger_value) return;
        cut = cut || ir::has_numbers(system, variable ? machine.variables.at(expr.variable.index).type : expr.type);
        places.emplace(expr.kind, expr.variable);
    });
    return cut && (computed || places.size() > 1);
}

/// The conditions of a machine, without their connectives.
std::vector<ir::ExprPtr> conditions_of(const ir::Machine& machine) {
    std::vector<ir::ExprPtr> result;
    const std::function<void(const ir::ExprPtr&)> add = [&](const ir::ExprPtr& condition) {
        if (!condition || !condition->span.is_known()) return;
        if (ir::is_connective(condition->kind))
            std::ranges::for_each(condition->args, add);
        else
            result.push_back(condition);
    };
    for (const ir::Transition& transition : machine.transitions) {
        add(transition.guard);
        if (transition.trigger) add(transition.trigger->predicate);
    }
    ir::visit_statements(machine, [&](const ir::Stmt& stmt) {
        add(stmt.condition);
        add(stmt.communication.predicate);
    });
    return result;
}

}  // namespace

/// One entry for each machine. Empty if the user chose the carriers.
const std::vector<Ground>& ReachedBounds::comparisons() {
    if (comparisons_) return *comparisons_;
    comparisons_.emplace();
    if (chooses_ranges(project_)) return *comparisons_;
    for (const ir::Machine& machine : project_.system.machines) {
        std::vector<std::string> texts;
        std::optional<diagnostics::Span> first;
        for (const ir::ExprPtr& condition : conditions_of(machine)) {
            if (!is_uncovered(project_.system, machine, *condition)) continue;
            const std::string text = expression_text(project_.sources, condition->span);
            if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
            if (!first) first = condition->span;
        }
        if (!first) continue;
        std::string more;
        if (texts.size() > 1)
            more = fmt::format(" and {} more condition{}", texts.size() - 1, texts.size() == 2 ? "" : "s");
        Ground ground;
        ground.text = fmt::format("{}{} compare{} only the values of carriers", texts.front(), more,
                                  texts.size() == 1 ? "s" : "");
        const std::string element = ir::element_at(project_.system, *first);
        ground.element = project_.label + (element.empty() ? "model" : element);
        ground.remedy = "--range gives types more values";
        set_place(project_.sources, *first, ground);
        comparisons_->push_back(std::move(ground));
    }
    return *comparisons_;
}

Basis ReachedBounds::comparisons_in(const csp_emit::Obligation& claim) {
    Basis result;
    for (const cspm::ExprPtr& process : processes_of(claim))
        for (const Ground& ground : comparisons())
            if (is_part(ground.element, process)) driver::add(result, ground);
    return result;
}

Basis ReachedBounds::basis_of_claim(const csp_emit::Obligation& claim, const std::vector<Ground>& met) {
    Basis result;
    for (const cspm::ExprPtr& process : processes_of(claim))
        for (Ground& ground : basis_of_process(process, met)) add(result, std::move(ground));
    return result;
}

Basis ReachedBounds::basis_of_process(const cspm::ExprPtr& process, const std::vector<Ground>& met) {
    const Visited& found = visit_process(process);
    Basis result;
    for (const Ground& ground : found.reached) add(result, ground);
    if (found.all) return result;
    for (Ground ground : met) {
        const bool reached = std::ranges::any_of(found.reached, [&](const Ground& other) {
            return other.place == ground.place && other.element == ground.element && other.remedy == ground.remedy;
        });
        if (reached || !is_part(ground.element, process)) continue;
        ground.text += fmt::format(" (not in the first {} states, and it is not known whether later)", most_states);
        add(result, std::move(ground));
    }
    return result;
}

}  // namespace robochart::driver
