// SPDX-License-Identifier: Apache-2.0
// Replaces the data of a model by classes of values. So results hold for all values, and not only for those of finite
// carriers (docs/data.md). The result is an ordinary system in which enumerations represent the classes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "semantics/data/kept_data.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Data whose values are replaced by classes of values.
struct ReplacedData {
    std::vector<std::string> places;  ///< names of variables, events and parameters, ascending
    std::string term;  ///< the term that the conditions read, as in "d - l"; "" if they read single values
    std::size_t classes = 0;
    std::size_t conditions = 0;
    /// True if the classes contain all values of the type. False if they contain only values that occur.
    bool all_values = false;
    bool nothing_tested = false;  ///< no condition reads the values
};

/// A variable that conditions compare with other variables.
struct RelatedVariable {
    std::string name;
    std::int64_t coefficient = 1;  ///< the variable's coefficient in the term; not 0
    std::int64_t initial = 0;      ///< the initial value, in units
};

/// Variables that the class model replaces by one variable, the holder. It holds the class of a linear term over their
/// values (docs/data.md, "Relations of variables").
struct RelatedVariables {
    std::string machine;  ///< "P::S"
    std::string holder;   ///< the name of the variable that holds the class, one of `variables`
    std::vector<RelatedVariable> variables;
    std::int64_t scale = 1;  ///< the number of units that represent 1
    bool whole = false;      ///< the variables have the type int; otherwise real
    /// For the text of each class: a value of the term in this class, in units.
    std::map<std::string, std::int64_t> term_values;
    /// For the qualified name of a transition or statement: the variable in which it stores its input.
    std::map<std::string, std::string> stored_by;
    bool assigned = false;  ///< the machine changes these variables in other ways than by inputs
};

/// A system whose data are classes of values, and facts about it for reports.
struct ClassModel {
    System system;
    Instantiation instantiation;
    std::vector<ReplacedData> data;  ///< not empty
    bool small_carriers = true;      ///< no replaced type has more than 64 values in the finite instantiation
    /// The machines ("P::S") whose outputs and calls have classes as values. Two outputs with different values may then
    /// have one name. So if such a machine is nondeterministic, its class model may still be deterministic.
    std::set<std::string> outputs_replaced;
    /// The number of conditions for which the class model chooses the answer (free_model).
    std::size_t free_conditions = 0;
    /// The groups of related variables. How an input of such a variable is named depends on the values of the other
    /// variables. So if a machine is deterministic, its class model need not be, and conversely.
    std::vector<RelatedVariables> related;
};

/// Returns true if the system has data of types that classes can replace. Whether they are replaced depends on how the
/// model uses the data.
[[nodiscard]] bool has_data(const System& system);
/// Returns true if data that classes can replace have a type with more than 64 values in the finite instantiation.
[[nodiscard]] bool has_large_carriers(const System& system, const Instantiation& instantiation);

/// The class model of a system, and the data that keep their carriers.
struct Classification {
    std::optional<ClassModel> model;  ///< no value if no data are replaced
    std::vector<KeptData> kept;       ///< the data with numbers (has_numbers), in the order of their first places
};

/// Replaces all data that can be replaced. Event names stay the same, but values change. So properties of the system
/// must not observe values of events.
[[nodiscard]] Classification classify_data(const System& system, const Instantiation& instantiation);

/// Returns a class model with internal choices: of the classes of computed values, and of the answers of conditions
/// that the classes do not determine. The ideal model refines it in traces, failures and divergences if values of
/// events are not observed (semantics/data/free_conditions.hpp). So a refinement that holds for the class model also
/// holds for the model. If it fails for the class model, it may still hold for the model. Properties must not observe
/// values of events. Returns no value if no data can be replaced.
[[nodiscard]] std::optional<ClassModel> free_model(const System& system, const Instantiation& instantiation);

/// Describes the classes of a class model to people who read its scripts. Gives one line for each type of classes, and
/// below it one line for each class with one of its values. Uses the names of the model.
[[nodiscard]] std::vector<std::string> describe_classes(const System& class_model);

}  // namespace robochart::ir
