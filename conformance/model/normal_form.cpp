// SPDX-License-Identifier: Apache-2.0
// Writes the simulation assumptions in CSPM (docs/conformance.md, "The normal form"). The operators are untimed, with
// tock as an ordinary event. A process without tock stops time, which makes writes and reads instantaneous.
#include "conformance/model/normal_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lookup.hpp"

namespace robochart::conformance {

namespace {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;

constexpr const char* end_event = "endOfModel__";

ExprPtr read_event(const std::string& kind, const std::string& constructor) {
    return b::dot({b::name("registerRead"), b::name(kind + "__" + constructor)});
}

std::string a1_name(const std::string& constructor) {
    return "A1__" + constructor;
}

std::string gate_name(const std::string& constructor) {
    return "DROP__" + constructor;
}

std::string raised_name(std::uint32_t input) {
    return fmt::format("r__{}", input);
}

std::string value_name(std::size_t index) {
    return fmt::format("x__{}", index);
}

/// Returns `terminate -> SKIP`, with an event that the normal form declares in place of `terminate`, because not every
/// component has an event `terminate`.
ExprPtr end() {
    return b::prefix(b::name(end_event), b::skip());
}

ExprPtr after_tocks(std::uint32_t tocks, ExprPtr process) {
    for (std::uint32_t t = 0; t < tocks; ++t) process = b::prefix(b::name("tock"), process);
    return process;
}

bool declares_name(const std::vector<DeclPtr>& decls, const std::string& name) {
    return std::ranges::any_of(decls, [&](const DeclPtr& decl) {
        if (decl->kind == cspm::DeclKind::timed) return declares_name(decl->decls, name);
        const std::vector<std::string> names = cspm::declared_names(*decl);
        return std::ranges::find(names, name) != names.end();
    });
}

/// Builds the declarations for one component.
class Writer {
public:
    Writer(const cspm::Script& script, const Alphabet& alphabet, std::uint32_t cycle_length, Reading reading)
        : script_(script), alphabet_(alphabet), cycle_length_(cycle_length), reading_(reading) {}

    NormalFormScript write(const ExprPtr& model) {
        add_channels();
        for (std::uint32_t i = 0; i < inputs().size(); ++i)
            add_definition(b::value(a1_name(constructor(i)), a1_process(i)));
        for (const std::uint32_t dropped : dropped_inputs()) add_definition(gate_process(dropped));
        add_definition(b::value("TA1__", ta1_process(),
                                "A1: an input happens only if it was read as present, at most once a cycle."));
        add_definition(
            b::value("A2__", a2_process(), "A2: each output is written at once, before another one or time passing."));
        add_definition(
            b::value("TA3__", ta3_process(), "A3: all registers are read, then the model acts, then time passes."));
        add_definition(b::value("SimulationAssumptions__", assumptions_process()));
        add_definition(b::value("NF__", compose_cycles(model), "The model in cycles, with maximal progress."));
        for (const DeclPtr& decl : result_.decls) check_name(*decl);
        result_.process = b::name("NF__");
        return std::move(result_);
    }

private:
    [[nodiscard]] const std::vector<Register>& inputs() const { return alphabet_.interface().inputs; }
    [[nodiscard]] const std::vector<Output>& outputs() const { return alphabet_.interface().outputs; }
    [[nodiscard]] const std::string& constructor(std::uint32_t input) const {
        return alphabet_.input_constructor(input);
    }
    [[nodiscard]] ExprPtr model_event(const std::string& local) const {
        // "e.in" consists of a channel and its direction.
        const std::size_t dot = local.find('.');
        const ExprPtr channel = b::name(declared_channel(local));
        return dot == std::string::npos ? channel : b::dot({channel, b::name(local.substr(dot + 1))});
    }
    void add_definition(DeclPtr decl) { result_.decls.push_back(std::move(decl)); }

    void check_name(const cspm::Decl& decl) const {
        for (const std::string& name : cspm::declared_names(decl)) {
            if (decl.kind != cspm::DeclKind::external && declares_name(script_.decls, name))
                throw AlphabetError(fmt::format("the script of the model already declares {}", name));
        }
    }

    [[nodiscard]] std::string qualified_name(const std::string& local) const {
        return alphabet_.interface().component + "::" + local.substr(0, local.find('.'));
    }

    [[nodiscard]] std::string declared_channel(const std::string& local) const {
        if (!find_channel(script_, qualified_name(local)))
            throw AlphabetError(fmt::format("the model has no channel {}", qualified_name(local)));
        return qualified_name(local);
    }

    /// Returns the types of an output's arguments as the model's channel declares them.
    [[nodiscard]] ExprPtr fields_of(const Output& output) const {
        const ExprPtr body = find_channel(script_, declared_channel(output.name))->body;
        const bool directed = output.name.find('.') != std::string::npos;
        if (!body || !directed) return body;
        if (body->kind != cspm::ExprKind::dot || body->args.size() < 2) return nullptr;
        return b::dot({body->args.begin() + 1, body->args.end()});
    }

    [[nodiscard]] static ExprPtr values_of(const Register& input) {
        if (input.texts.empty()) return nullptr;
        std::vector<ExprPtr> values;
        for (std::size_t v = 0; v < input.values.size(); ++v) {
            const bool numeric =
                input.carrier.kind == Carrier::Kind::number || input.carrier.kind == Carrier::Kind::real;
            values.push_back(numeric ? b::number(input.values[v]) : b::name(input.texts[v]));
            if (input.texts[v] == "true" || input.texts[v] == "false")
                values.back() = b::boolean(input.texts[v] == "true");
        }
        return b::set(std::move(values));
    }

    void add_channels() {
        std::vector<cspm::Constructor> registers;
        for (std::uint32_t i = 0; i < inputs().size(); ++i) {
            registers.push_back(b::constructor("absent__" + constructor(i)));
            registers.push_back(b::constructor("present__" + constructor(i), values_of(inputs()[i])));
        }
        std::vector<cspm::Constructor> written;
        for (std::uint32_t o = 0; o < outputs().size(); ++o)
            written.push_back(b::constructor("wrote__" + alphabet_.output_constructor(o), fields_of(outputs()[o])));
        if (!registers.empty()) {
            add_definition(b::datatype("Register__", std::move(registers), "What a read of an input register finds."));
            add_definition(b::channel({"registerRead"}, b::name("Register__")));
        }
        if (!written.empty()) {
            add_definition(b::datatype("Written__", std::move(written), "What the software tells the platform to do."));
            add_definition(b::channel({"registerWrite"}, b::name("Written__")));
        }
        add_definition(b::channel({end_event}));
        if (!declares_external("prioritise")) add_definition(b::external({"prioritise"}));
    }

    [[nodiscard]] bool declares_external(const std::string& name) const {
        return std::ranges::any_of(script_.decls, [&](const DeclPtr& decl) {
            return (decl->kind == cspm::DeclKind::external || decl->kind == cspm::DeclKind::transparent) &&
                   std::ranges::find(decl->names, name) != decl->names.end();
        });
    }

    [[nodiscard]] ExprPtr read_choice(std::uint32_t input, ExprPtr absent, ExprPtr present) const {
        std::vector<cspm::Field> fields;
        if (!inputs()[input].texts.empty()) fields.push_back(b::input(value_name(1)));
        return b::choice({b::prefix(read_event("absent", constructor(input)), std::move(absent)),
                          b::prefix(read_event("present", constructor(input)), std::move(fields), std::move(present))});
    }

    [[nodiscard]] ExprPtr a1_process(std::uint32_t input) const {
        const ExprPtr again = b::name(a1_name(constructor(input)));
        ExprPtr event = model_event(inputs()[input].name);
        if (!inputs()[input].texts.empty()) event = b::dot({event, b::name(value_name(1))});
        return read_choice(input, again, b::choice({b::prefix(event, again), again}));
    }

    [[nodiscard]] ExprPtr ta1_process() const {
        if (inputs().empty()) return end();
        std::vector<ExprPtr> a1_processes;
        for (std::uint32_t i = 0; i < inputs().size(); ++i) a1_processes.push_back(b::name(a1_name(constructor(i))));
        ExprPtr registers = b::interleave(std::move(a1_processes));
        for (const std::uint32_t dropped : dropped_inputs())
            registers = b::parallel(registers, gate_events(dropped),
                                    b::call(gate_name(constructor(dropped)),
                                            std::vector<ExprPtr>(deciding_inputs().size(), b::boolean(false))));
        return b::interrupt(registers, end());
    }

    // ------------------------------------------------------------ dropped inputs

    /// Returns the inputs that an order of events drops, ascending.
    [[nodiscard]] std::set<std::uint32_t> dropped_inputs() const {
        std::set<std::uint32_t> result;
        for (const DroppedInput& drop : alphabet_.interface().drops) result.insert(drop.dropped);
        return result;
    }
    /// Returns the inputs that decide what is dropped, ascending.
    [[nodiscard]] std::set<std::uint32_t> deciding_inputs() const {
        std::set<std::uint32_t> result;
        for (const DroppedInput& drop : alphabet_.interface().drops) result.insert({drop.event, drop.dropped});
        return result;
    }

    /// Returns the condition that the input is raised after all drops, in their order. `r__i` is true if register i is
    /// present.
    [[nodiscard]] ExprPtr counts_as_raised(std::uint32_t input) const {
        std::map<std::uint32_t, ExprPtr> raised;
        for (const std::uint32_t i : deciding_inputs()) raised[i] = b::name(raised_name(i));
        for (const DroppedInput& drop : alphabet_.interface().drops)
            raised[drop.dropped] = b::all_of({raised[drop.dropped], b::logical_not(raised[drop.event])});
        return raised.at(input);
    }

    /// Returns the reads that decide whether an input happens, and the event of the input.
    [[nodiscard]] ExprPtr gate_events(std::uint32_t dropped) const {
        std::vector<ExprPtr> events;
        for (const std::uint32_t i : deciding_inputs())
            for (const char* kind : {"absent", "present"}) events.push_back(read_event(kind, constructor(i)));
        events.push_back(model_event(inputs()[dropped].name));
        return b::productions(std::move(events));
    }

    /// Returns a process that lets the input happen if no raised event drops it.
    [[nodiscard]] DeclPtr gate_process(std::uint32_t dropped) const {
        std::vector<std::string> parameters;
        for (const std::uint32_t i : deciding_inputs()) parameters.push_back(raised_name(i));
        const auto again = [&](std::optional<std::uint32_t> read, bool present) {
            std::vector<ExprPtr> arguments;
            for (const std::uint32_t i : deciding_inputs())
                arguments.push_back(i == read ? b::boolean(present) : b::name(raised_name(i)));
            return b::call(gate_name(constructor(dropped)), std::move(arguments));
        };
        std::vector<ExprPtr> choices;
        for (const std::uint32_t i : deciding_inputs())
            choices.push_back(read_choice(i, again(i, false), again(i, true)));
        std::vector<cspm::Field> fields;
        if (!inputs()[dropped].texts.empty()) fields.push_back(b::input(value_name(1)));
        choices.push_back(
            b::guard(counts_as_raised(dropped),
                     b::prefix(model_event(inputs()[dropped].name), std::move(fields), again(std::nullopt, false))));
        return b::function_decl(gate_name(constructor(dropped)), b::variables(parameters),
                                b::choice(std::move(choices)),
                                "The declared order of events drops the input where another one is raised.");
    }

    [[nodiscard]] ExprPtr a2_process() const {
        std::vector<ExprPtr> choices;
        for (std::uint32_t o = 0; o < outputs().size(); ++o) choices.push_back(a2_output(o));
        choices.push_back(end());
        choices.push_back(after_tocks(cycle_length_, b::name("A2__")));
        return b::choice(std::move(choices));
    }

    [[nodiscard]] ExprPtr a2_output(std::uint32_t output) const {
        std::vector<cspm::Field> taken;
        std::vector<ExprPtr> report{b::name("registerWrite"),
                                    b::name("wrote__" + alphabet_.output_constructor(output))};
        for (std::size_t a = 1; a <= outputs()[output].arguments.size(); ++a) {
            taken.push_back(b::input(value_name(a)));
            report.push_back(b::name(value_name(a)));
        }
        return b::prefix(model_event(outputs()[output].name), std::move(taken),
                         b::prefix(b::dot(std::move(report)), b::name("A2__")));
    }

    [[nodiscard]] ExprPtr ta3_process() const {
        std::vector<ExprPtr> reads;
        for (std::uint32_t i = 0; i < inputs().size(); ++i) reads.push_back(read_choice(i, b::skip(), b::skip()));
        const ExprPtr acting = b::interrupt(b::call("RUN", {model_events(true, true)}),
                                            b::choice({end(), after_tocks(cycle_length_, b::name("TA3__"))}));
        if (reads.empty()) return acting;
        if (reading_ == Reading::any_order) return b::sequential({b::interleave(std::move(reads)), acting});
        reads.push_back(acting);
        return b::sequential(std::move(reads));
    }

    [[nodiscard]] ExprPtr model_events(bool with_inputs, bool with_outputs, std::vector<const char*> more = {}) const {
        std::vector<ExprPtr> events;
        for (const Register& input : inputs()) {
            if (with_inputs) events.push_back(model_event(input.name));
        }
        for (const Output& output : outputs()) {
            if (with_outputs) events.push_back(model_event(output.name));
        }
        for (const char* name : more) {
            const std::string_view event_name = name;
            if (event_name == "registerRead" && inputs().empty()) continue;
            if (event_name == "registerWrite" && outputs().empty()) continue;
            events.push_back(b::name(name));
        }
        return b::productions(std::move(events));
    }

    [[nodiscard]] ExprPtr assumptions_process() const {
        const ExprPtr first_two =
            b::alphabetised(b::name("TA1__"), model_events(true, false, {"registerRead", end_event}),
                            model_events(false, true, {"registerWrite", end_event, "tock"}), b::name("A2__"));
        return b::alphabetised(first_two,
                               model_events(true, true, {"registerRead", "registerWrite", end_event, "tock"}),
                               model_events(true, true, {"registerRead", "tock", end_event}), b::name("TA3__"));
    }

    /// Returns the model without external writes that the environment never makes.
    [[nodiscard]] ExprPtr without_blocked_writes(const ExprPtr& model) const {
        std::vector<ExprPtr> blocked;
        for (const std::string& channel : alphabet_.interface().blocked) blocked.push_back(model_event(channel));
        if (blocked.empty()) return model;
        return b::parallel(model, b::productions(std::move(blocked)), b::skip());
    }

    [[nodiscard]] ExprPtr compose_cycles(const ExprPtr& model) const {
        const std::string terminate = alphabet_.interface().component + "::terminate";
        const ExprPtr quiet = find_channel(script_, terminate) ? b::hide(model, b::set({b::name(terminate)})) : model;
        const ExprPtr parallel =
            b::parallel(b::sequential({without_blocked_writes(quiet), end()}),
                        model_events(true, true, {"tock", end_event}), b::name("SimulationAssumptions__"));
        const ExprPtr hidden = b::hide(parallel, model_events(true, true, {end_event}));
        return b::call("prioritise", {hidden, b::sequence({b::set({}), b::set({b::name("tock")})})});
    }

    const cspm::Script& script_;
    const Alphabet& alphabet_;
    std::uint32_t cycle_length_;
    Reading reading_;
    NormalFormScript result_;
};

}  // namespace

cspm::DeclPtr find_channel(const cspm::Script& script, const std::string& qualified) {
    DeclPtr found = cspm::declaration_of(script, qualified);
    return found && found->kind == cspm::DeclKind::channel ? found : nullptr;
}

NormalFormScript normal_form(const cspm::Script& script, const cspm::ExprPtr& model, const Alphabet& alphabet,
                             std::uint32_t cycle_length, Reading reading) {
    return Writer(script, alphabet, std::max(1U, cycle_length), reading).write(model);
}

}  // namespace robochart::conformance
