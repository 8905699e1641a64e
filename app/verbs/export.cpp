// SPDX-License-Identifier: Apache-2.0
// Implements `cspm SCRIPT --export FORMAT PROCESS`, which writes all states of a process, for other tools and for FDR.
#include <fmt/ostream.h>

#include <cerrno>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/command/script.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/lts/graph.hpp"
#include "driver/claims/state_space.hpp"

namespace robochart::app {

/// Parses the process. Puts it on a separate line, so that findings show only the process.
cspm::DeclPtr parse_process(LoadedScript& loaded, const std::string& process, const std::string& origin) {
    const auto source = loaded.sources.add(origin, "assert (\n" + process + "\n) :[divergence free]\n");
    cspm::Script read = cspm::read(loaded.sources, source, loaded.diagnostics);
    if (!loaded.diagnostics.ok() || read.decls.size() != 1) return nullptr;
    loaded.script.decls.push_back(read.decls.front());
    loaded.types = cspm::check_types(loaded.script, loaded.diagnostics);
    return loaded.diagnostics.ok() ? read.decls.front() : nullptr;
}

namespace {

/// Returns the definitions of the script, without assertions and print statements.
cspm::Script definitions_only(const cspm::Script& script) {
    cspm::Script result;
    for (const cspm::DeclPtr& decl : script.decls)
        if (decl->kind != cspm::DeclKind::assertion && decl->kind != cspm::DeclKind::print)
            result.decls.push_back(decl);
    return result;
}

/// Returns `name`, extended until no word of the text begins with it.
std::string fresh_name(const std::string& text, std::string name) {
    while (text.find(name) != std::string::npos) name += "_";
    return name;
}

void write_script(const LoadedScript& loaded, const cspm::ExprPtr& process, const lts::Graph& graph,
                  const process::EventTable& events, std::ostream& out) {
    const std::string text = cspm::print(definitions_only(loaded.script));
    const std::string original = cspm::print(process);
    const std::string name = fresh_name(text + original, "Explicit");
    fmt::print(out, "-- {}: {} states, {} transitions, as {}.\n\n{}\n", original, graph.size(), graph.edge_count(),
               name, text);
    lts::write_csp(graph, events, name, out);
    fmt::print(out, "\n-- The two are equal.\nassert {0} [FD= {1}\nassert {1} [FD= {0}\n", "(" + original + ")", name);
}

Exit export_from(LoadedScript& loaded, const Options& options) {
    const cspm::DeclPtr parsed = parse_process(loaded, options.script.exported_process, "--export");
    if (!parsed) {
        show_findings(loaded, options);
        return Exit::bad_input;
    }
    cspm::Session session(loaded.script, &options.run->budget());
    const refine::Limits bounds = limits(options, options.script.exported_process);
    const cspm::ExprPtr& process = parsed->assertion.specification;
    const auto system = session.system(process, bounds);
    std::size_t known = 0;
    const lts::Graph graph = driver::explore_graph(*system, bounds, known);
    options.run->finish();
    // Output for a terminal is collected first, because print_exact escapes it. Other output is written directly.
    std::ostringstream seen;
    std::ostream& out = output_is_a_terminal() ? seen : std::cout;
    errno = 0;
    switch (options.script.exported.value()) {
        case GraphFormat::aut:
            lts::write_aut(graph, session.event_table(), out);
            break;
        case GraphFormat::dot:
            lts::write_dot(graph, session.event_table(), out);
            break;
        case GraphFormat::csp:
            write_script(loaded, process, graph, session.event_table(), out);
            break;
    }
    print_exact(seen.str());
    std::cout.flush();
    if (!std::cout) throw OutputError(errno);
    return Exit::success;
}

}  // namespace

Exit export_process(const Options& options) {
    if (options.load.inputs.size() != 1) {
        print_error("robochart-verify: --export takes one script\n");
        return Exit::usage;
    }
    options.run->last_word([&options](const std::string& why) {
        print_error("robochart-verify: {} before all states of {} were known; nothing is written\n", why,
                    options.script.exported_process);
        return Exit::inconclusive;
    });
    LoadedScript loaded;
    loaded.diagnostics.set_budget(&options.run->budget());
    load_script(options.load.inputs.front(), loaded);
    if (!loaded.diagnostics.ok()) {
        show_findings(loaded, options);
        return Exit::bad_input;
    }
    try {
        return export_from(loaded, options);
    } catch (const cspm::EvaluationError& error) {
        print_error("{}: {}\n", loaded.sources.path_and_line(error.span), error.what());
        return Exit::bad_input;
    }
}

}  // namespace robochart::app
