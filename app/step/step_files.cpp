// SPDX-License-Identifier: Apache-2.0
// See step_files.hpp.
#include "app/step/step_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "conformance/traces/mcap.hpp"
#include "conformance/traces/trace_text.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/runtime/mcap_writer.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::app {
namespace {

using runs::Kind;

/// The number of states explored for one cycle of a log.
constexpr std::size_t most_searched = 100'000;

struct Unsayable {
    std::string why;
};

/// RoboSim: returns "pressed" for "P::S::registerRead.P::S::i_pressed.true"; "" for other events.
std::string register_name(const std::string& name) {
    for (const std::string_view channel : {"::registerRead.", "::registerWrite."}) {
        const std::size_t at = name.find(channel);
        if (at == std::string::npos) continue;
        const std::string rest = name.substr(at + channel.size());
        const std::string constructor = rest.substr(0, rest.find('.'));
        const std::size_t mark = constructor.rfind("::");
        return constructor.substr(mark == std::string::npos ? 2 : mark + 4);  // after `i_` or `o_`
    }
    return "";
}

/// True if the event reads the register of a variable. The text of such an event is "x = 3".
bool reads_variable(const runs::Event& event) {
    return event.kind == Kind::read && event.text.find(" = ") != std::string::npos;
}

/// Returns the values of an event in a log. For RoboSim, leaves out the truth value that states whether a register is
/// full.
std::vector<runs::Value> logged_values(const runs::Event& event) {
    std::vector<runs::Value> result = event.values;
    const bool of_event = event.kind == Kind::read && !reads_variable(event);
    if (of_event && !result.empty()) result.erase(result.begin());
    return result;
}

/// Returns the event as a word of a log. Throws Unsayable for composed values.
std::string word_of(const runs::Offer& offer, const Stepped& stepped) {
    const runs::Event& event = offer.happening.event;
    if (auto word = log_word(event, offer.name, stepped)) return std::move(*word);
    throw Unsayable{fmt::format("{} has a value with parts, which is not written to logs", event.text)};
}

/// A control cycle of one time unit.
struct Cycle {
    std::vector<std::string> inputs, outputs;
    bool ends = false;  ///< true if the time unit of the cycle ends
    bool terminates = false;
};

std::vector<Cycle> cycles_of(const runs::Stepper& stepper, const Stepped& stepped) {
    std::vector<Cycle> cycles(1);
    for (const runs::Taken& step : stepper.steps_taken()) {
        if (step.offer.hidden) continue;
        const LogRole role = log_role(step.offer.happening.event);
        Cycle& cycle = cycles.back();
        if (role == LogRole::tock) {
            for (const runs::Offer& other : stepper.offers_at(step.before))
                if (!other.hidden && log_role(other.happening.event) == LogRole::output)
                    throw Unsayable{fmt::format("time passes where {} is on offer; in cycles it is done at once",
                                                other.happening.event.text)};
            cycle.ends = true;
            cycles.emplace_back();
        } else if (role == LogRole::termination) {
            cycle.terminates = true;
        } else if (role == LogRole::input) {
            const std::string word = word_of(step.offer, stepped);
            const std::string name = word.substr(0, word.find('?'));
            for (const std::string& before : cycle.inputs)
                if (before.substr(0, before.find('?')) == name)
                    throw Unsayable{fmt::format("{} happens twice within one time unit; a cycle reads each input once",
                                                step.offer.happening.event.text)};
            cycle.inputs.push_back(word);
        } else if (role == LogRole::output) {
            cycle.outputs.push_back(word_of(step.offer, stepped));
        }
    }
    return cycles;
}

std::string log_text(const runs::Stepper& stepper, const Stepped& stepped) {
    std::string text = log_head(stepped);
    for (const Cycle& cycle : cycles_of(stepper, stepped)) {
        std::vector<std::string> words = cycle.inputs;
        words.insert(words.end(), cycle.outputs.begin(), cycle.outputs.end());
        if (cycle.ends) words.emplace_back("tock");
        if (cycle.terminates) words.emplace_back("terminate");
        if (!words.empty()) text += fmt::format("{}\n", fmt::join(words, " "));
    }
    return text;
}

/// Makes a name from a path. The name contains only letters, digits and _.
std::string name_of(const std::string& path) {
    std::string name = std::filesystem::path(path).stem().string();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return "Way_" + name;
}

/// The number of events in one definition, because the nesting of script texts is limited.
constexpr std::size_t most_in_one = 100;

/// Returns the steps so far as definitions of processes. The first process is called `name`.
std::string process_text(const runs::Stepper& stepper, const std::string& name) {
    std::string text = fmt::format("\t{} =", name);
    std::size_t events = 0;
    for (const runs::Taken& step : stepper.steps_taken()) {
        if (step.offer.hidden) continue;
        if (step.offer.happening.event.kind == Kind::terminate) return text + " SKIP\n";
        text += fmt::format(" {} ->\n\t ", step.offer.name);
        if (++events % most_in_one == 0) text += fmt::format(" {0}_{1}\n\t{0}_{1} =", name, events / most_in_one + 1);
    }
    return text + " STOP\n";
}

/// Returns the claim that the steps so far are a trace of the component.
std::string assertion_text(const runs::Stepper& stepper, const Stepped& stepped, const std::string& path) {
    const std::string name = name_of(path);
    const char* const time = stepped.time == csp_emit::Time::timed ? "timed" : "untimed";
    const std::size_t package = stepped.name.find("::");
    return fmt::format(
        "package {0}_assertions\n\n{1}{2} csp {0} csp-begin\n{3}csp-end\n\n"
        "{2} assertion Goes_{0} : {0} refines {4} in the traces model\n",
        name, package == std::string::npos ? "" : fmt::format("import {}::*\n\n", stepped.name.substr(0, package)),
        time, process_text(stepper, name), stepped.name);
}

/// A state of the search through a cycle.
struct Node {
    process::TermId term{};
    std::set<std::string> left;  ///< inputs that are available and not yet taken
    std::size_t outputs = 0, tocks = 0;
    std::size_t parent = 0, offer = 0;
};

/// A cycle of a log. Its words (events as in the log) must match the steps.
struct Wanted {
    std::uint64_t line = 0;  ///< line of its first word
    std::set<std::string> inputs;
    std::vector<std::string> outputs;
    std::size_t tocks = 0;
    bool terminates = false;
};

/// True if the cycle does not give the variable a new value, and the read finds its last value.
bool reads_kept_value(const runs::Offer& offer, const Wanted& expected, const KeptValues& kept) {
    if (!reads_variable(offer.happening.event)) return false;
    const std::string given = register_name(offer.name) + "?";
    return std::ranges::none_of(expected.inputs, [&](const std::string& word) { return word.starts_with(given); }) &&
           kept.is_kept(offer);
}

/// The state after this event; no value if the log does not allow the event here.
std::optional<Node> next(const Node& node, const runs::Offer& offer, const Wanted& expected, const KeptValues& kept,
                         const Stepped& stepped) {
    Node result = node;
    result.term = offer.step.target;
    if (offer.hidden) return result;
    const LogRole role = log_role(offer.happening.event);
    if (role == LogRole::tock) {
        if (node.tocks == expected.tocks || node.outputs < expected.outputs.size()) return std::nullopt;
        ++result.tocks;
        return result;
    }
    if (role == LogRole::termination) return expected.terminates ? std::optional(result) : std::nullopt;
    if (offer.happening.event.kind == Kind::empty_read) {
        const std::string input = register_name(offer.name) + "?";
        const bool full =
            std::ranges::any_of(node.left, [&](const std::string& word) { return word.starts_with(input); });
        return full ? std::nullopt : std::optional(result);
    }
    if (reads_kept_value(offer, expected, kept)) return result;
    const std::string word = word_of(offer, stepped);
    if (role == LogRole::input) return result.left.erase(word) > 0 ? std::optional(result) : std::nullopt;
    if (role != LogRole::output) return result;
    if (node.outputs == expected.outputs.size() || expected.outputs[node.outputs] != word) return std::nullopt;
    ++result.outputs;
    return result;
}

/// Takes steps of the model that match one cycle of the log. Returns false if the model has no such steps.
bool follow_cycle(runs::Stepper& stepper, const Wanted& expected, const Stepped& stepped, Run& run) {
    std::vector<Node> nodes{{stepper.current_term(), expected.inputs, 0, 0, 0, 0}};
    const KeptValues kept(stepper.steps_taken(), stepped);
    using Key = std::tuple<process::TermId, std::set<std::string>, std::size_t, std::size_t>;
    std::set<Key> seen;
    const auto take_way_to = [&](std::size_t at) {
        std::vector<std::size_t> offers;
        for (; at != 0; at = nodes[at].parent) offers.push_back(nodes[at].offer);
        for (auto offer = offers.rbegin(); offer != offers.rend(); ++offer) stepper.take_offer(*offer);
    };
    for (std::size_t at = 0; at < nodes.size() && at < most_searched; ++at) {
        run.budget().poll();
        if (nodes[at].outputs == expected.outputs.size() && nodes[at].tocks == expected.tocks) {
            take_way_to(at);
            return true;
        }
        const std::vector<runs::Offer> offers = stepper.offers_at(nodes[at].term);
        for (std::size_t i = 0; i < offers.size(); ++i) {
            auto found = next(nodes[at], offers[i], expected, kept, stepped);
            if (!found || !seen.insert({found->term, found->left, found->outputs, found->tocks}).second) continue;
            found->parent = at;
            found->offer = i;
            nodes.push_back(std::move(*found));
        }
    }
    return false;
}

/// True if a constant of the model has the value of this "NAME=VALUE".
bool has_constant(const Stepped& stepped, const std::string& constant) {
    if (stepped.project == nullptr) return false;
    const auto& constants = stepped.project->asked.constants;
    const auto found = constants.find(constant.substr(0, constant.find('=')));
    return found != constants.end() && constant == found->first + "=" + found->second;
}

std::unique_ptr<std::istream> open_log(const std::string& path, diagnostics::Pollable& limits) {
    try {
        if (auto in = conformance::open_log(path, limits)) return in;
    } catch (const conformance::McapFault& fault) {
        throw Unsayable{fmt::format("{}: {}", path, fault.what())};
    }
    throw Unsayable{fmt::format("{}: cannot be read", path)};
}

/// The cycles of the first run. Throws Unsayable if the log cannot be read.
std::vector<Wanted> read_log(const std::string& path, const Stepped& stepped, diagnostics::Pollable& limits) {
    const std::unique_ptr<std::istream> in = open_log(path, limits);
    conformance::LineReader reader(*in);
    conformance::TraceHeader header;
    std::vector<Wanted> cycles;
    std::vector<conformance::TraceToken> tokens;
    bool run = false, first = true;
    try {
        while (reader.read_line()) {
            conformance::split_line(reader.line_text(), tokens);
            if (tokens.empty()) continue;
            if (first && tokens.front().text != "robochart-trace")
                throw Unsayable{fmt::format("{}: is no log: it does not begin with `robochart-trace 1`", path)};
            if (std::exchange(first, false)) continue;
            if (tokens.front().text == "run") {
                if (run) break;
                run = true;
                cycles.emplace_back();
                continue;
            }
            if (!run) {
                (void)conformance::read_header_line(tokens, header, reader.line_number());
                continue;
            }
            for (const conformance::TraceToken& token : tokens) {
                const std::string word(token.text);
                Wanted& cycle = cycles.back();
                if (cycle.line == 0) cycle.line = reader.line_number();
                if (word == "tock") {
                    if (++cycle.tocks == header.cycle) cycles.emplace_back();
                } else if (word == "terminate") {
                    cycle.terminates = true;
                } else if (word.find('?') != std::string::npos) {
                    cycle.inputs.insert(word);
                } else {
                    cycle.outputs.push_back(word);
                }
            }
        }
    } catch (const conformance::TraceFault&) {
        throw Unsayable{fmt::format("{}:{}: is no line of a log", path, reader.line_number())};
    }
    if (!header.component.empty() && header.component != stepped.name)
        throw Unsayable{fmt::format("{}: is a log of {}", path, header.component)};
    for (const std::string& constant : header.constants)
        if (!stepped.any_constants && !has_constant(stepped, constant))
            throw Unsayable{fmt::format("{}: is a log of the model with {} (--const {})", path,
                                        diagnostics::escape_for_display(constant),
                                        diagnostics::escape_for_display(constant))};
    return cycles;
}

}  // namespace

LogRole log_role(const runs::Event& event) {
    switch (event.kind) {
        case Kind::input:
        case Kind::external_write:
        case Kind::read:
            return LogRole::input;
        case Kind::output:
        case Kind::call:
        case Kind::assignment:
            return LogRole::output;
        case Kind::tock:
            return LogRole::tock;
        case Kind::terminate:
            return LogRole::termination;
        case Kind::transition:
        case Kind::entered:
        case Kind::exited:
        case Kind::refusal:
        case Kind::internal:
        case Kind::event:
        case Kind::empty_read:
        case Kind::cycle_end:
            return LogRole::none;
    }
    return LogRole::none;
}

std::optional<std::string> log_word(const runs::Event& event, std::string name, const Stepped& stepped) {
    const std::string of_register = register_name(name);
    name = name.substr(0, name.find('.'));
    if (const std::string prefix = stepped.name + "::"; name.starts_with(prefix)) name = name.substr(prefix.size());
    for (const std::string_view before : {"set_EXT_", "set_"})
        if (name.starts_with(before) && (event.kind == Kind::assignment || event.kind == Kind::external_write)) {
            name = name.substr(before.size());
            break;
        }
    if (event.kind == Kind::call && name.ends_with("Call")) name.resize(name.size() - 4);
    if (!of_register.empty()) name = of_register;
    std::string word = name + (log_role(event) == LogRole::input ? "?" : "!");
    const std::vector<runs::Value> values = logged_values(event);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string& text = values[i].text;
        const bool plain = std::ranges::all_of(text, [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
        });
        if (!plain) return std::nullopt;
        word += (i > 0 ? "!" : "") + text;
    }
    return word;
}

std::optional<ReadRegister> read_register(const runs::Offer& offer) {
    const runs::Event& event = offer.happening.event;
    if (event.kind != Kind::read && event.kind != Kind::empty_read) return std::nullopt;
    const std::vector<runs::Value> values = logged_values(event);
    const bool valued = event.kind == Kind::read && !values.empty();
    return ReadRegister{register_name(offer.name), valued ? values.front().text : "", !reads_variable(event)};
}

KeptValues::KeptValues(const std::vector<runs::Taken>& steps, const Stepped& stepped) : stepped_(stepped) {
    for (const runs::Taken& step : steps) {
        const runs::Event& event = step.offer.happening.event;
        if (step.offer.hidden || event.values.empty()) continue;
        if (reads_variable(event) || event.kind == Kind::assignment)
            values_[register_name(step.offer.name)] = event.values.back().text;
    }
}

/// A register begins with the default of its type, as in the code (docs/robosim.md, "Code").
bool KeptValues::is_default(const runs::Offer& read) const {
    if (stepped_.project == nullptr) return false;
    const auto script = stepped_.project->scripts.find(csp_emit::Time::timed);
    if (script == stepped_.project->scripts.end()) return false;
    const std::size_t constructor = read.name.find('.');  // "P::S::registerRead.P::S::i_x.3"
    const std::size_t value = read.name.find('.', constructor + 1);
    if (value == std::string::npos) return false;
    const auto& events = script->second.provenance.events;
    const auto meaning = events.find(read.name.substr(0, value));
    if (meaning == events.end() || meaning->second.types.empty()) return false;
    const ir::System& system = stepped_.project->system;
    const ir::TypeId type = meaning->second.types.back();
    const ir::Value first = ir::default_value(system, stepped_.project->instantiation, type);
    return read.name.substr(value + 1) == cpp_emit::cspm_value(system, type, first);
}

bool KeptValues::is_kept(const runs::Offer& read) const {
    const auto known = values_.find(register_name(read.name));
    if (known == values_.end()) return is_default(read);
    return read.happening.event.values.back().text == known->second;
}

std::string log_head(const Stepped& stepped) {
    std::string constants;
    if (stepped.project != nullptr)
        for (const auto& [name, value] : stepped.project->asked.constants)
            constants += fmt::format("const {}={}\n", name, value);
    return fmt::format("robochart-trace 1\ncomponent {}\ncycle {}\n{}run by hand\n", stepped.name,
                       stepped.cycle.value_or(1), constants);
}

namespace {

/// Returns the log with the record of the run in a comment below its first line.
std::string with_comment(std::string log, const RunRecord& record) {
    return log.insert(log.find('\n') + 1, fmt::format("// run: {}\n", run_line(record)));
}

/// An MCAP file with the log. A log that is stepped by hand has no times.
std::string mcap_of(const std::string& log) {
    McapWriter writer("/trace");
    std::string bytes = writer.begin();
    bytes += writer.chunk(log, 0);
    return bytes + writer.end();
}

}  // namespace

std::string save_way(const runs::Stepper& stepper, const Stepped& stepped, const std::string& path, Run& run) {
    const std::string extension = std::filesystem::path(path).extension().string();
    const bool is_log = extension == ".trace" || extension == ".mcap";
    if (stepped.project == nullptr) return "only the ways of components are saved";
    try {
        std::string text;
        if (is_log)
            text = with_comment(log_text(stepper, stepped), run.recorder().record());
        else if (extension == ".assertions")
            text = assertion_text(stepper, stepped, path);
        else
            return fmt::format("{}: what is saved is a log, FILE.trace or FILE.mcap, or an assertion, FILE.assertions",
                               path);
        std::error_code code;
        if (std::filesystem::exists(std::filesystem::symlink_status(path, code)))
            return fmt::format("{} is there already, and stays as it is", path);
        if (is_log && stepped.time != csp_emit::Time::timed) return "logs have time; the untimed semantics has none";
        return diagnostics::replace_file(path, extension == ".mcap" ? mcap_of(text) : text, &run.budget());
    } catch (const Unsayable& what) {
        return what.why;
    }
}

Followed follow_log(runs::Stepper& stepper, const Stepped& stepped, const std::string& path, Run& run) {
    if (stepped.project == nullptr || stepped.time != csp_emit::Time::timed) return {"logs are of components, in time"};
    run.recorder().add_input_file(path);
    try {
        const std::vector<Wanted> cycles = read_log(path, stepped, run.budget());
        stepper.back_to(0);
        for (std::size_t i = 0; i < cycles.size(); ++i)
            if (!follow_cycle(stepper, cycles[i], stepped, run))
                return {fmt::format("{}:{}: cycle {} cannot be followed from here", path, cycles[i].line, i + 1)};
        return {};
    } catch (const Unsayable& what) {
        return {what.why};
    }
}

}  // namespace robochart::app
