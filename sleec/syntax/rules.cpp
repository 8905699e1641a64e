// SPDX-License-Identifier: Apache-2.0
// See rules.hpp.
#include "sleec/syntax/rules.hpp"

#include <array>

namespace robochart::sleec::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unexpected_token{
    "SLEEC-P01", Severity::error, "expected {}, found {}",
    "The text does not follow the grammar of SLEEC here. Definitions are between def_start and def_end, and rules "
    "between rule_start and rule_end: NAME when EVENT and CONDITION then EVENT within 5 seconds."};
const Rule bad_character{"SLEEC-P02", Severity::error, "no token of SLEEC begins with {}",
                         "SLEEC consists of ASCII letters, digits and operators. Other characters are allowed only in "
                         "comments: // to the end of the line, or /* ... */."};
const Rule open_comment{"SLEEC-P03", Severity::error, "this comment is not closed",
                        "A comment that begins with /* ends with */."};
const Rule big_number{"SLEEC-P04", Severity::error, "the number {} is too large",
                      "The greatest number is 1,000,000,000: in seconds that is more than thirty years."};
const Rule too_deep{
    "SLEEC-P05", Severity::error, "nested too deeply (the limit is {} levels)",
    "The depth of conditions and responses is limited, so that hostile input cannot exhaust the stack."};
const Rule not_supported{"SLEEC-P06", Severity::error, "this tool does not support {}",
                         "Rules, concerns and purposes are supported. Relations between events and measures, which "
                         "only LEGOS has, and a few of its words are rejected."};
const Rule unreadable{"SLEEC-P07", Severity::error, "cannot read '{}': {}",
                      "The file of rules does not exist, is not a file, or cannot be read."};
const Rule other_dialect{
    "SLEEC-P08", Severity::warning, "{} does not belong to the dialect of {}, in which this file is written",
    "SLEEC has two dialects. A file is in the dialect of LEGOS if it contains a construct that only LEGOS reads, such "
    "as a measure in braces. Then constructs that only the other tool reads are reported."};
const Rule extension{"SLEEC-P09", Severity::note, "{}: an extension of this tool, in neither dialect of SLEEC",
                     "SLEEC-TK and LEGOS do not read this form."};
const Rule mixed_operators{"SLEEC-P10", Severity::warning,
                           "'and' and 'or' have the same precedence and are read from the left: this is {}",
                           "In SLEEC 'c or a and b' means '(c or a) and b', unlike in most languages. Add parentheses "
                           "to show which reading is intended."};

std::span<const Rule* const> syntax_rule_table() {
    static constexpr std::array<const Rule*, 10> table{
        &unexpected_token, &bad_character, &open_comment,  &big_number, &too_deep,
        &not_supported,    &unreadable,    &other_dialect, &extension,  &mixed_operators};
    return table;
}

}  // namespace robochart::sleec::rules
