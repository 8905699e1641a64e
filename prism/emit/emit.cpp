// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/emit.hpp"

#include <fmt/format.h>

#include <map>

#include "prism/emit/channels.hpp"
#include "prism/emit/context.hpp"
#include "prism/emit/expressions.hpp"
#include "prism/emit/machine.hpp"
#include "prism/emit/ranges.hpp"
#include "prism/emit/tree.hpp"
#include "prism/syntax/printer.hpp"

namespace robochart::prism_emit {
namespace {

/// The heading of the list of names in the file.
constexpr std::string_view names_heading = "// Renames of RoboChart elements";

/// Adds the constants for the stages of an exit (R10).
void add_exit_constants(Context& context) {
    static const std::vector<std::pair<std::string, int>> stages{
        {"Exit_NONE", 0},    {"Exit_ACT_Parent", 1},      {"Exit_ACT_Trans", 2}, {"Exit_EXITED", 3},
        {"Exit_Sub_ACT", 4}, {"Exit_Sub_ACT_Waiting", 5}, {"Exit_Sub_EXITED", 6}};
    for (const auto& [name, value] : stages)
        context.emission.model.constants.push_back(tree::constant(context.unique_name(name), value));
}

/// Adds the platform's variables. R3: "Variables provided by the platform become global."
std::map<std::string, std::string> add_globals(Context& context) {
    std::map<std::string, std::string> names;
    const std::string platform = context.module.name + "::" + context.module.platform.name + "::";
    for (const ir::Variable& variable : context.module.platform.variables) {
        const std::string element = platform + variable.name;
        const auto carrier = context.find_carrier(variable.type, element, variable.origin.span);
        if (!carrier) continue;
        const std::string name = context.unique_name(variable.name);
        names[variable.name] = name;
        context.record_name(variable, element, name);
        Scope scope;
        scope.element = element;
        prism::ExprPtr initial;
        if (variable.initial) initial = whole_value(context, scope, *variable.initial);
        context.emission.model.globals.push_back(Context::declare_variable(name, *carrier, initial));
    }
    return names;
}

}  // namespace

Preferences preferences_of(const ir::Instantiation& instantiation) {
    const auto range = [](const std::vector<std::int64_t>& values, std::int64_t scale) {
        return values.empty() ? Range{} : Range{values.front() / scale, values.back() / scale};
    };
    return {range(instantiation.nat, 1), range(instantiation.integer, 1),
            range(instantiation.real, instantiation.scale)};
}

std::optional<Emission> emit(const ir::System& system, const ir::Module& module, const Preferences& preferences,
                             diagnostics::Diagnostics& diagnostics, const Functions& functions) {
    Context context(system, preferences, module, functions, diagnostics);
    context.emission.model.kind = preferences.kind;
    context.emission.model.kind_given = true;
    add_exit_constants(context);
    const std::map<std::string, std::string> globals = add_globals(context);
    std::map<std::string, std::string> constants;
    Channels channels(context);
    for (std::uint32_t c = 0; c < module.controllers.size(); ++c) {
        const auto& machines = system.controller(module.controllers[c].controller).machines;
        for (std::uint32_t m = 0; m < machines.size(); ++m)
            MachineEmitter(context, channels, globals, constants, {c, m})();
    }
    channels.emit_modules();
    if (!diagnostics.ok()) return std::nullopt;
    return std::move(context.emission);
}

bool is_of_robochart(std::string_view text) {
    return text.find(names_heading) != std::string_view::npos;
}

/// Writes the file. R1: "A comment block `renames of the ... [a::b] to [a_b]` at the end is read by the property
/// generator."
std::string file_text(const Emission& emission) {
    const prism::ModelFile model = in_ranges(emission.model);
    std::string result;
    if (model.labels.size() > emission.model.labels.size())
        result = fmt::format(
            "// Steps that would leave the range of a variable are left out in states with the label \"{0}\".\n"
            "// Numbers are those of the model if no such state is reachable: if P=? [ F \"{0}\" ] is 0.\n\n",
            left_out_label);
    result += prism::print(model);
    result += fmt::format("\n{}\n", names_heading);
    for (const NameOf& renaming : emission.names)
        result += "// renames of the " + renaming.kind + " [" + renaming.element + "] to [" + renaming.name + "]\n";
    return result;
}

}  // namespace robochart::prism_emit
