// The numbers that occur in a model, by type: what widens the carriers and sets the scale (semantics 3.13).
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Number literals by the type they are used with. Literals that are only a wait duration, a deadline or an operand of
/// a comparison with since() are numbers of time units, not values that a variable holds: they count for the scale
/// alone. Numbers that only say which element or field is meant count for nothing.
struct Literals {
    std::set<std::int64_t> nat, integer;
    std::vector<Decimal> real;                         ///< values
    std::vector<Decimal> real_time;                    ///< durations
    std::set<diagnostics::ForeignText> strings;        ///< texts
    std::map<std::int64_t, diagnostics::Span> places;  ///< where a whole number first occurs
    std::set<std::string> durations;                   ///< as durations() has them
};

[[nodiscard]] Literals literals_of(const System&);
/// The constants, by their names, that are used, and nowhere but as a whole duration or beside since(): their values
/// are numbers of time units too. Constants of one name are taken for one: that is how a required constant gets its
/// value.
[[nodiscard]] std::set<std::string> durations(const System&);
/// Adds the literals of one expression; `time`: it is a duration as a whole.
void add_literals(const System&, const Expr&, bool time, Literals&);

}  // namespace robochart::ir
