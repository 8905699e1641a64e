// SPDX-License-Identifier: Apache-2.0
// The boundary of a component: its input registers and outputs, and the names of their events in the model, in NF_c(M)
// and in L(G) (docs/conformance.md, "From reactive model to cycles"). Only this file relates the names of model and
// code.
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

/// The text form of numbers in the C interface (cpp_emit/runtime/explore_abi.h).
struct Carrier {
    enum class Kind { number, real, boolean, enumeration };
    Kind kind = Kind::number;
    std::vector<std::string> literals;  ///< enumeration: names for readers
    std::vector<std::string> names;     ///< enumeration: names in CSPM
};

/// An input register: absent in a cycle, or present with one of its values.
struct Register {
    std::string name;                  ///< event prefix relative to the component: "seeRobot.in", "set_EXT_reached"
    std::vector<std::int64_t> values;  ///< empty: it carries no value
    std::vector<std::string> texts;    ///< the values as CSPM text
    Carrier carrier;
    /// RoboSim, variables: the reading before the first cycle. An absent variable keeps its last value. For all other
    /// registers: 0.
    std::uint32_t kept = 0;

    /// The number of possible readings in one cycle: one for "absent", and one for each value, or one for "present" if
    /// the register carries no value.
    [[nodiscard]] std::uint32_t reading_count() const {
        return 1 + (values.empty() ? 1 : static_cast<std::uint32_t>(values.size()));
    }
};

/// An output: a sent event, a called operation, or a written shared variable.
struct Output {
    std::string name;                ///< "out.out", "MoveCall", "set_linearSpeed"
    std::vector<Carrier> arguments;  ///< one for each argument
};

/// In a cycle with input `event`, input `dropped` is not raised (docs/claims.md, "Order in a cycle").
struct DroppedInput {
    std::uint32_t event = 0, dropped = 0;
};

/// Removes from `raised` what the drops withhold, one drop after the other: a dropped event drops no later events.
/// `raised[i]` is true if input i is raised.
void drop_raised(std::vector<bool>& raised, const std::vector<DroppedInput>& drops);

struct Interface {
    std::string component;   ///< CSP prefix of its events: "P::M"
    std::int64_t scale = 1;  ///< reals are multiples of 1/scale
    std::vector<Register> inputs;
    std::vector<Output> outputs;
    std::vector<DroppedInput> drops = {};  ///< inputs that both model and code drop, in this order
    bool robosim = false;                  ///< M has registers itself (register_system.hpp)
    std::vector<std::string> blocked;      ///< channels of M that the environment does not use: "set_EXT_x"
};

/// The inputs that an order of events drops.
[[nodiscard]] std::vector<DroppedInput> dropped_inputs(const Interface&, const cpp_emit::EventOrder&);

/// The name of an input for readers: "seeRobot", "reached".
[[nodiscard]] std::string input_name(const Register& input);

/// The name of an output for readers: "Move", "out", "x".
[[nodiscard]] std::string output_name(const Output& output);

/// The value in CSPM's notation, and in RoboChart's (reals as exact decimals).
[[nodiscard]] std::string cspm_text(const Carrier&, std::int64_t value);
[[nodiscard]] std::string people_text(const Carrier&, std::int64_t value, std::int64_t scale);

/// Thrown if the model performs an event that the code's interface does not name, or if the interface is unusable.
class AlphabetError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The role of an event of the model M.
struct ModelRole {
    enum class Kind {
        tau,
        tick,
        tock,
        terminate,
        input,
        output,
        read,    ///< RoboSim: a register is read
        hidden,  ///< RoboSim: endexec
        blocked,
        foreign
    };
    Kind kind = Kind::foreign;
    std::uint32_t index = 0;              ///< input, output, read
    std::uint32_t reading = 0;            ///< input, read: 1 + index of the value; 0: an empty register
    process::Event write = process::tau;  ///< output: the event of NF that reports it
};

/// The role of an event of NF_c(M) or L(G), for describing a trace in cycles.
struct CycleRole {
    enum class Kind { read, write, tock, tick, other };
    Kind kind = Kind::other;
    std::uint32_t index = 0;
    std::uint32_t reading = 0;  ///< read: 0 absent, else 1 + index of the value
};

/// Both alphabets over one event table. Constructor names follow the register and output names:
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
    /// The event that reports an output with these arguments.
    [[nodiscard]] process::Event write_event(std::uint32_t output, const std::vector<std::int64_t>& arguments) const;
    [[nodiscard]] ModelRole model_role(process::Event) const;
    [[nodiscard]] CycleRole cycle_role(process::Event) const;
    /// The arguments of a write as text; the event must have that role.
    [[nodiscard]] std::vector<std::string> written_arguments(process::Event write) const;
    /// The constructors of the NF script's datatypes, such as "present__heading".
    [[nodiscard]] const std::string& input_constructor(std::uint32_t input) const { return input_names_[input]; }
    [[nodiscard]] const std::string& output_constructor(std::uint32_t output) const { return output_names_[output]; }
    /// The text of an NF event for readers: "heading = 0.1", "MoveForward()", "end of cycle".
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
