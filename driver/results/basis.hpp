// SPDX-License-Identifier: Apache-2.0
// The basis of a verdict lists the facts on which the verdict depends besides the model: assumptions, reached limits,
// and situations that no run reaches. The code that decides a claim makes the list. Every format shows it with the
// verdict, and no option hides it.
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
    guard,          ///< untimed: parts of a condition that read clocks were taken as true
    bound,          ///< a bound of the finite instantiation was reached
    no_time,        ///< timed: the specification never lets time pass
    time_stops,     ///< time can stop, and nothing is required after that
    ended,          ///< the component can terminate, and nothing is required after that
    never_at_rest,  ///< refusals were not compared, because the component never becomes stable
    never_asked,    ///< no run reaches the subject of the claim
    constant,       ///< probabilistic: a constant has a chosen value, because nothing gives it one
    sampling,       ///< probabilistic: random paths, not all states
    carriers,       ///< the claim is about the values of carriers; other claims are about classes of values
};

/// The kind as a word in data formats: "guard", "noTime".
[[nodiscard]] std::string_view name_of(GroundKind);

/// An entry of the basis.
struct Ground {
    GroundKind kind = GroundKind::bound;
    std::string text;                   ///< the fact, without a place
    std::string element;                ///< of the model: "P::S::t1"; "": of the whole claim
    std::string place;                  ///< "model.rct:12"; "" if it has none
    std::optional<runs::Place> region;  ///< the same place with its end
    std::string remedy;                 ///< what to do if it is not intended; "" if there is nothing to do

    friend auto operator<=>(const Ground&, const Ground&) = default;
};

/// The basis of one verdict, in the order of display, without duplicates.
using Basis = std::vector<Ground>;

/// Adds an entry unless it exists already.
void add(Basis&, Ground);

/// The region of a span with its end; no value if it is unknown.
[[nodiscard]] std::optional<runs::Place> region_of(const diagnostics::SourceManager&, diagnostics::Span);

/// Sets the place.
void set_place(const diagnostics::SourceManager&, diagnostics::Span, Ground&);

/// "the bound was met (model.rct:12)".
[[nodiscard]] std::string ground_text(const Ground&);

/// Lines for people, with at most `most` entries of a kind. A remedy is printed once, after the entries that share it.
[[nodiscard]] std::vector<std::string> basis_lines(const Basis&, std::size_t most);

}  // namespace robochart::driver
