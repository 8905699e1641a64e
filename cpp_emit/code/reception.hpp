// SPDX-License-Identifier: Apache-2.0
// Writes code that receives an event for triggers and input statements. The source is a register of the platform,
// another machine that waits to send the event, or a buffer. An event without a source happens spontaneously (semantics
// 3.9).
#pragma once

#include <functional>
#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns a further condition on the incoming value, whose text is given. May be an empty function.
using Condition = std::function<CppExpr(const std::string& incoming)>;

/// Writes code that tries each source of the event. It takes the event if it is present and `condition` holds: it
/// consumes the event, stores its value, and continues with the code that `then` writes. Returns true if the last
/// source always has the event.
bool write_reception(const Generation&, const Unit&, const ir::Communication&, CodeWriter&, const Condition& condition,
                     const std::function<void()>& then);

/// Returns the condition that the value satisfies the communication's own predicate. Empty if the communication has no
/// predicate.
[[nodiscard]] CppExpr value_predicate(const Generation&, const Unit&, const ir::Communication&,
                                      const std::string& incoming);
/// Returns the statement that consumes the event: `inputs_.x.present = false;`.
[[nodiscard]] std::string consume_statement(const EventPort&);
/// Returns the statement that stores the received value; "" if the value is not stored. Implements Fault::fields_lost.
[[nodiscard]] std::string store_received(const Generation&, const Unit&, const ir::Communication&,
                                         const std::string& value);
/// Returns the incoming value, converted to the type of the variable that receives it. For example, a nat may be stored
/// in a real.
[[nodiscard]] std::string as_variable(const Generation&, const Unit&, const ir::Communication&,
                                      const std::string& value);
/// Returns an arbitrary value of the type as C++ text. It is used for events that are not connected.
[[nodiscard]] std::string default_text(const Generation&, ir::TypeId);
/// Returns whether the event's only source is a register of the platform.
[[nodiscard]] bool from_register(const EventUse&);

}  // namespace robochart::cpp_emit
