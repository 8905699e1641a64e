// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/blocks/check_blocks.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/blocks/check_script.hpp"
#include "csp_emit/emit.hpp"
#include "frontend/project/project.hpp"
#include "frontend/project/units.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::csp_emit {

namespace {

using diagnostics::Diagnostics;
using diagnostics::SourceId;
using diagnostics::SourceManager;
using diagnostics::Span;
using frontend::AssertionTime;
using frontend::CspBlock;

/// A copy of the texts of one unit, which is parsed and instantiated separately.
struct Copy {
    SourceManager sources;
    std::unique_ptr<frontend::Model> model;
    ir::System system;
    ir::Instantiation instantiation;
    bool good = false;
};

/// Copies the texts of files. If `blank` is true, the texts of CSP blocks are omitted.
Copy copy_of(const frontend::Model& model, const SourceManager& sources, const std::vector<std::size_t>& files,
             bool blank, diagnostics::Budget* budget) {
    Copy copy;
    Diagnostics found;
    found.set_budget(budget);
    std::vector<SourceId> texts;
    for (const std::size_t index : files) {
        const frontend::File& file = *model.files[index];
        std::string text(sources.source_text(file.source));
        for (const CspBlock& block : file.csp_blocks)
            for (std::uint32_t i = block.text_span.begin; blank && i < block.text_span.end; ++i)
                if (text[i] != '\n') text[i] = ' ';
        texts.push_back(copy.sources.add(sources.path(file.source), std::move(text)));
    }
    copy.model = frontend::load_texts(copy.sources, texts, found);
    if (!found.ok()) return copy;
    copy.system = ir::lower(*copy.model, copy.sources, found);
    if (!found.ok()) return copy;
    copy.instantiation = ir::instantiate_system(copy.system, {}, found);
    copy.good = found.ok();
    return copy;
}

class BlockCheck {
public:
    BlockCheck(const frontend::Model& model, const SourceManager& sources, Diagnostics& out)
        : model_(model), sources_(sources), out_(out) {
        for (const auto& file : model.files) files_[sources.path(file->source)] = file.get();
    }

    void check_unit(const std::vector<std::size_t>& files) {
        // Blocks of RoboSim name processes that the script does not have.
        const auto in_script = [&](std::size_t file) {
            return model_.files[file]->dialect == frontend::Dialect::robochart;
        };
        std::vector<std::size_t> alone;
        std::ranges::remove_copy_if(files, std::back_inserter(alone), in_script);
        read_alone(alone);
        const bool has_blocks = std::ranges::any_of(
            files, [&](std::size_t file) { return in_script(file) && !model_.files[file]->csp_blocks.empty(); });
        if (!has_blocks) return;
        Copy copy = copy_of(model_, sources_, files, false, out_.budget());
        if (!copy.good) {
            std::vector<std::size_t> rest;
            std::ranges::copy_if(files, std::back_inserter(rest), in_script);
            return read_alone(rest);
        }
        for (const Time time : {Time::untimed, Time::timed}) {
            const AssertionTime other = time == Time::timed ? AssertionTime::untimed : AssertionTime::timed;
            const bool needed = std::ranges::any_of(files, [&](std::size_t file) {
                return in_script(file) &&
                       std::ranges::any_of(model_.files[file]->csp_blocks,
                                           [&](const CspBlock& block) { return block.time != other; });
            });
            if (needed) check_emission(copy, time);
        }
    }

private:
    void check_emission(Copy& copy, Time time) {
        Diagnostics found;
        found.set_budget(out_.budget());
        const Emission emission = emit(copy.system, copy.instantiation, time, Options{}, copy.sources, found);
        if (found.ok()) check_script(emission, copy.system, found);
        report_findings(copy.sources, found);
    }

    /// Parses the blocks of a unit that has no script.
    void read_alone(const std::vector<std::size_t>& files) {
        for (const std::size_t index : files) {
            const frontend::File& file = *model_.files[index];
            for (const CspBlock& block : file.csp_blocks) {
                SourceManager copy;
                std::string text(sources_.source_text(file.source));
                for (std::uint32_t i = 0; i < text.size(); ++i)
                    if ((i < block.text_span.begin || i >= block.text_span.end) && text[i] != '\n') text[i] = ' ';
                Diagnostics found;
                found.set_budget(out_.budget());
                (void)cspm::read(copy, copy.add(sources_.path(file.source), std::move(text)), found);
                report_findings(copy, found);
            }
        }
    }

    /// Reports findings about assertion files at their places in the texts of the model, each once.
    void report_findings(const SourceManager& copy, const Diagnostics& found) {
        for (const diagnostics::Diagnostic& finding : found.sorted_findings()) {
            if (finding.rule->severity == diagnostics::Severity::note || !finding.span.is_known()) continue;
            const Span span = original_span(copy, finding.span);
            if (!span.is_known() || !files_.at(sources_.path(span.source))->is_assertions) continue;
            if (!said_.emplace(finding.rule, span.source, span.begin, finding.message()).second) continue;
            diagnostics::Diagnostic& reported = out_.report(*finding.rule, span, finding.arguments);
            for (const diagnostics::Note& note : finding.notes)
                reported.notes.push_back({original_span(copy, note.span), note.message});
            for (const diagnostics::FixIt& fix : finding.fixes)
                if (const Span place = original_span(copy, fix.span); place.is_known())
                    reported.fixes.push_back({place, fix.replacement, fix.title});
        }
    }

    /// Returns the span in the model's texts. The texts of blocks are separate sources, with the path and the offsets
    /// of their file.
    [[nodiscard]] Span original_span(const SourceManager& copy, Span span) const {
        if (!span.is_known()) return {};
        const auto file = files_.find(copy.path(span.source));
        return file == files_.end() ? Span{} : Span{file->second->source, span.begin, span.end};
    }

    const frontend::Model& model_;
    const SourceManager& sources_;
    Diagnostics& out_;
    std::map<std::string, const frontend::File*> files_;
    /// The findings reported so far. For lookup only.
    std::set<std::tuple<const diagnostics::Rule*, SourceId, std::uint32_t, std::string>> said_;
};

}  // namespace

void check_blocks(const frontend::Model& model, const SourceManager& sources, Diagnostics& out) {
    BlockCheck check(model, sources, out);
    for (const frontend::Unit& unit : frontend::split_into_units(model)) check.check_unit(unit.files);
}

std::optional<Emission> emission_without_blocks(const frontend::Model& model, const SourceManager& sources,
                                                SourceId assertions, Time time, diagnostics::Budget* budget) {
    for (const frontend::Unit& unit : frontend::split_into_units(model)) {
        const bool its_own =
            std::ranges::any_of(unit.files, [&](std::size_t file) { return model.files[file]->source == assertions; });
        if (!its_own) continue;
        Copy copy = copy_of(model, sources, unit.files, true, budget);
        if (!copy.good) return std::nullopt;
        Diagnostics found;
        found.set_budget(budget);
        // the findings concern claims about the omitted blocks, so they are ignored
        return emit(copy.system, copy.instantiation, time, Options{}, copy.sources, found);
    }
    return std::nullopt;
}

}  // namespace robochart::csp_emit
