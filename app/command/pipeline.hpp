// The phases of one run over a model, each made once and on demand (docs/architecture.md has the table).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "app/command/options.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::app {

/// Everything known about the model of this run.
struct Project {
    explicit Project(
        std::shared_ptr<diagnostics::SourceManager> shared = std::make_shared<diagnostics::SourceManager>())
        : texts(std::move(shared)), sources(*texts) {}

    std::string name;    ///< of the first input, without folder and extension: names the files written
    std::string label;   ///< in front of what is said of it: "NAME: " where parts have components of one name
    std::string folder;  ///< below which its components' files go: "NAME/" there
    std::shared_ptr<diagnostics::SourceManager> texts;
    diagnostics::SourceManager& sources;  ///< of all parts of a run
    diagnostics::Diagnostics diagnostics;
    std::unique_ptr<frontend::Model> model;
    ir::System system;
    ir::InstantiationOptions asked;  ///< what the options ask of its instantiation
    ir::Instantiation instantiation;
    std::set<std::string> shared_names;  ///< that components of one kind in several of its packages have
    double seconds = 0;                  ///< reading, resolving, lowering
    std::map<csp_emit::Time, csp_emit::Emission> scripts;  ///< those that were asked for (emit_csp)
};

/// Reads the inputs, lowers them and makes them finite, as one. Stops after the first phase with errors; `diagnostics`
/// has them, and what the options name and the model does not have.
[[nodiscard]] std::unique_ptr<Project> load(const Options&);

/// The options with what the swarm's file says where they leave it open: constants, ranges, and with a grid the timed
/// semantics. Errors of that file are reported where the swarm is composed. Throws UsageError where options about a
/// swarm are given and none is named, or cannot be meant.
[[nodiscard]] Options with_swarm(Options);

/// The inputs, part by part: what does not belong together is resolved and made finite apart
/// (frontend/project/units.hpp), each part as if it were alone. One part where it all belongs together. A part with
/// errors is not lowered or made finite; its diagnostics have them. What the options name has to be in some part. The
/// words of --assertion become the names of the claims that they mean (claim_selection.hpp).
struct Part {
    std::unique_ptr<Project> project;
    bool again = false;  ///< its components are in a part before it too
};
[[nodiscard]] std::vector<Part> load_parts(Options&);
/// The same as far as reading and resolving go, whatever the instantiations; errors are in the diagnostics.
[[nodiscard]] std::vector<Part> read_parts(const Options&);

/// Whether the claim of this name is to be decided: all are where none is named.
[[nodiscard]] bool asked_for(const Options&, const std::string& claim);

/// Whether the core properties of a part are checked: asked for, or because the model claims nothing and assertions are
/// to be checked; not of components that a part before it has.
[[nodiscard]] bool core_wanted(const Part&, const Options&);

/// The semantics in one time, type checked; diagnostics are added to the project's. Made when it is first asked for, by
/// the options of that time, and kept with the project. Throws std::logic_error where the script is wrong and nothing
/// of it is the user's.
[[nodiscard]] const csp_emit::Emission& emit_csp(Project&, const Options&, csp_emit::Time);

/// The components that C++ is made for: the modules, without any the controllers, without any the machines;
/// or the one of the name asked for (any kind). Empty with a diagnostic if there is none.
[[nodiscard]] std::vector<ir::ComponentRef> code_components(const ir::System&, const std::string& wanted);

/// A component's name in names of files and of generated code: letters, digits and underscores. Its package is part of
/// it where components of other packages have its name.
[[nodiscard]] std::string file_name(const Project&, const ir::ComponentRef&);

/// A text that is no model: a file, or standard input where the path is "-". Nothing where it cannot be read; `error`
/// says why.
[[nodiscard]] std::optional<diagnostics::SourceId> load_input(diagnostics::SourceManager&, const std::string& path,
                                                              std::string& error);

/// "; it has patrol.scenario": what may have been meant where a folder is given for a file; "" if nothing.
[[nodiscard]] std::string files_inside(const std::string& folder, std::string_view ending);

/// Writes a file below `--out`; false with a diagnostic where it cannot, or where this run has already written one of
/// that name.
bool write_output(Project&, const Options&, const std::string& path, const std::string& text);

/// The exit code of a run that ends with errors: wrong usage where all of them are about the command line.
[[nodiscard]] Exit refusal(const Project&);

/// No errors, and no warnings where they are denied.
[[nodiscard]] bool acceptable(const Project&, const Options&);

/// Prints the project's diagnostics as text to stderr.
void show_findings(const Project&, const Options&);
/// The same; in a format for programs those that refuse the model are the answer, on stdout. Returns whether they are
/// acceptable.
bool show_diagnostics(const Project&, const Options&);

}  // namespace robochart::app
