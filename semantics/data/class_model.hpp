// SPDX-License-Identifier: Apache-2.0
// A model whose data are replaced by classes of values, so that its answers are about all values and not about finite
// carriers. docs/data.md explains it. The result is an ordinary system: classes are enumerations.
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
    bool all_values = false;      ///< the classes contain all values of the type; if false, only the values that occur
    bool nothing_tested = false;  ///< no condition reads the values
};

/// A variable that conditions compare with other variables.
struct RelatedVariable {
    std::string name;
    std::int64_t coefficient = 1;  ///< the variable's coefficient in the term; not 0
    std::int64_t initial = 0;      ///< the initial value, in units
};

/// Variables that the class model replaces by one variable, which holds the class of a linear term of their values
/// (docs/data.md, "Relations of variables").
struct RelatedVariables {
    std::string machine;  ///< "P::S"
    std::string holder;   ///< the name of the variable that holds the class, one of those below
    std::vector<RelatedVariable> variables;
    std::int64_t scale = 1;                           ///< the number of units that represent 1
    bool whole = false;                               ///< the variables have the type int; otherwise real
    std::map<std::string, std::int64_t> term_values;  ///< text of a class -> a value of the term in it, in units
    /// The qualified name of a transition or a statement -> the variable that stores its input.
    std::map<std::string, std::string> stored_by;
    bool assigned = false;  ///< the machine also changes these variables without an input
};

/// A system whose data are classes of values, and what is needed to report about it.
struct ClassModel {
    System system;
    Instantiation instantiation;
    std::vector<ReplacedData> data;  ///< not empty
    bool small_carriers = true;      ///< each replaced type has at most 64 values in the finite instantiation
    /// The machines ("P::S") for which classes replace values of outputs and calls. Two outputs with different values
    /// may then have the same name. So a nondeterministic machine may have a deterministic class model.
    std::set<std::string> outputs_replaced;
    /// The number of conditions whose answers the class model chooses (free_model).
    std::size_t free_conditions = 0;
    /// The name of an input of a related variable depends on the values of the other variables. So a class model may be
    /// deterministic although the machine is not, and a machine may be deterministic although its class model is not.
    std::vector<RelatedVariables> related;
};

/// Whether the system has data of types that classes can replace. Whether classes do replace these data also depends on
/// how the model uses them.
[[nodiscard]] bool has_data(const System& system);
/// Whether the type of such data has more than 64 values in the finite instantiation.
[[nodiscard]] bool has_large_carriers(const System& system, const Instantiation& instantiation);

/// The class model of a system, and the data that it does not replace.
struct Classification {
    std::optional<ClassModel> model;  ///< no value if no data are replaced
    std::vector<KeptData> kept;       ///< the data with numbers (has_numbers), in the order of their first places
};

/// Replaces all data that can be replaced. Properties of the system must not observe values of events, because the
/// class model has the same event names but different values.
[[nodiscard]] Classification classify_data(const System& system, const Instantiation& instantiation);

/// A class model that makes internal choices: of the classes of computed values, and of the answers of conditions that
/// the classes do not determine. The ideal model refines it in traces, failures and divergences, if values of events
/// are not observed (semantics/data/free_conditions.hpp). So a refinement that holds for the class model also holds for
/// the model. A refinement that fails for the class model may still hold for the model. No value if no data can be
/// replaced. Properties must not observe values of events.
[[nodiscard]] std::optional<ClassModel> free_model(const System& system, const Instantiation& instantiation);

/// Describes the classes of a class model for readers of its scripts. Each type of classes has one line, followed by
/// one line for each class with one of its values. The lines contain names of the model.
[[nodiscard]] std::vector<std::string> describe_classes(const System& class_model);

}  // namespace robochart::ir
