// SPDX-License-Identifier: Apache-2.0
// See process_encoding.hpp.
#include "prism/assertions/process/process_encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "prism/assertions/process/explored_process.hpp"
#include "prism/assertions/process/observers.hpp"
#include "prism/assertions/process/subgraph.hpp"
#include "prism/checks/check.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

std::string magnitude_digits(const boost::multiprecision::cpp_int& value) {
    std::string digits = value.str();
    return value < 0 ? digits.substr(1) : digits;
}

/// Returns a number as a RoboChart literal.
std::string literal_of(const ir::System& system, const ir::Constant& constant, const prism::Value& value) {
    const ir::Type& type = system.type(constant.type);
    if (type.kind == ir::TypeKind::boolean) return value.integer != 0 ? "true" : "false";
    if (type.kind == ir::TypeKind::enumeration) {
        if (value.integer < 0 || static_cast<std::size_t>(value.integer) >= type.labels.size())
            throw Wrong(fmt::format("{} is not a literal of {}", value.text(), type.name));
        return type.name + "::" + type.labels[static_cast<std::size_t>(value.integer)];
    }
    if (value.type != prism::Type::real) return value.text();
    // A number without a finite decimal expansion, such as a third, cannot be a literal.
    Rational rest = value.real.value();
    constexpr unsigned most_places = 18;
    for (unsigned places = 0; places <= most_places; ++places, rest *= 10)
        if (denominator(rest) == 1) {
            std::string digits = magnitude_digits(numerator(rest));
            if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
            if (places > 0) digits.insert(digits.size() - places, ".");
            return (rest < 0 ? "-" : "") + digits;
        }
    throw Wrong(fmt::format("the value {} of {} is not a decimal number", value.text(), constant.name));
}

prism::ExprPtr number_expression(const Rational& value) {
    const auto whole = [](const boost::multiprecision::cpp_int& part) {
        return prism::make_expr(prism::Op::real, {}, {}, magnitude_digits(part) + ".0");
    };
    const prism::ExprPtr fraction =
        prism::make_expr(prism::Op::divide, {}, {whole(numerator(value)), whole(denominator(value))});
    return value < 0 ? prism::make_expr(prism::Op::minus, {}, {fraction}) : fraction;
}

}  // namespace

/// The explored process for some values of the constants.
struct ProcessEncoding::Explored {
    std::string constants;  ///< the values, as text
    std::unique_ptr<ExploredProcess> process;
};

/// The answer to a question: the states of its model.
struct ProcessEncoding::Answered {
    std::optional<prism::CheckedModel> model;
    diagnostics::Diagnostics findings;
    std::unique_ptr<prism::StateSpace> space;
};

ProcessEncoding::ProcessEncoding(const ir::System& system, const ir::ComponentRef& subject,
                                 diagnostics::SourceManager& sources, ProcessOptions options)
    : system_(system),
      subject_(subject),
      sources_(sources),
      options_(std::move(options)),
      names_(std::make_unique<ProcessNames>(system, subject_)) {}

ProcessEncoding::~ProcessEncoding() = default;

Elements& ProcessEncoding::elements() {
    return *names_;
}

std::uint64_t ProcessEncoding::compared_state_count() const {
    return explored_ ? explored_->process->compared : 0;
}

prism::Constant ProcessEncoding::prism_constant(const std::string& path) {
    const ConstantHere found = names_->find_constant(path);
    const ir::Type& type = system_.type(found.seat->machine->constants[found.id.index].type);
    prism::Type constant_type = found.real ? prism::Type::real : prism::Type::integer;
    if (type.kind == ir::TypeKind::boolean) constant_type = prism::Type::boolean;
    return {constant_type, {path, {}}, nullptr};
}

const ProcessEncoding::Explored& ProcessEncoding::find_explored(const prism::Values& constants) {
    ir::GivenConstants chosen;
    std::string text;
    for (const auto& [path, value] : constants) {
        if (path.find("::") == std::string::npos) continue;  // a constant of an assertion file
        const ConstantHere found = names_->find_constant(path);
        const ir::Constant& declared = found.seat->machine->constants[found.id.index];
        const ir::ConstantSource source = ir::constant_source(system_, found.seat->module, found.seat->controller,
                                                              found.seat->part, *found.seat->machine, found.id);
        for (const ir::NamedConstant& constant : ir::named_constants(system_))
            if (constant.name == source.name) chosen[constant.path] = literal_of(system_, declared, value);
        text += fmt::format("{}={};", path, value.text());
    }
    for (const ObservedEvent& event : names_->observed())
        text += event.name() + (event.type.is_valid() ? ".val;" : ";");
    if (explored_ && explored_->constants == text) return *explored_;
    answered_.reset();
    explored_.reset();  // frees memory for the next process
    auto made = std::make_unique<Explored>();
    made->constants = text;
    diagnostics::Diagnostics findings;
    if (options_.budget != nullptr) findings.set_budget(options_.budget);
    ir::InstantiationOptions instantiation_options = options_.instantiation;
    instantiation_options.constants = ir::not_overridden(system_, options_.instantiation.constants, chosen);
    instantiation_options.constants.merge(chosen);
    ir::Instantiation instantiation = ir::instantiate_system(system_, instantiation_options, findings);
    if (!findings.ok()) throw Wrong(findings.first_error());
    made->process =
        explore_process(system_, subject_, std::move(instantiation), names_->observed(), sources_,
                        {options_.max_states, options_.compared_states, options_.budget, options_.on_session});
    explored_ = std::move(made);
    return *explored_;
}

namespace {

/// Makes one reward for each set of simultaneous events that contains the event of the item. `[]` applies to every step
/// except tock.
void add_items(const prism::RewardItem& item, const std::vector<EventSet>& happening,
               std::vector<prism::RewardItem>& items) {
    if (!item.transition || item.action.text == tock_action) return items.push_back(item);
    for (const EventSet events : happening) {
        bool earns = item.action.text.empty();
        for (std::size_t i = 0; i < most_observed && !earns; ++i)
            earns = (events >> i & 1U) != 0 && item.action.text == observed_action(EventSet{1} << i);
        if (!earns) continue;
        prism::RewardItem one = item;
        one.action.text = observed_action(events);
        items.push_back(std::move(one));
    }
}

}  // namespace

/// Declares what PRISM's language needs: names of observables, and rewards.
prism::ModelFile ProcessEncoding::model_declarations(const Explored& found, const Question& question,
                                                     const std::vector<EventSet>& happening) const {
    const Weights weights(system_, found.process->instantiation);
    prism::ModelFile file;
    file.kind = prism::ModelKind::mdp;
    file.kind_given = true;
    file.constants = question.model_constants;
    file.constants.push_back(
        {prism::Type::real, {ProcessNames::units, {}}, number_expression(found.process->instantiation.scale)});
    for (const ConstantHere& constant : names_->constants())
        file.constants.push_back(
            {prism::Type::real,
             {constant.name, {}},
             number_expression(weights.constant_value(*constant.seat->machine, constant.id, *constant.seat))});
    for (const Observable& observable : names_->observables())
        file.globals.push_back({{observable.name, {}},
                                observable.boolean ? prism::Type::boolean : prism::Type::integer,
                                nullptr,
                                nullptr,
                                nullptr});
    // PRISM requires a variable and a module.
    if (file.globals.empty()) file.globals.push_back({{"nothing__", {}}, prism::Type::boolean, {}, {}, {}});
    file.modules.push_back({{"process__", {}}, {}, {}, {}, {}});
    for (const prism::RewardStructure& structure : question.rewards) {
        file.rewards.push_back({structure.name, {}});
        for (const prism::RewardItem& item : structure.items) add_items(item, happening, file.rewards.back().items);
    }
    return file;
}

/// Returns the value of an observable in a state. Throws Wrong if it has none.
std::int32_t ProcessEncoding::value_in(const Explored& found, lts::StateIndex state,
                                       const Observable& observable) const {
    const std::vector<std::size_t>& parts =
        found.process->reader->parts_of_state(found.process->exploration->state(state));
    for (const std::size_t number : parts) {
        const Part& part = found.process->reader->part(number);
        if (observable.variable.empty()) {
            if (part.in_state(observable.component, observable.state)) return 1;
            continue;
        }
        const auto held = part.find_variable(observable.component, observable.variable);
        const auto value = held ? number_of(system_, found.process->instantiation, *held) : std::nullopt;
        if (!value) continue;
        if (*value < std::numeric_limits<std::int32_t>::min() || *value > std::numeric_limits<std::int32_t>::max())
            throw Wrong(fmt::format("a value of {} has more than 32 bits", observable.variable));
        return static_cast<std::int32_t>(*value);
    }
    if (observable.variable.empty() || observable.carried) return 0;
    throw Wrong(fmt::format("{} of {} has no value in the state {}", observable.variable, observable.component,
                            found.process->system->describe(found.process->exploration->state(state))));
}

DecisionProcess ProcessEncoding::make_decision_process(const Explored& found) const {
    diagnostics::Pollable& budget = diagnostics::or_unlimited(options_.budget);
    const auto under = [&](Scheduler scheduler) {
        return decision_process(*found.process->exploration, *found.process->reader,
                                {system_, found.process->instantiation, found.process->emission.provenance,
                                 found.process->session->event_table(), names_->seats(), names_->observed()},
                                scheduler, budget);
    };
    DecisionProcess result = under(options_.scheduler);
    const bool compared = found.process->exploration->size() <= options_.compared_states;
    if (compared && options_.scheduler == Scheduler::urgent && !is_subgraph(result, under(Scheduler::any), budget))
        throw std::logic_error(
            fmt::format("the urgent steps of {} are not among its steps", ir::qualified_name(subject_)));
    return result;
}

prism::GivenSpace ProcessEncoding::make_space(const Explored& found, DecisionProcess process) const {
    diagnostics::Pollable& budget = diagnostics::or_unlimited(options_.budget);
    prism::GivenSpace result{std::move(process.model), std::move(process.deadlocks), {}};
    for (const lts::StateIndex origin : process.origins) {
        budget.poll();
        for (const Observable& observable : names_->observables())
            result.values.push_back(value_in(found, origin, observable));
        if (names_->observables().empty()) result.values.push_back(0);
    }
    return result;
}

Unexplored ProcessEncoding::unexplored_model(const Question& /*question*/, const prism::Values& /*constants*/) {
    throw NotExpressed(
        "random paths of a decision process depend on who chooses: they are taken in RoboTool's encoding");
}

const prism::StateSpace& ProcessEncoding::explore_space(const Question& question, const prism::Values& constants) {
    if (!question.modules.empty())
        throw NotExpressed(
            "`with modules`: the modules of assertions run beside models of PRISM, in RoboTool's encoding");
    const Explored& found = find_explored(constants);
    auto made = std::make_unique<Answered>();
    DecisionProcess process = make_decision_process(found);
    made->model = prism::check_model(model_declarations(found, question, process.happening), made->findings);
    if (!made->model) throw Wrong(made->findings.first_error());
    prism::Values of_file;
    for (const auto& [name, value] : constants)
        if (name.find("::") == std::string::npos) of_file.emplace(name, value);
    made->space = std::make_unique<prism::StateSpace>(
        *made->model, of_file, make_space(found, std::move(process)),
        prism::ExploreOptions{options_.max_states, options_.exact, options_.budget}, made->findings);
    answered_ = std::move(made);
    return *answered_->space;
}

}  // namespace robochart::probability
