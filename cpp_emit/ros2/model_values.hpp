// SPDX-License-Identifier: Apache-2.0
// Represents values of the model in messages: their scalars, and the fields that can carry them. Private to this
// component.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/ros2/messages.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit::ros2 {

/// How a scalar of the model is converted to a field.
enum class ScalarKind { truth, nat, integer, real, enumeration };

/// A part of a value of the model that a message carries: "a0.x", "value.position.x".
struct Scalar {
    ScalarKind kind = ScalarKind::real;
    ir::TypeId type;      ///< type of the scalar or, for a list, of an item
    std::string place;    ///< C++ expression relative to the value's root
    std::string reading;  ///< for messages to the user: "speed", "value.x"
    bool list = false;    ///< a sequence of such scalars, which an array carries
};

/// A value of the model to which a mapping refers: a parameter, or the value of an event or variable.
struct ModelValue {
    std::string name;   ///< "speed", "value"
    std::string place;  ///< C++ expression
    ir::TypeId type;
};

[[nodiscard]] std::optional<ScalarKind> scalar_kind(const ir::Type&);
/// Returns the message of std_msgs that carries a scalar: "Float64".
[[nodiscard]] std::string message_of(ScalarKind);
/// Describes a type for messages to the user: "a number (real)", "an enumeration (Light)".
[[nodiscard]] std::string describe_type(const ir::Type&);
/// Collects all scalars in a value: the value itself, or the values of a record's fields. Returns false if a part is
/// neither a scalar, a sequence of scalars nor a record.
bool scalars_of(const ir::System&, const ModelValue&, std::vector<Scalar>&);

/// The scalar at the end of a path in the values.
struct FoundScalar {
    std::optional<Scalar> scalar;    ///< no value: the path names no scalar
    std::size_t missing = 0;         ///< index of the first word that names nothing, or the path's length
    std::vector<std::string> known;  ///< possible words at that place
    std::optional<ir::TypeId> type;  ///< type of the value that the words before it (or all words) name
};
[[nodiscard]] FoundScalar find_scalar(const ir::System&, const std::vector<ModelValue>&, const Path&);

/// Returns whether every value fits. If the element is published, every value of the scalar must fit into the field. If
/// it is received, every value of the field must fit into the scalar. Sequences are only received, from arrays.
[[nodiscard]] bool fits_field(const FieldType&, const Scalar&, bool published);

}  // namespace robochart::cpp_emit::ros2
