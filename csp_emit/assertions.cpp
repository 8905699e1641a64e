// Each kind of property has its CSPM form, as RoboTool generates it and FDR decides it (assertions.md 4).
#include "csp_emit/assertions.hpp"

#include <algorithm>

#include "checker/cspm/build.hpp"
#include "csp_emit/expressions.hpp"
#include "csp_emit/names.hpp"
#include "csp_emit/types.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::AssertionKind;
using cspm::DeclPtr;
using cspm::ExprPtr;
using ir::PropertyKind;

namespace {

ExprPtr tock() {
    return b::name("tock");
}

cspm::Model model_of(ir::PropertyModel model) {
    switch (model) {
        case ir::PropertyModel::traces:
            return cspm::Model::traces;
        case ir::PropertyModel::failures:
            return cspm::Model::failures;
        default:
            return cspm::Model::failures_divergences;
    }
}

/// No run of tocks for ever with nothing else on offer: `tock'` lets time pass visibly, hidden tocks must not diverge.
ExprPtr deadlock_watch(const ExprPtr& process) {
    const ExprPtr both = b::rename(process, {{tock(), tock()}, {tock(), b::name("tock'")}});
    const ExprPtr others = b::call("diff", {b::name("Events"), b::set({b::name("tock'"), tock()})});
    return b::hide(b::call("prioritise", {both, b::sequence({others, b::set({tock()})})}), b::set({tock()}));
}

class Asserter {
public:
    Asserter(const Project& project, const Emitted& emitted) : project_(project), emitted_(emitted) {}

    Obligation property(std::uint32_t index) const;
    void core(const std::string& path, const ComponentEmission& component, std::vector<Obligation>& out) const;

private:
    bool timed() const { return project_.timed(); }
    std::string path(const ir::ComponentRef& ref) const { return qualified(ref.package, ref.path); }
    const ComponentEmission* component(const ir::ComponentRef& ref) const;
    ExprPtr process(const ir::ComponentRef& ref, const ir::Property& property, const std::string& variant) const;
    ExprPtr argument(const std::string& parameter, const std::string& value, const ir::Property& property) const;
    std::vector<DeclPtr> unary(AssertionKind kind, const ExprPtr& process, bool negated) const;
    std::vector<DeclPtr> deadlock(const ExprPtr& process, bool negated) const;
    std::vector<DeclPtr> timelock(const ExprPtr& process, bool negated) const;
    std::vector<DeclPtr> termination(const ExprPtr& process, bool negated) const;
    std::vector<DeclPtr> refinement(const ir::Property& property, bool both) const;
    std::vector<DeclPtr> reachability(const ir::Property& property) const;
    ExprPtr renamed_to(const ir::ComponentRef& ref, const ir::ComponentRef& other, const ExprPtr& process) const;
    std::string unavailable(const ir::Property& property) const;
    std::vector<DeclPtr> forms(const ir::Property& property) const;

    const Project& project_;
    const Emitted& emitted_;
};

const ComponentEmission* Asserter::component(const ir::ComponentRef& ref) const {
    const auto found = emitted_.components.find(path(ref));
    return found == emitted_.components.end() ? nullptr : &found->second;
}

ExprPtr Asserter::argument(const std::string& parameter, const std::string& value, const ir::Property& property) const {
    for (const auto& [name, given] : property.constants)
        if (name == parameter || name == value) return expression(project_, {}, *given);
    return value.empty() ? nullptr : b::name(value);
}

/// `P::X::D__(0, constants...)`; for a process of a CSP block its name.
ExprPtr Asserter::process(const ir::ComponentRef& ref, const ir::Property& property, const std::string& variant) const {
    if (ref.kind == ir::ComponentKind::process) return b::name(ref.path);
    const ComponentEmission* found = component(ref);
    b::Exprs arguments{b::number(0)};
    if (found != nullptr) {
        for (const ArgumentParameter& parameter : found->arguments) {
            const ExprPtr given = argument(parameter.name, "", property);
            arguments.push_back(given ? given : default_literal(project_, parameter.type));
        }
        for (const ConstantParameter& constant : found->constants)
            arguments.push_back(argument(constant.parameter, constant.value, property));
    }
    return b::call(path(ref) + "::" + variant, arguments);
}

std::vector<DeclPtr> Asserter::unary(AssertionKind kind, const ExprPtr& process, bool negated) const {
    return {b::assert_property(process, kind, cspm::Model::none, negated)};
}

std::vector<DeclPtr> Asserter::deadlock(const ExprPtr& process, bool negated) const {
    if (!timed()) return unary(AssertionKind::deadlock_free, process, negated);
    return {b::assert_property(deadlock_watch(process), AssertionKind::divergence_free,
                               cspm::Model::failures_divergences, negated)};
}

/// Every stable state lets time pass.
std::vector<DeclPtr> Asserter::timelock(const ExprPtr& process, bool negated) const {
    const ExprPtr others = b::call("diff", {b::name("Events"), b::productions({tock()})});
    const ExprPtr any = b::interleave({b::call("RUN", {b::set({tock()})}), b::call("CHAOS", {others})});
    return {b::assert_refines(any, cspm::Model::failures, process, negated)};
}

/// Terminates: some deadlock or ✓ is reachable, and every deadlock is a ✓. Does not terminate: no ✓ is reachable,
/// that is, the event r__ that stands behind the ✓ is in no trace.
std::vector<DeclPtr> Asserter::termination(const ExprPtr& process, bool negated) const {
    const ExprPtr after = b::name("r__");
    if (negated) {
        const ExprPtr marked = b::sequential({process, b::prefix(after, b::stop())});
        return {b::assert_refines(b::stop(), cspm::Model::traces, b::project(marked, b::set({after})))};
    }
    const ExprPtr running = b::sequential({process, b::call("RUN", {b::set({after})})});
    return {b::assert_property(process, AssertionKind::deadlock_free, cspm::Model::none, true),
            b::assert_property(running, AssertionKind::deadlock_free, cspm::Model::none, false)};
}

/// Two components of the model are compared by the names of their events (csp-gen issue 91): one side is renamed.
ExprPtr Asserter::renamed_to(const ir::ComponentRef& ref, const ir::ComponentRef& other, const ExprPtr& process) const {
    const ComponentEmission* from = component(ref);
    const ComponentEmission* to = component(other);
    if (from == nullptr || to == nullptr || path(ref) == path(other)) return process;
    std::vector<cspm::Link> links;
    for (const std::string& channel : from->visible)
        if (std::find(to->visible.begin(), to->visible.end(), channel) != to->visible.end())
            links.push_back({b::name(path(ref) + "::" + channel), b::name(path(other) + "::" + channel)});
    return links.empty() ? process : b::rename(process, links);
}

std::vector<DeclPtr> Asserter::refinement(const ir::Property& property, bool both) const {
    const ExprPtr subject = renamed_to(property.subject, property.other, process(property.subject, property, "D__"));
    const ExprPtr other = process(property.other, property, "D__");
    const cspm::Model model = model_of(property.model);
    std::vector<DeclPtr> result{b::assert_refines(other, model, subject, property.negated)};
    if (both) result.push_back(b::assert_refines(subject, model, other));
    return result;
}

/// RoboTool asserts over VS_O__; VS__ is the same process before compression, and a counterexample through it still
/// shows every step.
std::vector<DeclPtr> Asserter::reachability(const ir::Property& property) const {
    const ExprPtr entered = b::name(path(property.subject) + "::" + property.state + "::entered");
    const ExprPtr only = b::project(process(property.subject, property, "VS__"), b::productions({entered}));
    return {b::assert_refines(b::stop(), cspm::Model::traces, only, !property.negated)};
}

/// Why a property has no CSPM form here; "" if it has one.
std::string Asserter::unavailable(const ir::Property& property) const {
    const bool binary = property.kind == PropertyKind::refines || property.kind == PropertyKind::equals;
    const bool component_only = property.kind == PropertyKind::reachable;
    if (property.kind == PropertyKind::clock_initialised)
        return "the semantics does not record whether a clock is initialised";
    if (property.kind == PropertyKind::timelock_free && !timed()) return "time cannot stop in the untimed semantics";
    if (binary && property.model == ir::PropertyModel::tick_tock) return "the tick-tock model is not supported yet";
    if (property.kind == PropertyKind::equals && property.negated)
        return "inequality is the failure of one of two refinements, which no CSPM assertion states";
    const auto missing = [&](const ir::ComponentRef& ref) {
        return ref.kind != ir::ComponentKind::process && component(ref) == nullptr;
    };
    if (missing(property.subject)) return property.subject.path + " was not emitted";
    if (binary && missing(property.other)) return property.other.path + " was not emitted";
    if (component_only && property.subject.kind == ir::ComponentKind::process)
        return "states are reached in components of the model only";
    return "";
}

std::vector<DeclPtr> Asserter::forms(const ir::Property& property) const {
    const auto subject = [&] { return process(property.subject, property, "D__"); };
    switch (property.kind) {
        case PropertyKind::deadlock_free:
            return deadlock(subject(), property.negated);
        case PropertyKind::divergence_free:
            return unary(AssertionKind::divergence_free, subject(), property.negated);
        case PropertyKind::deterministic:
            return unary(AssertionKind::deterministic, subject(), property.negated);
        case PropertyKind::timelock_free:
            return timelock(subject(), property.negated);
        case PropertyKind::terminates:
            return termination(subject(), property.negated);
        case PropertyKind::refines:
            return refinement(property, false);
        case PropertyKind::equals:
            return refinement(property, true);
        case PropertyKind::reachable:
            return reachability(property);
        default:
            return {};
    }
}

Obligation Asserter::property(std::uint32_t index) const {
    const ir::Property& property = project_.system.properties[index];
    Obligation result;
    result.property = index;
    result.time = project_.time;
    const std::size_t colon = property.wording.find(':');
    const std::string claim = colon == std::string::npos
                                  ? property.wording
                                  : property.wording.substr(property.wording.find_first_not_of(' ', colon + 1));
    result.title = property.name + (timed() ? " [timed] " : " [untimed] ") + claim;
    result.reason = unavailable(property);
    if (result.reason.empty()) result.assertions = forms(property);
    return result;
}

/// The generated assertions of one component: deadlock, divergence, determinism, and in time timelock.
void Asserter::core(const std::string& path, const ComponentEmission& component, std::vector<Obligation>& out) const {
    b::Exprs arguments{b::number(0)};
    for (const ArgumentParameter& parameter : component.arguments)
        arguments.push_back(default_literal(project_, parameter.type));
    for (const ConstantParameter& constant : component.constants) arguments.push_back(b::name(constant.value));
    const ExprPtr process = b::call(path + "::D__", arguments);
    const auto add = [&](const std::string& what, std::vector<DeclPtr> assertions) {
        Obligation obligation;
        obligation.title = (timed() ? "core [timed] " : "core [untimed] ") + path + " is " + what;
        obligation.time = project_.time;
        obligation.assertions = std::move(assertions);
        out.push_back(std::move(obligation));
    };
    add("deadlock-free", deadlock(process, false));
    add("divergence-free", unary(AssertionKind::divergence_free, process, false));
    add("deterministic", unary(AssertionKind::deterministic, process, false));
    if (timed()) add("timelock-free", timelock(process, false));
}

}  // namespace

std::vector<Obligation> obligations(const Project& project, const Emitted& emitted) {
    const Asserter asserter(project, emitted);
    std::vector<Obligation> result;
    for (std::uint32_t i = 0; i < project.system.properties.size(); ++i) {
        const ir::Property& property = project.system.properties[i];
        if (project.timed() ? property.timed : property.untimed) result.push_back(asserter.property(i));
    }
    if (project.options.core_assertions)
        for (const auto& [path, component] : emitted.components) asserter.core(path, component, result);
    return result;
}

}  // namespace robochart::csp_emit
