// SPDX-License-Identifier: Apache-2.0
// Writes a process term with its definitions as text for a certificate (docs/certificates.md, "Terms").
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "base/diagnostics/pollable.hpp"
#include "checker/process/term.hpp"

namespace robochart::certify {

/// A term as text, or the reason why it cannot be written.
struct TermText {
    std::optional<std::string> text;
    std::string reason;  ///< "" if there is a text
};

/// A term with more definitions than this is not written.
inline constexpr std::size_t most_definitions = 500'000;

/// Returns true if a process has at most `most_explicit_states` states (process_text.hpp).
using HasFewStates = std::function<bool(process::TermId)>;

/// Returns the text of a term. The operators at the top of the term that stay while their operands move are written in
/// place, so the certifier makes rules of them. All other terms become definitions, which the certifier explores as
/// components. If a component contains parallel operators and does not have few states, there is no text. Polls the
/// budget, and passes on errors of the evaluation and of `has_few_states`.
[[nodiscard]] TermText term_text(process::TermStore& terms, process::TermId term, const HasFewStates& has_few_states,
                                 diagnostics::Pollable& budget);

}  // namespace robochart::certify
