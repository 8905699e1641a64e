// What a verdict rests on beside the model: what was assumed, limited or never asked on the way to it. Whoever decides
// a claim makes the list; every format shows it with the verdict, and no option hides it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/source.hpp"
#include "runs/run.hpp"

namespace robochart::app {

/// What kind of thing a verdict rests on.
enum class GroundKind : unsigned char {
    guard,          ///< untimed: the parts of a condition that read clocks were taken for true
    bound,          ///< a bound of the finite instantiation was met
    no_time,        ///< timed: the specification never lets time pass
    time_stops,     ///< time can stop, and nothing is owed after that
    ended,          ///< the component can come to its end, and nothing is owed after that
    never_at_rest,  ///< what is refused was not compared, since the component does not come to rest
    never_asked,    ///< no run comes to what the claim asks about
};

/// As data: "guard", "noTime".
[[nodiscard]] std::string_view name_of(GroundKind);

/// One thing that a verdict rests on.
struct Ground {
    GroundKind kind = GroundKind::bound;
    std::string text;                   ///< what is so, without place
    std::string element;                ///< of the model: "P::S::t1"; "": of the claim as a whole
    std::string place;                  ///< "model.rct:12"; "" if it has none
    std::optional<runs::Place> region;  ///< the same with its end
    std::string remedy;                 ///< what to do if it is not meant; "" if there is nothing to do

    friend auto operator<=>(const Ground&, const Ground&) = default;
};

/// All that one verdict rests on, in the order in which it is shown; nothing twice.
using Basis = std::vector<Ground>;

/// Adds it unless it is there.
void add(Basis&, Ground);

/// Where it stands.
void set_place(const diagnostics::SourceManager&, diagnostics::Span, Ground&);

/// "the bound was met (model.rct:12)".
[[nodiscard]] std::string ground_text(const Ground&);

/// Lines for people, at most `most` grounds of a kind; a remedy once, behind the grounds that share it.
[[nodiscard]] std::vector<std::string> basis_lines(const Basis&, std::size_t most);

}  // namespace robochart::app
