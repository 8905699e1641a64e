// SPDX-License-Identifier: Apache-2.0
// See toolkits.hpp. The texts are compiled in by frontend/CMakeLists.txt.
#include "frontend/toolkits/toolkits.hpp"

#include <algorithm>
#include <set>

#include "frontend/syntax/parse.hpp"

namespace robochart::frontend {

namespace {

/// True if the package is core, which is always visible, or if the file imports it.
bool imports_package(const File& file, std::string_view package) {
    if (package == core_package) return true;
    return std::ranges::any_of(file.imports,
                               [&](const Import& import) { return import.name.parts.front() == package; });
}

/// Returns the source of a toolkit. The first call adds the text to `sources`.
diagnostics::SourceId text_of(const Toolkit& toolkit, diagnostics::SourceManager& sources) {
    const std::string path = "<library>/" + std::string(toolkit.package) + ".rct";
    for (std::uint32_t i = 0; i < sources.size(); ++i)
        if (sources.path(diagnostics::SourceId{i}) == path) return diagnostics::SourceId{i};
    return sources.add(path, std::string(toolkit.text));
}

std::vector<std::unique_ptr<File>> take_libraries(Model& model) {
    const auto first = std::stable_partition(model.files.begin(), model.files.end(),
                                             [](const auto& file) { return !file->is_library; });
    std::vector<std::unique_ptr<File>> taken(std::make_move_iterator(first),
                                             std::make_move_iterator(model.files.end()));
    model.files.erase(first, model.files.end());
    return taken;
}

}  // namespace

void add_toolkits(diagnostics::SourceManager& sources, Model& model, diagnostics::Diagnostics& out) {
    std::vector<std::unique_ptr<File>> had = take_libraries(model);
    std::set<std::string_view> added;
    for (const auto& file : model.files)
        for (const Toolkit& toolkit : all_toolkits())
            // The project itself contains this package.
            if (file->package.text() == toolkit.package) added.insert(toolkit.package);
    // The list grows during the iteration, because toolkits import each other.
    for (std::size_t i = 0; i < model.files.size(); ++i)
        for (const Toolkit& toolkit : all_toolkits()) {
            if (!imports_package(*model.files[i], toolkit.package) || !added.insert(toolkit.package).second) continue;
            const auto previous =
                std::ranges::find_if(had, [&](const auto& f) { return f && f->package.text() == toolkit.package; });
            model.files.push_back(previous != had.end() ? std::move(*previous)
                                                        : parse(sources, text_of(toolkit, sources), false, out));
            model.files.back()->is_library = true;
        }
}

}  // namespace robochart::frontend
