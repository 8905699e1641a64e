// SPDX-License-Identifier: Apache-2.0
// Declares the channels that machines, controllers and modules have in common (semantics 3.2).
#include "csp_emit/base/component.hpp"

#include <memory>
#include <utility>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;

void mean(Provenance& provenance, const std::string& component, const std::string& event, EventMeaning meaning) {
    meaning.component = component;
    provenance.events[component + "::" + event] = std::move(meaning);
}

cspm::ExprPtr call_of(const std::string& function, const std::vector<std::string>& parameters) {
    b::Exprs arguments;
    for (const std::string& parameter : parameters) arguments.push_back(b::name(parameter));
    return b::call(function, arguments);
}

namespace {

/// Returns the declaration with the span of the element from which it was generated, so that errors are reported at the
/// element.
cspm::DeclPtr with_place_of(const cspm::DeclPtr& decl, const ir::Origin& origin) {
    cspm::Decl result = *decl;
    result.span = origin.span;
    return std::make_shared<const cspm::Decl>(std::move(result));
}

}  // namespace

void ChannelDeclarations::mean(const std::string& event, EventMeaning meaning) {
    csp_emit::mean(provenance_, owner_, event, std::move(meaning));
}

void ChannelDeclarations::declare_event(const ir::Event& event) {
    b::Exprs fields{b::name("InOut")};
    std::vector<ir::TypeId> types;
    if (event.type) {
        fields.push_back(type_set(project_, *event.type));
        types.push_back(*event.type);
    }
    decls_.push_back(with_place_of(b::channel({event.name}, b::dot(fields)), event.origin));
    mean(event.name + ".in", {MeaningKind::trigger, "input " + event.name, types, event.origin});
    mean(event.name + ".out", {MeaningKind::output, "output " + event.name, types, event.origin});
}

void ChannelDeclarations::declare_call(const ir::OperationSignature& operation) {
    b::Exprs fields;
    for (const ir::TypeId type : operation.parameters) fields.push_back(type_set(project_, type));
    const std::string channel = operation.name + "Call";
    decls_.push_back(with_place_of(b::channel({channel}, fields.empty() ? nullptr : b::dot(fields)), operation.origin));
    mean(channel, {MeaningKind::call, "call " + operation.name, operation.parameters, operation.origin});
}

void ChannelDeclarations::declare_variable(const std::string& name, ir::TypeId type, bool written_by_others,
                                           const ir::Origin& origin) {
    std::vector<std::string> channels{"set_" + name};
    mean(channels[0], {MeaningKind::assignment, "write " + name, {type}, origin});
    if (written_by_others) {
        channels.push_back("set_EXT_" + name);
        mean(channels[1], {MeaningKind::external_write, "others write " + name, {type}, origin});
    }
    decls_.push_back(with_place_of(b::channel(channels, type_set(project_, type)), origin));
}

}  // namespace robochart::csp_emit
