// SPDX-License-Identifier: Apache-2.0
// Finds the ranges of "expand selection": the token, then the constructs that contain it, from inside out. Expressions
// and statements are found in the tree. In text with errors, brackets and declarations are still found.
#include <algorithm>
#include <set>
#include <utility>

#include "editors/server/features/models.hpp"
#include "frontend/syntax/file_visitor.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;

constexpr std::size_t max_depth = 60;

/// The spans that contain one offset.
class Around {
public:
    explicit Around(SourceId source, std::uint32_t offset) : source_(source), offset_(offset) {}

    void add(Span span) {
        const bool holds = span.source == source_ && span.begin <= offset_ && offset_ <= span.end;
        if (holds && span.begin < span.end) spans_.insert({span.end - span.begin, span.begin});
    }

    /// Returns the spans from the smallest outwards, each inside the next. If two spans overlap, the smaller one is
    /// used.
    [[nodiscard]] std::vector<Span> nested_spans() const {
        std::vector<Span> result;
        for (const auto& [length, begin] : spans_) {
            const Span span{source_, begin, begin + length};
            if (result.empty() || (span.begin <= result.back().begin && result.back().end <= span.end))
                result.push_back(span);
            // The answer is nested as deeply as the list, so the depth is limited.
            if (result.size() == max_depth) break;
        }
        return result;
    }

    void visit(const Import& import) { add(import.span); }
    void visit(const Assertion& assertion) { add(assertion.span); }
    void visit(const AssertionParameter&) {}
    void visit(const CspBlock& block) { add(join_spans(block.span, block.text_span)); }
    void visit(const Declaration& declaration) { add(join_spans(declaration.span, declaration.name_span)); }
    void visit(const State& state) {
        add(join_spans(state.span, state.name_span));
        for (const Action& action : state.actions) add(action.span);
    }
    void visit(const InterfaceClause& clause) { add(clause.name.span); }
    void visit(const TypeExpr& type) { add(type.span); }
    void visit(const Expr& expression) { add(expression.span); }
    void visit(const Communication& communication) { add(communication.span); }
    void visit(const Stmt& statement) { add(statement.span); }

    void add_brackets(const TokenStream& stream) {
        std::vector<std::uint32_t> open;
        for (const Token& token : stream.tokens) {
            if (token.kind != TokenKind::symbol) {
                if (token.kind != TokenKind::end) add(token.span);
                continue;
            }
            if (is_opening(token)) open.push_back(token.span.begin);
            if (!is_closing(token) || open.empty()) continue;
            add({source_, open.back(), token.span.end});
            open.pop_back();
        }
        for (const Span& comment : stream.comments) add(comment);
    }

private:
    static bool is_opening(const Token& token) {
        return std::ranges::any_of(std::initializer_list<const char*>{"{", "<{", "(", "(|", "[", "[|", "Set(", "Seq("},
                                   [&](const char* word) { return token.is_word(word); });
    }
    static bool is_closing(const Token& token) {
        return std::ranges::any_of(std::initializer_list<const char*>{"}", ")", "|)", "]", "|]"},
                                   [&](const char* word) { return token.is_word(word); });
    }

    SourceId source_;
    std::uint32_t offset_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> spans_;  ///< length and beginning
};

Json chain_ranges(const std::vector<Span>& spans, const SourceManager& sources, Encoding encoding) {
    Json result;
    for (auto span = spans.rbegin(); span != spans.rend(); ++span) {
        Json inner = Json::object({{"range", lsp_range(sources, *span, encoding)}});
        if (!result.is_null()) inner["parent"] = std::move(result);
        result = std::move(inner);
    }
    return result;
}

}  // namespace

Json Models::selection_ranges(const Request& request) {
    const Target target = target_of(request);
    const SourceManager& sources = target.project.sources();
    const SourceId source = target.document.source;
    const Encoding encoding = session_.client.encoding;
    diagnostics::Diagnostics ignored;
    const TokenStream stream = tokenize(sources, source, target.document.is_assertions, ignored);
    const File& file = target.project.tree_of(target.document);
    Json result = Json::array();
    for (const View position : request.params["positions"].items()) {
        const std::uint32_t offset = offset_of(sources, source, position, encoding);
        Around around(source, offset);
        around.add({source, 0, static_cast<std::uint32_t>(sources.source_text(source).size())});
        around.add_brackets(stream);
        Traversal(around).visit_file(file);
        std::vector<Span> spans = around.nested_spans();
        if (spans.empty()) spans.push_back({source, offset, offset});
        result.push_back(chain_ranges(spans, sources, encoding));
    }
    return result;
}

}  // namespace robochart::lsp
