// What a search has found, before it is confirmed and reported; as text, so that another run can take it up.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "checker/refine/search/limits.hpp"
#include "checker/refine/search/run.hpp"
#include "checker/refine/search/violation.hpp"

namespace robochart::refine {

/// What the search claims to have found.
struct Violation {
    ViolationKind kind = ViolationKind::trace;
    Run run;
    Run loop;                             ///< divergence: taus from the run's last state back to it
    std::optional<process::Event> event;  ///< nondeterminism: the event that is both accepted and refused
    bool shortest = true;                 ///< else a limit has ended the search for a shorter run
};

/// What a search that came to an end has found. Equal systems give equal findings.
struct Findings {
    Statistics statistics;
    std::optional<Violation> violation;
};

/// The findings as bytes. Events are written as their places in `named`, which is ascending and has all of them.
[[nodiscard]] std::string encode(const Findings&, const process::EventSet& named);
/// The findings again; none where the bytes are no findings with these events and states of `width` words.
[[nodiscard]] std::optional<Findings> decode(std::string_view bytes, const process::EventSet& named, std::size_t width);

}  // namespace robochart::refine
