// See seats.hpp.
#include "probability/process/seats.hpp"

#include <algorithm>

#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

std::string below(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "::" + name;
}

void add_machines(const ir::System& system, const ir::Module* module, const ir::Controller& controller,
                  const std::string& path, const std::string& component, std::vector<Seat>& result) {
    for (const ir::MachineInstance& each : controller.machines)
        result.push_back({module, &controller, each.name, &system.machine(each.machine), below(path, each.name),
                          below(component, each.name)});
}

/// Channels joined by connections: an end is a path below the component, "" for the platform's side of a module.
class Joined {
public:
    Joined(const ir::System& system, const ir::ComponentRef& subject) {
        if (subject.kind == ir::ComponentKind::module) {
            const ir::Module& module = system.modules[subject.definition];
            connect(module.connections, "", [&](std::uint32_t part) { return module.controllers[part].name; });
            for (const ir::ControllerInstance& each : module.controllers)
                controller(system.controller(each.controller), each.name);
        }
        if (subject.kind == ir::ComponentKind::controller) controller(system.controllers[subject.definition], "");
    }

    std::vector<std::string> with(const std::string& event) const {
        std::vector<std::string> result{event};
        for (std::size_t i = 0; i < result.size(); ++i)
            for (const auto& [one, other] : pairs_) {
                const std::string* const next = one == result[i] ? &other : other == result[i] ? &one : nullptr;
                if (next != nullptr && std::find(result.begin(), result.end(), *next) == result.end())
                    result.push_back(*next);
            }
        return result;
    }

private:
    void controller(const ir::Controller& controller, const std::string& path) {
        connect(controller.connections, path, [&](std::uint32_t part) { return controller.machines[part].name; });
    }

    template <class NameOf>
    void connect(const std::vector<ir::Connection>& connections, const std::string& path, const NameOf& name_of) {
        const auto place = [&](const ir::ConnectionEnd& end) {
            return below(end.kind == ir::EndKind::self ? path : below(path, name_of(end.part)), end.event);
        };
        for (const ir::Connection& each : connections)
            if (!each.async) pairs_.emplace_back(place(each.from), place(each.to));
    }

    std::vector<std::pair<std::string, std::string>> pairs_;
};

}  // namespace

std::vector<Seat> seats_in(const ir::System& system, const ir::ComponentRef& subject) {
    std::vector<Seat> result;
    const std::string component = ir::qualified(subject);
    if (subject.kind == ir::ComponentKind::module) {
        const ir::Module& module = system.modules[subject.definition];
        for (const ir::ControllerInstance& each : module.controllers)
            add_machines(system, &module, system.controller(each.controller), below(subject.path, each.name),
                         below(component, each.name), result);
    } else if (subject.kind == ir::ComponentKind::controller) {
        add_machines(system, nullptr, system.controllers[subject.definition], subject.path, component, result);
    } else if (subject.kind == ir::ComponentKind::machine) {
        const ir::Machine& machine = system.machines[subject.definition];
        result.push_back({nullptr, nullptr, machine.name, &machine, subject.path, component});
    }
    return result;
}

std::vector<std::string> joined_events(const ir::System& system, const ir::ComponentRef& subject,
                                       const std::string& path) {
    if (!path.starts_with(subject.path + "::")) return {};
    std::string inside = path.substr(subject.path.size() + 2);
    if (subject.kind == ir::ComponentKind::module) {
        const std::string platform = system.modules[subject.definition].platform.name + "::";
        if (inside.starts_with(platform)) inside = inside.substr(platform.size());
    }
    std::vector<std::string> result;
    for (const std::string& each : Joined(system, subject).with(inside))
        result.push_back(ir::qualified(subject) + "::" + each);
    return result;
}

}  // namespace robochart::probability
