// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/rules.hpp"

#include <array>

namespace robochart::cpp_emit::ros2::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule syntax{"RC-R01", Severity::error, "expected {}, found {}",
                  "A mapping is `ros2 for COMPONENT { ... }` with items `publish operation NAME as PACKAGE/TYPE on "
                  "\"TOPIC\" { field = parameter }` and `receive event NAME as ... { value = field }` "
                  "(docs/ros2.md)."};
const Rule unknown_name{"RC-R02", Severity::error, "{} has no {} '{}'{}",
                        "A mapping names the operations, events and shared variables that the component shows to its "
                        "platform, the parameters of these operations and the fields of its records."};
const Rule said_twice{"RC-R03", Severity::error, "{} is said twice",
                      "An element of the model has one message and one topic, a field one value, a value one field "
                      "that it comes from; which of two is meant cannot be known."};
const Rule wrong_name{"RC-R04", Severity::error, "'{}' is no name of a {}: {}",
                      "Names of packages, messages, fields and topics follow the rules of ROS 2; a name that breaks "
                      "them has no message or topic, and some belong to ROS itself."};
const Rule unknown_field{"RC-R05", Severity::error, "the message {} has no field '{}'{}",
                         "The fields of common messages are known: a misspelt one is reported here and not by the "
                         "compiler of the generated package."};
const Rule wrong_type{"RC-R06", Severity::error, "{} is {}, and {} is {}",
                      "Truth values go with `bool`, whole numbers and enumerations with fields of whole numbers, "
                      "numbers with `float32` and `float64`; a record is given field by field."};
const Rule incomplete{"RC-R07", Severity::error, "nothing gives {} of {} '{}' its value",
                      "An event or variable that carries a value takes all of it from the message: the rest would "
                      "have a value that nobody sent."};
const Rule not_sent{"RC-R08", Severity::warning, "{} of {} '{}' is in no field of its message",
                    "What the controller says is lost on the way. Map it, or allow the code where it is meant."};
const Rule shared_topic{"RC-R09", Severity::error, "'{}' cannot be on topic '{}' with '{}': {}",
                        "A topic has one message and one quality of service, and a controller that receives what it "
                        "publishes itself raises its own events, which the model does not know of."};
const Rule not_mapped{
    "RC-R10", Severity::note, "operations of '{}' on topics of their own: {}",
    "An operation that the mapping leaves out is published on ~/out/OPERATION. Somebody has to listen "
    "there, or the robot does nothing; the node warns where nobody does."};
const Rule not_checked{"RC-R11", Severity::note, "the fields of {} are not known here{}",
                       "Fields and types of common messages are checked when code is generated; those of other "
                       "messages by the compiler, where the generated package is built."};

const Rule not_asked{"RC-R12", Severity::warning, "every {} raises '{}', whatever is in {}",
                     "An event without value is raised by each message that arrives, a `false` and a full battery "
                     "too. Publish std_msgs/Empty when it happens, or give the event a value in the model "
                     "and let its transitions ask for it."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &syntax,     &unknown_name, &said_twice,   &wrong_name, &unknown_field, &wrong_type,
        &incomplete, &not_sent,     &shared_topic, &not_mapped, &not_checked,   &not_asked,
    };
    return table;
}

}  // namespace robochart::cpp_emit::ros2::rules
