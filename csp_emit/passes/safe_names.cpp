// SPDX-License-Identifier: Apache-2.0
// Renames elements. An element inside a component's CSPM module may have the name of a predefined function that the
// script does not use there, because the module's own name takes precedence. At the top of the script all predefined
// names are in use. RoboChart has several name spaces where CSPM has one. If two elements of a model would have the
// same name in CSPM, one of them gets a number.
#include "csp_emit/passes/safe_names.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "csp_emit/base/names.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {
namespace {

/// The kinds of elements whose names appear in the script.
enum class Bearer {
    component,  ///< a module of the script
    event,
    operation,  ///< `opCall`
    part,       ///< a reference: a module inside a module
    state,      ///< a module inside the machine's module
    package,
};

/// Calls `visit(bearer, name, top, span)` for every element whose name appears in the script. `top` is true outside all
/// modules.
template <class Visit>
class Elements {
public:
    explicit Elements(const Visit& visit) : visit_(visit) {}

    void visit_system(const ir::System& system) {
        for (const ir::Machine& machine : system.machines) visit_machine(machine);
        for (const ir::Controller& controller : system.controllers) {
            visit_component(controller.package, controller.name, controller.origin.span);
            visit_members(controller, controller.robosim);
            for (const auto& part : controller.machines) visit_(Bearer::part, part.name, false, part.origin.span);
        }
        for (const ir::Module& module : system.modules) {
            visit_component(module.package, module.name, module.origin.span);
            visit_members(module.platform, module.robosim);
            for (const auto& part : module.controllers) visit_(Bearer::part, part.name, false, part.origin.span);
        }
        for (const ir::Simulation& simulation : system.simulations)
            visit_component("", simulation.name, simulation.origin.span);
    }

private:
    /// Visits a component. In a package it is a module inside the package's module.
    void visit_component(const std::string& package, const std::string& name, diagnostics::Span span) {
        visit_(Bearer::component, name, package.empty(), span);
        if (!package.empty()) visit_(Bearer::package, flatten_name(package), true, span);
    }
    /// Visits the members of a component. RoboSim's registers have the names `i_e` and `o_e`, which no other element
    /// has.
    template <class Component>
    void visit_members(const Component& component, bool robosim) {
        if (robosim) return;
        for (const ir::Event& event : component.events) visit_(Bearer::event, event.name, false, event.origin.span);
        for (const ir::OperationSignature& operation : component.operations)
            visit_(Bearer::operation, operation.name, false, operation.origin.span);
    }
    void visit_machine(const ir::Machine& machine) {
        if (machine.kind == ir::MachineKind::state_machine)
            visit_component(machine.package, machine.name, machine.origin.span);
        visit_members(machine, machine.robosim);
        for (const ir::Node& node : machine.nodes)
            if (node.kind == ir::NodeKind::state || node.kind == ir::NodeKind::final)
                visit_(Bearer::state, node.name, false, node.origin.span);
    }

    const Visit& visit_;
};

template <class Visit>
void visit_elements(const ir::System& system, const Visit& visit) {
    Elements<Visit>(visit).visit_system(system);
}

/// Returns the channels other than those of events: `opCall`, `set_x`, `set_EXT_x` (semantics 3.2).
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

/// The new names by the old ones: for all kinds of elements, for states and parts, and for operations. For each type
/// and each function, the new name, or "" if the name does not change.
struct NewNames {
    std::map<std::string, std::string> all, states, operations;
    std::vector<std::string> types, functions;
    std::vector<std::string> machines;  ///< new names of machines, except for the first with the same full name
    std::vector<std::vector<std::string>> labels;  ///< for each type, the names of its literals; empty: unchanged
    NamesForBlocks for_blocks;

    [[nodiscard]] bool empty() const {
        const auto unchanged = [](const std::string& name) { return name.empty(); };
        const auto all_unchanged = [](const auto& names) { return names.empty(); };
        return std::ranges::all_of(labels, all_unchanged) && all.empty() && states.empty() && operations.empty() &&
               std::ranges::all_of(types, unchanged) && std::ranges::all_of(functions, unchanged) &&
               std::ranges::all_of(machines, unchanged);
    }
};

/// Returns the names of a type or function at the top of the script: first its own name, then the names that are
/// derived from it.
std::vector<std::string> names_of(const ir::Type& type) {
    std::vector<std::string> result{type_name(type)};
    if (type.kind == ir::TypeKind::enumeration)
        for (std::size_t i = 0; i < type.labels.size(); ++i) result.push_back(literal_name(type, i));
    return result;
}
std::vector<std::string> names_of(const ir::Function& function) {
    return {function_name(function), "pre_" + function_name(function)};
}

bool is_named(const ir::Type& type) {
    return type.kind == ir::TypeKind::enumeration || type.kind == ir::TypeKind::given;
}
bool is_named(const ir::Function&) {
    return true;
}

/// Chooses new names for elements whose names would have another meaning in the script.
class Choice {
public:
    Choice(const ir::System& system, diagnostics::Diagnostics& diagnostics)
        : diagnostics_(diagnostics), channels_(other_channels(system)) {
        taken_ = channels_;
        visit_elements(system, [&](Bearer bearer, const std::string& name, bool, diagnostics::Span) {
            taken_.insert(name);
            if (bearer == Bearer::operation) return;
            if (bearer == Bearer::event) events_.insert(name);
            modules_and_channels_.insert(name);
        });
        for (const ir::NamedConstant& constant : ir::named_constants(system)) taken_.insert(constant.name);
        constants_ = taken_;
        for (const auto& type : system.types)
            if (is_named(type)) take_names(type);
        for (const auto& function : system.functions) take_names(function);
    }

    NewNames choose_names(const ir::System& system) {
        choose_data(with_labels(with_packages(system.types)), names_.types);
        choose_data(with_packages(system.functions), names_.functions);
        visit_elements(system, [&](Bearer bearer, const std::string& name, bool top, diagnostics::Span span) {
            if (bearer == Bearer::operation) {
                if (!is_identifier(name)) choose_new_name(names_.operations, name, span, rules::reserved_name);
                return;
            }
            if ((bearer == Bearer::state || bearer == Bearer::part) &&
                (events_.contains(name) || channels_.contains(name)))
                choose_new_name(names_.states, name, span, rules::name_of_another);
            else if (top ? is_reserved(name) : is_reserved_inside(name))
                choose_new_name(names_.all, name, span, rules::reserved_name);
            else if (bearer == Bearer::event && channels_.contains(name))
                choose_new_name(names_.all, name, span, rules::name_of_another);
        });
        choose_machines(system);
        tell_blocks(system);
        return names_;
    }

private:
    /// Returns the types or functions, with the new names of their packages.
    template <class Data>
    std::vector<Data> with_packages(std::vector<Data> all) {
        for (Data& data : all) {
            const std::string package = flatten_name(data.package);
            if (!is_named(data) || package.empty()) continue;
            if (!is_identifier(package)) choose_new_name(names_.all, package, data.origin.span, rules::reserved_name);
            const auto found = names_.all.find(package);
            if (found != names_.all.end()) data.package = found->second;
        }
        return all;
    }

    /// Returns the types, after literals that share their name with a bound variable have got other labels.
    std::vector<ir::Type> with_labels(std::vector<ir::Type> types) {
        for (ir::Type& type : types) {
            names_.labels.emplace_back();
            if (type.kind != ir::TypeKind::enumeration) continue;
            const std::vector<std::string> before = names_of(type);
            for (std::size_t i = 0; i < type.labels.size(); ++i) {
                if (!has_generated_suffix(literal_name(type, i))) continue;
                const std::string label = type.labels[i];
                for (int number = 1; type.labels[i] == label || taken_.contains(literal_name(type, i)); ++number)
                    type.labels[i] = label + "_" + std::to_string(number);
                taken_.insert(literal_name(type, i));
                diagnostics_.report(rules::reserved_name, type.origin.span, {before[i + 1], literal_name(type, i)});
                names_.for_blocks.data[before[i + 1]] = literal_name(type, i);
                names_.labels.back() = type.labels;
            }
        }
        return types;
    }

    template <class Data>
    void take_names(const Data& data) {
        if (!data.package.empty()) taken_.insert(flatten_name(data.package));
        for (const std::string& name : names_of(data)) taken_.insert(name);
    }

    /// Returns the rule that forbids this name for a type or function, because the name has another meaning in the
    /// script, or null if the name is allowed.
    template <class Data>
    [[nodiscard]] const diagnostics::Rule* find_clash(const Data& data) const {
        const auto names = names_of(data);
        if (is_reserved(names.front())) return &rules::reserved_name;
        const auto another = [&](const std::string& name) {
            return data_.contains(name) || modules_and_channels_.contains(name) || constants_.contains(name);
        };
        return std::ranges::any_of(names, another) ? &rules::name_of_another : nullptr;
    }

    template <class Data>
    void choose_data(const std::vector<Data>& all, std::vector<std::string>& chosen) {
        for (const Data& data : all) {
            chosen.emplace_back();
            if (!is_named(data)) continue;
            Data renamed = data;
            if (const diagnostics::Rule* rule = find_clash(data)) {
                for (int number = 1; find_clash(renamed) != nullptr || taken_by_another(renamed, data); ++number)
                    renamed.name = stem(data.name) + "_" + std::to_string(number);
                chosen.back() = renamed.name;
                take_names(renamed);
                diagnostics_.report(*rule, data.origin.span, {names_of(data).front(), names_of(renamed).front()});
                const auto before = names_of(data), after = names_of(renamed);
                for (std::size_t i = 0; i < before.size(); ++i)
                    if (!data_.contains(before[i])) names_.for_blocks.data.try_emplace(before[i], after[i]);
                for (auto& [of_model, here] : names_.for_blocks.data)  // a literal, whose label changes too
                    for (std::size_t i = 0; i < before.size(); ++i)
                        if (here == before[i]) here = after[i];
            }
            for (const std::string& name : names_of(renamed)) data_.insert(name);
        }
    }
    /// Chooses names for machines with the same full name. A reference denotes the first of them (RC-N03). The others
    /// get a number.
    void choose_machines(const ir::System& system) {
        std::set<std::string> known;
        for (const ir::Machine& machine : system.machines) {
            names_.machines.emplace_back();
            if (machine.kind != ir::MachineKind::state_machine || machine.path != machine.name) continue;
            if (known.insert(machine.package + "::" + machine.name).second) continue;
            std::map<std::string, std::string> name;
            choose_new_name(name, machine.name, machine.origin.span, rules::name_of_another);
            names_.machines.back() = name.at(machine.name);
        }
    }

    template <class Data>
    [[nodiscard]] bool taken_by_another(const Data& renamed, const Data& data) const {
        const auto names = names_of(renamed), own = names_of(data);
        return std::ranges::any_of(names, [&](const std::string& name) {
            return taken_.contains(name) && std::ranges::find(own, name) == own.end();
        });
    }

    void tell_blocks(const ir::System& system) {
        NamesForBlocks& recorded = names_.for_blocks;
        visit_elements(system, [&](Bearer bearer, const std::string& name, bool top, diagnostics::Span) {
            const auto found = names_.all.find(name);
            if (bearer == Bearer::operation || found == names_.all.end()) return;
            if (top)
                recorded.first.insert(*found);
            else if (bearer == Bearer::event)
                recorded.last.insert(*found);
            else
                recorded.inside.insert(*found);
        });
        for (const auto& [before, after] : names_.states) recorded.inside[before] = after;
        for (auto* parts : {&recorded.first, &recorded.inside})
            for (const auto& [before, after] : names_.operations) (*parts)["OP_" + before] = "OP_" + after;
        for (const auto& [before, after] : names_.operations) recorded.last[before + "Call"] = after + "Call";
    }

    void choose_new_name(std::map<std::string, std::string>& names, const std::string& name, diagnostics::Span span,
                         const diagnostics::Rule& rule) {
        if (names.contains(name)) return;
        std::string& chosen = names[name];
        int number = 0;
        do chosen = stem(name) + "_" + std::to_string(++number);
        while (taken_.contains(chosen) || taken_.contains(chosen + "Call") || is_reserved(chosen));
        taken_.insert(chosen);
        diagnostics_.report(rule, span, {name, chosen});
    }

    /// Returns the new name without its number. It begins with a letter, as identifiers of CSPM do.
    static std::string stem(const std::string& name) {
        const auto letter =
            std::ranges::find_if(name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
        return letter == name.end() ? "name" : std::string(letter, name.end());
    }

    diagnostics::Diagnostics& diagnostics_;
    std::set<std::string> channels_, events_, modules_and_channels_, constants_, taken_;
    std::set<std::string> data_;  ///< current names of types and functions
    NewNames names_;
};

/// Writes the new names into a copy of the system.
class Renaming {
public:
    explicit Renaming(NewNames names) : names_(std::move(names)), states_(names_.all), tops_(names_.all) {
        for (const auto& [before, after] : names_.states) states_[before] = after;
        for (auto* paths : {&states_, &tops_})
            for (const auto& [before, after] : names_.operations) (*paths)["OP_" + before] = "OP_" + after;
    }

    void rename_system(ir::System& system) const {
        for (std::size_t i = 0; i < system.types.size(); ++i) {
            if (!is_named(system.types[i])) continue;
            rename_package(system.types[i].package);
            if (!names_.types[i].empty()) system.types[i].name = names_.types[i];
            if (!names_.labels[i].empty()) system.types[i].labels = names_.labels[i];
        }
        for (std::size_t i = 0; i < system.functions.size(); ++i) {
            rename_package(system.functions[i].package);
            if (!names_.functions[i].empty()) system.functions[i].name = names_.functions[i];
        }
        for (std::size_t i = 0; i < system.machines.size(); ++i) {
            rename_machine(system.machines[i]);
            if (!names_.machines[i].empty()) system.machines[i].name = system.machines[i].path = names_.machines[i];
        }
        for (ir::Controller& controller : system.controllers) this->rename_controller(controller);
        for (ir::Module& module : system.modules) this->rename_module(module);
        for (ir::Property& property : system.properties) {
            rename_reference(property.subject);
            rename_reference(property.other);
            if (property.kind == ir::PropertyKind::reachable) rename_path(property.state, states_, states_);
        }
        for (ir::Simulation& simulation : system.simulations) {
            rename_name(simulation.name);
            rename_reference(simulation.subject);
            for (auto* list : {&simulation.inputs, &simulation.outputs})
                for (std::string& name : *list) rename_name(name);
        }
        for (ir::CspBlock& block : system.csp_blocks)
            for (ir::ComponentRef& associated : block.associated) rename_reference(associated);
    }

private:
    using Names = std::map<std::string, std::string>;
    void rename_name(std::string& text) const { rename_name(text, names_.all); }
    static void rename_name(std::string& text, const Names& names) {
        const auto found = names.find(text);
        if (found != names.end()) text = found->second;
    }
    void rename_package(std::string& text) const {
        const auto found = names_.all.find(flatten_name(text));
        if (!text.empty() && found != names_.all.end()) text = found->second;
    }
    /// Renames `A::B::C`, segment by segment.
    static void rename_path(std::string& text, const Names& first, const Names& behind) {
        std::string result;
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find("::", at), text.size());
            std::string segment = text.substr(at, end - at);
            rename_name(segment, at == 0 ? first : behind);
            result += (at > 0 ? "::" : "") + segment;
            at = end + 2;
        }
        text = result;
    }
    template <class Component>
    void rename_members(Component& component, bool robosim) const {
        if (robosim) return;
        for (ir::Event& event : component.events) rename_name(event.name);
        for (ir::OperationSignature& operation : component.operations) rename_name(operation.name, names_.operations);
    }
    void rename_connections(std::vector<ir::Connection>& connections) const {
        for (ir::Connection& connection : connections) {
            rename_name(connection.from.event);
            rename_name(connection.to.event);
        }
    }
    void rename_machine(ir::Machine& machine) const {
        rename_package(machine.package);
        const bool operation = machine.kind == ir::MachineKind::operation;
        const std::string above = machine.path.substr(0, machine.path.size() - machine.name.size());
        rename_name(machine.name, operation ? names_.operations : names_.all);
        machine.path = above;
        rename_path(machine.path, names_.all, names_.all);
        machine.path += machine.name;
        rename_members(machine, machine.robosim);
        for (ir::Node& node : machine.nodes) {
            rename_name(node.name, states_);
            rename_path(node.path, states_, states_);
        }
    }
    void rename_controller(ir::Controller& controller) const {
        rename_package(controller.package);
        rename_name(controller.name);
        rename_path(controller.path, names_.all, names_.all);
        rename_members(controller, controller.robosim);
        for (auto& part : controller.machines) rename_name(part.name, states_);
        if (!controller.robosim) rename_connections(controller.connections);
    }
    void rename_module(ir::Module& module) const {
        rename_package(module.package);
        rename_name(module.name);
        rename_members(module.platform, module.robosim);
        for (auto& part : module.controllers) rename_name(part.name, states_);
        if (!module.robosim) rename_connections(module.connections);
    }
    void rename_reference(ir::ComponentRef& reference) const {
        rename_package(reference.package);
        if (reference.kind != ir::ComponentKind::process) rename_path(reference.path, tops_, states_);
        const bool machine = reference.kind == ir::ComponentKind::machine &&
                             reference.definition < names_.machines.size() &&
                             reference.path.find("::") == std::string::npos;
        if (machine && !names_.machines[reference.definition].empty())
            reference.path = names_.machines[reference.definition];
    }

    NewNames names_;
    Names states_;  ///< new names of states and parts
    Names tops_;    ///< new names of declarations outside components
};

/// Finds components and constants with the same name in the script (RC-C10).
class Doubles {
public:
    explicit Doubles(diagnostics::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void find_doubles(const ir::System& system) {
        for (const ir::Machine& machine : system.machines) {
            if (machine.path == machine.name) check_component(machine.package, module_name(machine), machine.origin);
            check_constants(machine.package, machine.path, machine.constants);
        }
        for (const ir::Controller& controller : system.controllers) {
            if (controller.path == controller.name)
                check_component(controller.package, controller.name, controller.origin);
            check_constants(controller.package, controller.path, controller.constants);
            for (const auto& part : controller.machines)
                check_constants(controller.package, controller.path + "::" + part.name,
                                system.machine(part.machine).constants);
        }
        for (const ir::Module& module : system.modules) {
            check_component(module.package, module.name, module.origin);
            check_constants(module.package, module.name, module.platform.constants);
        }
        for (const ir::Simulation& simulation : system.simulations)
            check_component("", simulation.name, simulation.origin);
        for (const auto& [package, origin] : packages_) check_name(package, "package " + package, origin);
    }

private:
    void check_component(const std::string& package, const std::string& name, const ir::Origin& origin) {
        std::string element = "component " + (package.empty() ? name : package + "::" + name);
        const auto [known, added] = elements_.try_emplace(element, origin.span);
        if (!added) element = "another " + element;  // declared twice with the same full name
        check_name(qualified_name(package, name), element, origin);
        if (!package.empty()) packages_.emplace(flatten_name(package), origin);
    }
    void check_constants(const std::string& package, const std::string& path,
                         const std::vector<ir::Constant>& constants) {
        for (const ir::Constant& constant : constants)
            check_name(ir::constant_name(package, path, constant.name),
                       "constant " + (package.empty() ? "" : package + "::") + path + "::" + constant.name,
                       constant.origin);
    }
    void check_name(const std::string& name, const std::string& element, const ir::Origin& origin) {
        const auto [known, added] = names_.try_emplace(name, Named{element, origin.span});
        if (added || known->second.element == element) return;
        diagnostics_.report(rules::one_name_for_two, origin.span, {element, known->second.element, name})
            .notes.push_back({known->second.span, "this is the other"});
    }

    struct Named {
        std::string element;
        diagnostics::Span span;
    };
    diagnostics::Diagnostics& diagnostics_;
    std::map<std::string, Named> names_;
    std::map<std::string, diagnostics::Span> elements_;
    std::map<std::string, ir::Origin> packages_;
};

/// Renames the constants in the instantiation, because their names begin with the components around them.
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
    for (const auto& [before_name, after_name] : renamed)
        if (before_name != after_name) after.for_blocks.data.emplace(before_name, after_name);
}

}  // namespace

SafeNames safe_names(const ir::System& system, const ir::Instantiation& instantiation,
                     diagnostics::Diagnostics& diagnostics) {
    const NewNames names = Choice(system, diagnostics).choose_names(system);
    SafeNames result;
    if (names.empty()) {
        Doubles(diagnostics).find_doubles(system);
        return result;
    }
    result.changed = true;
    result.system = system;
    result.instantiation = instantiation;
    result.for_blocks = names.for_blocks;
    Renaming(names).rename_system(result.system);
    rename_constants(system, result);
    Doubles(diagnostics).find_doubles(result.system);
    return result;
}

}  // namespace robochart::csp_emit
