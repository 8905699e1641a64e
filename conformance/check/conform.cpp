// SPDX-License-Identifier: Apache-2.0
// Runs the whole check: emits the script of the model, generates code, compiles it to a shared object, and compares it
// with the script (docs/conformance.md).
#include "conformance/check/conform.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/process/term_system.hpp"
#include "conformance/check/code_certificate.hpp"
#include "conformance/check/conformance_check.hpp"
#include "conformance/check/cycle_claims.hpp"
#include "conformance/check/enough_names.hpp"
#include "conformance/check/export.hpp"
#include "conformance/check/open_choice.hpp"
#include "conformance/check/partial_readings.hpp"
#include "conformance/check/random_walk.hpp"
#include "conformance/check/robot_numbers.hpp"
#include "conformance/check/standstill.hpp"
#include "conformance/check/violated_precondition.hpp"
#include "conformance/code/shared_object.hpp"
#include "conformance/code/tracked_code.hpp"
#include "conformance/model/component.hpp"
#include "conformance/model/cyclic_model.hpp"
#include "conformance/model/model_interface.hpp"
#include "conformance/model/normal_form.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "conformance/model/provenance_text.hpp"
#include "conformance/model/representatives.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "cpp_emit/plan/exploration_ports.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "cpp_emit/plan/unsupported.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/number_parts.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::conformance {

namespace {

Result not_generated(std::string reason) {
    Result result;
    result.outcome = Outcome::not_generated;
    result.reason = std::move(reason);
    return result;
}

std::unique_ptr<SharedObject> build_code(const cpp_emit::Emission& emission, const Options& options,
                                         diagnostics::Budget& budget, std::string& error) {
    std::vector<std::string> sources = emission.sources;
    sources.push_back(emission.shim);
    const BuildOptions build_options{options.compiler, options.flags, options.work_dir, &budget, options.cache};
    return SharedObject::build(emission.files, sources, build_options, error);
}

/// Returns the definition of the normal form as text, for FDR and for readers. The check itself does not use the text.
std::string normal_form_text(const csp_emit::Emission& script, const cspm::ExprPtr& process, const Alphabet& alphabet,
                             std::uint32_t cycle_length) {
    const NormalFormScript form = normal_form(script.definitions, process, alphabet, cycle_length, Reading::any_order);
    return cspm::print(cspm::Script{form.decls});
}

/// Continues a search that ended at its limit by random walks. If the model was not compiled as a whole, the walks
/// follow its terms.
Result combine_with_walks(Result bounded, cspm::Session& session, lts::TransitionSystem* compiled,
                          const cspm::ExprPtr& process, const Interface& interface, const rc_interface& code,
                          const Options& options) {
    if (options.walks.cycles == 0) return bounded;
    process::OperationalSemantics semantics(session.terms());
    process::TermSystem terms(semantics, session.process(process));
    const Alphabet alphabet(interface, session.event_table());
    lts::TransitionSystem& model = compiled == nullptr ? terms : *compiled;
    Result result = run_random_walks(model, alphabet, code, options.cycle_length, options.limits, options.walks);
    std::string before = bounded.reason;
    if (bounded.product.depth > 0)
        before +=
            fmt::format("; no difference in {} states, {} events deep", bounded.product.states, bounded.product.depth);
    if (result.outcome == Outcome::inconclusive) result.reason = fmt::format("{}; {}", before, result.reason);
    result.schedulability = bounded.schedulability;
    result.register_cycles = std::move(bounded.register_cycles);
    result.deadlines = std::move(bounded.deadlines);
    result.product = bounded.product;
    return result;
}

/// Returns the limits for the search. If walks may follow, the search gets three quarters of the remaining time.
refine::Limits limits_of_search(const Options& options) {
    refine::Limits limits = options.limits;
    const auto now = std::chrono::steady_clock::now();
    if (options.walks.cycles > 0 && limits.deadline && *limits.deadline > now)
        limits.deadline = now + (*limits.deadline - now) * 3 / 4;
    return limits;
}

/// Used if the registers have too many valuations to try all of them in every state: tries only those readings on which
/// the code or the model depends.
void try_partial_readings(Result& result, lts::TransitionSystem& model, cspm::Session& session,
                          const Interface& interface, const rc_interface& code, const Options& options,
                          const EventPlaces& places) {
    const Alphabet alphabet(interface, session.event_table());
    ModelGraph graph(model, alphabet);
    Result partial = judge_partially(graph, alphabet, code, options.cycle_length, limits_of_search(options), places);
    if (partial.outcome == Outcome::inconclusive) return;
    partial.schedulability = result.schedulability;
    partial.register_cycles = std::move(result.register_cycles);
    if (result.deadlines) partial.deadlines = std::move(result.deadlines);
    result = std::move(partial);
}

/// Returns the text of an evaluation error.
using FailureText = std::function<std::string(const cspm::EvaluationError&)>;

/// Checks a process. If a value of the model leaves its carrier, the search is impossible. Random walks then follow the
/// model; each of them ends where a value leaves its carrier.
Result check_process(cspm::Session& session, const cspm::ExprPtr& process, const Interface& interface,
                     const rc_interface& code, const Options& options, const EventPlaces& places,
                     const FailureText& failure_text) {
    std::unique_ptr<lts::TransitionSystem> model;
    Result result;
    try {
        const refine::Limits limits = limits_of_search(options);
        model = session.system(process, limits);
        result = judge_component(*model, session.event_table(), interface, code, options.cycle_length, limits,
                                 options.relation, places,
                                 interface.drops.empty() ? options.inputs : InputSearch::all_inputs);
    } catch (const process::Interrupted& limit) {
        result.reason = fmt::format("the model was not compiled: {}", limit.what());
    } catch (const cspm::EvaluationError& error) {
        if (!runs::leaves_carriers(error.what())) throw;
        model.reset();
        result = {};
        result.reason = failure_text(error);
    }
    const bool interrupted = options.limits.interrupted && options.limits.interrupted();
    // The other searches do not support dropped inputs.
    if (result.outcome != Outcome::inconclusive || interrupted || !interface.drops.empty()) return result;
    if (interface.robosim) {
        if (options.walks.cycles > 0) result.reason += "; no random walks follow, because the component is in RoboSim";
        return result;
    }
    if (model && options.relation == Relation::failures_divergences && options.inputs != InputSearch::on_demand)
        try_partial_readings(result, *model, session, interface, code, options, places);
    if (result.outcome != Outcome::inconclusive) return result;
    return combine_with_walks(std::move(result), session, model.get(), process, interface, code, options);
}

/// If a limit ended the check, reports which inputs have so many values that they cause the many cycles.
void report_large_inputs(Result& result, const Interface& interface) {
    constexpr double many = 100;
    constexpr std::size_t most = 3;
    if (result.outcome != Outcome::inconclusive) return;
    double valuations = 1;
    std::vector<const Register*> inputs;
    for (const Register& input : interface.inputs) {
        valuations *= input.reading_count();
        inputs.push_back(&input);
    }
    if (valuations < many) return;
    std::ranges::stable_sort(
        inputs, [](const Register* one, const Register* other) { return one->values.size() > other->values.size(); });
    if (inputs.size() > most) inputs.resize(most);
    std::vector<std::string> parts;
    for (const Register* input : inputs)
        if (input->values.size() > 1)
            parts.push_back(
                fmt::format("{} has {} values", input->name.substr(0, input->name.find('.')), input->values.size()));
    result.reason += fmt::format("; every state of the code has {:.4g} inputs{}{}", valuations,
                                 parts.empty() ? "" : ": ", fmt::join(parts, ", "));
    if (!parts.empty()) result.reason += "; --range makes carriers smaller";
}

/// Replaces definitions of the script by elements of the model, after ", at " in the reason and at the end of each
/// cycle. Removes definitions to which no element of the model corresponds.
void name_model_places(std::string& reason, std::vector<Cycle>& cycles, const csp_emit::Provenance& provenance,
                       const diagnostics::SourceManager& sources) {
    const auto in_words = [&](const std::string& state) {
        return fmt::format("{}", fmt::join(elements_of_state(state, provenance, sources), "; "));
    };
    constexpr std::string_view mark = ", at ";
    if (const std::size_t at = reason.find(mark); at != std::string::npos) {
        const std::string place = in_words(reason.substr(at + mark.size()));
        reason = reason.substr(0, at) + (place.empty() ? "" : ", " + place);
    }
    for (Cycle& cycle : cycles) cycle.state = in_words(cycle.state);
}

/// Does the same in the parts of a result that concern the model, not the code.
void name_model_places(Result& result, const csp_emit::Provenance& provenance,
                       const diagnostics::SourceManager& sources) {
    for (std::optional<Aside>* const aside : {&result.register_cycles, &result.deadlines})
        if (*aside) name_model_places((*aside)->reason, (*aside)->cycles, provenance, sources);
    if (result.outcome == Outcome::not_schedulable)
        name_model_places(result.reason, result.cycles, provenance, sources);
}

/// For each output and each of its arguments: whether the explored values represent all values. Empty if they do so for
/// no argument.
using Represented = std::vector<std::vector<bool>>;

/// Decides the claims about cycles, if the model can be run in cycles.
void add_cycle_claims(Result& result, cspm::Session& session, const cspm::ExprPtr& process, const Alphabet& alphabet,
                      const rc_interface& code, const ClaimedModel& claimed, const Represented& represented,
                      const Options& options) {
    const bool schedulable = result.outcome == Outcome::conforms || result.outcome == Outcome::differs;
    if (options.claims == nullptr || options.claims->claims.empty() || !schedulable) return;
    CycleClaims claims = *options.claims;
    claims.carriers = claims.carriers && represented.empty();
    try {
        // Claims read the states of the model. A compiled process does not distinguish all of them.
        process::OperationalSemantics semantics(session.terms());
        process::TermSystem terms(semantics, session.process(process));
        ModelGraph graph(terms, alphabet);
        result.claims =
            decide_cycle_claims(claims, claimed, graph, alphabet, code, options.cycle_length, options.limits);
    } catch (const process::Interrupted& limit) {
        result.warnings.push_back(fmt::format("claims about cycles are not decided: {}", limit.what()));
    }
}

/// Makes the result inconclusive if the model chooses between several values: a few explored values then do not
/// represent all values.
void refuse_choices(Result& result, cspm::Session& session, const cspm::ExprPtr& process, const Alphabet& alphabet,
                    const Represented& represented, const Options& options) {
    if (represented.empty() || result.outcome != Outcome::conforms) return;
    std::string reason;
    try {
        const auto model = session.system(process, options.limits);
        ModelGraph graph(*model, alphabet);
        NormalFormSystem normal_form(graph, alphabet, options.cycle_length);
        const auto found = open_choice(normal_form, alphabet, represented, options.limits);
        if (!found) return;
        reason = reason_of(*found);
    } catch (const process::Interrupted& limit) {
        reason = fmt::format("it was not decided whether few values represent all values: {}", limit.what());
    }
    result.outcome = Outcome::inconclusive;
    result.reason = std::move(reason);
}

Interface interface_of_model(const ir::System& system, const ir::Instantiation& instantiation,
                             const ir::ComponentRef& component, const csp_emit::Provenance& provenance,
                             const rc_interface& code) {
    Interface interface = interface_of(code);
    complete_interface(interface, system, instantiation, component, provenance);
    list_tracked_values(interface, code);
    return interface;
}

/// Checks code against a script. `sources` contains the texts of the model. Without it (null), outcomes that the model
/// causes are not explained in terms of the model.
Result judge_script(const csp_emit::Emission& script, const ir::System& system, const ir::Instantiation& instantiation,
                    const ir::ComponentRef& component, const rc_interface& code, const Represented& represented,
                    const Options& options, const diagnostics::SourceManager* sources, const EventPlaces& places) {
    const cspm::ExprPtr process = component_process(script.definitions, component);
    if (!process) return not_generated(fmt::format("{} has no timed CSP semantics here", component.path));
    Interface interface = interface_of_model(system, instantiation, component, script.provenance, code);
    interface.drops = dropped_inputs(interface, options.generator.order);
    const FailureText failure_text = [&](const cspm::EvaluationError& error) {
        return sources == nullptr ? runs::failure_text(error, system) : runs::placed_failure(error, system, *sources);
    };
    try {
        cspm::Session session(script.definitions);
        Result result = check_process(session, process, interface, code, options, places, failure_text);
        const Alphabet alphabet(interface, session.event_table());
        if (interface.robosim) {
            add_cycle_claims(result, session, process, alphabet, code, {system, script.provenance}, {}, options);
            if (options.exported != Export::none) export_code(result, {script, process, code, alphabet}, options);
            if (sources != nullptr) name_model_places(result, script.provenance, *sources);
            report_large_inputs(result, interface);
            return result;
        }
        refuse_choices(result, session, process, alphabet, represented, options);
        add_cycle_claims(result, session, process, alphabet, code, {system, script.provenance}, represented, options);
        if (sources != nullptr) {
            name_model_places(result, script.provenance, *sources);
            explain_result(result, session, process, alphabet, {script.provenance, system, instantiation, *sources},
                           options);
            if (result.reason.find(outside_precondition) != std::string::npos) {
                cpp_emit::Options generator = options.generator;
                generator.cycle_length = options.cycle_length;
                name_precondition(result, cpp_emit::violation_places(system, instantiation, component, generator),
                                  blocked_calls(result, session, process, alphabet, script.provenance, options),
                                  *sources);
            }
        }
        report_large_inputs(result, interface);
        result.normal_form = normal_form_text(script, process, alphabet, options.cycle_length);
        if (options.exported != Export::none) export_code(result, {script, process, code, alphabet}, options);
        return result;
    } catch (const AlphabetError& mismatch) {
        Result result;
        result.outcome = Outcome::differs;
        result.reason = mismatch.what();
        return result;
    } catch (const cspm::EvaluationError& failed) {
        Result result;
        result.outcome = Outcome::error;
        result.reason = failure_text(failed);
        return result;
    }
}

cpp_emit::Options generator_options(const TimedModel& timed, const Options& options) {
    cpp_emit::Options generator = options.generator;
    generator.cycle_length = options.cycle_length;
    generator.sources = timed.sources;
    return generator;
}

/// Returns why the values of the component are too many to explore, if this is the only obstacle. The generator reports
/// its other limits itself.
std::optional<std::string> reason_not_explored(const ir::System& system, const ir::Instantiation& instantiation,
                                               const ir::ComponentRef& component) {
    diagnostics::Diagnostics apart;  // discarded, because the generator reports the same findings
    const auto resolved = cpp_emit::resolve_component(system, instantiation, component, apart);
    if (!resolved || !cpp_emit::check_support(system, instantiation, *resolved, apart)) return std::nullopt;
    const auto beyond = cpp_emit::beyond_exploration(system, instantiation, *resolved);
    if (beyond.empty()) return std::nullopt;
    return fmt::format("{}: {}", beyond.front().name, beyond.front().limit);
}

/// Generates and compiles code for an instantiation. Compares it with the script of the same instantiation.
Result judge_values(const TimedModel& timed, const ir::ComponentRef& component, const ir::Instantiation& instantiation,
                    const csp_emit::Emission& script, const Options& options, diagnostics::Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.error_count();
    const ir::System& system = timed.model.system;
    if (auto reason = reason_not_explored(system, instantiation, component)) {
        Result result;
        result.reason = std::move(*reason);
        return result;
    }
    const cpp_emit::Emission code =
        cpp_emit::emit(system, instantiation, component, generator_options(timed, options), diagnostics);
    if (diagnostics.error_count() != errors || code.shim.empty())
        return not_generated(fmt::format("no C++ is generated for {}", component.path));

    std::string error;
    diagnostics::Budget own(options.limits);
    diagnostics::Budget& budget = diagnostics.budget() != nullptr ? *diagnostics.budget() : own;
    std::unique_ptr<SharedObject> object;
    try {
        const diagnostics::Budget::Phase phase(budget, "compiling the generated code");
        object = build_code(code, options, budget, error);
    } catch (const diagnostics::LimitReached& limit) {
        Result result;
        result.reason = limit.what();
        return result;
    } catch (const cpp_emit::NoCompiler& missing) {
        Result result;
        result.reason = fmt::format("conformance was not checked: {}", missing.what());
        return result;
    }
    if (!object) return not_generated(std::move(error));
    Result result = judge_script(script, system, instantiation, component, object->interface(), {}, options,
                                 timed.sources, code.event_places);
    if (options.certified.empty() || result.outcome != Outcome::conforms) return result;
    Interface interface = interface_of_model(system, instantiation, component, script.provenance, object->interface());
    interface.drops = dropped_inputs(interface, options.generator.order);
    certify_code(result,
                 {script, component_process(script.definitions, component), interface, object->interface(), code},
                 options);
    return result;
}

/// Checks a component with only a few values of some types. These may represent all values of the types.
Result judge_few_values(const TimedModel& timed, const ir::ComponentRef& component, const Representatives& few,
                        const Options& options, diagnostics::Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.error_count();
    const csp_emit::Emission script =
        csp_emit::emit(timed.model.system, few.instantiation, csp_emit::Time::timed, {}, *timed.sources, diagnostics);
    if (diagnostics.error_count() != errors)
        return not_generated(fmt::format("{} has no timed CSP semantics here", component.path));
    Options with_few = options;
    if (options.claims != nullptr) {
        CycleClaims claims = *options.claims;
        claims.carriers = false;
        with_few.claims = std::make_shared<const CycleClaims>(std::move(claims));
    }
    Result result = judge_values(timed, component, few.instantiation, script, with_few, diagnostics);
    result.lists_of_any_length = few.lists_of_any_length;
    for (const RepresentedType& type : few.types) result.represented.push_back({type.name, type.values});
    return result;
}

/// Checks the component with enough names to represent all values. If it is quickly known how many are enough, code is
/// compiled and explored only once. Otherwise the check first uses the least number of names, because any difference
/// that it finds is real.
Result judge_names(const TimedModel& timed, const ir::ComponentRef& component, const cpp_emit::Component& resolved,
                   const Options& options, diagnostics::Diagnostics& diagnostics) {
    constexpr std::chrono::seconds quickly{1};
    const RenamedSystem& model = timed.model;
    const auto judge = [&](std::size_t names, diagnostics::Diagnostics& findings) {
        const Representatives few =
            choose_representatives(model.system, model.instantiation, resolved, names, model.list_bounds);
        return judge_few_values(timed, component, few, options, findings);
    };
    Options quick = options;
    const auto end = std::chrono::steady_clock::now() + quickly;
    quick.limits.deadline = std::min(options.limits.deadline.value_or(end), end);
    EnoughNames enough = enough_names(model, component, resolved, quick, *timed.sources);
    if (enough.names) return judge(*enough.names, diagnostics);
    Result least = judge(least_names, diagnostics);
    if (least.outcome != Outcome::conforms) return least;
    if (std::chrono::steady_clock::now() >= end)
        enough = enough_names(model, component, resolved, options, *timed.sources);
    if (enough.names == least_names) return least;
    if (!enough.names) {
        least.outcome = Outcome::inconclusive;
        least.reason = enough.reason;
        return least;
    }
    diagnostics::Diagnostics apart;  // discarded, because the first check has reported the same findings
    return judge(*enough.names, apart);
}

/// The component with its types of numbers, and the model over the values that represent all numbers.
struct ValueSearch {
    cpp_emit::Component component;
    std::vector<ir::MachineId> machines;
    std::vector<ir::TypeId> types;
    ir::ValueModel model;
};

/// Returns no value if the component has data that need carriers, or if its inputs and outputs contain no numbers.
std::optional<ValueSearch> value_search(const RenamedSystem& model, const ir::ComponentRef& component) {
    diagnostics::Diagnostics apart;  // discarded, because the emitter reports the same findings
    auto resolved = cpp_emit::resolve_component(model.system, model.instantiation, component, apart);
    if (!resolved) return std::nullopt;
    std::vector<ir::TypeId> types = cpp_emit::tracked_types(model.system, *resolved);
    if (types.empty()) return std::nullopt;
    const auto is_sequence = [&](ir::TypeId type) { return ir::is_number_sequence(model.system, type); };
    for (const cpp_emit::Output& output : cpp_emit::exploration_outputs(*resolved))
        if (std::ranges::any_of(output.types, is_sequence)) return std::nullopt;
    std::vector<ir::MachineId> machines;
    for (const cpp_emit::Unit& unit : resolved->units) machines.push_back(unit.id);
    auto values = ir::value_model(model.system, model.instantiation, machines, {});
    if (!values) return std::nullopt;
    return ValueSearch{std::move(*resolved), std::move(machines), std::move(types), std::move(*values)};
}

/// Returns why value_search has no value for a component, that is, which data need carriers. Returns "" if inputs and
/// outputs contain no numbers.
std::string reason_for_carriers(const RenamedSystem& model, const ir::ComponentRef& component) {
    diagnostics::Diagnostics apart;  // discarded, because the emitter reports the same findings
    const auto resolved = cpp_emit::resolve_component(model.system, model.instantiation, component, apart);
    if (!resolved) return "";
    const auto has_numbers = [&](ir::TypeId type) { return ir::has_numbers(model.system, type); };
    bool numbers = false;
    for (const cpp_emit::Register& input : cpp_emit::exploration_registers(*resolved))
        numbers = numbers || (input.type && has_numbers(*input.type));
    for (const cpp_emit::Output& output : cpp_emit::exploration_outputs(*resolved))
        numbers = numbers || std::ranges::any_of(output.types, has_numbers);
    return numbers ? "the model does not only copy its numbers and compare them with constants" : "";
}

/// Returns, for each output and argument, the index of its tracked type.
OutputTypes tracked_output_types(const ValueSearch& search) {
    OutputTypes result;
    for (const cpp_emit::Output& output : cpp_emit::exploration_outputs(search.component)) {
        auto& arguments = result.emplace_back();
        for (const ir::TypeId type : output.types) {
            const auto found = std::ranges::find(search.types, type);
            arguments.emplace_back();
            if (found != search.types.end())
                arguments.back() = static_cast<std::uint32_t>(found - search.types.begin());
        }
    }
    return result;
}

/// Returns, for each output, the arguments of tracked types. Empty if there are no such arguments.
Represented tracked_arguments(const OutputTypes& types) {
    Represented result;
    bool found = false;
    for (const auto& arguments : types) {
        std::vector<bool>& tracked = result.emplace_back();
        for (const auto& type : arguments) tracked.push_back(type.has_value());
        found = found || std::ranges::find(tracked, true) != tracked.end();
    }
    return found ? result : Represented();
}

/// Returns comparisons of the code that are not yet cuts of the model. Returns no value if a comparison cannot be
/// written as a linear form of whole numbers or of reals.
std::optional<std::vector<ir::Cut>> undivided_cuts(const TrackedCode& code, const ir::ValueModel& model) {
    const auto cuts = code.comparisons(model.scale);
    if (!cuts) return std::nullopt;
    std::vector<ir::Cut> result;
    std::ranges::set_difference(*cuts, model.cuts, std::back_inserter(result));
    return result;
}

/// Returns the options of the search for all values. If it does not decide, a search in the carriers follows; so it
/// makes no random walks and uses only half of the remaining time.
Options options_for_all_values(const Options& options) {
    Options result = options;
    result.walks.cycles = 0;
    const auto now = std::chrono::steady_clock::now();
    auto& deadline = result.limits.deadline;
    if (deadline && *deadline > now) deadline = now + (*deadline - now) / 2;
    return result;
}

/// Returns the normal form of the model itself, for readers; "" if its carriers are too large.
std::string concrete_normal_form(const TimedModel& timed, const ir::ComponentRef& component, const Options& options) {
    if (reason_not_explored(timed.model.system, timed.model.instantiation, component)) return "";
    diagnostics::Diagnostics apart;
    try {
        auto model =
            model_interface(timed.model.system, timed.model.instantiation, component, timed.script.provenance, apart);
        if (!model) return "";
        model->interface.drops = dropped_inputs(model->interface, options.generator.order);
        cspm::Session session(timed.script.definitions);
        const Alphabet alphabet(model->interface, session.event_table());
        return normal_form_text(timed.script, component_process(timed.script.definitions, component), alphabet,
                                options.cycle_length);
    } catch (const std::length_error&) {
        return "";
    }
}

/// Repeats the check with the new comparisons of the code as further cuts, until there are no new ones.
ForAllValues divide_until_decided(const TimedModel& timed, const ir::ComponentRef& component, ValueSearch search,
                                  const rc_interface& code, const Options& options, const EventPlaces& places) {
    constexpr int most_rounds = 8;
    if (code.tracking->types != search.types.size()) return {};  // lists of one type have several capacities
    const TrackedCode tracked(code, timed.model.system, search.types);
    const OutputTypes output_types = tracked_output_types(search);
    std::vector<ir::Cut> cuts;
    for (int round = 0; round < most_rounds; ++round) {
        const ir::ValueModel& model = search.model;
        diagnostics::Diagnostics apart;
        const csp_emit::Emission script =
            csp_emit::emit(model.system, timed.model.instantiation, csp_emit::Time::timed, {}, *timed.sources, apart);
        if (!apart.ok() || !tracked.set_values(model)) return {};
        Result result =
            judge_script(script, model.system, timed.model.instantiation, component, code,
                         tracked_arguments(output_types), options_for_all_values(options), timed.sources, places);
        if (tracked.is_inexact()) return {std::nullopt, tracked.loss(), true};
        const auto more = undivided_cuts(tracked, model);
        if (!more) return {std::nullopt, "a comparison of the code has numbers that are too large", true};
        const bool tests_values = !tracked.loss().empty() || !more->empty();
        if (result.outcome == Outcome::error || result.outcome == Outcome::inconclusive)
            return {std::nullopt, result.reason, tests_values};
        const bool decided = result.outcome != Outcome::conforms || !tests_values;
        if (!decided && !tracked.loss().empty()) return {std::nullopt, tracked.loss(), true};
        if (decided) {
            result.normal_form = concrete_normal_form(timed, component, options);
            result.all_values = model.data;
            result.lists_of_any_length = true;
            if (result.outcome == Outcome::conforms) {
                const Interface interface =
                    interface_of_model(model.system, timed.model.instantiation, component, script.provenance, code);
                diagnostics::Budget budget(options.limits);
                test_on_robot(result,
                              {timed.model.system, model, code, search.types, output_types, interface, *timed.sources},
                              options.rounding_allowed, budget);
            }
            return {std::move(result), "", false};
        }
        cuts.insert(cuts.end(), more->begin(), more->end());
        auto finer = ir::value_model(timed.model.system, timed.model.instantiation, search.machines, cuts);
        if (!finer) return {std::nullopt, "the code makes too many comparisons", true};
        search.model = std::move(*finer);
    }
    return {std::nullopt, "the code makes too many comparisons", true};
}

}  // namespace

ForAllValues judge_for_all_values(const TimedModel& timed, const ir::ComponentRef& component, const rc_interface& code,
                                  const Options& options, const EventPlaces& places) {
    auto search = value_search(timed.model, component);
    if (!search) return {};
    return divide_until_decided(timed, component, std::move(*search), code, options, places);
}

Result judge_code(const csp_emit::Emission& script, const ir::System& system, const ir::Instantiation& instantiation,
                  const ir::ComponentRef& component, const rc_interface& code, const Options& options) {
    return judge_script(script, system, instantiation, component, code, {}, options, nullptr, {});
}

TimedModel timed_model(const ir::System& system, const ir::Instantiation& instantiation,
                       diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.error_count();
    TimedModel timed{renamed_system(system, instantiation, diagnostics), {}, &sources};
    timed.script =
        csp_emit::emit(timed.model.system, timed.model.instantiation, csp_emit::Time::timed, {}, sources, diagnostics);
    timed.sound = diagnostics.error_count() == errors;
    return timed;
}

namespace {

/// Returns the length of the longest explored sequence, plus one.
std::size_t longest_sequence(const ir::System& system, const ir::ValueModel& model) {
    std::size_t longest = 0;
    for (const ir::ExploredValues& type : model.types) {
        if (!ir::is_number_sequence(system, type.type)) continue;
        for (const auto& value : type.values) longest = std::max(longest, value.size() + 1);
    }
    return longest;
}

/// If the component only copies and compares its data, generates and compiles code with tracked numbers.
ForAllValues conform_for_all_values(const TimedModel& timed, const ir::ComponentRef& component, const Options& options,
                                    diagnostics::Diagnostics& diagnostics) {
    const bool plain = options.relation == Relation::failures_divergences && options.exported == Export::none &&
                       !options.generator.choices;
    if (options.numbers != Numbers::all || !plain) return {};
    const RenamedSystem& model = timed.model;
    diagnostics::Diagnostics findings;
    std::string error;
    diagnostics::Budget own(options.limits);
    diagnostics::Budget& budget = diagnostics.budget() != nullptr ? *diagnostics.budget() : own;
    try {
        auto search = value_search(model, component);
        if (!search) return {std::nullopt, reason_for_carriers(model, component), false};
        cpp_emit::Options generator = generator_options(timed, options);
        generator.tracked_scale = search->model.scale;
        generator.tracked_length = longest_sequence(model.system, search->model);
        const cpp_emit::Emission code =
            cpp_emit::emit(model.system, model.instantiation, component, generator, findings);
        if (!findings.ok() || code.shim.empty()) return {};
        const diagnostics::Budget::Phase phase(budget, "compiling the generated code");
        const auto object = build_code(code, options, budget, error);
        if (!object) return {};
        ForAllValues found =
            divide_until_decided(timed, component, std::move(*search), object->interface(), options, code.event_places);
        if (found.result) diagnostics.add(findings);
        return found;
    } catch (const diagnostics::LimitReached&) {
        return {};
    } catch (const cpp_emit::NoCompiler&) {
        return {};
    }
}

/// Returns the model with separate carriers for the lists that machines build. Returns no value if machines build no
/// lists.
std::optional<TimedModel> with_longer_lists(const TimedModel& timed) {
    TimedModel result{timed.model, {}, timed.sources, timed.sound};
    RenamedSystem& model = result.model;
    model.list_bounds = separate_longer_lists(model.system, model.instantiation);
    if (model.list_bounds.empty()) return std::nullopt;
    extend_carriers(model.instantiation, model.system, model.list_bounds, cpp_emit::max_input_values);
    diagnostics::Diagnostics apart;  // discarded, because the emission of the model has reported the same findings
    result.script = csp_emit::emit(model.system, model.instantiation, csp_emit::Time::timed, {}, *timed.sources, apart);
    if (!apart.ok()) return std::nullopt;
    return result;
}

/// Checks the component with the values of the carriers, or with a few that represent all values.
Result conform_in_carriers(const TimedModel& timed, const ir::ComponentRef& component, const Options& options,
                           diagnostics::Diagnostics& diagnostics) {
    const RenamedSystem& model = timed.model;
    diagnostics::Diagnostics apart;  // discarded, because the generator reports the same findings
    const auto resolved = cpp_emit::resolve_component(model.system, model.instantiation, component, apart);
    Representatives few;
    if (resolved)
        few = choose_representatives(model.system, model.instantiation, *resolved, least_names, model.list_bounds);
    if (few.types.empty())
        return judge_values(timed, component, model.instantiation, timed.script, options, diagnostics);
    return judge_names(timed, component, *resolved, options, diagnostics);
}

}  // namespace

namespace {

/// Checks a RoboSim component for the values of the carriers.
Result conform_robosim(const TimedModel& timed, const ir::ComponentRef& component, const Options& given,
                       diagnostics::Diagnostics& diagnostics) {
    const RenamedSystem& model = timed.model;
    Options options = given;
    options.cycle_length = static_cast<std::uint32_t>(ir::cycle_of(model.system, model.instantiation, component));
    return judge_values(timed, component, model.instantiation, timed.script, options, diagnostics);
}

}  // namespace

namespace {

/// Checks the component for all values if possible. Otherwise checks the values of the carriers, or a few values that
/// represent all of them.
Result conform_robochart(const TimedModel& timed, const ir::ComponentRef& component, const Options& options,
                         diagnostics::Diagnostics& diagnostics) {
    ForAllValues all = conform_for_all_values(timed, component, options, diagnostics);
    const bool differs = all.result && all.result->outcome == Outcome::differs;
    if (all.result && !differs) return std::move(*all.result);
    const std::optional<TimedModel> longer = with_longer_lists(timed);
    Result result = conform_in_carriers(longer ? *longer : timed, component, options, diagnostics);
    // Prefer to show the difference with values of the carriers. If it occurs only beyond the carriers, it is a
    // difference all the same.
    if (differs && result.outcome != Outcome::differs) return std::move(*all.result);
    if (result.represented.empty()) {
        result.not_for_all = std::move(all.reason);
    } else if (all.code_tests_values && result.outcome == Outcome::conforms) {
        result.outcome = Outcome::inconclusive;
        result.reason =
            "no difference for the few values explored, but the code also tests or computes values that the model only "
            "passes on";
    }
    return result;
}

/// Decides claims about cycles that compare values. If conformance was decided for other values than those of the
/// carriers, the claims still need the carriers.
void decide_claims_in_carriers(Result& result, const TimedModel& timed, const ir::ComponentRef& component,
                               const Options& options) {
    if (options.claims == nullptr || options.numbers == Numbers::carriers) return;
    const auto open = [&](const claims::CheckedClaim& claim) {
        const auto found = std::ranges::find(result.claims, claim.name, &CycleAnswers::claim);
        return found != result.claims.end() && reads_values(claim) && found->code.outcome == Outcome::inconclusive;
    };
    CycleClaims claims = *options.claims;
    std::erase_if(claims.claims, [&](const claims::CheckedClaim& claim) { return !open(claim); });
    if (claims.claims.empty()) return;
    Options carriers = options;
    carriers.numbers = Numbers::carriers;
    carriers.claims = std::make_shared<const CycleClaims>(std::move(claims));
    diagnostics::Diagnostics apart;  // discarded, because the first check has reported the same findings
    const Result again = judge_values(timed, component, timed.model.instantiation, timed.script, carriers, apart);
    if (again.outcome != Outcome::conforms) return;
    for (const CycleAnswers& answers : again.claims) {
        CycleAnswers& open_answers = *std::ranges::find(result.claims, answers.claim, &CycleAnswers::claim);
        open_answers = answers;
        open_answers.in_carriers = true;
    }
}

/// Adds a certificate for the values of the carriers if the conformance was decided for all values: a table contains
/// finitely many values.
void certify_in_carriers(Result& result, const TimedModel& timed, const ir::ComponentRef& component,
                         const Options& options) {
    Options carriers = options;
    carriers.numbers = Numbers::carriers;
    carriers.claims = nullptr;
    carriers.walks.cycles = 0;
    diagnostics::Diagnostics apart;  // discarded, because the first check has reported the same findings
    Result again = judge_values(timed, component, timed.model.instantiation, timed.script, carriers, apart);
    result.certificate = std::move(again.certificate);
    result.certificate_failure = std::move(again.certificate_failure);
    if (again.outcome != Outcome::conforms)
        result.certificate_failure = fmt::format("for the values of the carriers: {}", again.reason);
}

}  // namespace

Result conform(const TimedModel& timed, const ir::ComponentRef& named, const Options& options,
               diagnostics::Diagnostics& diagnostics) {
    const RenamedSystem& model = timed.model;
    const ir::ComponentRef component = renamed_component(model, named);
    if (!timed.sound || !component_process(timed.script.definitions, component))
        return not_generated(fmt::format("{} has no timed CSP semantics here", named.path));
    if (ir::is_robosim(model.system, component)) return conform_robosim(timed, component, options, diagnostics);
    Result result = conform_robochart(timed, component, options, diagnostics);
    decide_claims_in_carriers(result, timed, component, options);
    const bool missing = result.certificate == nullptr && result.certificate_failure.empty();
    if (!options.certified.empty() && result.outcome == Outcome::conforms && missing)
        certify_in_carriers(result, timed, component, options);
    if (result.outcome != Outcome::conforms) result.certificate = nullptr;
    return result;
}

Result conform(const ir::System& system, const ir::Instantiation& instantiation, const ir::ComponentRef& component,
               const Options& options, diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    return conform(timed_model(system, instantiation, sources, diagnostics), component, options, diagnostics);
}

}  // namespace robochart::conformance
