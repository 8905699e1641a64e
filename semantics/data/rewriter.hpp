// SPDX-License-Identifier: Apache-2.0
// Rewrites a system to one whose data are classes of values. Private to this component.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "semantics/data/classes.hpp"
#include "semantics/data/places.hpp"
#include "semantics/data/sampling.hpp"

namespace robochart::ir {

/// The system in which places of the flow classes have enumerations of their classes, and conditions test these.
/// `uses`: of all flow classes. `terms`: for flow classes of related variables, the term whose values the classes are.
[[nodiscard]] System with_classes(const System& system, const Sampling& sampling, const Places& places,
                                  const std::map<PlaceId, Uses>& uses, const std::map<PlaceId, ValueClasses>& classes,
                                  const std::map<PlaceId, std::string>& terms = {});

/// The text of a class of values of a term: "d - l = 1". `witness` is a value in the class; `scale` is its number of
/// units for 1.
[[nodiscard]] std::string term_value_text(const System& system, std::int64_t scale, const std::string& term,
                                          TypeId type, const Value& witness);

/// The names of the places of a flow class, ascending.
[[nodiscard]] std::vector<std::string> names_in(const Places& places, PlaceId flow);

}  // namespace robochart::ir
