// SPDX-License-Identifier: Apache-2.0
// See export.hpp. The script reads registers in the same fixed order on both sides ("One order of reading").
#include "conformance/check/export.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "checker/cspm/syntax/reader.hpp"
#include "checker/process/operational_semantics.hpp"
#include "conformance/code/code_graph.hpp"
#include "conformance/model/normal_form.hpp"

namespace robochart::conformance {

namespace {

/// Declares the channel for errors of the code, which no normal form performs. Returns "" if the graph has no such
/// event.
std::string fault_channel(const lts::Graph& graph, const process::EventTable& events) {
    for (lts::StateIndex state = 0; state < graph.size(); ++state)
        for (const lts::Edge& edge : graph.edges(state))
            if (events.name(edge.event).starts_with("code."))
                return "datatype CodeFault__ = precondition | unknown_result\n"
                       "channel code : CodeFault__\n\n";
    return "";
}

std::string script_text(const lts::Graph& graph, const CheckedCode& checked, std::uint32_t cycle_length) {
    const NormalFormScript form =
        normal_form(checked.script.definitions, checked.process, checked.alphabet, cycle_length, Reading::fixed_order);
    std::ostringstream code;
    lts::write_csp(graph, checked.alphabet.events(), "Code__", code);
    return fmt::format(
        "-- {0}: the model, its normal form in cycles of {1} time unit{2}, and the compiled code, {3} states.\n\n"
        "{4}\n{5}\n{6}-- The compiled code, state by state.\n{7}\n"
        "assert NF__ [FD= Code__\n",
        checked.alphabet.interface().component, cycle_length, cycle_length == 1 ? "" : "s", graph.size(),
        cspm::print(checked.script.definitions), cspm::print(cspm::Script{form.decls}),
        fault_channel(graph, checked.alphabet.events()), code.str());
}

}  // namespace

void export_code(Result& result, const CheckedCode& checked, const Options& options) {
    if (options.exported == Export::csp && checked.alphabet.interface().robosim) {
        result.export_failure =
            "in RoboSim, there is no normal form for a script; .aut and .dot contain the code alone";
        return;
    }
    try {
        CodeSystem system(checked.code, checked.alphabet, options.cycle_length);
        const lts::Graph graph = explore_code(system, options.limits);
        std::ostringstream out;
        if (options.exported == Export::aut) lts::write_aut(graph, checked.alphabet.events(), out);
        if (options.exported == Export::dot) lts::write_dot(graph, checked.alphabet.events(), out);
        if (options.exported == Export::csp) out << script_text(graph, checked, options.cycle_length);
        result.exported = out.str();
    } catch (const process::Interrupted& limit) {
        result.export_failure = limit.what();
    } catch (const std::length_error& limit) {
        result.export_failure = limit.what();
    }
}

}  // namespace robochart::conformance
