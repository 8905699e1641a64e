// SPDX-License-Identifier: Apache-2.0
// See incremental.hpp. The stored results of a file are reused if a new resolution would give the same results. The
// results depend on the file's own text, on the parts of other files that are visible in it (`outside_of`), and on a
// few facts about the project. All of these are compared.
#include "frontend/project/incremental.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontend/checks/checks.hpp"
#include "frontend/lint/lints.hpp"
#include "frontend/project/clear_resolution.hpp"
#include "frontend/project/project.hpp"
#include "frontend/project/tree_patch.hpp"
#include "frontend/resolve/resolver.hpp"
#include "frontend/syntax/file_visitor.hpp"

namespace robochart::frontend {

namespace {

using diagnostics::Diagnostic;
using diagnostics::SourceId;
using Findings = std::vector<Diagnostic>;

/// The stored results of a file.
struct Known {
    std::string outside;               ///< the parts that are visible in other files, as text; computed on first use
    Findings names;                    ///< findings about names and types
    bool asked_lost = false;           ///< an unresolved name may be declared in text that could not be parsed
    std::optional<Findings> warnings;  ///< warnings about single machines; no value if they were not computed
    bool changed = false;              ///< the tree was replaced
};

/// Names in text that could not be parsed. References to them are not reported.
struct Lost {
    std::set<std::string> names;
    bool declarations = false;
    bool operator==(const Lost&) const = default;
};

Lost lost_in(const Model& model) {
    Lost lost;
    for (const auto& file : model.files) {
        lost.names.insert(file->lost_names.begin(), file->lost_names.end());
        lost.declarations = lost.declarations || file->lost_declarations;
    }
    return lost;
}

/// Appends one character for each declaration that is visible in other files. The character shows whether the
/// declaration contains a syntax error.
void add_broken(const Declaration& declaration, std::string& out) {
    out += declaration.broken ? '!' : '.';
    const auto* component = dynamic_cast<const Component*>(&declaration);
    if (component == nullptr) return;
    for (const auto& part : component->platforms) add_broken(*part, out);
    for (const auto& part : component->controllers) add_broken(*part, out);
    for (const auto& part : component->machines) add_broken(*part, out);
    for (const auto& part : component->operations) add_broken(*part, out);
}

std::string broken_in(const File& file) {
    std::string out;
    for (const auto& declaration : file.declarations) add_broken(*declaration, out);
    return out;
}

bool has_components(const File& file) {
    return std::ranges::any_of(file.declarations, [](const auto& declaration) {
        return dynamic_cast<const Component*>(declaration.get()) != nullptr;
    });
}

/// Finds types with sizes. A size may be a constant whose own type is not known yet, depending on the order of files.
struct SizeFinder {
    bool found = false;
    void visit(const TypeExpr& type) { found = found || !type.sizes.empty(); }
    template <class Other>
    void visit(const Other&) {}
};

bool has_sizes(File& file) {
    SizeFinder finder;
    Traversal(finder).visit_file(file);
    return finder.found;
}

bool points_into(const Findings& findings, const std::set<SourceId>& sources) {
    return std::ranges::any_of(findings, [&](const Diagnostic& finding) {
        const auto in = [&](const auto& located) { return sources.contains(located.span.source); };
        return std::ranges::any_of(finding.notes, in) || std::ranges::any_of(finding.fixes, in);
    });
}

void report_again(const Findings& findings, Diagnostics& out) {
    for (const Diagnostic& finding : findings) {
        Diagnostic& again = out.report(*finding.rule, finding.span, finding.arguments);
        again.notes = finding.notes;
        again.fixes = finding.fixes;
    }
}

/// True if there are so few findings that all were stored and no search for a fix was skipped.
bool are_few(const Diagnostics& findings) {
    return findings.error_count() < Diagnostics::max_kept && findings.warning_count() < Diagnostics::max_kept;
}

}  // namespace

class Resolution::State {
public:
    void replace(std::unique_ptr<File>& place, std::unique_ptr<File> fresh);
    void forget_results() {
        known_.clear();
        valid_ = false;
    }
    void resolve(Model& model, Diagnostics& out);
    [[nodiscard]] std::size_t files_resolved() const { return files_resolved_; }

private:
    [[nodiscard]] bool must_begin_anew(const Model& model) const;
    bool run(Model& model, Diagnostics& out);
    [[nodiscard]] bool resolve_names(Model& model, const Names& names, const std::vector<File*>& files,
                                     Diagnostics& out);
    void add_warnings(const Model& model, const Names& names, Diagnostics& out);

    std::map<SourceId, Known> known_;
    Lost lost_;
    WrittenBy written_by_;
    bool valid_ = false;           ///< the results of every file are those of the last `resolve`
    bool many_ = false;            ///< the last `resolve` had too many findings to store
    bool broken_changed_ = false;  ///< since the last `resolve`, a declaration gained or lost its syntax errors
    std::size_t files_resolved_ = 0;
};

void Resolution::State::replace(std::unique_ptr<File>& place, std::unique_ptr<File> fresh) {
    const auto known = known_.find(fresh->source);
    const auto looks_the_same = [&] {
        std::string& outside = known->second.outside;
        if (outside.empty()) outside = outside_of(*place);
        return outside_of(*fresh) == outside && same_declarations(*place, *fresh);
    };
    const bool may_live_on = valid_ && known != known_.end() && looks_the_same();
    if (!may_live_on) {
        forget_results();
        place = std::move(fresh);
        return;
    }
    known->second.changed = true;
    broken_changed_ = broken_changed_ || broken_in(*place) != broken_in(*fresh);
    patch_file(*place, std::move(*fresh));
}

/// True if some file has no stored results, or if results are stored for a file that is not in the model.
bool Resolution::State::must_begin_anew(const Model& model) const {
    return !valid_ || known_.size() != model.files.size() ||
           std::ranges::any_of(model.files, [&](const auto& file) { return !known_.contains(file->source); });
}

void Resolution::State::resolve(Model& model, Diagnostics& out) {
    if (must_begin_anew(model)) forget_results();
    Diagnostics found;
    found.set_budget(out.budget());
    if (!many_ && run(model, found) && are_few(found)) {
        valid_ = true;
        report_again(found.sorted_findings(), out);
        return;
    }
    forget_results();
    frontend::resolve(model, out);
    files_resolved_ = model.files.size();
    many_ = !are_few(out);
}

/// Resolves the model with the stored results. Returns false if they are not sufficient.
bool Resolution::State::run(Model& model, Diagnostics& out) {
    const bool anew = !valid_;
    Lost lost = lost_in(model);
    std::set<SourceId> changed;
    for (const auto& [source, known] : known_)
        if (known.changed) changed.insert(source);
    std::vector<File*> files;
    for (const auto& file : model.files) {
        Known& known = known_[file->source];
        known.changed = anew || known.changed || file->is_assertions || (known.asked_lost && lost != lost_) ||
                        (broken_changed_ && has_components(*file)) || points_into(known.names, changed);
        if (!anew && known.changed && !file->is_assertions && has_sizes(*file)) return false;
        if (known.changed) files.push_back(file.get());
        if (known.warnings && points_into(*known.warnings, changed)) known.warnings.reset();
    }
    lost_ = std::move(lost);
    broken_changed_ = false;
    files_resolved_ = files.size();
    for (File* file : files) reset(*file);
    const Names names(model);
    if (!resolve_names(model, names, files, out)) return false;
    check(model, names, out);
    add_warnings(model, names, out);
    for (auto& [source, known] : known_) known.changed = false;
    return true;
}

bool Resolution::State::resolve_names(Model& model, const Names& names, const std::vector<File*>& files,
                                      Diagnostics& out) {
    Diagnostics found;
    found.set_budget(out.budget());
    Finder finder(names, found);
    Resolver resolver(model, finder);
    for (File* file : files) {
        Known& known = known_[file->source];
        resolver.resolve_headers(*file);
        known.asked_lost = names.take_asked_lost();
        known.names.clear();
        known.warnings.reset();
    }
    for (File* file : files) {
        resolver.resolve_bodies(*file);
        known_[file->source].asked_lost |= names.take_asked_lost();
    }
    resolver.resolve_all_assertions();
    for (Diagnostic& finding : found.sorted_findings()) {
        const auto known = known_.find(finding.span.source);
        if (known == known_.end() || !known->second.changed) return false;
        known->second.names.push_back(std::move(finding));
    }
    for (const auto& file : model.files) report_again(known_[file->source].names, out);
    return true;
}

void Resolution::State::add_warnings(const Model& model, const Names& names, Diagnostics& out) {
    WrittenBy written_by = variables_written_by_operations(model);
    const bool same_writers = written_by == written_by_;
    written_by_ = std::move(written_by);
    const bool whole = may_lint_project(model, out);
    for (const auto& file : model.files) {
        Known& known = known_[file->source];
        if (!same_writers) known.warnings.reset();
        if (!may_lint(*file, out)) continue;
        if (!known.warnings) {
            Diagnostics found;
            found.set_budget(out.budget());
            lint_file(*file, names, written_by_, found);
            known.warnings = found.sorted_findings();
        }
        report_again(*known.warnings, out);
    }
    if (whole) lint_project(model, out);
}

Resolution::Resolution() : state_(std::make_unique<State>()) {}
Resolution::~Resolution() = default;

void Resolution::replace(std::unique_ptr<File>& place, std::unique_ptr<File> fresh) {
    state_->replace(place, std::move(fresh));
}

void Resolution::forget_results() {
    state_->forget_results();
}

void Resolution::resolve(Model& model, Diagnostics& out) {
    state_->resolve(model, out);
}

std::size_t Resolution::files_resolved() const {
    return state_->files_resolved();
}

}  // namespace robochart::frontend
