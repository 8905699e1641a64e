// SPDX-License-Identifier: Apache-2.0
// Describes the boundary of a component: its input registers and outputs, and the names of their events in the model,
// in NF_c(M) and in L(G) (docs/conformance.md, "From reactive model to cycles"). Only this file relates the names of
// model and code.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "checker/process/term.hpp"
#include "cpp_emit/plan/options.hpp"

namespace robochart::conformance {

/// How the numbers of a type in the C interface (cpp_emit/runtime/explore_abi.h) are written as text.
struct Carrier {
    enum class Kind { number, real, boolean, enumeration };
    Kind kind = Kind::number;
    std::vector<std::string> literals;  ///< enumeration: names for reports
    std::vector<std::string> names;     ///< enumeration: names in CSPM
};

/// An input register: absent in a cycle, or present with one of its values.
struct Register {
    std::string name;                  ///< event prefix relative to the component: "seeRobot.in", "set_EXT_reached"
    std::vector<std::int64_t> values;  ///< empty: it carries no value
    std::vector<std::string> texts;    ///< the values as CSPM text
    Carrier carrier;
    /// For variables in RoboSim: the reading before the first cycle, because an absent variable keeps its last value.
    /// For all other registers: 0.
    std::uint32_t kept = 0;

    /// Returns the number of possible readings in one cycle: one for "absent", and one for each value. A register that
    /// carries no value has one reading for "present" instead of values.
    [[nodiscard]] std::uint32_t reading_count() const {
        return 1 + (values.empty() ? 1 : static_cast<std::uint32_t>(values.size()));
    }
};

/// An output: a sent event, a called operation, or a written shared variable.
struct Output {
    std::string name;                ///< "out.out", "MoveCall", "set_linearSpeed"
    std::vector<Carrier> arguments;  ///< one for each argument
};

/// States that in a cycle with input `event`, input `dropped` is not raised (docs/claims.md, "Order in a cycle").
struct DroppedInput {
    std::uint32_t event = 0, dropped = 0;
};

/// Removes dropped inputs from `raised`, one drop after the other. An event that has been dropped drops no later
/// events. `raised[i]` is true if input i is raised.
void drop_raised(std::vector<bool>& raised, const std::vector<DroppedInput>& drops);

struct Interface {
    std::string component;   ///< CSP prefix of its events: "P::M"
    std::int64_t scale = 1;  ///< reals are multiples of 1/scale
    std::vector<Register> inputs;
    std::vector<Output> outputs;
    std::vector<DroppedInput> drops = {};  ///< inputs that both model and code drop, in this order
    bool robosim = false;                  ///< true: M itself has registers (register_system.hpp)
    std::vector<std::string> blocked;      ///< channels of M that the environment does not use: "set_EXT_x"
};

/// Returns the inputs that an order of events drops.
[[nodiscard]] std::vector<DroppedInput> dropped_inputs(const Interface&, const cpp_emit::EventOrder&);

/// Returns the name of an input for reports: "seeRobot", "reached".
[[nodiscard]] std::string input_name(const Register& input);

/// Returns the name of an output for reports: "Move", "out", "x".
[[nodiscard]] std::string output_name(const Output& output);

/// Return the value in CSPM's notation, and in RoboChart's (reals as exact decimals).
[[nodiscard]] std::string cspm_text(const Carrier&, std::int64_t value);
[[nodiscard]] std::string people_text(const Carrier&, std::int64_t value, std::int64_t scale);

/// Thrown if the model performs an event that the code's interface does not name, or if the interface is unusable.
class AlphabetError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What an event of the model M does in a cycle.
struct ModelRole {
    enum class Kind {
        tau,
        tick,
        tock,
        terminate,
        input,
        output,
        read,    ///< RoboSim: a register is read
        hidden,  ///< RoboSim: `endexec`
        blocked,
        foreign
    };
    Kind kind = Kind::foreign;
    std::uint32_t index = 0;              ///< for input, output, read
    std::uint32_t reading = 0;            ///< for input, read: 1 + index of the value; 0: an empty register
    process::Event write = process::tau;  ///< for output: the event of NF that reports it
};

/// What an event of NF_c(M) or L(G) does, for describing a trace in cycles.
struct CycleRole {
    enum class Kind { read, write, tock, tick, other };
    Kind kind = Kind::other;
    std::uint32_t index = 0;
    std::uint32_t reading = 0;  ///< for read: 0 absent, else 1 + index of the value
};

/// The alphabets of model and code over one event table. Constructor names follow the register and output names:
/// "seeRobot.in" gives registerRead.absent__seeRobot and registerRead.present__seeRobot.
class Alphabet {
public:
    Alphabet(Interface, process::EventTable&);

    [[nodiscard]] const Interface& interface() const { return interface_; }
    [[nodiscard]] process::EventTable& events() const { return *events_; }
    [[nodiscard]] process::Event tock() const { return tock_; }
    [[nodiscard]] process::Event read_event(std::uint32_t input, std::uint32_t reading) const {
        return reads_[input][reading];
    }
    /// Returns the event that reports an output with these arguments.
    [[nodiscard]] process::Event write_event(std::uint32_t output, const std::vector<std::int64_t>& arguments) const;
    [[nodiscard]] ModelRole model_role(process::Event) const;
    [[nodiscard]] CycleRole cycle_role(process::Event) const;
    /// Returns the arguments of a write as text. The event must be a write.
    [[nodiscard]] std::vector<std::string> written_arguments(process::Event write) const;
    /// Return the constructors of the NF script's datatypes, such as "present__heading".
    [[nodiscard]] const std::string& input_constructor(std::uint32_t input) const { return input_names_[input]; }
    [[nodiscard]] const std::string& output_constructor(std::uint32_t output) const { return output_names_[output]; }
    /// Returns the text of an NF event for reports: "heading = 0.1", "MoveForward()", "end of cycle".
    [[nodiscard]] std::string describe_event(process::Event) const;

private:
    [[nodiscard]] ModelRole find_role(const std::string& name) const;
    [[nodiscard]] ModelRole register_role(std::string_view local) const;
    [[nodiscard]] ModelRole read_role(std::uint32_t input, std::string_view content) const;
    [[nodiscard]] ModelRole output_role(std::uint32_t output, std::string_view arguments) const;
    [[nodiscard]] std::string describe_write(std::uint32_t output, process::Event write) const;

    Interface interface_;
    process::EventTable* events_;
    process::Event tock_;
    std::vector<std::string> input_names_, output_names_;
    std::vector<std::vector<process::Event>> reads_;
};

}  // namespace robochart::conformance
