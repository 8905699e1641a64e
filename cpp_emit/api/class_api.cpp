// SPDX-License-Identifier: Apache-2.0
// Plans the classes: what they contain, and how everything in them is called.
#include "cpp_emit/api/class_api.hpp"

#include <algorithm>

#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

class ClassApiMaker {
public:
    explicit ClassApiMaker(const Generation& generation)
        : system_(generation.system), component_(generation.component) {}

    ClassApi make_api() {
        NameScope classes(own_type_names());
        for (const std::string& name : own_member_names()) classes.reserve_name(name);
        classes.reserve_name(component_.cpp_name + "_core");
        api_.name_space = package_namespace(component_.package);
        api_.cpp_name =
            classes.unique_name(component_.is_composed() ? component_.name : component_.root_unit().machine->name);
        for (const char* const suffix : {"Node", "Messages", "Outbox"}) {  // suffixes of the names in cpp_emit/ros2
            classes.reserve_name(api_.cpp_name + suffix);
            members_.reserve_name(api_.cpp_name + suffix);
        }
        api_.own.cpp_name = api_.cpp_name;
        for (const Unit& unit : component_.units)
            for (const std::string& interface : unit.machine->interfaces) add_base(interface, classes);
        for (const ApiClass& base : api_.bases) members_.reserve_name(base.cpp_name);
        members_.reserve_name(api_.cpp_name);
        members_.reserve_name(component_.cpp_name + "_core");
        add_operations();
        add_functions();
        add_events();
        add_variables();
        add_timers();
        add_machines();
        event_methods();
        std::erase_if(api_.bases, [](const ApiClass& base) {
            return base.variables.empty() && base.events.empty() && base.operations.empty();
        });
        return std::move(api_);
    }

private:
    void add_base(const std::string& interface, NameScope& classes) {
        const auto same = [&](const ApiClass& base) { return base.interface == interface; };
        if (std::ranges::none_of(api_.bases, same))
            api_.bases.push_back({interface, classes.unique_name(interface), {}, {}, {}});
    }

    ApiClass& class_of_interface(const std::string& interface) {
        const auto found =
            std::ranges::find_if(api_.bases, [&](const ApiClass& base) { return base.interface == interface; });
        return found == api_.bases.end() ? api_.own : *found;
    }

    /// Returns the name if no member has it yet. Otherwise returns it with `suffix`. Example: an event and an operation
    /// may have the same name.
    std::string unique_member(const std::string& name, const char* suffix) {
        NameScope trial = members_;
        const std::string plain = trial.unique_name(name);
        return plain == name ? members_.unique_name(name) : members_.unique_name(name + suffix);
    }

    void add_functions() {
        for (const FunctionHook& hook : component_.functions)
            api_.functions.push_back({&hook, unique_member(system_.functions[hook.id.index].name, "_function")});
    }

    void add_operations() {
        for (const PlatformCall& call : component_.calls)
            class_of_interface(call.signature->interface)
                .operations.push_back(
                    {call.signature, unique_member(call.signature->name, "_operation"), call.method, false});
        for (const ModelledCall& call : component_.modelled)
            class_of_interface(call.signature->interface)
                .operations.push_back(
                    {call.signature, unique_member(call.signature->name, "_operation"), call.method, true});
    }

    void add_events() {
        for (const EventPort& port : component_.events) {
            ApiClass& target = class_of_interface(port.interface);
            for (const bool sent : {false, true}) {
                if (sent ? port.output.empty() : !port.received) continue;
                const std::string flag = unique_member(port.model_name, sent && port.received ? "_sent" : "_event");
                target.events.push_back(
                    {&port, flag, port.type ? unique_member(flag + "_value", "_of_event") : "", sent, ""});
            }
        }
    }

    /// Adds the methods for events. Other members come first, so that they keep their names.
    void event_methods() {
        const auto name = [&](ApiClass& part) {
            for (ApiEvent& event : part.events)
                event.method = unique_member((event.sent ? "on_" : "raise_") + event.port->model_name, "_event");
        };
        for (ApiClass& base : api_.bases) name(base);
        name(api_.own);
    }

    void add_variables() {
        for (const StoredVariable& stored : component_.variables)
            if (!stored.copy && !stored.local)
                class_of_interface(stored.variable->interface)
                    .variables.push_back({&stored, unique_member(stored.name(), "_variable"), copy_paths(stored)});
    }

    /// Returns the members of other machines that hold a copy of the variable.
    [[nodiscard]] std::vector<std::string> copy_paths(const StoredVariable& first) const {
        std::vector<std::string> paths;
        for (const StoredVariable& stored : component_.variables)
            if (stored.copy && stored.has_member() && stored.variable->name == first.variable->name)
                paths.push_back(stored.path);
        return paths;
    }

    void add_timers() {
        for (const Part& part : component_.parts) {
            const Unit& root = component_.units[part.root];
            const std::string prefix = part.tag.empty() ? "" : part.tag + ".";
            for (std::size_t i = 0; i < root.clock_fields.size(); ++i) {
                const ir::Clock& clock = root.machine->clocks[i];
                if (root.clock_read[i] && !clock.entry_of.is_valid())
                    api_.timers.push_back({unique_member(clock.name, "_timer"), prefix + root.clock_fields[i], &clock});
            }
        }
    }

    void add_machines() {
        for (const Part& part : component_.parts) {
            const std::string suffix = part.tag.empty() ? "" : "_" + part.tag;
            ApiMachine machine{
                "state" + suffix, "States" + suffix, part.tag.empty() ? "at" : part.tag + ".at", part.root, {}};
            NameScope scope(std::set<std::string>{"none"});
            for (const ir::Node& node : component_.units[part.root].machine->nodes)
                machine.states.push_back(node.kind == ir::NodeKind::state ? scope.unique_name(node.path) : "");
            api_.machines.push_back(std::move(machine));
        }
    }

    const ir::System& system_;
    const Component& component_;
    ClassApi api_;
    NameScope members_{own_member_names()};
};

}  // namespace

ClassApi make_class_api(const Generation& generation) {
    return ClassApiMaker(generation).make_api();
}

std::string free_member(const ClassApi& api, std::string name) {
    const auto taken = [&] {
        bool found = false;
        each_class(api, [&](const ApiClass& part) {
            for (const ApiVariable& variable : part.variables) found = found || variable.member == name;
            for (const ApiEvent& event : part.events) found = found || event.flag == name || event.value == name;
            for (const ApiOperation& operation : part.operations) found = found || operation.method == name;
        });
        return found;
    };
    while (taken()) name += "_robot";
    return name;
}

Spelling deployed_spelling(const std::string& core) {
    return {"robochart::Deployment", core + "::", "double", "std::int64_t", "std::int64_t"};
}

std::string deployed_type(const Generation& generation, const std::string& core, ir::TypeId id) {
    return cpp_type(generation.system, id, deployed_spelling(core));
}

}  // namespace robochart::cpp_emit
