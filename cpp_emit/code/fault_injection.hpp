// Small pieces of generated code that seeded faults can change, written by one function each wherever they are needed.
#pragma once

#include <string>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// The input that is looked at; Fault::wrong_input: another of the same type.
[[nodiscard]] const EventPort& received_port(const Generation&, const EventPort&);
/// The output that is made; Fault::wrong_output: another of the same type.
[[nodiscard]] const EventPort& sent_port(const Generation&, const EventPort&);
/// The operation of the platform that is called; Fault::wrong_output: another of the same parameters.
[[nodiscard]] const PlatformCall& called(const Generation&, const PlatformCall&);
/// Of the senders of a connection the one that is heard; Fault::wrong_sender: another of the same type.
[[nodiscard]] const EventUse& heard(const Generation&, const EventUse&);
/// `inputs_.x.present = false;`; "" with Fault::event_not_consumed.
[[nodiscard]] std::string consume(const Generation&, const EventPort&);
/// Stores what was received, "" if nothing is to be stored; Fault::value_not_stored and Fault::fields_lost.
[[nodiscard]] std::string received(const Generation&, const Unit&, const ir::Communication&, const std::string& value);
/// A deadline that runs from here: `f.d = duration(3) + 1;`. `part` tells it from others.
[[nodiscard]] std::string watch_from(const Generation&, const Unit&, const std::string& field, const ir::Expr& bound,
                                     const void* part);
/// The test of the bound of steps in a loop's condition; "" with Fault::loop_never_ends.
[[nodiscard]] std::string bound_test(const Generation&);
/// A variable's first value; Fault::initial_lost: the default of its type.
[[nodiscard]] ir::Value begins_with(const Generation&, const ir::Variable&, const ir::Value& initial);
/// The numbers 0 to count - 1, in reverse where the fault strikes.
[[nodiscard]] std::vector<std::size_t> order(const Generation&, std::size_t count, Fault reversed);

}  // namespace robochart::cpp_emit
