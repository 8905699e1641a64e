// SPDX-License-Identifier: Apache-2.0
// Determines what may be written at the cursor from the tokens before it.
#include "editors/server/features/completion_context.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>

namespace robochart::lsp {

namespace {

using frontend::Token;
using frontend::TokenKind;
using Tokens = std::deque<Token>;

bool is_among(const Token& token, std::initializer_list<std::string_view> words) {
    return (token.kind == TokenKind::keyword || token.kind == TokenKind::symbol) &&
           std::ranges::find(words, token.text) != words.end();
}

bool is_name(const Token& token) {
    return token.kind == TokenKind::identifier;
}

// ---------------------------------------------------------------- enclosing bodies

struct HeadRow {
    std::string_view word;
    Block block;
    bool top_level;  ///< true if allowed only at file level, so earlier bodies were not closed
    bool part;       ///< true if allowed only at file level and in controllers and modules
};
constexpr std::array<HeadRow, 14> heads = {{{"interface", Block::interface, true, true},
                                            {"enumeration", Block::type, true, true},
                                            {"datatype", Block::type, true, true},
                                            {"record", Block::type, true, true},
                                            {"function", Block::function, true, true},
                                            {"module", Block::module, true, true},
                                            {"robotic", Block::platform, false, true},
                                            {"controller", Block::controller, false, true},
                                            {"stm", Block::machine, false, true},
                                            {"operation", Block::operation, false, true},
                                            {"state", Block::state, false, false},
                                            {"final", Block::state, false, false},
                                            {"transition", Block::transition, false, false},
                                            {"context", Block::interface, false, false}}};  // of RoboSim

const HeadRow* head_row(const Token& token) {
    if (token.kind != TokenKind::keyword) return nullptr;
    for (const HeadRow& row : heads)
        if (row.word == token.text) return &row;
    return nullptr;
}

/// The bodies that contain the end of a list of tokens. A missing brace is detected when a token cannot occur in the
/// current body.
class Bodies {
public:
    std::vector<Enclosing> enclosing_bodies(const Tokens& words) {
        open_ = {{Block::file, {}, 0}};
        for (std::size_t i = 0; i < words.size(); ++i) read_word(words, i);
        return open_;
    }

private:
    void read_word(const Tokens& words, std::size_t i) {
        const Token& token = words[i];
        if (const HeadRow* row = head_row(token)) return enter_head(words, i, *row);
        if (is_among(token, {"{", "<{"})) {
            const bool body = head_ && token.is_word("{");
            open_.push_back({body ? head_->block : Block::bracket, body ? head_->name : Span(), i + 1});
            head_.reset();
        } else if (token.is_word("}")) {
            if (open_.size() > 1) open_.pop_back();
            head_.reset();
        } else if (is_among(token, {"entry", "during", "exit", "var", "const", "event", "uses", "requires", "provides",
                                    "trigger", "initial", "junction", "connection", "import", "clock"})) {
            head_.reset();
            close_brackets();
        }
    }

    void enter_head(const Tokens& words, std::size_t i, const HeadRow& row) {
        const std::size_t name = i + (row.block == Block::platform ? 2 : 1);
        close_brackets();
        if (row.top_level) open_.resize(1);
        while (open_.size() > 1 && !may_hold(open_.back().block, row)) open_.pop_back();
        head_ = {row.block, name < words.size() ? words[name].span : Span(), 0};
    }

    static bool may_hold(Block block, const HeadRow& row) {
        if (row.part) return block == Block::controller || block == Block::module;
        return block == Block::machine || block == Block::operation || block == Block::state;
    }
    void close_brackets() {
        while (open_.size() > 1 && open_.back().block == Block::bracket) open_.pop_back();
    }

    std::vector<Enclosing> open_;
    std::optional<Enclosing> head_;
};

// ---------------------------------------------------------------- the expected construct

/// The tokens before the cursor, and queries about them.
class Reader {
public:
    Reader(const Tokens& words, bool is_assertions, CompletionContext& context)
        : words_(words), is_assertions_(is_assertions), context_(context) {}

    void run() {
        std::size_t end = words_.size();
        if (end > 0 && token_before(end).is_word("::"))
            end = read_qualifier(end);
        else if (end > 0 && token_before(end).is_word(".") && !is_assertions_)
            return member_step(end);
        context_.expected = is_assertions_ ? in_assertions(end) : wanted_at(end);
        read_binders(end);
    }

private:
    [[nodiscard]] const Token& token_before(std::size_t end, std::size_t back = 1) const {
        static const Token none;
        return end >= back ? words_[end - back] : none;
    }
    [[nodiscard]] const Enclosing& innermost_body() const { return context_.enclosing.back(); }

    /// Reads `A::B::` before the end; returns the index of its first token.
    std::size_t read_qualifier(std::size_t end) {
        while (end >= 2 && token_before(end).is_word("::") && is_name(token_before(end, 2))) {
            context_.qualifier.insert(context_.qualifier.begin(), std::string(token_before(end, 2).text));
            end -= 2;
        }
        return end;
    }

    /// Reads `a[1].f.`. After an event's name and `.`, a value is expected.
    void member_step(std::size_t end) {
        std::vector<std::string> steps;
        while (end > 0 && token_before(end).is_word(".")) {
            --end;
            while (end > 0 && token_before(end).is_word("]")) {
                std::size_t open = 0;
                do {
                    --end;
                    if (words_[end].is_word("]")) ++open;
                    if (words_[end].is_word("[")) --open;
                } while (end > 0 && open > 0);
                steps.insert(steps.begin(), std::string());
            }
            if (end == 0 || !is_name(token_before(end))) return;
            steps.insert(steps.begin(), std::string(token_before(end).text));
            --end;
        }
        context_.value = std::move(steps);
        context_.expected = Wanted::expression;
        read_binders(end);
    }

    /// Returns the last token before the end that begins a clause of the body; the beginning of the body if there is
    /// none.
    [[nodiscard]] std::size_t clause_begin(std::size_t end) const {
        std::size_t begin = 0;
        for (const Enclosing& enclosing : context_.enclosing)
            if (enclosing.block != Block::bracket) begin = enclosing.begin;
        for (std::size_t i = end; i > begin; --i)
            if (is_among(words_[i - 1], {"from",   "trigger", "probability", "condition",    "action",       "entry",
                                         "during", "exit",    "uses",        "requires",     "provides",     "var",
                                         "const",  "event",   "clock",       "connection",   "import",       "sref",
                                         "cref",   "rref",    "opref",       "precondition", "postcondition"}))
                return i - 1;
        return begin;
    }
    [[nodiscard]] bool in_clause(std::size_t end, std::initializer_list<std::string_view> clauses) const {
        const std::size_t at = clause_begin(end);
        return at < end && is_among(words_[at], clauses);
    }

    /// True if the tokens between a `:` and the end are the beginning of a type that is not complete.
    [[nodiscard]] bool in_type(std::size_t end) const {
        for (std::size_t i = end; i > 0; --i) {
            const Token& token = words_[i - 1];
            if (token.is_word(":")) return true;
            const bool link = is_among(token, {"*", "->", "<->", "Set(", "Seq(", "(", "::", "vector", "matrix"});
            const bool operand = is_name(token) || token.is_word(")");
            const bool complete = i == end && operand;
            if ((!link && !operand) || complete) return false;
        }
        return false;
    }

    [[nodiscard]] bool is_operand_end(const Token& token) const {
        switch (token.kind) {
            case TokenKind::identifier:
            case TokenKind::integer:
            case TokenKind::real:
            case TokenKind::string:
                return true;
            case TokenKind::end:
            case TokenKind::keyword:
            case TokenKind::symbol:
            case TokenKind::csp_code:
                break;
        }
        return is_among(token, {")", "]", "}", "|)", "|]", "true", "false", "result", "end", "skip"});
    }

    [[nodiscard]] Wanted wanted_at(std::size_t end) {
        if (end == 0 || ends_import(end)) return Wanted::member;
        const Token& token = token_before(end);
        if (const auto fixed = by_word(end, token)) return *fixed;
        if (in_type(end)) return Wanted::type;
        if (token.is_word("{") && innermost_body().begin == end && innermost_body().block != Block::bracket)
            return Wanted::member;
        if (token.is_word("=") && is_among(token_before(end, 3), {"sref", "cref", "rref", "opref"})) {
            context_.word = std::string(token_before(end, 3).text);
            return Wanted::reference;
        }
        if (token.is_word(",")) return after_comma(end);
        if (token.is_word("?")) return Wanted::variable;
        if (token.is_word("(")) return after_bracket(end);
        if (is_operand_end(token)) return after_operand(end);
        return Wanted::expression;
    }

    /// True after `import p::*`.
    [[nodiscard]] bool ends_import(std::size_t end) const {
        return token_before(end).is_word("*") && token_before(end, 2).is_word("::");
    }

    /// Returns the expected construct, if the last token alone decides it.
    [[nodiscard]] std::optional<Wanted> by_word(std::size_t end, const Token& token) {
        const bool in_transition = innermost_body().block == Block::transition;
        if (token.is_word("from") && in_transition) return Wanted::source;
        if (token.is_word("to")) {
            if (in_transition && in_clause(end, {"from"})) return Wanted::target;
            return in_clause(end, {"connection"}) ? Wanted::connection_node : Wanted::expression;
        }
        if (token.is_word("on")) return on_node(end);
        if (is_among(token, {"trigger", "send"})) return Wanted::event;
        if (is_among(token, {"uses", "requires", "provides"})) return Wanted::interface;
        if (token.is_word("connection")) return Wanted::connection_node;
        if (token.is_word("import")) return Wanted::import;
        if (token.is_word("#")) return Wanted::clock;
        if (is_among(token, {"action", "entry", "during", "exit", ";"})) return Wanted::statement;
        if (is_among(token, {"then", "else"})) return Wanted::branch;
        if (token.is_word("as") || token.is_word("is")) return Wanted::type;
        if (is_among(token,
                     {"package",       "diagram",    "stm",    "state",       "initial",  "final",      "junction",
                      "probabilistic", "transition", "event",  "var",         "const",    "clock",      "interface",
                      "type",          "datatype",   "record", "enumeration", "function", "controller", "module",
                      "platform",      "operation",  "sref",   "cref",        "rref",     "opref",      "forall",
                      "exists",        "exists1",    "lambda", "the",         "let"}))
            return Wanted::nothing;
        if (is_among(token, {"robotic", "terminates"})) return Wanted::member;
        return std::nullopt;
    }

    [[nodiscard]] Wanted on_node(std::size_t end) {
        std::size_t at = end - 1;
        while (at > 0 && (is_name(words_[at - 1]) || words_[at - 1].is_word("::"))) {
            if (is_name(words_[at - 1])) context_.path.insert(context_.path.begin(), std::string(words_[at - 1].text));
            --at;
        }
        return Wanted::connection_event;
    }

    [[nodiscard]] Wanted after_bracket(std::size_t end) const {
        if (token_before(end, 2).is_word("since")) return Wanted::clock;
        if (token_before(end, 2).is_word("sinceEntry")) return Wanted::state;
        // Parameters of a declaration have new names. All other brackets contain values.
        if (is_name(token_before(end, 2)) && is_among(token_before(end, 3), {"operation", "function"}))
            return Wanted::nothing;
        const bool declares = innermost_body().block == Block::interface || innermost_body().block == Block::platform;
        if (innermost_body().block == Block::type) return Wanted::type;
        return declares ? Wanted::nothing : Wanted::expression;
    }

    [[nodiscard]] Wanted after_comma(std::size_t end) const {
        if (in_clause(end, {"uses", "requires", "provides"})) return Wanted::interface;
        const std::size_t open = open_bracket(end);
        if (open == end) return in_clause(end, {"var", "const"}) ? Wanted::nothing : Wanted::expression;
        return words_[open].is_word("(") ? after_bracket(open + 1) : Wanted::expression;
    }

    /// Returns the innermost bracket of the clause that is still open; `end` if there is none.
    [[nodiscard]] std::size_t open_bracket(std::size_t end) const {
        int depth = 0;
        for (std::size_t i = end; i > clause_begin(end); --i) {
            if (is_among(words_[i - 1], {")", "]", "|)", "|]"})) --depth;
            if (is_among(words_[i - 1], {"(", "[", "(|", "[|", "Set(", "Seq("})) ++depth;
            if (depth > 0) return i - 1;
        }
        return end;
    }

    /// Returns what may follow a complete operand. In the transition `t { from A`, only clauses may follow. Elsewhere,
    /// an operator or the next member may follow.
    [[nodiscard]] Wanted after_operand(std::size_t end) {
        if (innermost_body().block == Block::transition) {
            const std::size_t at = clause_begin(end);
            context_.word = at < end && words_[at].kind == TokenKind::keyword ? std::string(words_[at].text) : "";
            for (std::size_t i = at; i < end; ++i)
                if (context_.word == "from" && words_[i].is_word("to")) context_.word = "to";
        }
        return Wanted::continuation;
    }

    // Assertion files

    [[nodiscard]] bool is_any_word(const Token& token, std::initializer_list<std::string_view> words) const {
        const bool any_word = token.kind == TokenKind::identifier || token.kind == TokenKind::keyword;
        return any_word && !token.escaped && std::ranges::find(words, token.text) != words.end();
    }

    [[nodiscard]] Wanted in_assertions(std::size_t end) const {
        if (end == 0 || ends_import(end)) return Wanted::member;
        const Token& token = token_before(end);
        if (token.kind == TokenKind::csp_code) return Wanted::member;
        if (is_any_word(token, {"import"})) return Wanted::import;
        if (is_any_word(token, {"assertion", "csp", "package"})) return Wanted::nothing;
        if (is_any_word(token, {"timed", "untimed"})) return Wanted::member;
        if (token.is_word(":") ||
            is_any_word(token, {"in", "refines", "refine", "equals", "of", "clock", "constant", "parameter"}))
            return Wanted::component;
        if (is_any_word(token, {"to"}) && is_any_word(token_before(end, 2), {"conforms", "conform"}))
            return Wanted::rule;
        if (is_any_word(token, {"to"}) && is_any_word(token_before(end, 2), {"associated", "equal"}))
            return Wanted::component;
        if (is_any_word(token, {"is", "not", "does"})) return Wanted::property;
        if (token.is_word(",") && !has_associated(end)) return Wanted::expression;
        if (token.is_word(",")) return Wanted::component;
        if (is_any_word(token, {"to", "assigned", "value"}) || (token.kind == TokenKind::symbol && !token.is_word(")")))
            return Wanted::expression;
        return Wanted::continuation;
    }
    [[nodiscard]] bool has_associated(std::size_t end) const {
        for (std::size_t i = end; i > 0 && !words_[i - 1].first_on_line; --i)
            if (is_any_word(words_[i - 1], {"associated"})) return true;
        return false;
    }

    /// Reads `forall x : T | …`, `let y == e @ …`: the names before `:` or `==` in the clause.
    void read_binders(std::size_t end) {
        for (std::size_t i = clause_begin(end); i + 1 < end; ++i) {
            const bool binds =
                i > 0 && is_among(words_[i - 1], {"forall", "exists", "exists1", "lambda", "the", "let", "{", ","});
            if (binds && is_name(words_[i]) && (words_[i + 1].is_word(":") || words_[i + 1].is_word("==")))
                context_.bound.emplace_back(words_[i].text);
        }
    }

    const Tokens& words_;
    bool is_assertions_;
    CompletionContext& context_;
};

bool is_inside(const Span& span, std::uint32_t offset) {
    return span.begin < offset && offset < span.end;
}

}  // namespace

CompletionContext context_at(const SourceManager& sources, SourceId source, bool is_assertions, std::uint32_t offset) {
    diagnostics::Diagnostics ignored;
    frontend::TokenStream stream = frontend::tokenize(sources, source, is_assertions, ignored);
    CompletionContext context;
    context.prefix = {source, offset, offset};
    const std::string_view text = sources.source_text(source);
    for (const Span& comment : stream.comments) {
        const bool line_comment = text.substr(comment.begin, 2) == "//";
        if (is_inside(comment, offset) || (line_comment && comment.end == offset)) return context;
    }
    Tokens before;
    for (const Token& token : stream.tokens) {
        if (token.kind == TokenKind::end || token.span.begin >= offset) break;
        const bool word = token.kind == TokenKind::identifier || token.kind == TokenKind::keyword;
        if (word && offset <= token.span.end) {
            context.prefix.begin = token.span.begin;
            break;
        }
        const bool open = token.kind == TokenKind::string || token.kind == TokenKind::csp_code;
        if (open && is_inside(token.span, offset)) return context;
        const bool number = token.kind == TokenKind::integer || token.kind == TokenKind::real;
        if (number && token.span.end == offset) return context;
        before.push_back(token);
    }
    context.enclosing = Bodies().enclosing_bodies(before);
    Reader(before, is_assertions, context).run();
    return context;
}

}  // namespace robochart::lsp
