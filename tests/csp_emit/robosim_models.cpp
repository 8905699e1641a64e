// SPDX-License-Identifier: Apache-2.0
#include "tests/csp_emit/robosim_models.hpp"

namespace robochart::csp_emit::robosim_test {

std::string machine(const std::string& inputs, const std::string& outputs, const std::string& body,
                    const std::string& cycle) {
    return "stm S { cycleDef cycle == " + cycle + " input context { " + inputs + " } output context { " + outputs +
           " } initial i " + body + " }\n";
}

std::string sender_and_reader(int late) {
    std::string reader =
        "stm R { cycleDef cycle == 1 input context { event sig } output context { event got event none } "
        "initial i ";
    for (int n = 0; n <= late; ++n) reader += "state R" + std::to_string(n) + " { } ";
    reader += "state E { } transition a { from i to R0 } ";
    for (int n = 0; n < late; ++n)
        reader += "transition s" + std::to_string(n) + " { from R" + std::to_string(n) + " to R" +
                  std::to_string(n + 1) + " exec } ";
    const std::string last = std::to_string(late);
    reader += "transition x { from R" + last + " to E condition $sig action $got } transition y { from R" + last +
              " to E condition not $sig action $none } transition z { from E to E exec } }\n";
    return "stm W { cycleDef cycle == 1 input context { } output context { event sig } initial i state A { } "
           "transition t0 { from i to A action $sig } transition t1 { from A to A exec } }\n" +
           reader +
           "controller C { cycleDef cycle == 1 event got event none sref w = W sref r = R "
           "connection w on sig to r on sig connection r on got to C on got connection r on none to C on none }";
}

std::string two_callers(const std::string& first, const std::string& second, const std::string& cycle) {
    const auto one = [](const std::string& name, const std::string& call, const std::string& own_cycle) {
        return "stm " + name + " { cycleDef cycle == " + own_cycle +
               " input context { } output context { requires Op } " +
               "initial i state Z { } transition t0 { from i to Z action " + call +
               " } "
               "transition t1 { from Z to Z exec } } ";
    };
    return "interface Op { go(n : nat) stay() }\ncontroller C { cycleDef cycle == " + cycle + " requires Op " +
           one("A", first, "3") + one("B", second, "5") + "}";
}

}  // namespace robochart::csp_emit::robosim_test
