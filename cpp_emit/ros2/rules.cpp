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
                        "A mapping names the operations, events and shared variables between the component and its "
                        "platform, the parameters of these operations, and the fields of its records."};
const Rule said_twice{"RC-R03", Severity::error, "{} is given twice",
                      "An element of the model has one message and one topic. A field has one value, and a value comes "
                      "from one field. Remove one of the two."};
const Rule wrong_name{"RC-R04", Severity::error, "'{}' is not a valid name of a {}: {}",
                      "Names of packages, messages, fields and topics follow the rules of ROS 2, and some names belong "
                      "to ROS itself. No message or topic can have another name."};
const Rule unknown_field{"RC-R05", Severity::error, "the message {} has no field '{}'{}",
                         "The fields of common messages are known. So a misspelt field is reported here, and not later "
                         "by the compiler of the generated package."};
const Rule wrong_type{"RC-R06", Severity::error, "{} is {}, and {} is {}",
                      "Truth values need a field of type `bool`, whole numbers and enumerations a field of whole "
                      "numbers, and numbers `float32` or `float64`. A record is assigned field by field."};
const Rule incomplete{"RC-R07", Severity::error, "no field of the message provides {} of {} '{}'",
                      "The mapping must take every part of the value of an event or variable from the message. A part "
                      "without a field would have a value that nobody sent."};
const Rule not_sent{
    "RC-R08", Severity::warning, "no field of the message contains {} of {} '{}'",
    "This output of the controller is not published. Map it to a field, or allow this code if the loss is intended."};
const Rule shared_topic{"RC-R09", Severity::error, "'{}' cannot be on topic '{}' with '{}': {}",
                        "A topic has one message type and one quality of service. A controller that receives what it "
                        "publishes raises its own events, and the model does not describe this."};
const Rule not_mapped{
    "RC-R10", Severity::note, "operations of '{}' without a mapping use default topics: {}",
    "An operation without a mapping is published on ~/out/OPERATION. Another node must subscribe to this topic, or the "
    "operation has no effect. The node prints a warning if there is no subscriber."};
const Rule not_checked{"RC-R11", Severity::note, "the fields of {} are not known here{}",
                       "Fields and types of common messages are checked when code is generated. The compiler checks "
                       "those of other messages when it builds the generated package."};

const Rule not_asked{"RC-R12", Severity::warning, "every {} raises '{}', regardless of the contents of {}",
                     "Each message raises an event without a value, even a `false` or the state of a full battery. "
                     "Publish std_msgs/Empty when the event occurs, or give the event a value in the model and let its "
                     "transitions test the value."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &syntax,     &unknown_name, &said_twice,   &wrong_name, &unknown_field, &wrong_type,
        &incomplete, &not_sent,     &shared_topic, &not_mapped, &not_checked,   &not_asked,
    };
    return table;
}

}  // namespace robochart::cpp_emit::ros2::rules
