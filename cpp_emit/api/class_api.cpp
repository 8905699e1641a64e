// Which class holds what, and under which names.
#include "cpp_emit/api/class_api.hpp"

#include <algorithm>

#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

class FaceMaker {
public:
    explicit FaceMaker(const Generation& generation) : system_(generation.system), component_(generation.component) {}

    Face make() {
        NameScope classes(own_type_names());
        for (const std::string& name : own_member_names()) classes.take(name);
        classes.take(component_.cpp_name + "_core");
        face_.name_space = package_namespace(component_.package);
        face_.cpp_name = classes.unique(component_.composed() ? component_.name : component_.root().machine->name);
        face_.own.cpp_name = face_.cpp_name;
        for (const Unit& unit : component_.units)
            for (const std::string& interface : unit.machine->interfaces) add_base(interface, classes);
        for (const FaceClass& base : face_.bases) members_.take(base.cpp_name);
        members_.take(face_.cpp_name);
        members_.take(face_.cpp_name + "Node");  // ros2_node.cpp
        members_.take(component_.cpp_name + "_core");
        operations();
        functions();
        events();
        variables();
        timers();
        machines();
        event_methods();
        std::erase_if(face_.bases, [](const FaceClass& base) {
            return base.variables.empty() && base.events.empty() && base.operations.empty();
        });
        return std::move(face_);
    }

private:
    void add_base(const std::string& interface, NameScope& classes) {
        const auto same = [&](const FaceClass& base) { return base.interface == interface; };
        if (std::none_of(face_.bases.begin(), face_.bases.end(), same))
            face_.bases.push_back({interface, classes.unique(interface), {}, {}, {}});
    }

    FaceClass& home(const std::string& interface) {
        const auto found = std::find_if(face_.bases.begin(), face_.bases.end(),
                                        [&](const FaceClass& base) { return base.interface == interface; });
        return found == face_.bases.end() ? face_.own : *found;
    }

    /// The name itself where it is free; with `suffix` where an event and an operation, say, are called alike.
    std::string member(const std::string& name, const char* suffix) {
        NameScope trial = members_;
        const std::string plain = trial.unique(name);
        return plain == name ? members_.unique(name) : members_.unique(name + suffix);
    }

    void functions() {
        for (const FunctionHook& hook : component_.functions)
            face_.functions.push_back({&hook, member(system_.functions[hook.id.index].name, "_function")});
    }

    void operations() {
        for (const PlatformCall& call : component_.calls)
            home(call.signature->interface)
                .operations.push_back({call.signature, member(call.signature->name, "_operation"), call.method, false});
        for (const ModelledCall& call : component_.modelled)
            home(call.signature->interface)
                .operations.push_back({call.signature, member(call.signature->name, "_operation"), call.method, true});
    }

    void events() {
        for (const EventPort& port : component_.events) {
            FaceClass& target = home(port.interface);
            for (const bool sent : {false, true}) {
                if (sent ? port.output.empty() : !port.received) continue;
                const std::string flag = member(port.model_name, sent && port.received ? "_sent" : "_event");
                target.events.push_back({&port, flag, port.type ? member(flag + "_value", "_of_event") : "", sent, ""});
            }
        }
    }

    /// Last, so that they take no other member's name.
    void event_methods() {
        const auto name = [&](FaceClass& part) {
            for (FaceEvent& event : part.events)
                event.method = member((event.sent ? "on_" : "raise_") + event.port->model_name, "_event");
        };
        for (FaceClass& base : face_.bases) name(base);
        name(face_.own);
    }

    void variables() {
        for (const StoredVariable& stored : component_.variables)
            if (!stored.copy)
                home(stored.variable->interface)
                    .variables.push_back({&stored, member(stored.variable->name, "_variable"), copies(stored)});
    }

    /// Where the other machines keep theirs.
    [[nodiscard]] std::vector<std::string> copies(const StoredVariable& first) const {
        std::vector<std::string> paths;
        for (const StoredVariable& stored : component_.variables)
            if (stored.copy && stored.stored() && stored.variable->name == first.variable->name)
                paths.push_back(stored.path);
        return paths;
    }

    void timers() {
        for (const Part& part : component_.parts) {
            const Unit& root = component_.units[part.root];
            const std::string prefix = part.tag.empty() ? "" : part.tag + ".";
            for (std::size_t i = 0; i < root.clock_fields.size(); ++i) {
                const ir::Clock& clock = root.machine->clocks[i];
                if (root.clock_read[i] && !clock.entry_of.valid())
                    face_.timers.push_back({member(clock.name, "_timer"), prefix + root.clock_fields[i], &clock});
            }
        }
    }

    void machines() {
        for (const Part& part : component_.parts) {
            const std::string suffix = part.tag.empty() ? "" : "_" + part.tag;
            FaceMachine machine{
                "state" + suffix, "States" + suffix, part.tag.empty() ? "at" : part.tag + ".at", part.root, {}};
            NameScope scope(std::set<std::string>{"none"});
            for (const ir::Node& node : component_.units[part.root].machine->nodes)
                machine.states.push_back(node.kind == ir::NodeKind::state ? scope.unique(node.path) : "");
            face_.machines.push_back(std::move(machine));
        }
    }

    const ir::System& system_;
    const Component& component_;
    Face face_;
    NameScope members_{own_member_names()};
};

}  // namespace

Face make_face(const Generation& generation) {
    return FaceMaker(generation).make();
}

Spelling deployed(const std::string& core) {
    return {"robochart::Deployment", core + "::", "double", "std::int64_t", "std::int64_t"};
}

std::string deployed_type(const Generation& generation, const std::string& core, ir::TypeId id) {
    return cpp_type(generation.system, id, deployed(core));
}

}  // namespace robochart::cpp_emit
