// SPDX-License-Identifier: Apache-2.0
// See models_beside.hpp.
#include "editors/server/claims/models_beside.hpp"

#include <filesystem>
#include <set>
#include <utility>

#include "base/diagnostics/files.hpp"
#include "frontend/project/project.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::lsp {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const std::string& folder, std::string_view ending) {
    std::vector<std::string> result;
    for (const std::string& path : diagnostics::files_below(folder, false).files)
        if (path.ends_with(ending)) result.push_back(path);
    return result;
}

namespace {

std::string signature_of(const std::vector<std::string>& paths) {
    std::string result;
    for (const std::string& path : paths) {
        std::error_code error;
        const auto time = fs::last_write_time(path, error).time_since_epoch().count();
        result += path + ' ' + std::to_string(fs::file_size(path, error)) + ' ' + std::to_string(time) + '\n';
    }
    return result;
}

void load_models(const std::vector<std::string>& paths, diagnostics::Budget* budget, ClaimedModels& result) {
    diagnostics::Diagnostics findings;  // the editor shows them in the models
    findings.set_budget(budget);
    const auto model = frontend::load_project(result.sources, paths, findings);
    if (!findings.ok()) return;
    std::set<std::string> packages;
    for (const auto& file : model->files)
        if (!file->is_library) packages.insert(file->package.text());
    result.packages.assign(packages.begin(), packages.end());
    result.system = ir::lower(*model, result.sources, findings);
    if (!findings.ok()) return;
    result.components = claims::components_of(result.system);
    result.good = true;
}

}  // namespace

NamePlace name_place(std::string_view text_before) {
    const auto begin_of = [&](std::string_view more) {
        std::size_t begin = text_before.size();
        const auto in_name = [&](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                   more.find(c) != std::string_view::npos;
        };
        while (begin > 0 && in_name(text_before[begin - 1])) --begin;
        return begin;
    };
    NamePlace result;
    std::size_t begin = begin_of(":");
    result.qualifier = text_before.substr(begin);
    text_before = text_before.substr(0, begin);
    text_before = text_before.substr(0, text_before.find_last_not_of(" \t\n\r") + 1);
    begin = begin_of("");
    result.word = text_before.substr(begin);
    return result;
}

std::vector<std::string> states_after(const std::string& qualifier, const ClaimedModels& models) {
    std::set<std::string> result;
    for (const ir::Machine& machine : models.system.machines)
        for (const ir::Node& node : machine.nodes)
            if (machine.kind == ir::MachineKind::state_machine && node.kind == ir::NodeKind::state &&
                node.path.starts_with(qualifier))
                result.insert(node.path.substr(qualifier.size()));
    return {result.begin(), result.end()};
}

const ClaimedModels* ModelsBeside::find(const std::string& path, diagnostics::Budget* budget) {
    if (!path.starts_with('/')) return nullptr;
    const fs::path folder = fs::path(path).parent_path();
    std::vector<std::string> models = files_in(folder.string(), ".rct");
    if (models.empty()) models = files_in(folder.parent_path().string(), ".rct");
    if (models.empty()) return nullptr;
    const std::string signature = signature_of(models);
    std::unique_ptr<ClaimedModels>& known = models_[folder.string()];
    if (known == nullptr || known->signature != signature) {
        auto loaded = std::make_unique<ClaimedModels>();
        loaded->signature = signature;
        load_models(models, budget, *loaded);
        known = std::move(loaded);
    }
    return known->good ? known.get() : nullptr;
}

}  // namespace robochart::lsp
