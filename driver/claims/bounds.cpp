// SPDX-License-Identifier: Apache-2.0
// Each expression whose bound a run reaches is reported once, with the element that contains the expression.
#include "driver/claims/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <optional>

#include "base/diagnostics/text.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/expressions/clipping.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/component_processes.hpp"
#include "driver/settings/search_context.hpp"
#include "semantics/data/derived_values.hpp"
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

/// Returns the expression as written, on one line.
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
    // Calls without a source position and calls in CSP blocks are not expressions of the model.
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

/// Returns the processes to explore for a claim. If a CSP block defines the process of the claim, the whole process is
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

/// True if the expression reads the size of a sequence. Sizes have their own entries of the basis.
bool reads_size(const ir::Expr& expr) {
    return expr.text == "sequence_toolkit_size" || expr.text == "sequence_toolkit_isNonEmpty";
}

/// A condition or a time in a machine. `trigger` is the event whose received value the expression reads; it has no
/// value if the expression reads no received value.
struct ReadExpression {
    const ir::Expr* expr = nullptr;
    std::optional<ir::EventId> trigger;
};

/// What an expression reads.
struct Reading {
    bool numbers = false;   ///< it reads values that contain numbers
    bool computed = false;  ///< it computes values, or reads values that were computed
    bool outside = false;   ///< it reads values that come from outside the machine
    bool clocks = false;
    std::set<std::pair<ir::ExprKind, ir::VariableId>> places;
};

Reading reading_of(const ir::System& system, const ir::DerivedValues& derived, ir::MachineId id,
                   const ReadExpression& root) {
    const ir::Machine& machine = system.machine(id);
    Reading result;
    ir::visit_operands(*root.expr, [&](const ir::Expr& expr) {
        if (is_computation(expr) || (expr.kind == ir::ExprKind::toolkit && !reads_size(expr))) result.computed = true;
        if (expr.kind == ir::ExprKind::since || expr.kind == ir::ExprKind::since_entry) result.clocks = true;
        const bool variable = expr.kind == ir::ExprKind::variable;
        if (!variable && expr.kind != ir::ExprKind::trigger_value) return;
        ir::ValueSource source = ir::ValueSource::outside;
        if (variable)
            source = derived.of_variable(id, expr.variable);
        else if (root.trigger)
            source = derived.of_event(id, *root.trigger);
        const ir::TypeId type = variable ? machine.variables.at(expr.variable.index).type : expr.type;
        result.numbers = result.numbers || ir::has_numbers(system, type);
        result.computed = result.computed || source == ir::ValueSource::derived;
        result.outside = result.outside || source != ir::ValueSource::inside;
        result.places.emplace(expr.kind, expr.variable);
    });
    return result;
}

/// True if the condition depends on more than comparisons of one received value with literals and constants.
bool is_uncovered(const Reading& read) {
    return read.numbers && (read.computed || read.places.size() > 1 || (read.clocks && read.outside));
}

/// Collects the conditions of a machine (the operands of their connectives), the comparisons in its other expressions,
/// and its deadlines and waiting times.
class ExpressionsOfMachine {
public:
    explicit ExpressionsOfMachine(const ir::Machine& machine) {
        for (const auto* contract : {&machine.preconditions, &machine.postconditions})
            for (const ir::ExprPtr& condition : *contract) add(condition);
        for (const ir::Transition& transition : machine.transitions) {
            if (transition.trigger) trigger_ = transition.trigger->event;
            add(transition.guard);
            if (transition.trigger) add(transition.trigger->predicate);
            add_time(transition.deadline);
            trigger_.reset();
        }
        ir::visit_statements(machine, [&](const ir::Stmt& stmt) { add_statement(stmt); });
    }

    [[nodiscard]] const std::vector<ReadExpression>& conditions() const { return conditions_; }
    [[nodiscard]] const std::vector<ReadExpression>& times() const { return times_; }

private:
    void add_statement(const ir::Stmt& stmt) {
        add(stmt.condition);
        add_time(stmt.upper);
        if (stmt.kind == ir::StmtKind::assign)
            add_comparisons(stmt.value);
        else
            add_time(stmt.value);
        if (stmt.kind == ir::StmtKind::communicate) trigger_ = stmt.communication.event;
        add(stmt.communication.predicate);
        trigger_.reset();
        add_comparisons(stmt.communication.value);
        for (const ir::ExprPtr& argument : stmt.args) add_comparisons(argument);
    }
    void add(const ir::ExprPtr& condition) {
        if (!condition || !condition->span.is_known()) return;
        if (!ir::is_connective(condition->kind)) return conditions_.push_back({condition.get(), trigger_});
        for (const ir::ExprPtr& part : condition->args) add(part);
    }
    void add_comparisons(const ir::ExprPtr& value) {
        if (!value) return;
        ir::visit_operands(*value, [&](const ir::Expr& expr) {
            const bool compares = ir::is_comparison(expr.kind) || expr.kind == ir::ExprKind::is_in;
            if (compares && expr.span.is_known()) conditions_.push_back({&expr, std::nullopt});
        });
    }
    void add_time(const ir::ExprPtr& time) {
        if (time && time->span.is_known()) times_.push_back({time.get(), trigger_});
    }

    std::vector<ReadExpression> conditions_, times_;
    std::optional<ir::EventId> trigger_;
};

/// Returns an entry of the basis about these expressions. Its text contains the first expression, the number of further
/// expressions, the noun and the verb.
std::optional<Ground> ground_for(const Project& project, const std::vector<const ir::Expr*>& expressions,
                                 const char* noun, const char* verb) {
    std::vector<std::string> texts;
    for (const ir::Expr* expr : expressions) {
        const std::string text = expression_text(project.sources, expr->span);
        if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
    }
    if (texts.empty()) return std::nullopt;
    std::string more;
    if (texts.size() > 1) more = fmt::format(" and {} more {}{}", texts.size() - 1, noun, texts.size() == 2 ? "" : "s");
    Ground ground;
    ground.text =
        fmt::format("{}{} {}{} only the values of carriers", texts.front(), more, verb, texts.size() == 1 ? "s" : "");
    const std::string element = ir::element_at(project.system, expressions.front()->span);
    ground.element = project.label + (element.empty() ? "model" : element);
    ground.remedy = "--range gives types more values";
    set_place(project.sources, expressions.front()->span, ground);
    return ground;
}

}  // namespace

/// Returns up to two entries for each machine, or no entries if the user chose the carriers.
const std::vector<Ground>& ReachedBounds::comparisons() {
    if (comparisons_) return *comparisons_;
    comparisons_.emplace();
    if (chooses_ranges(project_)) return *comparisons_;
    const ir::DerivedValues derived(project_.system, project_.instantiation);
    for (std::uint32_t m = 0; m < project_.system.machines.size(); ++m) {
        const ExpressionsOfMachine machine(project_.system.machines[m]);
        const auto read = [&](const ReadExpression& expression) {
            return reading_of(project_.system, derived, ir::MachineId{m}, expression);
        };
        std::vector<const ir::Expr*> conditions, times;
        for (const ReadExpression& condition : machine.conditions())
            if (is_uncovered(read(condition))) conditions.push_back(condition.expr);
        for (const ReadExpression& time : machine.times())
            if (const Reading found = read(time); found.numbers && found.outside) times.push_back(time.expr);
        for (auto& ground :
             {ground_for(project_, conditions, "condition", "compare"), ground_for(project_, times, "time", "take")})
            if (ground) comparisons_->push_back(*ground);
    }
    return *comparisons_;
}

/// Returns the entries for the claim. An operation may run in every component, so its entries belong to all claims.
Basis ReachedBounds::comparisons_in(const csp_emit::Obligation& claim) {
    const auto in_operation = [&](const Ground& ground) {
        return std::ranges::any_of(project_.system.machines, [&](const ir::Machine& machine) {
            const std::string package = machine.package.empty() ? "" : machine.package + "::";
            return machine.kind == ir::MachineKind::operation &&
                   ground.element.starts_with(project_.label + package + machine.path + "::");
        });
    };
    Basis result;
    for (const cspm::ExprPtr& process : processes_of(claim))
        for (const Ground& ground : comparisons())
            if (is_part(ground.element, process) || in_operation(ground)) driver::add(result, ground);
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
