// The layout of each construct (private to the formatter). The words are read a second time, after the parser found
// them free of mistakes: what this reading does not foresee would be laid out badly, but no word can be lost, as every
// word is written when it is read and the result is compared with the text (format.cpp).
//
// Methods are named after what they lay out and take the gap to leave before it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/format/format_document.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// The text between two words.
enum class Gap : std::uint8_t {
    done,    ///< written already
    none,    ///< nothing
    blank,   ///< a blank
    soft,    ///< nothing, or a line end if the group breaks
    line,    ///< a blank, or a line end if the group breaks
    open,    ///< the same after an opening brace
    first,   ///< a line end after an opening brace
    member,  ///< a line end; an empty line is kept
    block,   ///< a line end and an empty line
    start,   ///< the beginning of the text
};

class Layout {
public:
    /// `verbatim`: lengths of the PRISM parts of an assertion file, in order.
    Layout(std::string_view text, const TokenStream& stream, bool is_assertions, std::vector<std::size_t> verbatim);

    [[nodiscard]] std::string run(std::string_view line_end);

private:
    using Part = Doc (Layout::*)(Gap);

    // Words (format.cpp)
    [[nodiscard]] Token peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at(std::string_view word) const { return peek().is(word); }
    [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name() const { return peek().kind == TokenKind::identifier; }
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    [[nodiscard]] bool at_closing() const;
    [[nodiscard]] std::string_view source(diagnostics::Span span) const;
    Doc token(Gap gap);
    Doc advance();
    Doc names(Gap gap);
    Doc words(Gap gap, std::size_t count);
    Doc cat(std::initializer_list<Doc> docs) { return doc_.cat(docs); }
    /// A group whose gap stands before it.
    Doc group(Doc gap, Doc inner) { return doc_.cat(gap, doc_.group(inner)); }

    // Gaps and comments (format_comments.cpp)
    struct Piece {
        diagnostics::Span span;
        std::size_t lines;      ///< line ends before it, at most 2
        bool to_line_end;       ///< `// …`
        bool is_token = false;  ///< the word itself
    };
    Doc gap(Gap gap);
    Doc closing_comments();
    [[nodiscard]] std::vector<Piece> pieces();
    Doc separator(Gap gap, std::size_t lines);
    Doc inline_comments(Gap gap, const std::vector<Piece>& pieces);
    Doc own_lines(Gap gap, const std::vector<Piece>& pieces, std::size_t trailing);
    Doc following(Gap gap, const Piece& before, const Piece& piece);
    Doc trailing(const std::vector<Piece>& pieces, std::size_t count);
    Doc comment(const Piece& piece);
    Doc comment_line(std::string_view line, std::size_t margin, bool moved);
    [[nodiscard]] std::optional<std::string_view> margin(std::size_t offset) const;
    [[nodiscard]] std::size_t line_ends(std::size_t begin, std::size_t end) const;
    [[nodiscard]] bool may_touch() const;

    // Files, declarations, types (format_declarations.cpp)
    Doc member(Gap gap);
    Doc declaration(Gap gap);
    Doc braces(Part part, Gap inside, Gap between);
    Doc members(Part part, Gap inside, Gap between);
    Doc list(Gap gap, Part element);
    Doc elements(Gap first, Part element);
    Doc block(Gap gap);
    Doc operation(Gap gap);
    Doc enumeration(Gap gap);
    Doc record(Gap gap);
    Doc literal(Gap gap);
    Doc phrase(Gap gap);
    Doc import(Gap gap);
    Doc interfaces(Gap gap);
    Doc variables(Gap gap);
    Doc variable(Gap gap);
    Doc typed(Gap gap);
    Doc event(Gap gap);
    Doc signature(Gap gap);
    Doc reference(Gap gap);
    Doc connection(Gap gap);
    Doc contract(Gap gap);
    Doc type(Gap gap);
    Doc atomic_type(Gap gap);
    Doc type_or_size(Gap gap);
    [[nodiscard]] bool opens_block() const;

    // Machines (format_machines.cpp)
    Doc state(Gap gap);
    Doc action(Gap gap);
    Doc action_body();
    Doc transition(Gap gap);
    Doc clauses(Gap gap);
    Doc clause(Gap gap, bool trigger_before);
    Doc deadline(Gap gap);

    // Statements (format_statements.cpp)
    Doc statement(Gap gap);
    Doc sequence(Gap gap);
    Doc timed_statement(Gap gap);
    Doc basic_statement(Gap gap);
    Doc conditional(Gap gap, Part branch);
    Doc communication(Gap gap);
    Doc predicate();

    // Expressions (format_expressions.cpp)
    static constexpr int value_level = 12;  ///< of what follows `!` and `.`: no operators; above every operand of one
    Doc expression(Gap gap);
    Doc operand(Gap gap, int level);
    Doc prefix(int level);
    Doc chain(Doc left, int level);
    Doc infix(int level);
    Doc binder(int level);
    Doc bindings(Gap gap);
    Doc binding(Gap gap);
    Doc negation();
    Doc postfix();
    Doc atom();
    Doc sequence_element(Gap gap);
    Doc sequence_with_set();
    Doc set_element(Gap gap);
    Doc field(Gap gap);
    [[nodiscard]] int operator_level() const;
    [[nodiscard]] bool at_step() const;

    // Assertion files (format_assertions.cpp)
    Doc assertion_member(Gap gap);
    Doc assertion(Gap gap);
    Doc assertion_body();
    Doc property();
    Doc hyphenated();
    Doc parameters();
    Doc parameter(Gap gap);
    Doc csp_block(Gap gap);
    Doc verbatim(Gap gap);

    std::string_view text_;
    const TokenStream& stream_;
    bool is_assertions_;
    std::vector<std::size_t> verbatim_;
    Document doc_;
    std::size_t at_ = 0;
    std::size_t comment_ = 0;       ///< the next comment to be written
    std::size_t verbatim_at_ = 0;   ///< the next PRISM part
    std::size_t previous_end_ = 0;  ///< offset behind the last word
    bool after_block_ = false;      ///< the last member had a body of several lines
};

}  // namespace robochart::frontend
