// SPDX-License-Identifier: Apache-2.0
// Represents a finite instantiation of a System: the values of its types and constants.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "base/diagnostics/escape.hpp"

namespace robochart::ir {

/// A value over finite carriers. Numbers are stored as integers, and a real is stored as the integer scale*value. A
/// Boolean is 0 or 1. A value of an enumeration or given type is the index of its literal. Composed values use `parts`.
struct Value {
    std::int64_t number = 0;
    std::vector<Value> parts;
    /// Compares by number, then part by part. A list comes before every longer list that begins with it.
    friend std::strong_ordering operator<=>(const Value&, const Value&);
    friend bool operator==(const Value&, const Value&);
};

/// The user's choices on the command line or in a scenario.
struct InstantiationOptions {
    std::map<std::string, std::string>
        constants;  ///< "NAME" or "P::S::NAME" (or its end, "S::NAME") -> RoboChart literal
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> ranges;  ///< "nat" -> {0,4}
};

/// A finite instantiation of a System. All sets are ascending and have no duplicates.
struct Instantiation {
    /// Reals are integers in units of 1/scale. The scale is a power of ten. It is 1 if the model has no decimal literal
    /// (as in RoboTool).
    std::int64_t scale = 1;
    std::vector<std::int64_t> nat, integer;
    /// The values of type real in units of 1/scale: the whole numbers of the range and every decimal literal of the
    /// model.
    std::vector<std::int64_t> real;
    std::vector<diagnostics::ForeignText> strings{""};  ///< values of type string
    std::int64_t given_size = 2;                        ///< number of elements of each given type
    std::int64_t sequence_bound = 2;                    ///< length of the longest sequence
    std::int64_t clock_bound = 10;                      ///< core_clock_type = {0..clock_bound}
    std::int64_t recursion_bound = 2;                   ///< limit on nested calls of one operation
    bool unbounded = false;                             ///< carriers contain all numbers, so arithmetic is not clipped
    /// The values of constants that have no value in the model, and of constants that an option sets. The key is the
    /// qualified name of the constant, as in CSP (`const_P_S_c`, see query.hpp). An entry overrides the value in the
    /// model.
    std::map<std::string, Value> constants;
    /// Composed types for which only some values are considered. Maps the index of the type to these values, in
    /// ascending order. Only conformance uses this map, for values that components only pass on
    /// (conformance/model/representatives.hpp), and for classes of sequences (conformance/model/tested_sequences.hpp).
    std::map<std::uint32_t, std::vector<Value>> representatives;
    /// The limits on time and memory. Code that iterates over carriers or evaluates expressions polls this budget.
    diagnostics::Budget* budget = nullptr;

    void poll() const {
        if (budget != nullptr) budget->poll();
    }
};

}  // namespace robochart::ir
