// SPDX-License-Identifier: Apache-2.0
// See prism_model.hpp.
#include "app/prism/prism_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "base/diagnostics/escape.hpp"
#include "driver/model/pipeline.hpp"
#include "prism/checks/check.hpp"
#include "prism/emit/emit.hpp"
#include "prism/emit/ranges.hpp"
#include "prism/session/experiment.hpp"
#include "prism/syntax/printer.hpp"
#include "prism/syntax/reader.hpp"
#include "prism/syntax/rules.hpp"

namespace robochart::app {
namespace {

std::optional<diagnostics::SourceId> load_text(const std::string& path, const Options& options, LoadedModel& loaded) {
    std::string error;
    const std::optional<diagnostics::SourceId> source = driver::load_input(loaded.sources, path, error);
    if (source)
        record_text(loaded.sources, *source, options);
    else
        loaded.diagnostics.report(prism::rules::unreadable, {}, {diagnostics::escape_for_display(path), error});
    return source;
}

void add(prism::PropertyFile& all, prism::PropertyFile more) {
    all.constants.insert(all.constants.end(), more.constants.begin(), more.constants.end());
    all.labels.insert(all.labels.end(), more.labels.begin(), more.labels.end());
    all.properties.insert(all.properties.end(), more.properties.begin(), more.properties.end());
}

/// Finds the label with which `emit prism` marks states whose steps are omitted. A state with this label must not be
/// reachable.
void note_left_out(std::string_view text, prism::CheckedModel& model) {
    if (!prism_emit::is_of_robochart(text)) return;
    for (const prism::Definition& label : model.labels)
        if (label.name.text == prism_emit::left_out_label) model.left_out = label.body;
}

/// Applies the uniform scheduler, which chooses every combination of commands with equal probability. The result is a
/// dtmc.
void resolve_choices(const Options& options, LoadedModel& loaded) {
    if (loaded.model->kind != prism::ModelKind::mdp) return;
    if (options.probability.scheduler == driver::Scheduler::uniform) {
        loaded.scheduled = true;
        loaded.model->kind = prism::ModelKind::dtmc;
    } else if (options.prism.sampling) {
        throw UsageError("--sim: the model is an mdp, and paths depend on its scheduler: add --scheduler uniform");
    }
}

/// Splits "N=4:6,p=max(1,2)" into its parts. A comma between parentheses separates arguments, not parts.
std::vector<std::string> split_settings(const std::string& list) {
    std::vector<std::string> settings(1);
    int depth = 0;
    for (const char c : list) {
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (c == ',' && depth == 0)
            settings.emplace_back();
        else
            settings.back() += c;
    }
    return settings;
}

/// Adds the constants to the record of the run: those that the files define, and the values that --const gives.
void record_constants(const Options& options, const LoadedModel& loaded) {
    const std::string& model = options.load.inputs.front();
    std::vector<RecordedConstant> constants;
    for (const auto* list : {&loaded.model->constants, &loaded.properties.constants})
        for (const prism::Constant& constant : *list)
            if (constant.value != nullptr)
                constants.push_back({model, constant.name.text, prism::print(constant.value), ValueSource::model});
    for (const std::string& list : options.instantiation.constants)
        for (const std::string& setting : split_settings(list)) {
            const std::size_t equals = std::min(setting.find('='), setting.size());
            constants.push_back({model, setting.substr(0, equals), setting.substr(std::min(equals + 1, setting.size())),
                                 ValueSource::option});
        }
    options.run->recorder().add_constants(constants);
}

}  // namespace

void load_model(const Options& options, LoadedModel& loaded) {
    const auto source = load_text(options.load.inputs.front(), options, loaded);
    if (!source) return;
    const prism::ModelFile model = prism::read_model(loaded.sources, *source, loaded.diagnostics);
    if (loaded.diagnostics.ok() || model.kind_given) loaded.kind = model.kind;
    prism::PropertyFile properties;
    for (std::size_t i = 1; i < options.load.inputs.size(); ++i)
        if (const auto file = load_text(options.load.inputs[i], options, loaded))
            add(properties, prism::read_properties(loaded.sources, *file, loaded.diagnostics));
    for (const std::string& text : options.prism.properties) {
        const auto id = loaded.sources.add("--property", text);
        add(properties, prism::read_properties(loaded.sources, id, loaded.diagnostics));
    }
    if (!loaded.diagnostics.ok()) return;
    loaded.model = prism::check_model(model, loaded.diagnostics);
    if (loaded.model) note_left_out(loaded.sources.source_text(*source), *loaded.model);
    if (loaded.model) resolve_choices(options, loaded);
    if (loaded.model) loaded.properties = prism::check_properties(*loaded.model, properties, loaded.diagnostics);
    if (loaded.model) record_constants(options, loaded);
}

Experiment make_experiment(const LoadedModel& loaded, const Options& options) {
    const std::vector<prism::Constant> of_model = prism::open_constants(loaded.model->constants);
    std::vector<prism::Constant> open = prism::open_constants(loaded.properties.constants);
    open.insert(open.end(), of_model.begin(), of_model.end());
    std::vector<prism::Series> model, properties;
    try {
        for (const std::string& text : options.instantiation.constants)
            for (prism::Series& series : prism::read_series(text, open)) {
                const auto same = [&](const auto& other) { return other.name == series.name; };
                if (std::ranges::any_of(model, same) || std::ranges::any_of(properties, same))
                    throw prism::BadValue(fmt::format("'{}' is given twice", series.name));
                const bool in_model =
                    std::ranges::any_of(of_model, [&](const auto& c) { return c.name.text == series.name; });
                (in_model ? model : properties).push_back(std::move(series));
            }
        return {prism::combinations(model), prism::combinations(properties)};
    } catch (const prism::BadValue& error) {
        throw UsageError(fmt::format("--const {}", error.what()));
    }
}

}  // namespace robochart::app
