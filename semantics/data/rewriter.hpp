// SPDX-License-Identifier: Apache-2.0
// Rewrites a system so that its data are classes of values. Private to this component.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "semantics/data/classes.hpp"
#include "semantics/data/places.hpp"
#include "semantics/data/sampling.hpp"

namespace robochart::ir {

/// Returns the system with classes: the places of each flow class hold literals of an enumeration, one for each class,
/// and conditions test these literals. `uses` contains the uses of all flow classes. `terms` contains the term of each
/// flow class of related variables; its classes are classes of the values of the term.
[[nodiscard]] System with_classes(const System& system, const Sampling& sampling, const Places& places,
                                  const std::map<PlaceId, Uses>& uses, const std::map<PlaceId, ValueClasses>& classes,
                                  const std::map<PlaceId, std::string>& terms = {});

/// Returns the text of a class of values of a term: "d - l = 1". `witness` is one of these values. `scale` is the
/// number of units that represent 1.
[[nodiscard]] std::string term_value_text(const System& system, std::int64_t scale, const std::string& term,
                                          TypeId type, const Value& witness);

/// Returns the names of the places of a flow class, ascending.
[[nodiscard]] std::vector<std::string> names_in(const Places& places, PlaceId flow);

}  // namespace robochart::ir
