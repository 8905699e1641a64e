// SPDX-License-Identifier: Apache-2.0
// Handles conditions on several variables of a machine, such as `d > l` or `(now - start) % 360 < 90`. Private to this
// component.
//
// One variable, the holder, replaces a group of variables that conditions relate, if all conditions read the group
// through one linear term t, such as d - l. The holder stores the value of t. A statement that stores an input in a
// variable of the group receives the new value of t instead. Statement: the two systems are bisimilar up to the names
// of input values. Reason: if the variable ranges over all values of its type, then so does t, for all values of the
// other variables. A linear form with a coefficient other than 0 maps the reals onto the reals, and a form with a
// coefficient of 1 or -1 maps the integers onto the integers. This property is called homogeneity. It does not hold for
// nat and for types with bounds (docs/data.md, "Relations of variables").
//
// An input is stored after its event has occurred. In between, nothing may change the group. Therefore no during action
// may write a variable of the group.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "semantics/data/linear_form.hpp"
#include "semantics/data/places.hpp"
#include "semantics/data/sampling.hpp"

namespace robochart::ir {

/// Identifies a group of variables: its machine, and the lowest VariableId in the group.
using GroupId = std::pair<MachineId, VariableId>;

/// A group of variables that is replaced by a holder.
struct Relation {
    GroupId group;  ///< the variable in this identifier is the holder
    /// The term: components are variables by VariableId. The constant is 0.
    LinearForm term;
    std::string text;  ///< "d - l"
    /// The initial value of each variable of the group, in units of the sampling scale.
    std::map<VariableId, std::int64_t> initial;
    /// For the qualified name of a transition or statement: the variable in which it stores its input.
    std::map<std::string, VariableId> stored_by;
    bool assigned = false;  ///< an assignment changes a variable of the group
};

/// A system in which holders replace groups. The other variables of a group remain, but nothing uses them. They have
/// the type and the initial value of the holder.
struct RelatedSystem {
    System system;
    std::vector<Relation> relations;
};

/// Replaces all groups that can be replaced, except `refused`. Call collect_uses with `places` first.
[[nodiscard]] RelatedSystem relate_variables(const System& system, const Sampling& sampling, const Places& places,
                                             std::set<GroupId> refused);

}  // namespace robochart::ir
