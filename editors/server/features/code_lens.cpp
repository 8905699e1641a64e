// SPDX-License-Identifier: Apache-2.0
// Offers commands in the text: "check" above each assertion, "draw" and "step" above each module, controller and
// machine. The editor runs the commands, because they may take a long time and need the editor's windows.

#include "editors/server/features/capabilities.hpp"
#include "editors/server/features/models.hpp"
#include "frontend/diagrams/notation/subjects.hpp"

namespace robochart::lsp {

namespace {

/// The lenses of one document. A lens contains a command that the editor supports, with the document's URI and a name
/// as arguments.
class Lenses {
public:
    Lenses(const Session& session, const Target& target) : session_(session), target_(target) {}

    Json find() {
        for (const frontend::Assertion& assertion : target_.project.tree_of(target_.document).assertions)
            // For an assertion without a name, the parser generates a name with an empty span.
            if (assertion.name_span.begin != assertion.name_span.end)
                add("check", check_command, assertion.name_span, assertion.name);
        for (const auto& assertion : target_.project.tree_of(target_.document).probabilistic_assertions)
            if (assertion.name_span.begin != assertion.name_span.end)
                add("check", check_command, assertion.name_span, assertion.name);
        for (const diagrams::Subject& subject :
             diagrams::find_subjects(target_.project.current_model(), target_.project.sources())) {
            if (!is_component(subject)) continue;
            add("draw", draw_command, subject.component->name_span, subject.name);
            add("step", step_command, subject.component->name_span, subject.name);
        }
        return std::move(result_);
    }

private:
    /// True for a component of the document that has a process.
    [[nodiscard]] bool is_component(const diagrams::Subject& subject) const {
        if (subject.component == nullptr || subject.component->span.source != target_.document.source) return false;
        const Span name = subject.component->name_span;
        const frontend::DeclKind kind = subject.component->kind;
        return name.begin != name.end &&
               (kind == frontend::DeclKind::module || kind == frontend::DeclKind::controller ||
                kind == frontend::DeclKind::state_machine);
    }
    void add(const char* title, const char* command, Span place, const std::string& name) {
        if (!session_.client.commands.contains(command)) return;
        const Json run = Json::object(
            {{"title", title}, {"command", command}, {"arguments", Json::array({target_.document.uri, name})}});
        result_.push_back(Json::object(
            {{"range", lsp_range(target_.project.sources(), place, session_.client.encoding)}, {"command", run}}));
    }

    const Session& session_;
    const Target target_;
    Json result_ = Json::array();
};

}  // namespace

Json Models::code_lenses(const Request& request) {
    return Lenses(session_, target_of(request)).find();
}

}  // namespace robochart::lsp
