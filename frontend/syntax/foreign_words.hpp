// SPDX-License-Identifier: Apache-2.0
// Lists words of other notations (UML and SCXML, Stateflow, UPPAAL, PRISM, programming languages) that authors use in
// models, with RoboChart's equivalents. The parser and name resolution share one table of words. The parser uses a
// second table for forms that consist of several words.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "base/advice/advice.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// The position of a word in a model.
enum class ForeignPlace {
    declaration,  ///< begins a declaration of a file
    member,       ///< begins a member of a machine, controller, platform or interface
    state_part,   ///< begins a part of a state
    clause,       ///< begins a clause of a transition
    statement,    ///< begins a statement and is followed by another word
    if_end,       ///< ends an `if`
    infix,        ///< occurs between two expressions
    type,         ///< names a type
    value,        ///< names a value
    operation,    ///< names an operation that is called
    event,        ///< names an event and is a whole statement
};

/// A row of the table.
struct ForeignWord {
    std::string_view word;
    ForeignPlace place;
    /// The equivalent: a word of the grammar or of package core. If there is no single equivalent word, it is "", and
    /// the reason explains what to write.
    std::string_view instead;
    std::string_view reason;  ///< why the word is wrong: a sentence without a full stop
    bool left_out = false;    ///< the text is correct without the word
};

/// Returns the row for a word at a place, or null if there is none.
[[nodiscard]] const ForeignWord* foreign_word(std::string_view word, ForeignPlace place);
/// Returns all rows, for tests.
[[nodiscard]] std::span<const ForeignWord> foreign_words();

/// Returns the advice that is added to a syntax error if the text has a form of another notation, or an incomplete
/// form.
[[nodiscard]] std::span<const diagnostics::Advice> foreign_forms();
/// Returns the token at an index, for tables of advice. If the index is outside the text, the result is the end token.
[[nodiscard]] diagnostics::AdviceWord advice_word(const TokenList&, std::ptrdiff_t index);

}  // namespace robochart::frontend
