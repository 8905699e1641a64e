// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/second_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/lts/graph.hpp"
#include "checker/lts/tau_components.hpp"
#include "csp_emit/assertion_forms.hpp"
#include "csp_emit/claimed_components.hpp"
#include "driver/settings/search_context.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {
namespace {

namespace b = cspm::build;
using cspm::ExprPtr;

/// Thrown if there are too many states to explore.
struct TooMany {};

bool is_refinement(const csp_emit::Obligation& obligation) {
    return obligation.kind == ir::PropertyKind::refines || obligation.kind == ir::PropertyKind::equals;
}

/// Returns "P::S::e.in" for `P::S::e.in` and `P::S::e.in.3`; "" if the expression is not an event of a component.
std::string event_named(const ExprPtr& expr, const csp_emit::Provenance& provenance) {
    const bool dotted = expr->kind == cspm::ExprKind::dot;
    const ExprPtr& channel = dotted ? expr->args.front() : expr;
    if (channel->kind != cspm::ExprKind::name || channel->text.find("::") == std::string::npos) return "";
    std::string name = channel->text;
    if (provenance.events.contains(name)) return name;
    if (dotted && expr->args[1]->kind == cspm::ExprKind::name) name += "." + expr->args[1]->text;
    return provenance.events.contains(name) ? name : "";
}

/// True if the set contains the channel with any values.
bool contains_channel(const std::set<std::string>& events, const std::string& channel) {
    if (events.contains(channel)) return true;
    const auto next = events.lower_bound(channel + ".");
    return next != events.end() && next->starts_with(channel + ".");
}

/// The events of components that the process hides or renames: the events in its prefixes with these names are not
/// those that it performs.
std::set<std::string> replaced_events(const csp_emit::Emission& emission, const ExprPtr& process) {
    std::set<std::string> found;
    const auto collect = [&](const ExprPtr& expr) {
        if (const std::string event = event_named(expr, emission.provenance); !event.empty()) found.insert(event);
    };
    csp_emit::visit_named(emission, {process}, [&](const ExprPtr& expr) {
        if (expr->kind == cspm::ExprKind::hide) csp_emit::visit_named(emission, {expr->args[1]}, collect);
        if (expr->kind != cspm::ExprKind::rename) return;
        for (const cspm::Link& link : expr->links) collect(link.from);
    });
    return found;
}

/// The events of components in prefixes of the expression and of the definitions that it uses, each with its first
/// place, without those that it replaces.
std::map<std::string, diagnostics::Span> prefixed_events(const csp_emit::Emission& emission, const ExprPtr& process) {
    std::map<std::string, diagnostics::Span> found;
    csp_emit::visit_named(emission, {process}, [&](const ExprPtr& expr) {
        if (expr->kind != cspm::ExprKind::prefix) return;
        if (const std::string event = event_named(expr->args[0], emission.provenance); !event.empty())
            found.try_emplace(event, expr->args[0]->span);
    });
    for (const std::string& event : replaced_events(emission, process)) found.erase(event);
    return found;
}

}  // namespace

SecondLook::SecondLook(const Project& project, const csp_emit::Emission& emission, cspm::Session& session,
                       const SearchContext& search)
    : project_(project), emission_(emission), session_(session), search_(search) {}

SecondLook::Seen SecondLook::find_seen(const ExprPtr& process) {
    Seen seen;
    try {
        const auto system = session_.system(process, limits_of_check(search_));
        const lts::Exploration all = lts::explore(*system, [&](std::size_t states) {
            if (states > most_states_for_second_look) throw TooMany{};
            search_.services.budget().poll();
        });
        const lts::TauComponents taus = lts::tau_components(all.graph);
        seen.diverges = std::ranges::find(taus.cyclic, true) != taus.cyclic.end();
        std::set<lts::Event> events;
        std::vector<bool> ended(all.graph.size()), halted(all.graph.size());
        for (lts::StateIndex state = 0; state < all.graph.size(); ++state) {
            halted[state] = true;
            for (const lts::Edge& edge : all.graph.edges(state)) {
                if (edge.event == lts::tick) ended[edge.target] = true;
                const bool internal = edge.event == lts::tau || edge.event == lts::tick;
                if (internal || system->events().name(edge.event) == "tock") halted[state] = false;
                if (!internal) events.insert(edge.event);
            }
        }
        for (lts::StateIndex state = 0; state < all.graph.size(); ++state) {
            seen.ends = seen.ends || ended[state];
            seen.time_stops = seen.time_stops || (halted[state] && !ended[state]);
        }
        for (const lts::Event event : events) seen.events.insert(system->events().name(event));
        seen.time_passes = seen.events.contains("tock");
        seen.whole = true;
    } catch (const TooMany&) {
    } catch (const diagnostics::LimitReached&) {
    } catch (const cspm::EvaluationError&) {
    } catch (const std::bad_alloc&) {
    }
    return seen;
}

const SecondLook::Seen& SecondLook::seen_of(const ExprPtr& process) {
    const auto [known, added] = seen_.try_emplace(cspm::print(process));
    if (added) known->second = find_seen(process);
    return known->second;
}

/// Hides calls, outputs and writes of the process, because the platform accepts them at once. If time stops in the
/// result, the component stops it.
ExprPtr SecondLook::with_outputs_taken(const ExprPtr& process) const {
    std::vector<ExprPtr> outputs;
    for (const std::string& path : csp_emit::components_in(emission_, {process}))
        for (const ExprPtr& output : csp_emit::outputs_of(emission_.provenance, path)) outputs.push_back(output);
    // a claim that compares two components renames the registers of one component to those of the other
    if (runs_in_cycles(process))
        for (const csp_emit::ComponentProcesses& component : emission_.components)
            for (const ExprPtr& event : csp_emit::cycle_events_of(emission_.provenance, component.path))
                outputs.push_back(event);
    return outputs.empty() ? process : b::hide(process, b::productions(outputs));
}

/// Returns the given variant of the process of the claim's component, with the constants of the instantiation. Returns
/// null if the claim is not about a component or sets constants.
ExprPtr SecondLook::subject_of(const csp_emit::Obligation& obligation, const std::string& variant) const {
    if (obligation.property == ir::no_id) return nullptr;
    const ir::Property& property = project_.system.properties[obligation.property];
    if (property.subject.kind == ir::ComponentKind::process || !property.constants.empty()) return nullptr;
    const std::string path = ir::qualified_name(property.subject);
    for (const csp_emit::ComponentProcesses& component : emission_.components) {
        if (component.path != path) continue;
        auto process = std::make_shared<cspm::Expr>(*component.process);
        process->args[0] = b::name(path + "::" + variant);
        return process;
    }
    return nullptr;
}

/// True if the process contains a RoboSim component.
bool SecondLook::runs_in_cycles(const ExprPtr& process) const {
    const std::set<std::string> paths = csp_emit::components_in(emission_, {process});
    return std::ranges::any_of(
        paths, [&](const std::string& path) { return !csp_emit::cycle_events_of(emission_.provenance, path).empty(); });
}

void SecondLook::add_time_stops(const ExprPtr& process, AssertionReport& report) {
    const Seen& seen = seen_of(with_outputs_taken(process));
    if (!seen.whole || !seen.time_stops) return;
    add(report.basis, {GroundKind::time_stops,
                       "time can stop, and after that nothing is asked any more",
                       {},
                       {},
                       {},
                       runs_in_cycles(process) ? "`is deadlock-free` says after which inputs"
                                               : "`is timelock-free` shows a run to where time stops"});
}

/// Adds an entry if the violation is the passing of time. A specification without `tock` allows only events that occur
/// before any time passes.
void SecondLook::add_no_time(const cspm::Assertion& assertion, const std::string& specification,
                             AssertionReport& report) {
    if (!report.run || report.run->end.kind != runs::EndKind::forbidden || !report.run->end.event ||
        report.run->end.event->kind != runs::Kind::tock)
        return;
    const Seen& seen = seen_of(assertion.specification);
    if (!seen.whole || seen.time_passes) return;
    add(report.basis,
        {GroundKind::no_time,
         fmt::format("the specification `{}` never lets time pass", specification),
         {},
         {},
         {},
         fmt::format("write `{} ||| RUN({{tock}})` if time may pass everywhere, `tock ->` where it may, or `untimed "
                     "assertion`",
                     specification)});
}

/// Adds the events of the specification that never occur in the implementation. The requirements after such an event do
/// not influence the answer.
void SecondLook::note_unreached_events(const cspm::Assertion& assertion, AssertionReport& report) {
    const auto named = prefixed_events(emission_, assertion.specification);
    if (named.empty()) return;
    const Seen& seen = seen_of(assertion.implementation);
    if (!seen.whole) return;
    for (const auto& [event, span] : named) {
        if (contains_channel(seen.events, event)) continue;
        Ground ground;
        ground.kind = GroundKind::never_asked;
        ground.text = fmt::format("no run has `{}`: what the specification says of it is never asked",
                                  emission_.provenance.events.at(event).text);
        set_place(project_.sources, span, ground);
        add(report.basis, std::move(ground));
    }
}

/// The name of the specification in the claim. `equals` has two assertions; in the second, the subject is the
/// specification. Claims that are not in an assertion file have no such name; theirs is the process in the script.
std::string SecondLook::name_of_specification(const csp_emit::Obligation& obligation, std::size_t place) const {
    if (obligation.property == ir::no_id) return cspm::print(obligation.assertions[place]->assertion.specification);
    const ir::Property& property = project_.system.properties[obligation.property];
    return ir::qualified_name(place == 0 ? property.other : property.subject);
}

void SecondLook::add_of_refinement(const csp_emit::Obligation& obligation, std::size_t place, AssertionReport& report) {
    const cspm::Assertion& assertion = obligation.assertions[place]->assertion;
    const bool timed = obligation.time == csp_emit::Time::timed;
    if (assertion.kind != cspm::AssertionKind::refinement || assertion.negated) return;
    if (timed && report.answer == Answer::fails)
        add_no_time(assertion, name_of_specification(obligation, place), report);
    if (report.answer != Answer::holds) return;
    // The entry is added only for processes of components. A process that a CSP block defines may stop time
    // intentionally.
    const bool of_model = !csp_emit::components_in(emission_, {assertion.implementation}).empty();
    if (timed && of_model) add_time_stops(assertion.implementation, report);
    if (assertion.model == cspm::Model::failures) {
        const Seen& seen = seen_of(assertion.implementation);
        if (seen.whole && seen.diverges)
            add(report.basis,
                {GroundKind::never_at_rest,
                 "it can go on internally for ever: what it refuses meanwhile is not compared in the failures model",
                 {},
                 {},
                 {},
                 "hide no inputs (docs/claims-in-csp.md, \"Never hide inputs\"), or claim it in the "
                 "failures divergences model"});
    }
    note_unreached_events(assertion, report);
}

/// Adds entries to the basis of a claim of deadlock freedom. In the timed semantics, a component that has terminated,
/// or in which time has stopped, is not deadlocked.
void SecondLook::add_of_deadlock(const csp_emit::Obligation& obligation, AssertionReport& report) {
    const ExprPtr process = subject_of(obligation, "D__");
    if (!process) return;
    const Seen& seen = seen_of(process);
    if (seen.whole && seen.ends)
        add(report.basis, {GroundKind::ended,
                           "it can come to its end, which is no deadlock in time",
                           {},
                           {},
                           {},
                           "`does not terminate` shows a run to its end"});
    add_time_stops(process, report);
}

void SecondLook::add_of_missed_event(const csp_emit::Obligation& obligation, AssertionReport& report) {
    if (const ExprPtr process = subject_of(obligation, "D__")) add_time_stops(process, report);
    const ir::Property& property = project_.system.properties[obligation.property];
    const ExprPtr states = property.state.empty() ? nullptr : subject_of(obligation, "VS__");
    if (!states) return;
    const std::string entered = fmt::format("{}::{}::entered", ir::qualified_name(property.subject), property.state);
    const Seen& seen = seen_of(b::project(states, b::productions({b::name(entered)})));
    if (seen.whole && seen.events.empty())
        add(report.basis, {GroundKind::never_asked,
                           fmt::format("no run enters {}: whether it misses the event is never asked", property.state),
                           {},
                           {},
                           {},
                           {}});
}

void SecondLook::add_to(const csp_emit::Obligation& obligation, AssertionReport& report) {
    const bool holds = report.answer == Answer::holds;
    if (!holds && report.answer != Answer::fails) return;
    const bool timed = obligation.time == csp_emit::Time::timed;
    if (is_refinement(obligation))
        for (std::size_t place = 0; place < obligation.assertions.size(); ++place)
            add_of_refinement(obligation, place, report);
    if (!holds || !timed || obligation.negated != (obligation.kind == ir::PropertyKind::event_missed)) return;
    if (obligation.kind == ir::PropertyKind::deadlock_free) add_of_deadlock(obligation, report);
    if (obligation.kind == ir::PropertyKind::event_missed) add_of_missed_event(obligation, report);
}

}  // namespace robochart::driver
