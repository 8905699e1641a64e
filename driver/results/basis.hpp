// SPDX-License-Identifier: Apache-2.0
// The basis of a verdict lists the facts on which the verdict depends in addition to the model: assumptions, reached
// limits, and situations that no run reaches. The code that decides a claim makes this list. Every output format shows
// the list with the verdict, and no option hides it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "counterexample/run.hpp"

namespace robochart::driver {

/// The kind of an entry of the basis.
enum class GroundKind : unsigned char {
    guard,          ///< untimed: the parts of a condition that read clocks were assumed to be true
    bound,          ///< a bound of the finite instantiation was reached
    no_time,        ///< timed: the specification never allows time to pass
    time_stops,     ///< time can stop, and nothing is required after that
    ended,          ///< the component can terminate, and nothing is required after that
    never_at_rest,  ///< refusals were not compared, because the component never becomes stable
    never_asked,    ///< no run reaches the subject of the claim
    constant,       ///< probabilistic: the value of a constant was chosen, because nothing sets it
    sampling,       ///< probabilistic: random paths were used, and not all states were explored
    carriers,       ///< the claim is about values of carriers, not about classes of values
};

/// Returns the name of the kind in data formats: "guard", "noTime".
[[nodiscard]] std::string_view name_of(GroundKind);

/// An entry of the basis.
struct Ground {
    GroundKind kind = GroundKind::bound;
    std::string text;     ///< the fact, without a place
    std::string element;  ///< an element of the model, "P::S::t1"; "" if the entry is about the whole claim
    std::string place;    ///< "model.rct:12"; "" if the entry has no place
    std::optional<runs::Place> region;  ///< the same place with its end
    std::string remedy;                 ///< how to avoid the entry; "" if there is no remedy

    friend auto operator<=>(const Ground&, const Ground&) = default;
};

/// The basis of one verdict, in the order of display, without duplicates.
using Basis = std::vector<Ground>;

/// Adds an entry unless it exists already.
void add(Basis&, Ground);

/// Returns the span as a region with its end; no value if the span is unknown.
[[nodiscard]] std::optional<runs::Place> region_of(const diagnostics::SourceManager&, diagnostics::Span);

/// Sets the place and the region of an entry.
void set_place(const diagnostics::SourceManager&, diagnostics::Span, Ground&);

/// Returns the entry as text with its place: "the bound was met (model.rct:12)".
[[nodiscard]] std::string ground_text(const Ground&);

/// Returns readable lines, with at most `most` entries of each kind. If several entries have the same remedy, the
/// remedy follows these entries only once.
[[nodiscard]] std::vector<std::string> basis_lines(const Basis&, std::size_t most);

}  // namespace robochart::driver
