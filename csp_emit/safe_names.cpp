// Elements inside a component's CSPM module may be called like a predefined function that the script does not use
// there: the module's own name comes first. At the top of the script every predefined name is in use. What is one name
// space in CSPM is several in RoboChart: where two elements of a model would meet in it, one of them gets a number.
#include "csp_emit/safe_names.hpp"

#include <map>
#include <set>

#include "csp_emit/names.hpp"
#include "csp_emit/rules.hpp"
#include "semantics/query.hpp"

namespace robochart::csp_emit {
namespace {

/// What carries a name of its own in the script.
enum class Bearer {
    data,       ///< a given type, an enumeration, a function: outside the modules
    component,  ///< a module of the script
    event,
    part,   ///< a reference: a module inside a module
    state,  ///< a module inside its machine's
    package,
};

/// Calls `visit(bearer, name, top, span)` for every name that an element has in the script under its own name; `top`:
/// outside all modules.
template <class Visit>
class Elements {
public:
    explicit Elements(const Visit& visit) : visit_(visit) {}

    void system(const ir::System& system) {
        for (const ir::Type& type : system.types)
            if (type.kind == ir::TypeKind::enumeration || type.kind == ir::TypeKind::given)
                top(Bearer::data, type.package, type.name, type.origin.span);
        for (const ir::Function& function : system.functions)
            top(Bearer::data, function.package, function.name, function.origin.span);
        for (const ir::Machine& machine : system.machines) this->machine(machine);
        for (const ir::Controller& controller : system.controllers) {
            top(Bearer::component, controller.package, controller.name, controller.origin.span);
            events(controller.events);
            for (const auto& part : controller.machines) visit_(Bearer::part, part.name, false, part.origin.span);
        }
        for (const ir::Module& module : system.modules) {
            top(Bearer::component, module.package, module.name, module.origin.span);
            events(module.platform.events);
            for (const auto& part : module.controllers) visit_(Bearer::part, part.name, false, part.origin.span);
        }
    }

private:
    /// In a package an element is a module inside the package's, and a type or function carries its name in front.
    void top(Bearer bearer, const std::string& package, const std::string& name, diagnostics::Span span) {
        if (package.empty())
            visit_(bearer, name, true, span);
        else if (bearer == Bearer::component)
            visit_(bearer, name, false, span);
        if (!package.empty() && flatten(package) == package) visit_(Bearer::package, package, true, span);
    }
    void events(const std::vector<ir::Event>& events) {
        for (const ir::Event& event : events) visit_(Bearer::event, event.name, false, event.origin.span);
    }
    void machine(const ir::Machine& machine) {
        if (machine.kind == ir::MachineKind::state_machine)
            top(Bearer::component, machine.package, machine.name, machine.origin.span);
        events(machine.events);
        for (const ir::Node& node : machine.nodes)
            if (node.kind == ir::NodeKind::state || node.kind == ir::NodeKind::final)
                visit_(Bearer::state, node.name, false, node.origin.span);
    }

    const Visit& visit_;
};

template <class Visit>
void visit_elements(const ir::System& system, const Visit& visit) {
    Elements<Visit>(visit).system(system);
}

/// Channels beside the events: `opCall`, `set_x`, `set_EXT_x` (semantics 3.2).
std::set<std::string> other_channels(const ir::System& system) {
    std::set<std::string> result;
    const auto add = [&](const auto& component) {
        for (const ir::OperationSignature& operation : component.operations) result.insert(operation.name + "Call");
        for (const ir::Variable& variable : component.variables)
            for (const char* prefix : {"set_", "set_EXT_", "setL_", "get_"}) result.insert(prefix + variable.name);
    };
    for (const ir::Machine& machine : system.machines) add(machine);
    for (const ir::Controller& controller : system.controllers) add(controller);
    for (const ir::Module& module : system.modules) add(module.platform);
    return result;
}

/// Old names to new ones: those of all elements alike, and those of one sort only.
struct NewNames {
    std::map<std::string, std::string> all, data, states;
};

/// Chooses new names for the elements whose own name would mean something else where it stands.
class Choice {
public:
    Choice(const ir::System& system, diagnostics::Diagnostics& diagnostics)
        : diagnostics_(diagnostics), channels_(other_channels(system)) {
        taken_ = channels_;
        visit_elements(system, [&](Bearer bearer, const std::string& name, bool, diagnostics::Span) {
            taken_.insert(name);
            if (bearer == Bearer::event) events_.insert(name);
            if (bearer != Bearer::data) modules_and_channels_.insert(name);
        });
    }

    NewNames choose(const ir::System& system) {
        visit_elements(system, [&](Bearer bearer, const std::string& name, bool top, diagnostics::Span span) {
            if (top ? is_reserved(name) : is_reserved_inside(name))
                rename(names_.all, name, span, rules::reserved_name);
            else if (bearer == Bearer::event && channels_.contains(name))
                rename(names_.all, name, span, rules::name_of_another);
            else if (bearer == Bearer::state && (events_.contains(name) || channels_.contains(name)))
                rename(names_.states, name, span, rules::name_of_another);
            else if (bearer == Bearer::data && top &&
                     (modules_and_channels_.contains(name) || channels_.contains(name)))
                rename(names_.data, name, span, rules::name_of_another);
        });
        return names_;
    }

private:
    void rename(std::map<std::string, std::string>& names, const std::string& name, diagnostics::Span span,
                const diagnostics::Rule& rule) {
        if (names.contains(name)) return;
        std::string& chosen = names[name];
        int number = 0;
        do chosen = name + "_" + std::to_string(++number);
        while (taken_.contains(chosen) || is_reserved(chosen));
        taken_.insert(chosen);
        diagnostics_.report(rule, span, {name, chosen});
    }

    diagnostics::Diagnostics& diagnostics_;
    std::set<std::string> channels_, events_, modules_and_channels_, taken_;
    NewNames names_;
};

/// Writes the new names into a copy of the system.
class Renaming {
public:
    explicit Renaming(NewNames names) : names_(std::move(names)), states_(names_.all), data_(names_.all) {
        states_.insert(names_.states.begin(), names_.states.end());
        data_.insert(names_.data.begin(), names_.data.end());
    }

    void system(ir::System& system) const {
        for (ir::Type& type : system.types) {
            if (type.kind != ir::TypeKind::enumeration && type.kind != ir::TypeKind::given) continue;
            name(type.package);
            if (type.package.empty()) name(type.name, data_);
        }
        for (ir::Function& function : system.functions) {
            name(function.package);
            if (function.package.empty()) name(function.name, data_);
        }
        for (ir::Machine& machine : system.machines) this->machine(machine);
        for (ir::Controller& controller : system.controllers) this->controller(controller);
        for (ir::Module& module : system.modules) this->module(module);
        for (ir::Property& property : system.properties) {
            reference(property.subject);
            reference(property.other);
            if (property.kind == ir::PropertyKind::reachable) path(property.state, states_);
        }
        for (ir::CspBlock& block : system.csp_blocks)
            for (ir::ComponentRef& associated : block.associated) reference(associated);
    }

private:
    using Names = std::map<std::string, std::string>;
    void name(std::string& text) const { name(text, names_.all); }
    static void name(std::string& text, const Names& names) {
        const auto found = names.find(text);
        if (found != names.end()) text = found->second;
    }
    void path(std::string& text) const { path(text, names_.all); }
    /// `A::B::C`, segment by segment.
    static void path(std::string& text, const Names& names) {
        std::string result;
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find("::", at), text.size());
            std::string segment = text.substr(at, end - at);
            name(segment, names);
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
            name(node.name, states_);
            path(node.path, states_);
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

    NewNames names_;
    Names states_, data_;  ///< all that states, and types and functions, are renamed by
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
    const NewNames names = Choice(system, diagnostics).choose(system);
    SafeNames result;
    if (names.all.empty() && names.data.empty() && names.states.empty()) return result;
    result.changed = true;
    result.system = system;
    result.instantiation = instantiation;
    Renaming(names).system(result.system);
    rename_constants(system, result);
    return result;
}

}  // namespace robochart::csp_emit
