// Which class holds what, and under which names.
#include "cpp_emit/face.hpp"

#include <algorithm>

#include "cpp_emit/types.hpp"

namespace robochart::cpp_emit {

namespace {

class FaceMaker {
public:
    explicit FaceMaker(const Generation& generation) : component_(generation.component) {}

    Face make() {
        const ir::Machine& machine = *component_.root().machine;
        NameScope classes(std::set<std::string>{component_.cpp_name + "_core"});
        face_.name_space = package_namespace(component_.package);
        face_.cpp_name = classes.unique(machine.name);
        face_.own.cpp_name = face_.cpp_name;
        for (const Unit& unit : component_.units)
            for (const std::string& interface : unit.machine->interfaces) add_base(interface, classes);
        operations();
        events();
        variables();
        timers();
        states();
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
                target.events.push_back({&port, flag, port.type ? member(flag + "_value", "_of_event") : "", sent});
            }
        }
    }

    void variables() {
        for (const StoredVariable& stored : component_.variables)
            home(stored.variable->interface).variables.push_back({&stored, member(stored.variable->name, "_variable")});
    }

    void timers() {
        const Unit& root = component_.root();
        for (std::size_t i = 0; i < root.clock_fields.size(); ++i) {
            const ir::Clock& clock = root.machine->clocks[i];
            if (root.clock_read[i] && !clock.entry_of.valid())
                face_.timers.push_back({member(clock.name, "_timer"), root.clock_fields[i], &clock});
        }
    }

    void states() {
        NameScope scope(std::set<std::string>{"none"});
        for (const ir::Node& node : component_.root().machine->nodes)
            face_.states.push_back(node.kind == ir::NodeKind::state ? scope.unique(node.path) : "");
    }

    const Component& component_;
    Face face_;
    NameScope members_{{"step", "MakeTransition", "CheckInEvent", "reset", "state", "States", "name", "isFinal", "core",
                        "terminated", "Platform", "raise", "print", "show_value", "read_value", "Console"}};
};

}  // namespace

Face make_face(const Generation& generation) {
    return FaceMaker(generation).make();
}

std::string deployed_type(const Generation& generation, const std::string& core, ir::TypeId id) {
    switch (generation.system.type(id).kind) {
        case ir::TypeKind::boolean:
            return "bool";
        case ir::TypeKind::real:
            return "double";
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
            return "std::int64_t";
        default:
            return core + "::" + cpp_type(generation.system, id);
    }
}

}  // namespace robochart::cpp_emit
