// Values of the model in messages: which scalars a value is made of, and which fields go with them. Private to this
// component.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/ros2/messages.hpp"
#include "cpp_emit/ros2/node_plan.hpp"

namespace robochart::cpp_emit::ros2 {

/// A value of the model that a mapping refers to: a parameter, or what an event or variable carries.
struct ModelValue {
    std::string name;   ///< "speed", "value"
    std::string place;  ///< C++
    ir::TypeId type;
};

[[nodiscard]] std::optional<ScalarKind> scalar_kind(const ir::Type&);
/// The message of std_msgs that carries a scalar: "Float64".
[[nodiscard]] std::string message_of(ScalarKind);
/// "a number (real)", "an enumeration (Light)".
[[nodiscard]] std::string described(const ir::Type&);
/// All scalars that a value is made of: itself, or those of a record's fields. False where a part is none of both.
bool scalars_of(const ir::System&, const ModelValue&, std::vector<Scalar>&);

/// Where a path leads in the values.
struct FoundScalar {
    std::optional<Scalar> scalar;    ///< there is one
    std::size_t missing = 0;         ///< the first word that names nothing; the path's length if all do
    std::vector<std::string> known;  ///< what could stand there
    std::optional<ir::TypeId> type;  ///< what the words before it, or all, lead to
};
[[nodiscard]] FoundScalar find_scalar(const ir::System&, const std::vector<ModelValue>&, const Path&);

/// A field takes the values of the scalar, or the scalar those of the field.
[[nodiscard]] bool fits(const FieldType&, ScalarKind, bool published);

}  // namespace robochart::cpp_emit::ros2
