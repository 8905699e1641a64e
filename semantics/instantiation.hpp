// Making a model finite: carriers of the basic types, values of constants, the scale of reals.
// Defaults follow RoboTool's generated instantiations.csp (semantics 3.13):
// * nat {0..2}, int {-2..2}, real {-2..2}, each widened to the least and greatest literal used with the type, and to
// hold
//   the type before it (nat in int in real). Choice of ours, where RoboTool counts every literal for every type: a
//   literal counts for the type its place asks for (`x < 5` with x:real widens real only), a negated literal is one
//   literal (-5), and literals that are only a wait duration, a deadline, compared with since() or an index do not
//   widen anything, because they are times and places and no variable's values.
// * Literals in the values that assertions and options give to constants count, and those of postconditions, which
//   define functions; preconditions do not.
// * Strings are the empty one and those written in the model.
// * scale: the smallest power of ten that makes every decimal literal whole; 1 without decimal literals.
// * Constants without a value: 0, true, the first literal; undefined functions likewise.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
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
    /// By number, then part by part; a shorter list of parts goes first.
    friend std::strong_ordering operator<=>(const Value&, const Value&);
    friend bool operator==(const Value&, const Value&);
};

/// What the user asked for on the command line or in a scenario.
struct InstantiationOptions {
    std::map<std::string, std::string>
        constants;  ///< "NAME" or "P::S::NAME" (or its end, "S::NAME") -> RoboChart literal
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> ranges;  ///< "nat" -> {0,4}
};

/// A finite reading of a System. All sets ascending, without duplicates.
struct Instantiation {
    /// Reals are integers in units of 1/scale; a power of ten; 1 if the model has no decimal literal (RoboTool's
    /// reading).
    std::int64_t scale = 1;
    std::vector<std::int64_t> nat, integer;
    /// In units of 1/scale: whole numbers of the range and every decimal literal of the model.
    std::vector<std::int64_t> real;
    std::vector<diagnostics::ForeignText> strings{""};  ///< values of type string
    std::int64_t given_size = 2;           ///< elements of each given type
    std::int64_t sequence_bound = 2;       ///< longest sequence
    std::int64_t clock_bound = 10;         ///< core_clock_type = {0..clock_bound}
    std::int64_t recursion_bound = 2;      ///< nested calls of one operation
    /// Constants without a value in the model, and those an option sets: qualified name as in CSP (`const_P_S_c`, see
    /// query.hpp) -> value. An entry here goes before the value in the model.
    std::map<std::string, Value> constants;
    /// The limits within which it is worked with: what goes through carriers and evaluates polls here.
    diagnostics::Budget* budget = nullptr;

    void poll() const {
        if (budget != nullptr) budget->poll();
    }
};

/// RoboTool's defaults, widened by the model's literals and constants, then the user's options.
/// Bad options (unknown constant, empty range) are reported.
[[nodiscard]] Instantiation instantiate(const System&, const InstantiationOptions&, diagnostics::Diagnostics&);

/// Whether an option's name for a constant, "NAME" or the end of "P::S::NAME", is one of the system.
[[nodiscard]] bool names_constant(const System&, const std::string& option);
/// All values of a type in ascending order; the first is not necessarily the default. Throws std::length_error above
/// `limit`.
[[nodiscard]] std::vector<Value> carrier(const System&, const Instantiation&, TypeId, std::size_t limit = 1U << 20U);
/// The initial value of a variable without one (semantics 3.6): 0, true for booleans, first literal, empty sequence or
/// set.
[[nodiscard]] Value default_value(const System&, const Instantiation&, TypeId);
/// Evaluates an expression without variables (literals, constants, arithmetic); reals in units of 1/scale.
/// The machine's constants are those of the machine on its own (`const_P_S_c`).
/// Returns nothing if it is not constant.
[[nodiscard]] std::optional<Value> evaluate_constant(const System&, const Instantiation&, const Machine*, const Expr&);
/// Values of a machine's constants by ConstantId, for the machine running as `part` of a controller of a module
/// (see constant_source in query.hpp; null: without that context). Constants of functions without definition get the
/// default of their type.
[[nodiscard]] std::vector<Value> constant_values(const System&, const Instantiation&, const Module*, const Controller*,
                                                 const std::string& part, const Machine&);
/// Largest whole number a clock is compared with in the machine, or in an operation it may call that shares the clock,
/// plus 1: where it may saturate without changing any comparison. What is compared with and not constant counts with
/// the greatest value of its type.
[[nodiscard]] std::int64_t clock_saturation(const System&, const Instantiation&, const Machine&, ClockId);

}  // namespace robochart::ir
