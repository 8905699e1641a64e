// Assertions and csp blocks: names resolved to components, states and constants (reference: assertion language 4).
#include "semantics/lower/properties.hpp"

#include <algorithm>

#include "semantics/lower/expressions.hpp"
#include "semantics/lower/paths.hpp"
#include "semantics/query.hpp"
#include "semantics/rules.hpp"
#include "semantics/suggest.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;
using Strings = std::vector<std::string>;

PropertyKind kind_of(ast::AssertionKind kind) {
    switch (kind) {
        case ast::AssertionKind::deadlock_free:
            return PropertyKind::deadlock_free;
        case ast::AssertionKind::divergence_free:
            return PropertyKind::divergence_free;
        case ast::AssertionKind::deterministic:
            return PropertyKind::deterministic;
        case ast::AssertionKind::timelock_free:
            return PropertyKind::timelock_free;
        case ast::AssertionKind::terminates:
            return PropertyKind::terminates;
        case ast::AssertionKind::refines:
            return PropertyKind::refines;
        case ast::AssertionKind::equals:
            return PropertyKind::equals;
        case ast::AssertionKind::reachable:
            return PropertyKind::reachable;
        case ast::AssertionKind::clock_initialised:
            break;
    }
    return PropertyKind::clock_initialised;
}

PropertyModel model_of(const std::optional<ast::AssertionModel>& model) {
    switch (model.value_or(ast::AssertionModel::failures_divergences)) {
        case ast::AssertionModel::traces:
            return PropertyModel::traces;
        case ast::AssertionModel::failures:
            return PropertyModel::failures;
        case ast::AssertionModel::tick_tock:
            return PropertyModel::tick_tock;
        case ast::AssertionModel::failures_divergences:
            break;
    }
    return PropertyModel::failures_divergences;
}

/// Text on one line: every run of blanks is one blank.
std::string on_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

/// The assertion as written; the span may start after the word that says in which time it is decided.
std::string wording_of(const diagnostics::SourceManager& sources, const ast::Assertion& source) {
    const auto text = sources.text(source.span.source);
    const std::string line = on_one_line(text.substr(source.span.begin, source.span.end - source.span.begin));
    if (line.compare(0, 9, "assertion") != 0 || source.time == ast::AssertionTime::both) return line;
    return (source.time == ast::AssertionTime::timed ? "timed " : "untimed ") + line;
}

class Properties {
public:
    Properties(Lowering& lowering, const ast::File& file) : lowering_(lowering), file_(file) {}

    void run();

private:
    void assertion(const ast::Assertion& source);
    void block(const ast::CspBlock& source);
    std::optional<FoundComponent> component(const ast::QualifiedName& name, bool processes);
    void unknown(const ast::QualifiedName& name);
    [[nodiscard]] bool is_process(const std::string& name) const;
    void reachable(const ast::Assertion& source, const FoundComponent& subject, Property& property);
    std::string state_below(const ast::QualifiedName& state, const FoundComponent& subject);
    static std::string state_of(const FoundComponent& subject, const FoundComponent& place, const Strings& names,
                                std::size_t from);
    void clock(const ast::Assertion& source, Property& property);
    void parameter(const ast::AssertionParameter& source, Property& property);
    void constant(const ast::AssertionParameter& source, const FoundComponent& context, Property& property);
    void operation_parameter(const ast::AssertionParameter& source, const FoundComponent& context, Property& property);
    void no_such(const ast::AssertionParameter& source, const std::string& what, const Strings& candidates);
    ExprPtr value(const ast::AssertionParameter& source, TypeId type);

    Lowering& lowering_;
    const ast::File& file_;
};

bool Properties::is_process(const std::string& name) const {
    return std::any_of(lowering_.files.begin(), lowering_.files.end(), [&](const ast::File* file) {
        return std::any_of(file->csp_blocks.begin(), file->csp_blocks.end(),
                           [&](const ast::CspBlock& block) { return block.name == name; });
    });
}

void Properties::unknown(const ast::QualifiedName& name) {
    Strings candidates = component_paths(lowering_);
    for (const auto* file : lowering_.files)
        for (const auto& block : file->csp_blocks) candidates.push_back(block.name);
    lowering_.diagnostics.report(rules::unknown_component, name.span,
                                 {name.text(), did_you_mean(name.text(), candidates)});
}

/// The component a whole name leads to; a csp block of that name goes before.
std::optional<FoundComponent> Properties::component(const ast::QualifiedName& name, bool processes) {
    if (processes && is_process(name.text())) {
        FoundComponent process;
        process.ref.path = name.text();
        return process;
    }
    auto found = find_component(lowering_, file_, name);
    if (found && found->used == name.parts.size()) return found;
    unknown(name);
    return std::nullopt;
}

/// Path of a node below the subject: the way from the subject to the machine, then the node's path.
std::string Properties::state_of(const FoundComponent& subject, const FoundComponent& place, const Strings& names,
                                 std::size_t from) {
    const std::string& above = subject.ref.path;
    const std::string& at = place.ref.path;
    const bool below = at.compare(0, above.size(), above) == 0 &&
                       (at.size() == above.size() || at.compare(above.size(), 2, "::") == 0);
    if (place.machine == nullptr || !below || place.ref.package != subject.ref.package) return "";
    const Node* node = find_node(*place.machine, names, from);
    if (node == nullptr || (node->kind != NodeKind::state && node->kind != NodeKind::final)) return "";
    const std::string way = at.size() > above.size() ? at.substr(above.size() + 2) + "::" : "";
    return way + node->path;
}

/// The name may be relative to the subject, a full path through it, or a path through the definition of one of its
/// parts.
std::string Properties::state_below(const ast::QualifiedName& state, const FoundComponent& subject) {
    const FoundComponent relative = walk(lowering_, subject, state.parts);
    std::string path = state_of(subject, relative, state.parts, relative.used);
    if (!path.empty()) return path;
    const auto absolute = find_component(lowering_, file_, state);
    if (!absolute) return "";
    path = state_of(subject, *absolute, state.parts, absolute->used);
    if (!path.empty() || absolute->machine == nullptr) return path;
    const MachineId machine{absolute->ref.definition};
    if (subject.machine == absolute->machine) return state_of(subject, subject, state.parts, absolute->used);
    const auto instances = instances_of(lowering_, subject, machine);
    return instances.size() == 1 ? state_of(subject, instances.front(), state.parts, absolute->used) : "";
}

void Properties::reachable(const ast::Assertion& source, const FoundComponent& subject, Property& property) {
    property.state = state_below(source.other, subject);
    if (!property.state.empty()) return;
    Strings candidates;
    if (subject.machine != nullptr)
        for (const auto& node : subject.machine->nodes) candidates.push_back(node.path);
    lowering_.diagnostics.report(
        rules::not_a_state, source.other.span,
        {source.other.text(), subject.ref.path, did_you_mean(source.other.parts.back(), candidates)});
}

/// `clock X::S::C is initialised`: the subject is the machine that the path leads to.
void Properties::clock(const ast::Assertion& source, Property& property) {
    const auto& name = source.other;
    const auto found = find_component(lowering_, file_, name);
    const bool machine = found && found->machine != nullptr && found->used + 1 == name.parts.size();
    if (!machine) return unknown(name);
    property.subject = found->ref;
    property.state = name.parts.back();
    const auto& clocks = found->machine->clocks;
    const bool known =
        std::any_of(clocks.begin(), clocks.end(), [&](const Clock& clock) { return clock.name == property.state; });
    if (!known) lowering_.unresolved("clock '" + name.text() + "'", name.span);
}

ExprPtr Properties::value(const ast::AssertionParameter& source, TypeId type) {
    if (source.value) return lower_expression(lowering_, {}, *source.value, type);
    lowering_.unresolved("the value of " + source.name.text(), source.name.span);
    return make_boolean(true, source.name.span);
}

void Properties::no_such(const ast::AssertionParameter& source, const std::string& what, const Strings& candidates) {
    lowering_.diagnostics.report(
        rules::not_a_constant, source.name.span,
        {source.context.text(), what, source.name.text(), did_you_mean(source.name.text(), candidates)});
}

template <class Declaration>
std::optional<std::uint32_t> position(const std::vector<Declaration>& items, const std::string& name) {
    for (std::uint32_t i = 0; i < items.size(); ++i)
        if (items[i].name == name) return i;
    return std::nullopt;
}

template <class Declaration>
Strings names_of(const std::vector<Declaration>& items) {
    Strings names;
    for (const auto& item : items) names.push_back(item.name);
    return names;
}

/// The constant under the name its process parameter has, in the place where its value counts.
void Properties::constant(const ast::AssertionParameter& source, const FoundComponent& context, Property& property) {
    const auto& constants = context.machine != nullptr      ? context.machine->constants
                            : context.controller != nullptr ? context.controller->constants
                                                            : context.module->platform.constants;
    const auto at = position(constants, source.name.text());
    if (!at) return no_such(source, "constant", names_of(constants));
    std::string name = constant_name(context.ref.package, context.ref.path, source.name.text());
    if (context.machine != nullptr)
        name = constant_source(lowering_.system, context.module, context.controller, context.part, *context.machine,
                               ConstantId{*at})
                   .name;
    else if (context.controller != nullptr)
        name = constant_source(context.module, *context.controller, ConstantId{*at}).name;
    property.constants.emplace_back(name, value(source, constants[*at].type));
}

/// `parameter p of O`: "param_" in place of "const_", the rest alike.
void Properties::operation_parameter(const ast::AssertionParameter& source, const FoundComponent& context,
                                     Property& property) {
    const bool operation = context.machine != nullptr && context.machine->kind == MachineKind::operation;
    const auto at = operation ? position(context.machine->variables, source.name.text()) : std::nullopt;
    if (!at || context.machine->variables[*at].scope != VariableScope::parameter)
        return no_such(source, "parameter", operation ? names_of(context.machine->variables) : Strings{});
    const std::string path =
        context.controller != nullptr ? context.controller->path + "::" + context.part : context.machine->path;
    std::string name = constant_name(context.ref.package, path, source.name.text());
    name.replace(0, std::string("const_").size(), "param_");
    property.constants.emplace_back(name, value(source, context.machine->variables[*at].type));
}

void Properties::parameter(const ast::AssertionParameter& source, Property& property) {
    const auto context = component(source.context, false);
    if (!context) return;
    if (source.constant)
        constant(source, *context, property);
    else
        operation_parameter(source, *context, property);
}

void Properties::assertion(const ast::Assertion& source) {
    Property property;
    property.name = source.name;
    property.kind = kind_of(source.kind);
    property.negated = source.negated;
    property.timed = source.time != ast::AssertionTime::untimed;
    property.untimed = source.time != ast::AssertionTime::timed;
    property.model = model_of(source.model);
    property.file = lowering_.sources.path(file_.source);
    property.wording = wording_of(lowering_.sources, source);
    property.origin = origin_of(source.name, source.span);
    if (property.kind == PropertyKind::clock_initialised) {
        clock(source, property);
    } else if (const auto subject = component(source.subject, true)) {
        property.subject = subject->ref;
        if (property.kind == PropertyKind::reachable) reachable(source, *subject, property);
    }
    if (property.kind == PropertyKind::refines || property.kind == PropertyKind::equals)
        if (const auto other = component(source.other, true)) property.other = other->ref;
    for (const auto& item : source.parameters) parameter(item, property);
    lowering_.system.properties.push_back(std::move(property));
}

void Properties::block(const ast::CspBlock& source) {
    CspBlock block;
    block.name = source.name;
    block.timed = source.time != ast::AssertionTime::untimed;
    block.untimed = source.time != ast::AssertionTime::timed;
    for (const auto& name : source.associated)
        if (const auto found = component(name, true)) block.associated.push_back(found->ref);
    block.text = source.text;
    block.text_span = source.text_span;
    block.file = lowering_.sources.path(file_.source);
    lowering_.system.csp_blocks.push_back(std::move(block));
}

void Properties::run() {
    for (const auto& block : file_.csp_blocks) this->block(block);
    for (const auto& assertion : file_.assertions) this->assertion(assertion);
}

}  // namespace

void lower_properties(Lowering& lowering) {
    for (const auto* file : lowering.files) Properties(lowering, *file).run();
}

}  // namespace robochart::ir
