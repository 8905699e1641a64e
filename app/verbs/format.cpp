// SPDX-License-Identifier: Apache-2.0
// The verb `format`: formats files in place, shows what would change, or formats standard input to standard output
// (docs/format.md).
#include "frontend/format/format.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/report/diff.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/fixes.hpp"
#include "base/diagnostics/render.hpp"
#include "claims/sleec/syntax/format.hpp"
#include "claims/syntax/layout.hpp"
#include "frontend/syntax/dialect.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::app {
namespace {

namespace fs = std::filesystem;
namespace syntax = frontend::syntax;

/// The language of a text.
enum class Language { model, assertions, rules, claims };

std::optional<Language> language_of(const fs::path& path) {
    if (frontend::is_model_path(path.string())) return Language::model;
    if (frontend::is_assertion_path(path.string())) return Language::assertions;
    if (path.extension() == ".sleec") return Language::rules;
    if (path.extension() == ".claims") return Language::claims;
    return std::nullopt;
}

/// One run of the verb.
class Formatting {
public:
    explicit Formatting(const Options& options) : options_(options) {}

    Exit run();

private:
    void format_input(const std::string& path);
    void format_file(const fs::path& path);
    void standard_input();
    void handle_change(const fs::path& path, std::string_view before, const std::string& after);
    void report_failure(const diagnostics::Rule& rule, std::vector<std::string> arguments);
    /// Returns the formatted text. If the text has syntax errors, shows them and returns no value.
    std::optional<std::string> format(diagnostics::SourceId source, Language language);
    void print_findings(const diagnostics::Diagnostics& diagnostics) const;
    [[nodiscard]] std::string closing_line() const;

    const Options& options_;
    diagnostics::SourceManager sources_;
    std::set<fs::path> seen_;
    std::size_t files_ = 0;
    std::size_t changed_ = 0;
    bool failed_ = false;
};

void Formatting::print_findings(const diagnostics::Diagnostics& diagnostics) const {
    const diagnostics::TextStyle style = findings_style(options_);
    print_error_styled(diagnostics::render_text(sources_, diagnostics, style));
}

void Formatting::report_failure(const diagnostics::Rule& rule, std::vector<std::string> arguments) {
    diagnostics::Diagnostics diagnostics;
    diagnostics.report(rule, {}, std::move(arguments));
    print_findings(diagnostics);
    failed_ = true;
}

std::optional<std::string> Formatting::format(diagnostics::SourceId source, Language language) {
    diagnostics::Diagnostics diagnostics;
    diagnostics.set_budget(&options_.run->budget());
    const auto formatted = [&] {
        switch (language) {
            case Language::rules:
                return sleec::format(sources_, source, diagnostics);
            case Language::claims:
                return claims::format(sources_, source, diagnostics);
            case Language::model:
            case Language::assertions:
                break;
        }
        return frontend::format(sources_, source, language == Language::assertions, diagnostics);
    };
    auto result = formatted();
    if (result) return result;
    print_findings(diagnostics);
    failed_ = true;
    return std::nullopt;
}

void Formatting::standard_input() {
    std::string error;
    std::string text = diagnostics::standard_input(diagnostics::SourceManager::max_bytes, error);
    if (!error.empty()) return report_failure(syntax::unreadable, {"-", error});
    const auto source = sources_.add("<stdin>", std::move(text));
    const auto result = format(source, options_.formatting.assertions ? Language::assertions : Language::model);
    if (!result) return;
    ++files_;
    const std::string_view before = sources_.source_text(source);
    if (options_.formatting.check || options_.formatting.diff) {
        if (*result != before) handle_change("<stdin>", before, *result);
    } else {
        print_exact(*result);
    }
}

void Formatting::handle_change(const fs::path& path, std::string_view before, const std::string& after) {
    ++changed_;
    if (options_.formatting.diff) return print_exact(unified_diff(path.string(), before, after));
    if (!options_.formatting.check) {
        const std::string error = diagnostics::replace_text(path.string(), after, &options_.run->budget());
        if (!error.empty()) return report_failure(rules::unwritable, {error});
    }
    if (options_.formatting.check || !options_.output.quiet)
        print("{}\n", diagnostics::escape_for_display(path.string()));
}

void Formatting::format_file(const fs::path& path) {
    std::error_code code;
    const fs::path canonical = fs::weakly_canonical(path, code);
    if (!seen_.insert(code ? path : canonical).second) return;
    std::string error;
    const auto source = sources_.load_file(path.string(), error);
    if (!source) return report_failure(syntax::unreadable, {path.string(), error});
    ++files_;
    const auto result = format(*source, language_of(path).value_or(Language::model));
    if (result && *result != sources_.source_text(*source)) handle_change(path, sources_.source_text(*source), *result);
}

void Formatting::format_input(const std::string& path) {
    if (path == "-") return standard_input();
    std::error_code code;
    if (!fs::is_directory(path, code)) return format_file(path);
    const diagnostics::FilesBelow found = diagnostics::files_below(path, true);
    for (const auto& [folder, cause] : found.unreadable) report_failure(syntax::unreadable, {folder, cause});
    std::size_t ours = 0;
    for (const fs::path file : found.files) {
        if (!language_of(file)) continue;
        ++ours;
        format_file(file);
    }
    if (ours == 0 && found.unreadable.empty()) report_failure(syntax::no_files, {path});
}

std::string Formatting::closing_line() const {
    const auto count = [](std::size_t n) { return fmt::format("{} file{}", n, n == 1 ? "" : "s"); };
    const char* const verdict = options_.formatting.check || options_.formatting.diff ? "would change" : "changed";
    return changed_ == 0 ? fmt::format("{} in the standard layout", count(files_))
                         : fmt::format("{} of {} {}", changed_, count(files_), verdict);
}

Exit Formatting::run() {
    for (const std::string& path : options_.load.inputs) format_input(path);
    const bool filters = options_.load.inputs == std::vector<std::string>{"-"};
    finish_output();  // so that the summary comes last if both streams are the same
    if (!options_.output.quiet && !failed_ && !(filters && !options_.formatting.check))
        print_error("{}\n", closing_line());
    if (failed_) return Exit::bad_input;
    return options_.formatting.check && changed_ > 0 ? Exit::failed : Exit::success;
}

}  // namespace

Exit run_format(const Options& options) {
    return Formatting(options).run();
}

}  // namespace robochart::app
