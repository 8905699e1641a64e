// SPDX-License-Identifier: Apache-2.0
// Emits a machine. A machine may run separately, in a controller, and in that controller within a module. If its
// operations have the same definitions in these places, its module is emitted once and renamed for the other places.
// Otherwise it is emitted again.
#include "csp_emit/machine/machine.hpp"

#include "csp_emit/machine/machine_module.hpp"

namespace robochart::csp_emit {
namespace {

std::string key_of(const MachineContext& context) {
    std::string result = context.machine->package + "::" + context.machine->path;
    for (const auto& [operation, machine] : context.definitions)
        result += " " + operation + "=" + std::to_string(machine.index);
    return result;
}

/// Replaces the old path in a name by the new one, at the beginning of the name and after the channel of an event
/// (emit.hpp: Provenance).
std::string replace_path(const std::string& name, const std::string& from, const std::string& to) {
    const std::string before = from + "::";
    std::string result;
    for (std::size_t at = 0; at < name.size();) {
        const bool starts = at == 0 || name[at - 1] == '.';
        if (starts && name.compare(at, before.size(), before) == 0) {
            result += to + "::";
            at += before.size();
        } else {
            result += name[at++];
        }
    }
    return result;
}

template <class Meaning>
void add_moved(const std::map<std::string, Meaning>& meanings, const std::string& from, const std::string& to,
               std::map<std::string, Meaning>& result) {
    for (const auto& [name, meaning] : meanings) (result[replace_path(name, from, to)] = meaning).component = to;
}

cspm::DeclPtr rename_module(const cspm::DeclPtr& module, const std::string& name) {
    if (module->names.front() == name) return module;
    auto result = std::make_shared<cspm::Decl>(*module);
    result->names.front() = name;
    return result;
}

}  // namespace

ComponentEmission emit_machine(MachineContext context, Emitted& emitted) {
    if (const auto facts = emitted.shown.find(context.path); facts != emitted.shown.end())
        context.shown = facts->second;
    if (context.is_special()) return machine_module(std::move(context), emitted);
    const std::string path = context.path;
    const std::string name = context.name;
    const auto [found, added] = emitted.machines.try_emplace(key_of(context));
    EmittedMachine& known = found->second;
    if (added) {
        Emitted apart;
        known.path = path;
        known.emission = machine_module(std::move(context), apart);
        known.provenance = std::move(apart.provenance);
    }
    add_moved(known.provenance.events, known.path, path, emitted.provenance.events);
    add_moved(known.provenance.definitions, known.path, path, emitted.provenance.definitions);
    ComponentEmission result = known.emission;
    result.module = rename_module(result.module, name);
    return emitted.components[path] = result;
}

}  // namespace robochart::csp_emit
