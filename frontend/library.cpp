// See library.hpp. The texts are compiled in by frontend/CMakeLists.txt.
#include "frontend/library.hpp"

#include <algorithm>
#include <set>

namespace robochart::frontend {

namespace {

/// Core is known everywhere, the toolkits where they are imported.
bool imports(const File& file, std::string_view package) {
    if (package == core_package) return true;
    return std::any_of(file.imports.begin(), file.imports.end(),
                       [&](const Import& import) { return import.name.parts.front() == package; });
}

}  // namespace

void add_toolkits(diagnostics::SourceManager& sources, Model& model, diagnostics::Diagnostics& out) {
    std::set<std::string_view> added;
    for (const auto& file : model.files)
        for (const Toolkit& toolkit : toolkits())
            if (file->package.text() == toolkit.package) added.insert(toolkit.package);  // the project brings its own
    // The list grows while it is walked: toolkits import each other.
    for (std::size_t i = 0; i < model.files.size(); ++i)
        for (const Toolkit& toolkit : toolkits()) {
            if (!imports(*model.files[i], toolkit.package) || !added.insert(toolkit.package).second) continue;
            const auto source =
                sources.add("<library>/" + std::string(toolkit.package) + ".rct", std::string(toolkit.text));
            model.files.push_back(parse(sources, source, false, out));
            model.files.back()->is_library = true;
        }
}

}  // namespace robochart::frontend
