// Elements inside a component's CSPM module may be called like a predefined function that the script does not use
// there: the module's own name comes first. At the top of the script every predefined name is in use.
#include "csp_emit/safe_names.hpp"

#include <map>
#include <set>

#include "csp_emit/names.hpp"
#include "csp_emit/rules.hpp"
#include "semantics/query.hpp"

namespace robochart::csp_emit {
namespace {

/// Calls `visit(name, top, span)` for every name that an element has in the script under its own name.
template <class Visit>
class Elements {
public:
    explicit Elements(const Visit& visit) : visit_(visit) {}

    void system(const ir::System& system) {
        for (const ir::Type& type : system.types)
            if (type.kind == ir::TypeKind::enumeration || type.kind == ir::TypeKind::given)
                top(type.package, type.name, type.origin.span, false);
        for (const ir::Function& function : system.functions)
            top(function.package, function.name, function.origin.span, false);
        for (const ir::Machine& machine : system.machines) this->machine(machine);
        for (const ir::Controller& controller : system.controllers) {
            top(controller.package, controller.name, controller.origin.span, true);
            events(controller.events);
            for (const auto& part : controller.machines) visit_(part.name, false, part.origin.span);
        }
        for (const ir::Module& module : system.modules) {
            top(module.package, module.name, module.origin.span, true);
            events(module.platform.events);
            for (const auto& part : module.controllers) visit_(part.name, false, part.origin.span);
        }
    }

private:
    /// In a package an element is a module inside the package's, and a type or function carries its name in front.
    void top(const std::string& package, const std::string& name, diagnostics::Span span, bool component) {
        if (package.empty())
            visit_(name, true, span);
        else if (component)
            visit_(name, false, span);
        if (!package.empty() && flatten(package) == package) visit_(package, true, span);
    }
    void events(const std::vector<ir::Event>& events) {
        for (const ir::Event& event : events) visit_(event.name, false, event.origin.span);
    }
    void machine(const ir::Machine& machine) {
        if (machine.kind == ir::MachineKind::state_machine)
            top(machine.package, machine.name, machine.origin.span, true);
        events(machine.events);
        for (const ir::Node& node : machine.nodes)
            if (node.kind == ir::NodeKind::state || node.kind == ir::NodeKind::final)
                visit_(node.name, false, node.origin.span);
    }

    const Visit& visit_;
};

template <class Visit>
void visit_elements(const ir::System& system, const Visit& visit) {
    Elements<Visit>(visit).system(system);
}

/// Writes the new names into a copy of the system.
class Renaming {
public:
    explicit Renaming(std::map<std::string, std::string> names) : names_(std::move(names)) {}

    void system(ir::System& system) const {
        for (ir::Type& type : system.types) {
            if (type.kind != ir::TypeKind::enumeration && type.kind != ir::TypeKind::given) continue;
            name(type.package);
            if (type.package.empty()) name(type.name);
        }
        for (ir::Function& function : system.functions) {
            name(function.package);
            if (function.package.empty()) name(function.name);
        }
        for (ir::Machine& machine : system.machines) this->machine(machine);
        for (ir::Controller& controller : system.controllers) this->controller(controller);
        for (ir::Module& module : system.modules) this->module(module);
        for (ir::Property& property : system.properties) {
            reference(property.subject);
            reference(property.other);
            path(property.state);
        }
        for (ir::CspBlock& block : system.csp_blocks)
            for (ir::ComponentRef& associated : block.associated) reference(associated);
    }

private:
    void name(std::string& text) const {
        const auto found = names_.find(text);
        if (found != names_.end()) text = found->second;
    }
    /// `A::B::C`, segment by segment.
    void path(std::string& text) const {
        std::string result;
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find("::", at), text.size());
            std::string segment = text.substr(at, end - at);
            name(segment);
            result += (at > 0 ? "::" : "") + segment;
            at = end + 2;
        }
        text = result;
    }
    void events(std::vector<ir::Event>& events) const {
        for (ir::Event& event : events) name(event.name);
    }
    void connections(std::vector<ir::Connection>& connections) const {
        for (ir::Connection& connection : connections) {
            name(connection.from.event);
            name(connection.to.event);
        }
    }
    void machine(ir::Machine& machine) const {
        name(machine.package);
        path(machine.path);
        if (machine.kind == ir::MachineKind::state_machine) name(machine.name);
        events(machine.events);
        for (ir::Node& node : machine.nodes) {
            name(node.name);
            path(node.path);
        }
    }
    void controller(ir::Controller& controller) const {
        name(controller.package);
        name(controller.name);
        path(controller.path);
        events(controller.events);
        for (auto& part : controller.machines) name(part.name);
        connections(controller.connections);
    }
    void module(ir::Module& module) const {
        name(module.package);
        name(module.name);
        events(module.platform.events);
        for (auto& part : module.controllers) name(part.name);
        connections(module.connections);
    }
    void reference(ir::ComponentRef& reference) const {
        name(reference.package);
        if (reference.kind != ir::ComponentKind::process) path(reference.path);
    }

    std::map<std::string, std::string> names_;
};

/// Constants are called after the components around them: the instantiation follows.
void rename_constants(const ir::System& before, SafeNames& after) {
    const auto old_names = ir::named_constants(before);
    const auto new_names = ir::named_constants(after.system);
    std::map<std::string, std::string> renamed;
    for (std::size_t i = 0; i < old_names.size() && i < new_names.size(); ++i)
        renamed[old_names[i].name] = new_names[i].name;
    const auto now = [&](const std::string& name) {
        const auto found = renamed.find(name);
        return found == renamed.end() ? name : found->second;
    };
    std::map<std::string, ir::Value> constants;
    for (const auto& [name, value] : after.instantiation.constants) constants[now(name)] = value;
    after.instantiation.constants = std::move(constants);
    for (ir::Property& property : after.system.properties)
        for (auto& [name, value] : property.constants) name = now(name);
}

}  // namespace

SafeNames safe_names(const ir::System& system, const ir::Instantiation& instantiation,
                     diagnostics::Diagnostics& diagnostics) {
    std::set<std::string> all;
    visit_elements(system, [&](const std::string& name, bool, diagnostics::Span) { all.insert(name); });
    std::map<std::string, std::string> names;
    visit_elements(system, [&](const std::string& name, bool top, diagnostics::Span span) {
        if (!(top ? is_reserved(name) : is_reserved_inside(name)) || names.contains(name)) return;
        std::string& chosen = names[name];
        int number = 0;
        do chosen = name + "_" + std::to_string(++number);
        while (all.contains(chosen) || is_reserved(chosen));
        all.insert(chosen);
        diagnostics.report(rules::reserved_name, span, {name, chosen});
    });
    SafeNames result;
    if (names.empty()) return result;
    result.changed = true;
    result.system = system;
    result.instantiation = instantiation;
    Renaming(names).system(result.system);
    rename_constants(system, result);
    return result;
}

}  // namespace robochart::csp_emit
