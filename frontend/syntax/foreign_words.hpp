// Words of other notations (UML and SCXML, Stateflow, UPPAAL, PRISM, programming languages) that people write in
// models, with what RoboChart has instead: one table for the reader and for the resolution of names; and a table of
// forms of several words, for the reader.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "diagnostics/advice/advice.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// Where in a model a word stands.
enum class ForeignPlace {
    declaration,  ///< begins a declaration of a file
    member,       ///< begins a member of a machine, controller, platform or interface
    state_part,   ///< begins a part of a state
    clause,       ///< begins a clause of a transition
    statement,    ///< begins a statement and has another word behind it
    if_end,       ///< ends an `if`
    infix,        ///< stands between two expressions
    type,         ///< names a type
    value,        ///< names a value
    operation,    ///< names an operation that is called
    event,        ///< names an event, alone as a statement
};

/// One row.
struct ForeignWord {
    std::string_view word;
    ForeignPlace place;
    /// What is written instead, a word of the grammar or of core; "": no word alone, the reason says what to do.
    std::string_view instead;
    std::string_view reason;  ///< a sentence without full stop
    bool left_out = false;    ///< without the word the text is right
};

/// The row of a word in a place; null if there is none.
[[nodiscard]] const ForeignWord* foreign_word(std::string_view word, ForeignPlace place);
/// All rows, for the tests.
[[nodiscard]] std::span<const ForeignWord> foreign_words();

/// What is said beside a syntax error about a form that is of another notation, or not complete.
[[nodiscard]] std::span<const diagnostics::Advice> foreign_forms();
/// A word of a text for tables of advice; outside the text its end.
[[nodiscard]] diagnostics::AdviceWord advice_word(const TokenList&, std::ptrdiff_t index);

}  // namespace robochart::frontend
