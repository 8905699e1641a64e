#include "csp_emit/assertion_forms.hpp"

#include <algorithm>

#include "csp_emit/machine/machine.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::AssertionKind;
using cspm::DeclPtr;
using cspm::ExprPtr;

namespace {

ExprPtr tock() {
    return b::name("tock");
}

ExprPtr deadlock_watch(const ExprPtr& process) {
    const ExprPtr both = b::rename(process, {{tock(), tock()}, {tock(), b::name("tock'")}});
    const ExprPtr others = b::call("diff", {b::name("Events"), b::set({b::name("tock'"), tock()})});
    return b::hide(b::call("prioritise", {both, b::sequence({others, b::set({tock()})})}), b::set({tock()}));
}

}  // namespace

DeclPtr deadlock_free(const ExprPtr& process, bool timed, cspm::Model model, bool negated) {
    if (!timed) return b::assert_property(process, AssertionKind::deadlock_free, model, negated);
    return b::assert_property(deadlock_watch(process), AssertionKind::divergence_free,
                              cspm::Model::failures_divergences, negated);
}

DeclPtr timelock_free(const ExprPtr& process, bool negated) {
    const ExprPtr others = b::call("diff", {b::name("Events"), b::productions({tock()})});
    const ExprPtr any = b::interleave({b::call("RUN", {b::set({tock()})}), b::call("CHAOS", {others})});
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

DeclPtr never(const ExprPtr& process, bool negated) {
    return b::assert_refines(b::skip(), cspm::Model::traces, process, negated);
}

ExprPtr ClockWatch::only(const std::string& event, const std::vector<ExprPtr>& arguments) const {
    return b::project(b::call(name + "::D__", arguments), b::productions({b::name(name + "::" + event)}));
}

namespace {

/// The channels of the component around a machine by which operations that it defines call the platform: they are not
/// the machine's own, and the copy stands elsewhere.
std::vector<DeclPtr> channels_around(const Emitted& emitted, const std::string& path) {
    std::vector<DeclPtr> result;
    const std::size_t end = path.rfind("::");
    const auto around = emitted.components.find(end == std::string::npos ? "" : path.substr(0, end));
    if (around == emitted.components.end() || !around->second.module) return result;
    const std::vector<std::string>& own = emitted.components.at(path).visible;
    for (const DeclPtr& decl : around->second.module->exports) {
        const bool calls = decl->kind == cspm::DeclKind::channel && decl->names.size() == 1 &&
                           decl->names.front().ends_with("Call") &&
                           std::find(own.begin(), own.end(), decl->names.front()) == own.end();
        if (calls) result.push_back(decl);
    }
    return result;
}

}  // namespace

ClockWatch clock_watch(const Project& project, NameManager& names, Emitted& emitted, const std::string& path,
                       const std::string& clock, const std::string& purpose) {
    const ComponentEmission& machine = emitted.components.at(path);
    MachineContext context;
    context.project = &project;
    context.machine = machine.machine;
    context.name = names.unique("CLW_" + purpose);
    context.path = context.name;
    context.definitions = machine.definitions;
    context.names = names;
    context.watched = clock;
    const std::string name = context.name;
    Emitted apart;
    const ComponentEmission watching = emit_machine(std::move(context), apart);
    emitted.provenance.events.merge(apart.provenance.events);
    emitted.provenance.definitions.merge(apart.provenance.definitions);
    auto module = std::make_shared<cspm::Decl>(*watching.module);
    const std::vector<DeclPtr> channels = channels_around(emitted, path);
    module->exports.insert(module->exports.begin(), channels.begin(), channels.end());
    return {std::move(module), name, watching.reads_of_watched};
}

}  // namespace robochart::csp_emit
