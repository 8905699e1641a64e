// Receiving an event, wherever it comes from: a register of the platform, another machine that waits to send it, a
// buffer, or nowhere (semantics 3.9). Triggers and input statements alike.
#pragma once

#include <functional>
#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// A further condition, given the text of the incoming value; there may be none.
using Condition = std::function<CppExpr(const std::string& incoming)>;

/// Writes, for each source of the event, code that takes it if it is there and `condition` holds: consumes the event,
/// stores its value, and goes on with what `then` writes. True if the last of them is always taken.
bool receive(const Generation&, const Unit&, const ir::Communication&, CodeWriter&, const Condition& condition,
             const std::function<void()>& then);

/// The communication's own predicate on the value; none if it has none.
[[nodiscard]] CppExpr predicate(const Generation&, const Unit&, const ir::Communication&, const std::string& incoming);
/// `inputs_.x.present = false;`.
[[nodiscard]] std::string consume(const EventPort&);
/// Stores what was received, "" if nothing is to be stored; Fault::fields_lost.
[[nodiscard]] std::string received(const Generation&, const Unit&, const ir::Communication&, const std::string& value);
/// Some value of the type, as C++ text: what an event connected to nothing carries.
[[nodiscard]] std::string default_text(const Generation&, ir::TypeId);
/// The event's only source is a register of the platform.
[[nodiscard]] bool from_register(const EventUse&);

}  // namespace robochart::cpp_emit
