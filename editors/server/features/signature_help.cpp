// SPDX-License-Identifier: Apache-2.0
// Shows the parameters of the call at the cursor.
#include <algorithm>

#include "editors/server/features/completion_context.hpp"
#include "editors/server/features/models.hpp"
#include "editors/server/workspace/describe.hpp"
#include "editors/server/workspace/visible.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;

/// A call whose bracket is still open at the place.
struct Call {
    std::string name;
    std::size_t argument = 0;
};

Call call_at(const SourceManager& sources, const Document& document, std::uint32_t offset) {
    diagnostics::Diagnostics ignored;
    const TokenStream stream = tokenize(sources, document.source, document.is_assertions, ignored);
    std::vector<Call> open;
    Token before;
    for (const Token& token : stream.tokens) {
        if (token.span.begin >= offset) break;
        const bool opens = token.is_word("(") || token.is_word("[") || token.is_word("{") || token.is_word("(|") ||
                           token.is_word("[|") || token.is_word("Set(") || token.is_word("Seq(") || token.is_word("<{");
        const bool closes = token.is_word(")") || token.is_word("]") || token.is_word("}") || token.is_word("|)") ||
                            token.is_word("|]");
        const bool called = before.kind == TokenKind::identifier && token.is_word("(");
        if (opens) open.push_back({called ? std::string(before.text) : std::string(), 0});
        if (closes && !open.empty()) open.pop_back();
        if (token.is_word(",") && !open.empty()) ++open.back().argument;
        before = token;
    }
    return open.empty() ? Call() : open.back();
}

const std::vector<VariablePtr>* parameters_of(const Declaration& declaration) {
    if (const auto* function = dynamic_cast<const Function*>(&declaration)) return &function->parameters;
    if (const auto* signature = dynamic_cast<const OperationSignature*>(&declaration)) return &signature->parameters;
    return nullptr;
}

/// Finds the called operation or function. Prefers operations of the component that contains the place.
const Declaration* find_callee(Project& project, const Document& document, std::uint32_t offset,
                               const std::string& name) {
    const File& file = project.tree_of(document);
    const CompletionContext context = context_at(project.sources(), document.source, document.is_assertions, offset);
    for (auto enclosing = context.enclosing.rbegin(); enclosing != context.enclosing.rend(); ++enclosing)
        if (const Declaration* around = declared_at(file, enclosing->name))
            for (const Declaration* member : members_of(*around))
                if (member->name == name && parameters_of(*member) != nullptr) return member;
    for (const Declaration* declaration : visible_from(project.current_model(), file))
        if (declaration->name == name && parameters_of(*declaration) != nullptr) return declaration;
    return nullptr;
}

}  // namespace

Json Models::signature_help(const Request& request) {
    const Target target = target_of(request);
    const Call call = call_at(target.project.sources(), target.document, target.offset);
    if (call.name.empty()) return {};
    const Declaration* found = find_callee(target.project, target.document, target.offset, call.name);
    if (found == nullptr) return {};
    Json parameters = Json::array();
    for (const VariablePtr& parameter : *parameters_of(*found)) {
        std::string label = parameter->name;
        if (parameter->type_expr) label += " : " + to_text(*parameter->type_expr);
        parameters.push_back(Json::object({{"label", std::move(label)}}));
    }
    return Json::object(
        {{"signatures",
          Json::array({Json::object({{"label", signature_text(*found)}, {"parameters", std::move(parameters)}})})},
         {"activeSignature", 0},
         {"activeParameter", call.argument}});
}

}  // namespace robochart::lsp
