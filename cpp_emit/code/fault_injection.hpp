// Small pieces of generated code that seeded faults can change, written by one function each wherever they are needed.
#pragma once

#include <string>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Of the senders of a connection the one that is heard; Fault::wrong_sender: another of the same type.
[[nodiscard]] const EventUse& heard(const Generation&, const EventUse&);
/// `inputs_.x.present = false;`.
[[nodiscard]] std::string consume(const EventPort&);
/// Stores what was received, "" if nothing is to be stored; Fault::fields_lost.
[[nodiscard]] std::string received(const Generation&, const Unit&, const ir::Communication&, const std::string& value);
/// A deadline that runs from here: `f.d = duration(3) + 1;`.
[[nodiscard]] std::string watch_from(const Generation&, const Unit&, const std::string& field, const ir::Expr& bound);
/// The test of the bound of steps in a loop's condition; "" with Fault::loop_never_ends.
[[nodiscard]] std::string bound_test(const Generation&);

}  // namespace robochart::cpp_emit
