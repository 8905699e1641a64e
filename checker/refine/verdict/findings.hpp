// SPDX-License-Identifier: Apache-2.0
// Represents the result of a search before a replay confirms it. The result can be encoded as bytes for use by another
// run of the program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "checker/refine/search/limits.hpp"
#include "checker/refine/search/run.hpp"
#include "checker/refine/search/violation.hpp"

namespace robochart::refine {

/// A violation that the search has found, before a replay confirms it.
struct Violation {
    ViolationKind kind = ViolationKind::trace;
    Run run;
    Run loop;                             ///< divergence: taus from the run's last state back to this state
    std::optional<process::Event> event;  ///< nondeterminism: the event that is both accepted and refused
    bool shortest = true;                 ///< false if a limit has ended the search for a shorter run
};

/// The result of a complete search. Searches of equal systems have equal findings.
struct Findings {
    Statistics statistics;
    std::optional<Violation> violation;
};

/// Encodes the findings. Events are written as their indices in `named`, which must be ascending and contain all of
/// these events.
[[nodiscard]] std::string encode(const Findings&, const process::EventSet& named);
/// Decodes findings. Returns no value if the bytes are not findings with these events and states of `width` words.
[[nodiscard]] std::optional<Findings> decode(std::string_view bytes, const process::EventSet& named, std::size_t width);

}  // namespace robochart::refine
