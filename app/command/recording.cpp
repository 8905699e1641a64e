// SPDX-License-Identifier: Apache-2.0
// Finds the files of a project, and the value of each constant with its source (ValueSource).
#include "app/command/recording.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "app/command/run.hpp"
#include "app/command/run_record.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "counterexample/values.hpp"
#include "cpp_emit/plan/types.hpp"
#include "prism/emit/emit.hpp"
#include "prism/emit/preferences.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/own_constants.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace {

/// Returns the NAME of each NAME=VALUE.
std::vector<std::string> names_set_by(const std::vector<std::string>& settings) {
    std::vector<std::string> names;
    for (const std::string& setting : settings) names.push_back(setting.substr(0, setting.find('=')));
    return names;
}

bool is_named(const std::string& path, const std::vector<std::string>& names) {
    return std::ranges::any_of(names, [&](const std::string& name) { return ir::is_named_by(path, name); });
}

/// Returns the source of the values that --const overrides.
ValueSource weaker_source(const Options& options) {
    if (!options.swarm.file.empty()) return ValueSource::swarm;
    return options.conform.traces.empty() ? ValueSource::scenario : ValueSource::log;
}

/// Returns the values that the model gives to its constants, by the constant's name in scripts.
std::map<std::string, ir::Value> values_in_model(const ir::System& system, const ir::Instantiation& finite) {
    std::map<std::string, ir::Value> values;
    const auto add = [&](const std::string& package, const std::string& path, const ir::Constant& constant,
                         const ir::Machine* machine) {
        if (constant.value == nullptr) return;
        if (auto value = ir::evaluate_constant(system, finite, machine, *constant.value))
            values.emplace(ir::constant_name(package, path, constant.name), std::move(*value));
    };
    for (const ir::Machine& machine : system.machines)
        for (const ir::Constant& constant : machine.constants) add(machine.package, machine.path, constant, &machine);
    for (const ir::Controller& controller : system.controllers) {
        for (const ir::Constant& constant : controller.constants)
            add(controller.package, controller.path, constant, nullptr);
        const auto add_part = [&](const std::string& part, const ir::Machine& machine) {
            for (const ir::Constant& constant : machine.constants)
                add(controller.package, controller.path + "::" + part, constant, &machine);
        };
        for (const auto& part : controller.machines) add_part(part.name, system.machine(part.machine));
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            add_part(controller.definition_names.at(i), system.machine(controller.definitions[i]));
    }
    for (const ir::Module& module : system.modules)
        for (const ir::Constant& constant : module.platform.constants)
            add(module.package, module.name, constant, nullptr);
    return values;
}

/// The value of a constant, and its source.
struct Found {
    ValueSource source = ValueSource::model;
    std::string value;
};

class ConstantsInForce {
public:
    ConstantsInForce(const driver::Project& project, const driver::InstantiationSettings& used, const Options& options)
        : project_(project),
          by_options_(names_set_by(used.constants)),
          by_weaker_(names_set_by(used.weaker_constants)),
          weaker_(weaker_source(options)),
          of_machines_(ir::own_constants(project.system)),
          in_model_(values_in_model(project.system, project.instantiation)) {
        for (const ir::NamedConstant& constant : ir::named_constants(project.system)) add(constant);
    }

    /// Returns all constants, except constants of a component in a controller that have the same value as the
    /// component's own constant.
    [[nodiscard]] std::vector<RecordedConstant> take() {
        std::vector<RecordedConstant> result;
        for (const ir::NamedConstant& constant : named_) {
            const Found& found = found_.at(constant.name);
            if (const auto own = of_machines_.find(constant.name); own != of_machines_.end())
                if (const auto machine = found_.find(own->second);
                    machine != found_.end() && machine->second.value == found.value)
                    continue;
            result.push_back({project_.name, constant.path, found.value, found.source});
        }
        return result;
    }

private:
    void add(const ir::NamedConstant& constant) {
        named_.push_back(constant);
        found_.emplace(constant.name, Found{source(constant), value(constant)});
        if (is_named(constant.path, by_options_) || is_named(constant.path, by_weaker_))
            paths_set_.emplace(constant.name, constant.path);
    }

    [[nodiscard]] ValueSource source(const ir::NamedConstant& constant) const {
        if (is_named(constant.path, by_options_)) return ValueSource::option;
        if (is_named(constant.path, by_weaker_)) return weaker_;
        // A value that an option gives to a component's own constant also applies to the component in a controller.
        if (const auto own = of_machines_.find(constant.name); own != of_machines_.end())
            if (const auto path = paths_set_.find(own->second); path != paths_set_.end())
                return is_named(path->second, by_options_) ? ValueSource::option : weaker_;
        return constant.has_value ? ValueSource::model : ValueSource::by_default;
    }

    /// Returns the value as text, or "not computed" if it is an expression that only the script evaluates.
    [[nodiscard]] std::string value(const ir::NamedConstant& constant) const {
        const auto& chosen = project_.instantiation.constants;
        if (const auto at = chosen.find(constant.name); at != chosen.end()) return text(constant, at->second);
        if (const auto at = in_model_.find(constant.name); at != in_model_.end()) return text(constant, at->second);
        return "not computed";
    }

    [[nodiscard]] std::string text(const ir::NamedConstant& constant, const ir::Value& value) const {
        return runs::value_text(project_.system, project_.instantiation, constant.type,
                                cpp_emit::cspm_value(project_.system, constant.type, value));
    }

    const driver::Project& project_;
    std::vector<std::string> by_options_, by_weaker_;
    ValueSource weaker_;
    std::map<std::string, std::string> of_machines_;
    std::map<std::string, ir::Value> in_model_;
    std::vector<ir::NamedConstant> named_;
    std::map<std::string, Found> found_;
    std::map<std::string, std::string> paths_set_;
};

RecordedRange carrier(const driver::Project& project, const char* type, const std::vector<std::int64_t>& numbers,
                      std::int64_t scale, ValueSource source) {
    RecordedRange range{project.name, type, 0, 0, numbers.size(), source};
    if (numbers.empty()) return range;
    range.low = static_cast<double>(numbers.front()) / static_cast<double>(scale);
    range.high = static_cast<double>(numbers.back()) / static_cast<double>(scale);
    return range;
}

RecordedRange between(const driver::Project& project, const std::string& type, std::int64_t low, std::int64_t high,
                      ValueSource source) {
    return {project.name,
            type,
            static_cast<double>(low),
            static_cast<double>(high),
            static_cast<std::uint64_t>(high - low) + 1,
            source};
}

std::vector<RecordedRange> ranges_in_force(const driver::Project& project, const Options& options) {
    const ir::Instantiation& finite = project.instantiation;
    const auto source = [&](const char* type) {
        if (!project.asked.ranges.contains(type)) return ValueSource::by_default;
        const bool by_swarm = !options.swarm.file.empty() && !options.run->recorder().has_range_option(type);
        return by_swarm ? ValueSource::swarm : ValueSource::option;
    };
    return {carrier(project, "nat", finite.nat, 1, source("nat")),
            carrier(project, "int", finite.integer, 1, source("int")),
            carrier(project, "real", finite.real, finite.scale, source("real")),
            between(project, "Seq", 0, finite.sequence_bound, source("Seq")),
            between(project, "clock", 0, finite.clock_bound, source("clock")),
            between(project, "given", 0, finite.given_size - 1, source("given"))};
}

/// True for the texts of libraries and for scripts that are part of the program.
bool is_library(const std::string& path) {
    return path.starts_with("<library>/");
}

/// Records the files of SLEEC rules in the folders of the assertion files, because claims about rules refer to them.
void record_claimed_rules(const driver::Project& project, RunRecorder& recorder) {
    std::set<std::string> folders;
    for (const ir::Property& property : project.system.properties)
        if (!property.rule.empty()) folders.insert(std::filesystem::path(property.file).parent_path().string());
    for (const std::string& folder : folders) {
        std::set<std::string> files;
        std::error_code code;
        std::filesystem::directory_iterator at(folder.empty() ? "." : folder, code);
        for (const std::filesystem::directory_iterator end; !code && at != end; at.increment(code))
            if (at->path().extension() == ".sleec") files.insert(at->path().lexically_normal().string());
        for (const std::string& file : files) recorder.add_input_file(file);
    }
}

/// Records the ranges of RoboTool's preferences, which replace those of the instantiation. Errors in the file are
/// reported when the file is used.
void record_preferences(const driver::Project& project, const Options& options) {
    std::string error;
    diagnostics::SourceManager sources;
    const auto source = sources.load_file(options.probability.preferences, error);
    prism_emit::Preferences preferences = prism_emit::preferences_of(project.instantiation);
    if (!source || !prism_emit::read_preferences(sources.source_text(*source), preferences).empty()) return;
    RunRecorder& recorder = options.run->recorder();
    const auto record = [&](const char* type, const prism_emit::Range& range) {
        if (!range.asked) return;  // the file does not set this range
        recorder.remove_range(project.name, type);
        recorder.add_ranges({between(project, type, range.low, range.high, ValueSource::preferences)});
    };
    record("nat", preferences.nat);
    record("int", preferences.integer);
    record("real", preferences.real);
}

bool has_probabilistic_claims(const driver::Project& project) {
    return std::ranges::any_of(project.model->files,
                               [](const auto& file) { return !file->probabilistic_assertions.empty(); });
}

}  // namespace

void record_text(const diagnostics::SourceManager& sources, diagnostics::SourceId source, const Options& options) {
    options.run->recorder().add_input(sources.path(source), sources.source_text(source));
}

void record_texts(const diagnostics::SourceManager& sources, const Options& options) {
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (const auto source = static_cast<diagnostics::SourceId>(i); !is_library(sources.path(source)))
            record_text(sources, source, options);
}

void record_projects(const std::vector<driver::Part>& parts, const driver::Settings& used, const Options& options) {
    for (const driver::Part& part : parts) record_project(*part.project, used, options);
}

void record_project(const driver::Project& project, const driver::Settings& used, const Options& options) {
    record_texts(project.sources, options);
    if (!project.diagnostics.ok() || !project.model) return;
    RunRecorder& recorder = options.run->recorder();
    recorder.add_constants(ConstantsInForce(project, used.instantiation, options).take());
    recorder.add_ranges(ranges_in_force(project, options));
    record_claimed_rules(project, recorder);
    if (!options.probability.preferences.empty()) record_preferences(project, options);
    if (decides_assertions(options.verb) && has_probabilistic_claims(project)) recorder.set_seed(used.probability.seed);
}

void record_block_values(const driver::Project& project, const Options& options) {
    if (project.scripts.empty() || !project.diagnostics.ok()) return;
    const cspm::Script& definitions = project.scripts.rbegin()->second.definitions;  // the timed script, if it exists
    static const std::map<std::string, std::string> carriers{
        {"core_nat", "nat"}, {"core_int", "int"}, {"core_real", "real"}, {"core_clock_type", "clock"}};
    RunRecorder& recorder = options.run->recorder();
    const bool code_too = options.verb == Verb::verify;
    std::map<std::string, const ir::NamedConstant*> named;
    const std::vector<ir::NamedConstant> all = ir::named_constants(project.system);
    for (const ir::NamedConstant& constant : all) named.emplace(constant.name, &constant);
    std::vector<RecordedConstant> found;
    for (const cspm::DeclPtr& decl : definitions.decls) {
        if (!decl->span.is_known()) continue;  // generated, not written in a block
        if (decl->kind == cspm::DeclKind::nametype) {
            const auto carrier = carriers.find(decl->names.front());
            if (carrier == carriers.end()) continue;
            if (!code_too) recorder.remove_range(project.name, carrier->second);
            found.push_back({project.name, carrier->first, cspm::print(decl->body), ValueSource::block});
        }
        if (decl->kind != cspm::DeclKind::value) continue;
        const cspm::PatternPtr& pattern = decl->patterns.front().front();
        if (pattern->kind != cspm::PatternKind::name) continue;
        const auto constant = named.find(pattern->text);
        if (constant == named.end()) continue;
        const std::string& path = constant->second->path;
        if (!code_too) recorder.remove_constant(project.name, path);
        found.push_back(
            {project.name, path,
             runs::value_text(project.system, project.instantiation, constant->second->type, cspm::print(decl->body)),
             ValueSource::block});
    }
    recorder.add_constants(found);
}

}  // namespace robochart::app
