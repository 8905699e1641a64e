// SPDX-License-Identifier: Apache-2.0
// See code_certificate.hpp. The file code.txt of a certificate contains all that robochart-replay needs to build the
// code and to run the table: the sources with their digests, the interface, and a text for each state of the code.
#include "conformance/check/code_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/cache/sha256.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "checker/certify/certificate.hpp"
#include "checker/certify/process_text.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/refine/search/budget.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/model/normal_form.hpp"
#include "conformance/model/register_system.hpp"
#include "cpp_emit/load/shared_library.hpp"

namespace robochart::conformance {

namespace {

/// Thrown if there is no certificate; the message contains the reason.
class NoCertificate : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The specification as text, with the script that defines it.
struct Specification {
    std::string text;
    std::string script;
};

std::string text_of(lts::TransitionSystem& process, cspm::Session& session, refine::Budget& budget) {
    std::optional<std::string> text = certify::process_text(process, session.terms(), budget);
    if (!text)
        throw NoCertificate(fmt::format("the specification is not compiled and has more than {} states",
                                        certify::most_explicit_states));
    return std::move(*text);
}

/// Reads a printed script. The specification is then what its text says: in the tree of a normal form, composite values
/// are names (normal_form.cpp).
cspm::Script read_again(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    cspm::Script script = cspm::read(sources, sources.add("model.csp", text), findings);
    if (!findings.ok()) throw NoCertificate("the script with the normal form cannot be read");
    return script;
}

/// The normal form, as components and rules. Registers are read in the order in which the table reads them.
Specification normal_form_part(const ConformingCode& checked, const Options& options, refine::Budget& budget) {
    process::EventTable events;
    const Alphabet alphabet(checked.interface, events);
    NormalFormScript form =
        normal_form(checked.script.definitions, checked.process, alphabet, options.cycle_length, Reading::fixed_order);
    cspm::Script script = checked.script.definitions;
    script.decls.insert(script.decls.end(), form.decls.begin(), form.decls.end());
    const std::string text = cspm::print(script);
    cspm::Session session(read_again(text));
    const auto system = session.whole_system(form.process, options.limits);
    return {text_of(*system, session, budget), text};
}

/// The RoboSim component with the events of the code, state by state.
Specification register_part(const ConformingCode& checked, const Options& options, refine::Budget& budget) {
    cspm::Session session(checked.script.definitions);
    const auto model = session.system(checked.process, options.limits);
    const Alphabet alphabet(checked.interface, session.event_table());
    ModelGraph graph(*model, alphabet);
    RegisterSystem system(graph, alphabet, options.cycle_length, AfterEnd::stop);
    return {text_of(system, session, budget), cspm::print(checked.script.definitions)};
}

/// The explored code: its process, and the states in which cycles begin.
struct Table {
    std::string process;
    std::string states;  ///< the part of code.txt about them
};

/// Replaces control characters, so that a text is one line.
std::string in_one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
    return text;
}

Table explore_table(const ConformingCode& checked, const Options& options, refine::Budget& budget) {
    process::EventTable events;
    const Alphabet alphabet(checked.interface, events);
    CodeSystem code(checked.code, alphabet, options.cycle_length);
    code.set_budget(budget);
    const lts::Exploration found = lts::explore(code, [&](std::size_t states) {
        budget.poll();
        if (states > certify::most_explicit_states)
            throw NoCertificate(fmt::format("the table has more than {} states", certify::most_explicit_states));
        if (code.cycle_count() > most_rows)
            throw NoCertificate(fmt::format("the table has more than {} rows", most_rows));
    });
    if (!code.unsound_reason().empty()) throw NoCertificate(code.unsound_reason());
    Table table{certify::graph_text(found.graph, events, budget),
                fmt::format("states {}\n", code.started_images().size())};
    std::vector<lts::Word> state(code.width());
    for (const std::uint32_t image : code.started_images()) {
        code.enter_cycle(state, image);
        table.states += fmt::format("state {} {}\n", found.states.find(state), in_one_line(code.print_image(image)));
    }
    return table;
}

/// Returns the names of a carrier's values 0, 1, ... in events; empty if values are written as numbers.
std::vector<std::string> names_of(const Carrier& carrier) {
    if (carrier.kind == Carrier::Kind::boolean) return {cspm_text(carrier, 0), cspm_text(carrier, 1)};
    return carrier.kind == Carrier::Kind::enumeration ? carrier.names : std::vector<std::string>();
}

std::string interface_part(const Interface& interface) {
    std::string text = fmt::format("inputs {}\n", interface.inputs.size());
    for (const Register& input : interface.inputs) {
        text += fmt::format("input {} {}\n", input.texts.size(), input.name);
        for (const std::string& value : input.texts) text += certify::one_line(value) + "\n";
    }
    text += fmt::format("outputs {}\n", interface.outputs.size());
    for (const Output& output : interface.outputs) {
        text += fmt::format("output {} {}\n", output.arguments.size(), output.name);
        for (const Carrier& carrier : output.arguments) {
            const std::vector<std::string> names = names_of(carrier);
            text += fmt::format("argument {}\n", names.size());
            for (const std::string& name : names) text += certify::one_line(name) + "\n";
        }
    }
    return text;
}

std::string code_text(const ConformingCode& checked, const Table& table, const Options& options) {
    std::vector<std::string> compiled = checked.emission.sources;
    compiled.push_back(checked.emission.shim);
    const cpp_emit::BuildOptions build{options.compiler, options.flags, "", nullptr, nullptr};
    std::string text = fmt::format(
        "robochart-verify code 1\ncomponent: {}\ncycle: {}\nbuild: {}\nimplementation-sha256: {}\nsources {}\n",
        checked.code.component, options.cycle_length, cpp_emit::build_command(build, compiled, "OBJECT"),
        diagnostics::sha256(table.process), checked.emission.files.size());
    for (const cpp_emit::OutputFile& file : checked.emission.files)
        text += fmt::format("{} {}\n", diagnostics::sha256(file.text), file.path);
    text += interface_part(checked.interface) + table.states;
    return text + fmt::format("end-sha256: {}\n", diagnostics::sha256(text));
}

std::shared_ptr<const certify::Certificate> certificate_of(const ConformingCode& checked, const Options& options) {
    if (options.relation != Relation::failures_divergences)
        throw NoCertificate("there are no certificates for tick-tock");
    refine::Budget budget(options.limits, refine::Progress::Phase::compiling);
    const Table table = explore_table(checked, options, budget);
    const bool robosim = checked.interface.robosim;
    Specification specification =
        robosim ? register_part(checked, options, budget) : normal_form_part(checked, options, budget);
    auto result = std::make_shared<certify::Certificate>(
        certify::refinement_certificate({robosim ? "the component [FD= its code" : "assert NF__ [FD= Code__",
                                         options.certified, diagnostics::sha256(specification.script)},
                                        std::move(specification.text), table.process));
    for (const cpp_emit::OutputFile& file : checked.emission.files)
        result->further.push_back({"code/" + file.path, file.text});
    result->further.push_back({"model.csp", specification.script});
    result->further.push_back({"code.txt", code_text(checked, table, options)});
    return result;
}

}  // namespace

void certify_code(Result& result, const ConformingCode& checked, const Options& options) {
    try {
        result.certificate = certificate_of(checked, options);
    } catch (const NoCertificate& reason) {
        result.certificate_failure = reason.what();
    } catch (const process::Interrupted& limit) {
        result.certificate_failure = limit.what();
    } catch (const std::length_error& limit) {
        result.certificate_failure = limit.what();
    } catch (const AlphabetError& mismatch) {
        result.certificate_failure = mismatch.what();
    } catch (const cspm::EvaluationError& error) {
        result.certificate_failure = error.what();
    }
}

}  // namespace robochart::conformance
