// See unread_definitions.hpp.
#include "csp_emit/unread_definitions.hpp"

#include <fmt/format.h>

#include <map>

#include "csp_emit/base/rules.hpp"
#include "diagnostics/spelling.hpp"

namespace robochart::csp_emit {
namespace {

using DefinitionsByName = std::map<std::string, std::vector<const cspm::Decl*>>;

/// Of the blocks Instantiations, by name: a function has several clauses.
DefinitionsByName definitions_of(const std::vector<FileBlocks>& files) {
    DefinitionsByName result;
    for (const FileBlocks& file : files)
        for (const cspm::DeclPtr& decl : file.instantiations)
            for (const std::string& name : user_names({decl}).all) result[name].push_back(decl.get());
    return result;
}

/// Named as RoboTool names carriers and constants.
bool is_of_instantiations(const std::string& name) {
    return name.starts_with("core_") || name.starts_with("const_");
}

}  // namespace

void check_instantiations_read(const Project& project, const std::vector<FileBlocks>& files,
                               const std::set<std::string>& known, const std::vector<std::string>& left_out) {
    for (const auto& [name, clauses] : definitions_of(files)) {
        if (known.count(name) != 0 || project.occurrences(name) > clauses.size()) continue;
        const std::string meant = diagnostics::nearest(name, left_out);
        if (meant.empty() && !is_of_instantiations(name)) continue;
        project.diagnostics.report(rules::definition_unread, clauses.front()->span,
                                   {name, meant.empty() ? std::string() : fmt::format("; did you mean '{}'?", meant)});
    }
}

}  // namespace robochart::csp_emit
