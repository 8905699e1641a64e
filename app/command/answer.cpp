// SPDX-License-Identifier: Apache-2.0
#include "app/command/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/command/option_table.hpp"
#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/command/run_record.hpp"
#include "base/rule_pages/rule_pages.hpp"

namespace robochart::app {

void output_document(const Options& options, const std::function<std::string(Format)>& document) {
    // All documents contain the same record, so two documents in the same format are equal.
    const RunRecord record = record_of(options);
    const auto complete = [&](Format format) {
        std::string text = document(format);
        return format == Format::json ? with_run(std::move(text), record) : text;
    };
    if (options.output.format != Format::text) print_exact(complete(options.output.format));
    for (const auto& [format, path] : options.output.files) options.run->keep_for(path, complete(format));
}

void output_json(const Options& options, const diagnostics::Json& document) {
    output_document(options, [&](Format) { return diagnostics::json_text(document) + "\n"; });
}

bool is_requested(const Options& options, Format format) {
    return options.output.format == format || options.output.files.contains(format);
}

diagnostics::SarifRules about_log(const Options& options, const std::string& limit) {
    const auto& verbs = verb_table();
    const auto verb = std::ranges::find_if(verbs, [&](const VerbRow& row) { return row.verb == options.verb; });
    return {
        program_version, fmt::format("{}/{}", full_name(*verb), fmt::join(options.load.inputs, " ")),
        [](const diagnostics::Rule& rule) { return diagnostics::read_page(diagnostics::page_text(rule.code)).title; },
        diagnostics::reason_for, limit};
}

}  // namespace robochart::app
