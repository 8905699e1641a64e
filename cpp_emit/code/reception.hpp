// SPDX-License-Identifier: Apache-2.0
// Writes code that receives an event from any source: a register of the platform, another machine that waits to send
// it, a buffer, or no source (semantics 3.9). Used for triggers and input statements.
#pragma once

#include <functional>
#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// A further condition on the text of the incoming value; may be empty.
using Condition = std::function<CppExpr(const std::string& incoming)>;

/// For each source of the event, writes code that takes it if it is present and `condition` holds. The code consumes
/// the event, stores its value, and continues with the code that `then` writes. Returns whether the last source always
/// has the event.
bool write_reception(const Generation&, const Unit&, const ir::Communication&, CodeWriter&, const Condition& condition,
                     const std::function<void()>& then);

/// The condition that the value satisfies the communication's own predicate; empty if there is no predicate.
[[nodiscard]] CppExpr value_predicate(const Generation&, const Unit&, const ir::Communication&,
                                      const std::string& incoming);
/// The statement that consumes the event: `inputs_.x.present = false;`.
[[nodiscard]] std::string consume_statement(const EventPort&);
/// The statement that stores the received value; "" if the value is not stored. Implements Fault::fields_lost.
[[nodiscard]] std::string store_received(const Generation&, const Unit&, const ir::Communication&,
                                         const std::string& value);
/// The incoming value, converted to the type of the variable that receives it. For example, a nat may be stored in a
/// real.
[[nodiscard]] std::string as_variable(const Generation&, const Unit&, const ir::Communication&,
                                      const std::string& value);
/// An arbitrary value of the type as C++ text, the value of an event that is not connected.
[[nodiscard]] std::string default_text(const Generation&, ir::TypeId);
/// Whether the event's only source is a register of the platform.
[[nodiscard]] bool from_register(const EventUse&);

}  // namespace robochart::cpp_emit
