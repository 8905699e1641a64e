// "check" above each assertion: a command that the editor runs, since checks may take long.
#include "lsp/features/capabilities.hpp"
#include "lsp/features/features.hpp"

namespace robochart::lsp {

Json code_lenses(Session& session, View params) {
    const Target target = target_of(session, params);
    Json result = Json::array();
    for (const frontend::Assertion& each : target.project.tree(target.document).assertions) {
        // The parser gives a name to those that have none.
        if (each.name_span.begin == each.name_span.end) continue;
        const Json command = Json::object({{"title", "check"},
                                           {"command", check_command},
                                           {"arguments", Json::array({target.document.uri, each.name})}});
        result.push_back(
            Json::object({{"range", range(target.project.sources(), each.name_span, session.client.encoding)},
                          {"command", command}}));
    }
    return result;
}

}  // namespace robochart::lsp
