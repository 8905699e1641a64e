// SPDX-License-Identifier: Apache-2.0
// Finds the callers of an operation, and the calls in an operation or machine. As in go-to-definition, a call refers to
// every operation with the name of the called signature.
#include <algorithm>
#include <utility>

#include "editors/server/features/models.hpp"
#include "editors/server/workspace/describe.hpp"
#include "frontend/syntax/file_visitor.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;

struct CallSite {
    const Machine* caller;
    const Declaration* callee;
    Span span;
};

/// The calls and the operations of a project, sorted by file and place.
struct CallGraph {
    std::vector<CallSite> calls;
    std::vector<const Machine*> operations;

    void visit(const Machine& machine) {
        current_ = &machine;
        if (machine.kind == DeclKind::operation) operations.push_back(&machine);
    }
    void visit(const Stmt& statement) {
        if (statement.kind == StmtKind::call && statement.declaration != nullptr && current_ != nullptr)
            calls.push_back({current_, statement.declaration, statement.name.span});
    }
    template <class Node>
    void visit(const Node&) {}

    /// Returns the operations that a call may run; the signature if no operation is defined.
    [[nodiscard]] std::vector<const Declaration*> definitions_of(const Declaration& callee) const {
        std::vector<const Declaration*> result;
        for (const Machine* operation : operations)
            if (operation->name == callee.name) result.push_back(operation);
        if (result.empty()) result.push_back(&callee);
        return result;
    }

private:
    const Machine* current_ = nullptr;
};

CallGraph call_graph(Project& project) {
    CallGraph graph;
    for (const auto& file : project.current_model().files)
        if (!file->is_library) Traversal(graph).visit_file(*file);
    return graph;
}

Json hierarchy_item(const Session& session, Project& project, const Declaration& declaration) {
    Json place = lsp_location(session, project, join_spans(declaration.span, declaration.name_span));
    if (place.is_null()) return {};
    return Json::object(
        {{"name", declaration.name},
         {"kind", symbol_kind(declaration)},
         {"detail", signature_text(declaration)},
         {"uri", std::move(place["uri"])},
         {"range", std::move(place["range"])},
         {"selectionRange", lsp_range(project.sources(), declaration.name_span, session.client.encoding)}});
}

/// Returns the operation, signature or machine whose name is at the place; null if there is none.
const Declaration* callable_at(const Target& target) {
    const Occurrence* name = target.project.occurrence_at(target.document.source, target.offset);
    if (name == nullptr || name->target == nullptr) return nullptr;
    const DeclKind kind = name->target->kind;
    const bool callable =
        kind == DeclKind::operation || kind == DeclKind::operation_signature || kind == DeclKind::state_machine;
    return callable ? name->target : nullptr;
}

/// The places of calls, grouped by the other end, in the order of the first call.
class Ends {
public:
    Ends(const Session& session, Project& project, const char* key) : session_(session), project_(project), key_(key) {}

    void add(const Declaration& end, Span call) {
        auto found = std::ranges::find(ends_, &end, &std::pair<const Declaration*, Json>::first);
        if (found == ends_.end()) found = ends_.insert(found, {&end, Json::array()});
        found->second.push_back(lsp_range(project_.sources(), call, session_.client.encoding));
    }
    [[nodiscard]] Json take_calls() {
        Json result = Json::array();
        for (auto& [end, ranges] : ends_) {
            Json shown = hierarchy_item(session_, project_, *end);
            if (!shown.is_null())
                result.push_back(Json::object({{key_, std::move(shown)}, {"fromRanges", std::move(ranges)}}));
        }
        return result;
    }

private:
    const Session& session_;
    Project& project_;
    const char* key_;
    std::vector<std::pair<const Declaration*, Json>> ends_;
};

}  // namespace

Json Models::prepare_call_hierarchy(const Request& request) {
    const Target target = target_of(request);
    const Declaration* found = callable_at(target);
    if (found == nullptr) return {};
    std::vector<const Declaration*> shown = {found};
    if (found->kind == DeclKind::operation_signature) shown = call_graph(target.project).definitions_of(*found);
    Json result = Json::array();
    for (const Declaration* declaration : shown)
        if (Json made = hierarchy_item(session_, target.project, *declaration); !made.is_null())
            result.push_back(std::move(made));
    return result;
}

Json Models::incoming_calls(const Request& request) {
    const Target target = target_of(request);
    const Declaration* callee = callable_at(target);
    Ends callers(session_, target.project, "from");
    if (callee != nullptr && callee->kind != DeclKind::state_machine)
        for (const CallSite& call : call_graph(target.project).calls)
            if (call.callee->name == callee->name) callers.add(*call.caller, call.span);
    return callers.take_calls();
}

Json Models::outgoing_calls(const Request& request) {
    const Target target = target_of(request);
    const Declaration* caller = callable_at(target);
    const CallGraph graph = call_graph(target.project);
    Ends callees(session_, target.project, "to");
    for (const CallSite& call : graph.calls)
        if (call.caller == caller)
            for (const Declaration* definition : graph.definitions_of(*call.callee))
                callees.add(*definition, call.span);
    return callees.take_calls();
}

}  // namespace robochart::lsp
