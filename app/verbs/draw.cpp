// SPDX-License-Identifier: Apache-2.0
// The verb `draw`: draws the diagrams of all components of a model into a folder, or of one component
// (docs/diagrams.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>

#include "app/base/numbers.hpp"
#include "app/command/findings.hpp"
#include "app/command/option_table.hpp"
#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/pages/part_diagrams.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/programs.hpp"
#include "frontend/diagrams/exports/dot.hpp"
#include "frontend/diagrams/exports/mermaid.hpp"
#include "frontend/diagrams/layout/arrange.hpp"
#include "frontend/diagrams/svg/svg.hpp"

namespace robochart::app {
namespace {

/// True if the subject's name ends with this name ("S" or "C::S" for "P::C::S"), or if its file has this name.
bool is_called(const diagrams::Subject& subject, const std::string& name) {
    return subject.name == name || subject.file == name || subject.name.ends_with("::" + name);
}

/// One run of the verb.
class DiagramWriter {
public:
    explicit DiagramWriter(const Options& options) : options_(options) {
        options_.load.inputs = {options.load.inputs.front()};
        requested_.assign(options.load.inputs.begin() + 1, options.load.inputs.end());
        if (!options_.output.folder_given) options_.output.folder = "out/diagrams";
    }

    Exit run() {
        parts_ = driver::read_parts(options_.load, options_.run->budget());
        diagrams_.emplace(parts_, options_.run->budget());
        choose_subjects();
        if (has_places() && !parts_.empty()) parts_.front().project->diagnostics.add(diagrams_->stored_findings());
        std::optional<diagnostics::Budget::Phase> phase(std::in_place, options_.run->budget(), "drawing");
        written_ = requested_.size() == 1 ? draw_one() : draw_all();
        phase.reset();
        options_.run->finish();
        bool good = written_;
        for (const driver::Part& part : parts_) {
            show_findings(*part.project, options_);
            good = good && is_acceptable(*part.project, options_.load);
        }
        if (chosen_.empty() && good) print_error("robochart-verify: there is nothing to draw\n");
        return good && !chosen_.empty() ? Exit::success : Exit::bad_input;
    }

private:
    /// Selects the subjects that the command line names, or all if it names none. Throws UsageError.
    void choose_subjects() {
        for (const std::string& name : requested_) chosen_.push_back(&find_subject(name));
        if (!requested_.empty()) return;
        for (const PartSubject& part_subject : diagrams_->subjects()) chosen_.push_back(&part_subject);
    }

    [[nodiscard]] const PartSubject& find_subject(const std::string& name) const {
        std::vector<const PartSubject*> called;
        std::vector<std::string> known;
        for (const PartSubject& part_subject : diagrams_->subjects()) {
            if (part_subject.subject.name == name && part_subject.subject.component != nullptr) return part_subject;
            if (is_called(part_subject.subject, name)) called.push_back(&part_subject);
            known.push_back(part_subject.subject.name);
            if (part_subject.subject.component != nullptr) known.push_back(part_subject.subject.component->name);
        }
        if (called.empty())
            throw UsageError(fmt::format("the model has no component '{}'{}", name, did_you_mean(name, known)));
        if (called.size() == 1) return *called.front();
        std::vector<std::string> names;
        for (const PartSubject* part_subject : called)
            names.push_back(part_subject->subject.file + " (" + part_subject->subject.name + ")");
        throw UsageError(fmt::format("'{}' may be {}", name, fmt::join(names, ", ")));
    }

    /// Returns the diagram in the selected format. If it cannot be drawn, reports a diagnostic and returns no value.
    std::optional<std::string> text_of(const PartSubject& drawn) {
        diagrams::SvgOptions style;
        if (options_.draw.theme == Theme::light || options_.draw.picture != PictureFormat::svg)
            style.theme = diagrams::Theme::light;
        if (options_.draw.theme == Theme::dark) style.theme = diagrams::Theme::dark;
        try {
            const diagrams::Picture picture = diagrams::draw_subject(
                drawn.subject, {*drawn.elements, nullptr, &options_.run->budget(), layout_of(drawn)});
            if (options_.draw.picture == PictureFormat::mermaid) return diagrams::render_mermaid(picture);
            if (options_.draw.picture == PictureFormat::dot) return diagrams::render_dot(picture);
            const std::string text = diagrams::render_svg(picture, *drawn.elements, style);
            return options_.draw.picture == PictureFormat::svg ? text : convert_svg(drawn, text);
        } catch (const diagrams::layout::TooLarge& large) {
            return report_unwritable(drawn, fmt::format("{}: {}", drawn.subject.name, large.what()));
        }
    }

    /// Returns the file extension of the selected format.
    [[nodiscard]] const char* ending() const {
        constexpr std::array<const char*, 5> endings{"svg", "png", "pdf", "mmd", "dot"};
        return endings[static_cast<std::size_t>(options_.draw.picture)];
    }

    /// True if this program computes the layout of the selected format.
    [[nodiscard]] bool has_places() const {
        return options_.draw.picture != PictureFormat::mermaid && options_.draw.picture != PictureFormat::dot;
    }

    /// Returns the layout that a person drew, if there is one.
    [[nodiscard]] const diagrams::StoredLayout* layout_of(const PartSubject& drawn) const {
        if (!has_places()) return nullptr;
        diagrams_->explain_layout(drawn);
        return drawn.layout;
    }

    static std::nullopt_t report_unwritable(const PartSubject& drawn, const std::string& why) {
        drawn.project->diagnostics.report(rules::unwritable, {}, {why});
        return std::nullopt;
    }

    /// Converts the diagram with rsvg-convert, in a temporary folder.
    std::optional<std::string> convert_svg(const PartSubject& drawn, const std::string& text) {
        std::string error;
        diagnostics::Budget* budget = &options_.run->budget();
        const diagnostics::TemporaryFolder folder("", error, budget);
        if (error.empty()) error = diagnostics::write_below(folder.path(), "diagram.svg", text, budget);
        if (!error.empty()) return report_unwritable(drawn, error);
        const std::string made = folder.path() + "/diagram";
        const std::string log = folder.path() + "/log";
        const int status = diagnostics::run_program(
            {"rsvg-convert", "--format", ending(), "--output", made, folder.path() + "/diagram.svg"}, log, error,
            budget);
        if (status < 0)
            return report_unwritable(
                drawn,
                fmt::format("{}; it makes PNG and PDF: on Debian, `apt install librsvg2-bin` installs it", error));
        if (status > 0)
            return report_unwritable(drawn, fmt::format("rsvg-convert failed with status {}: {}", status,
                                                        read_contents(log).substr(0, 500)));
        return read_contents(made);
    }

    static std::string read_contents(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    /// Draws to the file of `--out`, or to standard output.
    bool draw_one() {
        const PartSubject& drawn = *chosen_.front();
        const auto text = text_of(drawn);
        if (!text) return false;
        if (options_.output.folder_given && options_.output.folder != "-") {
            const std::string error = diagnostics::replace_file(options_.output.folder, *text, &options_.run->budget());
            if (!error.empty()) report_unwritable(drawn, error);
            return error.empty();
        }
        const bool binary = options_.draw.picture == PictureFormat::png || options_.draw.picture == PictureFormat::pdf;
        if (binary && output_is_a_terminal())
            throw UsageError(fmt::format("a terminal cannot show {}; write it to a file with --out FILE", ending()));
        print_exact(*text);
        return true;
    }

    bool draw_all() {
        const std::string extension = ending();
        bool good = true;
        for (const PartSubject* chosen : chosen_) {
            const PartSubject& drawn = *chosen;
            const std::string file = drawn.subject.file + "." + extension;
            const auto text = text_of(drawn);
            if (!text || !write_output(*drawn.project, options_, file, *text)) {
                good = false;
                continue;
            }
            if (!options_.output.quiet)
                print("  {:<60} {:>12} bytes\n", options_.output.folder + "/" + file, with_commas(text->size()));
        }
        return good;
    }

    Options options_;
    std::vector<std::string> requested_;
    std::vector<driver::Part> parts_;
    std::optional<PartDiagrams> diagrams_;
    std::vector<const PartSubject*> chosen_;  ///< elements of diagrams_
    bool written_ = false;
};

}  // namespace

Exit run_draw(const Options& options) {
    options.run->last_word([](const std::string& why) {
        print_error("robochart-verify: inconclusive: {}\n", why);
        return Exit::inconclusive;
    });
    return DiagramWriter(options).run();
}

}  // namespace robochart::app
