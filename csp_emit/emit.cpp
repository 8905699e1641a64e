// SPDX-License-Identifier: Apache-2.0
// Assembles the untimed or timed script: library, data, instantiations, components by package, CSP blocks, assertions.
#include "csp_emit/emit.hpp"
#include "csp_emit/showing.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/diagnostics/escape.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lexer.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/assertions.hpp"
#include "csp_emit/base/block_comments.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/script_library.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/block_claims.hpp"
#include "csp_emit/block_constants.hpp"
#include "csp_emit/compose/controller.hpp"
#include "csp_emit/compose/instantiations.hpp"
#include "csp_emit/compose/module.hpp"
#include "csp_emit/compose/simulation.hpp"
#include "csp_emit/core_properties.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/passes/name_clashes.hpp"
#include "csp_emit/passes/safe_names.hpp"
#include "csp_emit/passes/shared_modules.hpp"
#include "csp_emit/robotool_names.hpp"
#include "csp_emit/unread_definitions.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;

namespace {

/// Reserves every name that elements of the model have in the script.
class NameSurvey {
public:
    NameSurvey(const Project& project, NameManager& names) : project_(project), names_(names) {}

    void reserve_elements() {
        for (const char* name : {"registerRead", "registerWrite", "startexec", "endexec", "terminate",
                                 "RegisterDataInput", "RegisterDataOutput", "RegisterInputs", "RegisterOutputs"})
            names_.reserve(name);
        for (const ir::Simulation& simulation : project_.system.simulations) names_.reserve(simulation.name);
        for (const ir::Type& type : project_.system.types) reserve_type(type);
        for (const ir::Function& function : project_.system.functions) reserve_name(function_name(function));
        for (const ir::NamedConstant& constant : ir::named_constants(project_.system)) names_.reserve(constant.name);
        for (const ir::Machine& machine : project_.system.machines) reserve_component(machine, machine.name);
        for (const ir::Machine& machine : project_.system.machines) reserve_nodes(machine);
        for (const ir::Controller& controller : project_.system.controllers) {
            reserve_component(controller, controller.name);
            for (const auto& part : controller.machines) reserve_name(part.name);
        }
        for (const ir::Module& module : project_.system.modules) {
            reserve_component(module.platform, module.name);
            for (const auto& part : module.controllers) reserve_name(part.name);
        }
    }

private:
    void reserve_name(const std::string& name) { names_.reserve(name); }
    void reserve_type(const ir::Type& type) {
        if (type.kind != ir::TypeKind::enumeration && type.kind != ir::TypeKind::given) return;
        reserve_name(type_name(type));
        for (std::size_t i = 0; i < type.labels.size(); ++i) names_.reserve(literal_name(type, i));
    }
    template <class Component>
    void reserve_component(const Component& component, const std::string& name) {
        reserve_name(name);
        for (const ir::Event& event : component.events) reserve_name(event.name);
        for (const auto& operation : component.operations) names_.reserve(operation.name + "Call");
        for (const ir::Variable& variable : component.variables) {
            names_.reserve("set_" + variable.name);
            names_.reserve("set_EXT_" + variable.name);
            reserve_register(variable.name);
        }
        for (const ir::Event& event : component.events) reserve_register(event.name);
        for (const auto& operation : component.operations) reserve_register(operation.name);
    }
    /// RoboSim: reserves the constructors of the channels of registers.
    void reserve_register(const std::string& name) {
        const std::string plain = name.starts_with("$") ? name.substr(1) : name;
        for (const char* prefix : {"i_", "o_"}) names_.reserve(prefix + plain);
    }
    void reserve_nodes(const ir::Machine& machine) {
        for (const ir::Node& node : machine.nodes)
            if (node.kind == ir::NodeKind::state || node.kind == ir::NodeKind::final) reserve_name(node.name);
    }

    const Project& project_;
    NameManager& names_;
};

void append_declarations(std::vector<DeclPtr>& decls, const std::vector<DeclPtr>& more) {
    decls.insert(decls.end(), more.begin(), more.end());
}

/// The components of a package, in the order machines, controllers, modules.
class Packages {
public:
    void add_module(const std::string& package, const DeclPtr& module) {
        const std::string name = flatten_name(package);
        const auto found = std::ranges::find_if(packages_, [&](const auto& p) { return p.first == name; });
        if (found == packages_.end())
            packages_.push_back({name, {module}});
        else
            found->second.push_back(module);
    }
    std::vector<DeclPtr> decls() const {
        std::vector<DeclPtr> result;
        for (const auto& [name, modules] : packages_) {
            if (name.empty())
                result.insert(result.end(), modules.begin(), modules.end());
            else
                result.push_back(b::module_(name, {}, {}, modules, "package " + name));
        }
        return result;
    }

private:
    std::vector<std::pair<std::string, std::vector<DeclPtr>>> packages_;
};

/// Emits every component. `given` contains the constants that blocks Instantiations define and that influence claims.
void emit_components(const Project& project, const NameManager& names, const std::set<std::string>& given,
                     Emitted& emitted, std::vector<DeclPtr>& decls) {
    Packages packages;
    const ir::System& system = project.system;
    for (const ir::Machine& machine : system.machines) {
        if (machine.path != machine.name) continue;  // inline: emitted inside its controller
        if (machine.robosim && !project.is_timed()) continue;
        MachineContext context;
        context.project = &project;
        context.machine = &machine;
        context.name = module_name(machine);
        context.path = qualified_name(machine.package, context.name);
        context.names = names;
        packages.add_module(machine.package, emit_machine(std::move(context), emitted).module);
    }
    for (const ir::Controller& controller : system.controllers) {
        if (controller.path != controller.name || (controller.robosim && !project.is_timed())) continue;
        const ControllerContext context{
            &project, &controller, controller.name, qualified_name(controller.package, controller.name),
            names,    nullptr,     &given};
        packages.add_module(controller.package, emit_controller(context, emitted).module);
    }
    for (const ir::Module& module : system.modules) {
        if (module.robosim && !project.is_timed()) continue;
        const ModuleContext context{&project, &module, qualified_name(module.package, module.name), names, &given};
        packages.add_module(module.package, emit_module(context, emitted).module);
    }
    const bool share = project.options.share_modules && project.diagnostics.ok();
    const auto modules = share ? share_modules(packages.decls(), names) : packages.decls();
    decls.insert(decls.end(), modules.begin(), modules.end());
    for (const ir::Simulation& simulation : system.simulations)
        if (project.is_timed()) decls.push_back(emit_simulation(project, simulation, emitted).module);
}

/// Parses a block so that its diagnostics point into the .assertions file: blanks replace the text around the block.
std::vector<DeclPtr> read_block(const Project& project, const ir::CspBlock& block) {
    std::string text = block.text;
    if (block.text_span.is_known()) {
        text = std::string(project.sources.source_text(block.text_span.source));
        for (std::size_t i = 0; i < text.size(); ++i)
            if ((i < block.text_span.begin || i >= block.text_span.end) && text[i] != '\n') text[i] = ' ';
    }
    const auto source = project.sources.add(block.file, text);
    return with_comments(cspm::read(project.sources, source, project.diagnostics).decls, text);
}

/// Removes `transparent` lines that repeat lines of the library.
std::vector<DeclPtr> declared_once(const std::vector<DeclPtr>& blocks, const std::vector<DeclPtr>& library) {
    const auto announces = [](const DeclPtr& decl) {
        return decl->kind == cspm::DeclKind::transparent || decl->kind == cspm::DeclKind::external;
    };
    std::set<std::string> known;
    for (const DeclPtr& decl : library)
        if (announces(decl)) known.insert(decl->names.begin(), decl->names.end());
    std::vector<DeclPtr> result;
    for (const DeclPtr& decl : blocks) {
        if (!announces(decl)) {
            result.push_back(decl);
            continue;
        }
        cspm::Decl remaining = *decl;
        std::erase_if(remaining.names, [&](const std::string& name) { return !known.insert(name).second; });
        if (!remaining.names.empty()) result.push_back(std::make_shared<const cspm::Decl>(std::move(remaining)));
    }
    return result;
}

/// Returns the blocks for this semantics, file by file. Instantiations lose the `transparent` lines that repeat lines
/// of the library.
std::vector<FileBlocks> user_blocks(const Project& project, const std::vector<DeclPtr>& library) {
    std::vector<FileBlocks> result;
    std::set<std::string> instantiations;
    for (const ir::CspBlock& block : project.system.csp_blocks) {
        if (!project.block_applies(block)) continue;
        if (result.empty() || result.back().file != block.file) result.push_back({block.file, {}, {}});
        FileBlocks& file = result.back();
        const std::vector<DeclPtr> decls = read_block(project, block);
        if (project.replaces_instantiations(block)) {
            if (!instantiations.insert(block.text).second) continue;  // an earlier file contains the same block
            project.diagnostics.report(rules::instantiations_replaced, block.text_span, {block.name});
            append_declarations(file.instantiations, declared_once(decls, library));
        } else {
            append_declarations(file.others, decls);
        }
    }
    return result;
}

/// Adds the generated instantiations of all names that the user's blocks do not define. Collects these names, and
/// separately the names of functions whose values the finite instantiation chooses.
void add_instantiations(const Project& project, const std::set<std::string>& given, std::vector<DeclPtr>& decls,
                        std::set<std::string>& bounded, std::vector<std::string>& left_out) {
    for (const DeclPtr& decl : instantiation_definitions(project)) {
        const std::string name = !decl->names.empty() ? decl->names.front() : decl->patterns.front().front()->text;
        if (given.count(name) != 0) continue;
        left_out.push_back(name);
        decls.push_back(decl);
        if (decl->kind == cspm::DeclKind::function) bounded.insert(name);
    }
    for (const ir::Function& function : project.system.functions)  // values determined by a postcondition are the
                                                                   // model's
        if (!function.postconditions.empty()) bounded.erase(function_name(function));
}

/// Returns the names that a block may redefine or use.
std::set<std::string> names_for_blocks(const Project& project, const std::vector<DeclPtr>& core,
                                       const std::vector<DeclPtr>& generated, const NamesForBlocks& of_model) {
    std::set<std::string> result = user_names(core).all;
    result.merge(user_names(generated).all);
    result.merge(user_names(instantiation_definitions(project)).all);
    for (const auto& [before, after] : of_model.data) result.insert(before);
    return result;
}

/// Reserves every word in the blocks, so that generated names differ from all of them.
void reserve_words_of_blocks(const Project& project, NameManager& names) {
    for (const ir::CspBlock& block : project.system.csp_blocks) {
        const std::string& text = block.text;
        for (auto at = text.begin(); at != text.end();) {
            at = std::find_if(at, text.end(), cspm::continues_name);
            const auto end = std::find_if_not(at, text.end(), cspm::continues_name);
            if (at != end) names.reserve(std::string(at, end));
            at = end;
        }
    }
}

/// Adds a comment above an assertion: the claim as reports print it, with its place.
void name_claim(const Project& project, Obligation& obligation) {
    std::vector<DeclPtr>& first = obligation.preparation.empty() ? obligation.assertions : obligation.preparation;
    if (first.empty()) return;
    const bool core = obligation.property == ir::no_id;
    const ir::Origin& origin = core ? obligation.origin : project.system.properties[obligation.property].origin;
    const std::string place = project.sources.path_and_line(origin.span);
    cspm::Decl named = *first.front();
    named.comment =
        diagnostics::escape_for_display(obligation.title + (place.empty() ? "" : ", " + place)) + "\n" + named.comment;
    first.front() = std::make_shared<const cspm::Decl>(std::move(named));
}

/// Rejects blocks that give a constant a value in only one of several instances of a machine from which an operation
/// requires the constant.
void check_shared_constants(const Project& project, const std::set<std::string>& given) {
    for (const ir::SharedConstant& shared : ir::shared_constants(project.system))
        for (const ir::ConstantSource& source : shared.sources)
            if (given.contains(source.name))
                project.report_unsupported("a value of its own for " + source.name + " in a csp block, while " +
                                               shared.operation->name + " requires the constant of several callers,",
                                           shared.operation->origin.span);
}

/// Returns the script's name for a generated name.
std::string new_name(const cspm::NewNames& names, const std::string& name) {
    const auto found = names.find(name);
    return found == names.end() ? name : found->second;
}

void point_out_probabilities(const Project& project) {
    for (const ir::Machine& machine : project.system.machines)
        for (const ir::Node& node : machine.nodes)
            if (node.kind == ir::NodeKind::probabilistic)
                project.diagnostics.report(rules::probabilistic_choice, node.origin.span, {node.path});
}

}  // namespace

namespace {

Emission emit_with(const ir::System& system, const ir::Instantiation& instantiation, Time time, const Options& options,
                   const Shown& shown, diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    const SafeNames safe = safe_names(system, instantiation, diagnostics);
    const Project project{safe.changed ? safe.system : system,
                          safe.changed ? safe.instantiation : instantiation,
                          time,
                          options,
                          sources,
                          diagnostics};
    NameManager names;
    reserve_all(names);
    NameSurvey(project, names).reserve_elements();
    point_out_probabilities(project);
    Emission result;
    const std::vector<DeclPtr> core = script_library(project);
    const std::vector<FileBlocks> files = user_blocks(project, core);
    UserNames theirs;
    for (const FileBlocks& file : files)
        for (const auto* part : {&file.instantiations, &file.others}) {
            UserNames more = user_names(*part);
            theirs.constructors.merge(more.constructors);
            theirs.all.merge(more.all);
        }
    reserve_words_of_blocks(project, names);
    std::vector<DeclPtr> generated = data_definitions(project);
    append_declarations(generated, record_definitions(project, theirs.all));
    std::vector<std::string> left_out;
    Emitted emitted;
    emitted.shown = shown;
    const std::set<std::string> given = given_names(files, safe.for_blocks);
    check_shared_constants(project, given);
    std::set<std::string> deciding = given;  // for a constant with two names: the name that determines its value
    add_instantiations(project, given, generated, result.bounded, left_out);
    if (project.instantiations_replaced()) {
        const auto definitions = block_definitions(project, files, safe.for_blocks);
        check_instantiations_read(project, definitions, names_for_blocks(project, core, generated, safe.for_blocks),
                                  left_out);
        for (const std::string& part : check_names_of_constants(project, definitions)) deciding.erase(part);
    }
    emit_components(project, names, deciding, emitted, generated);
    std::vector<DeclPtr> ours = core;
    append_declarations(ours, generated);
    const cspm::NewNames new_names = new_names_of_ours(theirs, ours, names);
    const std::vector<cspm::QualifiedNames> new_names_of_files =
        new_names_of_theirs(files, safe.for_blocks, ours, names);
    for (std::size_t i = 0; i < files.size(); ++i) emitted.names_of_blocks[files[i].file] = new_names_of_files[i].plain;
    const std::string terminated = new_name(new_names, "r__");
    EventMeaning tock{MeaningKind::tock, "one time unit passes", {}, {}};
    if (project.is_timed()) {
        emitted.provenance.events["tock"] = tock;
        // The copy of tock that deadlock checks do not hide.
        emitted.provenance.events[new_name(new_names, "tock'")] = tock;
    }
    emitted.provenance.events[terminated] = {MeaningKind::terminate, "it has terminated", {}, {}};
    std::vector<DeclPtr>& definitions = result.definitions.decls;
    definitions = cspm::rename_declarations(core, new_names);
    for (std::size_t i = 0; i < files.size(); ++i)
        append_declarations(definitions, cspm::rename_declarations(files[i].instantiations, new_names_of_files[i]));
    append_declarations(definitions, cspm::rename_declarations(generated, new_names));
    result.script = result.definitions;
    for (std::size_t i = 0; i < files.size(); ++i)
        append_declarations(
            result.script.decls,
            cspm::rename_declarations(declared_once(files[i].others, result.script.decls), new_names_of_files[i]));
    DeclsOfFiles decls_of_files;
    for (const FileBlocks& file : files) decls_of_files[file.file] = file.others;
    for (const FileBlocks& file : files) check_robotool_names(project, emitted.components, definitions, file.others);
    check_block_claims(project, decls_of_files, emitted.provenance);
    std::vector<Obligation> of_blocks = block_obligations(project, result.script.decls);
    const auto add = [&](std::vector<Obligation> more) {
        for (Obligation& obligation : more) {
            obligation.preparation = cspm::rename_declarations(obligation.preparation, new_names);
            name_claim(project, obligation);
            append_declarations(result.script.decls, obligation.preparation);
            append_declarations(result.script.decls, obligation.assertions);
            result.obligations.push_back(std::move(obligation));
        }
    };
    add(make_obligations(project, names, emitted));
    std::move(of_blocks.begin(), of_blocks.end(), std::back_inserter(result.obligations));
    if (options.core_properties) add(core_properties(project, names, emitted));
    result.captured = captured_names(cspm::rename_declarations(ours, new_names));
    for (const auto& [path, component] : emitted.components)
        result.components.push_back(
            {path, default_process(project, path, component, "D__"), default_process(project, path, component, "O__")});
    result.provenance = std::move(emitted.provenance);
    return result;
}

}  // namespace

Emission emit(const ir::System& system, const ir::Instantiation& instantiation, Time time, const Options& options,
              diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    return emit_with(system, instantiation, time, options, {}, sources, diagnostics);
}

Emission emit_showing(const ir::System& system, const ir::Instantiation& instantiation, const Shown& shown,
                      diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    return emit_with(system, instantiation, Time::timed, {}, shown, sources, diagnostics);
}

}  // namespace robochart::csp_emit
