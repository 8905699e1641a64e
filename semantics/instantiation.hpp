// Making a model finite: carriers of the basic types, values of constants, the scale of reals.
// Defaults follow RoboTool's generated instantiations.csp (docs/semantics.md, "Instantiation").
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "semantics/ir.hpp"

namespace robochart::ir {

/// A value over finite carriers. Numbers: the integer, or for reals the integer scale*value.
/// Booleans 0/1, enumerations and given types the literal's index. Composed values use `parts`.
struct Value {
    std::int64_t number = 0;
    std::vector<Value> parts;
    friend auto operator<=>(const Value&, const Value&) = default;
    friend bool operator==(const Value&, const Value&) = default;
};

/// What the user asked for on the command line or in a scenario.
struct InstantiationOptions {
    std::map<std::string, std::string> constants;  ///< "NAME" or "P::S::NAME" -> RoboChart literal
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> ranges;  ///< "nat" -> {0,4}
};

/// A finite reading of a System. All sets ascending, without duplicates.
struct Instantiation {
    /// Reals are integers in units of 1/scale; a power of ten; 1 if the model has no decimal literal (RoboTool's reading).
    std::int64_t scale = 1;
    std::vector<std::int64_t> nat, integer;
    /// In units of 1/scale: whole numbers of the range and every decimal literal of the model.
    std::vector<std::int64_t> real;
    std::int64_t given_size = 2;      ///< elements of each given type
    std::int64_t sequence_bound = 2;  ///< longest sequence
    std::int64_t clock_bound = 10;    ///< core_clock_type = {0..clock_bound}
    std::int64_t recursion_bound = 2; ///< nested calls of one operation
    /// Constants without a value in the model: qualified name as in CSP (`const_P_S_c`) -> value.
    std::map<std::string, Value> constants;
};

/// RoboTool's defaults, widened by the model's literals and constants, then the user's options.
/// Bad options (unknown constant, empty range) are reported.
[[nodiscard]] Instantiation instantiate(const System&, const InstantiationOptions&, diagnostics::Diagnostics&);

/// All values of a type in ascending order; the first is not necessarily the default. Throws std::length_error above `limit`.
[[nodiscard]] std::vector<Value> carrier(const System&, const Instantiation&, TypeId, std::size_t limit = 1U << 20U);
/// The initial value of a variable without one (semantics 3.6): 0, true for booleans, first literal, empty sequence or set.
[[nodiscard]] Value default_value(const System&, const Instantiation&, TypeId);
/// Evaluates an expression without variables (literals, constants, arithmetic); reals in units of 1/scale.
/// Returns nothing if it is not constant.
[[nodiscard]] std::optional<Value> evaluate_constant(const System&, const Instantiation&, const Machine*, const Expr&);
/// Largest value a clock is compared with in the machine, plus 1: where it may saturate.
[[nodiscard]] std::int64_t clock_saturation(const System&, const Instantiation&, const Machine&, ClockId);

}  // namespace robochart::ir
