// SPDX-License-Identifier: Apache-2.0
// Extends the carriers of numbers by the numbers of a log, so that the model compares them with each other as they were
// logged (docs/traces.md, "Numbers that are compared with each other").
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "conformance/model/logged_value.hpp"
#include "conformance/model/model_interface.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The numbers of a log that the component compares with each other (NumberUse::related), by their kind.
using LoggedNumbers = std::map<ir::TypeKind, std::set<double>>;

/// The most numbers of one kind. The model has steps for each of them in each state that reads one.
inline constexpr std::size_t most_logged_numbers = 1000;

/// An instantiation whose carriers contain the numbers of a log.
struct ExactNumbers {
    ir::Instantiation instantiation;
    NumberCodes codes;
    /// A comparison of the log's numbers that has another answer in the arithmetic of double than with exact numbers;
    /// empty if there is none.
    std::string rounding;
};

/// The instantiation of a model with this interface, with the numbers of a log. All comparisons of the component have
/// the same answers for the carriers' numbers as for the logged ones. If there is no such instantiation, returns no
/// value and sets `cause`.
[[nodiscard]] std::optional<ExactNumbers> with_logged_numbers(const ir::System&, const ir::Instantiation&,
                                                              const ModelInterface&, const LoggedNumbers&,
                                                              std::string& cause);

}  // namespace robochart::conformance
