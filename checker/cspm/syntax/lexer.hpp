// SPDX-License-Identifier: Apache-2.0
// Converts CSPM text to tokens by FDR's layout rule. A line end is a token, with two exceptions: the token before it
// cannot end an expression, or the token after it cannot begin an expression or a declaration.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cspm {

enum class Tok : std::uint8_t {
    // clang-format off
    end, newline, bad,
    identifier, integer, character, string, property, print, include,
    // words
    kw_false, kw_true, kw_and, kw_or, kw_not, kw_if, kw_then, kw_else, kw_let, kw_within,
    kw_channel, kw_assert, kw_datatype, kw_subtype, kw_external, kw_transparent, kw_nametype,
    kw_module, kw_exports, kw_endmodule, kw_instance, kw_timed,
    // brackets
    l_paren, r_paren, l_pipe_brace, r_pipe_brace, l_brace, r_brace, l_map, r_map,
    l_double_square, r_double_square, l_pipe_square, r_pipe_square, l_square, r_square,
    empty_sequence,
    // operators
    refines_t, refines_f, refines_fd, refines_v, refines_vd, refines_r, refines_rd,
    external_choice, internal_choice, interleave, interrupt, arrow, sliding, exception_end, parallel_bar,
    semicolon, ampersand, project, l_sync_interrupt, r_sync_interrupt, l_sync_choice, r_sync_choice,
    equal_equal, not_equal, less_equal, greater_equal, less, greater,
    pipe, comma, dot_dot, dot, question, exclamation, dollar, drawn_from, tie, scope, of_type, colon,
    yield_star, yield, double_at, at, equals, backslash, plus, minus, times, divide, modulus, concat, hash, underscore,
    // clang-format on
};

struct Token {
    Tok kind = Tok::end;
    diagnostics::Span span;
    std::string_view text;    ///< the text of the token in the script
    std::int64_t number = 0;  ///< value of an integer, code of a character
};

/// Returns all tokens of a text; the last one has the kind `end`. Reports malformed tokens and skips them.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&);

/// Returns true for characters that names may contain after the first one.
[[nodiscard]] bool continues_name(char c);

/// Returns how messages refer to a token: its text in quotes, or a description.
[[nodiscard]] std::string_view spelling(Tok kind);

}  // namespace robochart::cspm
