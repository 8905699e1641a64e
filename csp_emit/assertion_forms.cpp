// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/assertion_forms.hpp"

#include <algorithm>

#include "csp_emit/machine/machine.hpp"
#include "semantics/ir/arithmetic.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::AssertionKind;
using cspm::DeclPtr;
using cspm::ExprPtr;

namespace {

ExprPtr tock_event() {
    return b::name("tock");
}

ExprPtr deadlock_watch(const ExprPtr& process, const ExprPtr& alphabet) {
    const ExprPtr both = b::rename(process, {{tock_event(), tock_event()}, {tock_event(), b::name("tock'")}});
    const ExprPtr others = b::call("diff", {alphabet, b::set({b::name("tock'"), tock_event()})});
    return b::hide(b::call("prioritise", {both, b::sequence({others, b::set({tock_event()})})}),
                   b::set({tock_event()}));
}

}  // namespace

DeclPtr deadlock_free(const ExprPtr& process, bool timed, cspm::Model model, bool negated, const ExprPtr& alphabet) {
    if (!timed) return b::assert_property(process, AssertionKind::deadlock_free, model, negated);
    return b::assert_property(deadlock_watch(process, alphabet ? alphabet : b::name("Events")),
                              AssertionKind::divergence_free, cspm::Model::failures_divergences, negated);
}

DeclPtr timelock_free(const ExprPtr& process, bool negated) {
    const ExprPtr others = b::call("diff", {b::name("Events"), b::productions({tock_event()})});
    const ExprPtr any = b::interleave({b::call("RUN", {b::set({tock_event()})}), b::call("CHAOS", {others})});
    return b::assert_refines(any, cspm::Model::failures, process, negated);
}

DeclPtr never_terminates(const ExprPtr& process) {
    const ExprPtr after = b::name("r__");
    const ExprPtr marked = b::sequential({process, b::prefix(after, b::stop())});
    return b::assert_refines(b::stop(), cspm::Model::traces, b::project(marked, b::set({after})));
}

ExprPtr running_on(const ExprPtr& process, const std::string& event) {
    return b::sequential({process, b::call("RUN", {b::set({b::name(event)})})});
}

DeclPtr never_performs(const ExprPtr& process, bool negated) {
    return b::assert_refines(b::skip(), cspm::Model::traces, process, negated);
}

std::vector<ExprPtr> outputs_of(const Provenance& provenance, const std::string& path) {
    std::vector<ExprPtr> result;
    const std::string prefix = path + "::";
    const auto& events = provenance.events;
    for (auto at = events.lower_bound(prefix); at != events.end() && at->first.starts_with(prefix); ++at) {
        const MeaningKind kind = at->second.kind;
        const std::string own = at->first.substr(prefix.size());
        const bool outside =
            kind == MeaningKind::output || kind == MeaningKind::call || kind == MeaningKind::assignment;
        if (!outside || own.find("::") != std::string::npos) continue;
        const std::size_t dot = own.find('.');
        const ExprPtr channel = b::name(prefix + own.substr(0, dot));
        if (dot == std::string::npos) result.push_back(channel);
        // Hidden steps with these meanings (`step__.n`) are omitted, because the process does not show their effects.
        if (own.ends_with(".out")) result.push_back(b::dot({channel, b::name("out")}));
    }
    return result;
}

std::vector<ExprPtr> cycle_events_of(const Provenance& provenance, const std::string& path) {
    std::vector<ExprPtr> result;
    for (const char* const channel : {"registerRead.", "registerWrite.", "endexec"}) {
        const std::string name = path + "::" + channel;
        const auto found = provenance.events.lower_bound(name);
        const bool declared = found != provenance.events.end() && found->first.starts_with(name);
        if (declared) result.push_back(b::name(name.ends_with('.') ? name.substr(0, name.size() - 1) : name));
    }
    return result;
}

ExprPtr WatchedCopy::copy_process(const std::vector<ExprPtr>& arguments) const {
    return b::call(name + "::D__", arguments);
}

ExprPtr WatchedCopy::only_event(const std::string& event, const std::vector<ExprPtr>& arguments) const {
    return b::project(copy_process(arguments), b::productions({b::name(this->event_of_copy(event))}));
}

namespace {

/// Declares the channels on which operations of the surrounding component call the platform. These channels do not
/// belong to the machine, and the copy is outside of the component.
std::vector<DeclPtr> channels_around(const Emitted& emitted, const std::string& path) {
    std::vector<DeclPtr> result;
    const std::size_t end = path.rfind("::");
    const auto around = emitted.components.find(end == std::string::npos ? "" : path.substr(0, end));
    if (around == emitted.components.end() || !around->second.module) return result;
    const std::vector<std::string>& own = emitted.components.at(path).visible;
    for (const DeclPtr& decl : around->second.module->exports) {
        const bool calls = decl->kind == cspm::DeclKind::channel && decl->names.size() == 1 &&
                           decl->names.front().ends_with("Call") &&
                           std::ranges::find(own, decl->names.front()) == own.end();
        if (calls) result.push_back(decl);
    }
    return result;
}

/// Returns the copy of the machine at `path`. The caller has set in `context` what the copy observes.
WatchedCopy watched_copy(const Project& project, NameManager& names, Emitted& emitted, const std::string& path,
                         const std::string& name, MachineContext context) {
    const ComponentEmission& machine = emitted.components.at(path);
    context.project = &project;
    context.machine = machine.machine;
    context.name = names.unique_name(name);
    context.path = context.name;
    context.definitions = machine.definitions;
    context.names = names;
    const std::string copy = context.name;
    Emitted apart;
    const ComponentEmission watching = emit_machine(std::move(context), apart);
    emitted.provenance.events.merge(apart.provenance.events);
    emitted.provenance.definitions.merge(apart.provenance.definitions);
    auto module = std::make_shared<cspm::Decl>(*watching.module);
    const std::vector<DeclPtr> channels = channels_around(emitted, path);
    module->exports.insert(module->exports.begin(), channels.begin(), channels.end());
    return {std::move(module), copy, watching.reads_of_watched};
}

}  // namespace

WatchedCopy clock_watch(const Project& project, NameManager& names, Emitted& emitted, const std::string& path,
                        const std::string& clock, const std::string& purpose) {
    MachineContext context;
    context.watched = clock;
    return watched_copy(project, names, emitted, path, "CLW_" + purpose, std::move(context));
}

WatchedCopy offer_watch(const Project& project, NameManager& names, Emitted& emitted, const std::string& path,
                        const std::string& event, const ir::Node* state, const std::string& purpose) {
    MachineContext context;
    context.offered = event;
    const std::vector<ir::Node>& nodes = emitted.components.at(path).machine->nodes;
    if (state != nullptr) context.within = ir::NodeId{static_cast<std::uint32_t>(state - nodes.data())};
    return watched_copy(project, names, emitted, path, "OFW_" + purpose, std::move(context));
}

ExprPtr missing_process(const WatchedCopy& watch, const Emitted& emitted, const std::string& event, std::int64_t units,
                        const std::vector<ExprPtr>& arguments, const std::string& name,
                        std::vector<DeclPtr>& preparation) {
    const auto own = [&](const char* event_name) { return b::name(watch.event_of_copy(event_name)); };
    const ExprPtr taken = b::dot({b::name(watch.event_of_copy(event)), b::name("in")});
    const ExprPtr left = b::name("k__");
    const auto counting = [&](const ExprPtr& value) { return b::call(name, {value}); };
    const ExprPtr anew = counting(b::number(ir::number_after(units)));
    const auto above = [&](std::int64_t value) { return b::binary(cspm::ExprKind::greater, left, b::number(value)); };
    const ExprPtr refused = b::if_(above(units), counting(b::number(units)), counting(left));
    const ExprPtr less = counting(b::binary(cspm::ExprKind::minus, left, b::number(1)));
    const ExprPtr passes =
        b::if_(above(units), counting(left), b::if_(above(1), less, b::prefix(own("missed__"), b::stop())));
    const ExprPtr takes =
        b::replicated(cspm::ExprKind::replicated_external, {b::generator("e__", b::productions({taken}))},
                      b::prefix(b::name("e__"), anew));
    preparation.push_back(
        b::function_decl(name, b::variables({"k__"}),
                         b::choice({b::prefix(own("inside__"), anew), b::prefix(own("outside__"), anew), takes,
                                    b::prefix(own("refused__"), refused), b::prefix(tock_event(), passes)})));
    const ExprPtr both = b::rename(watch.copy_process(arguments),
                                   {{own("inside__"), own("inside__")}, {own("inside__"), own("refused__")}});
    const auto before = [](const ExprPtr& process, const ExprPtr& first, const ExprPtr& later) {
        return b::call("prioritise", {process, b::sequence({first, later})});
    };
    const ExprPtr prompt =
        before(both, b::productions(outputs_of(emitted.provenance, watch.name)), b::set({tock_event()}));
    const ExprPtr limited = before(prompt, b::productions({taken}), b::set({own("refused__")}));
    const ExprPtr seen = b::productions({own("inside__"), own("outside__"), own("refused__"), taken, tock_event()});
    return b::project(b::parallel(limited, seen, anew), b::productions({own("missed__")}));
}

}  // namespace robochart::csp_emit
