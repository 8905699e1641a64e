// SPDX-License-Identifier: Apache-2.0
// Writes the help as text for a terminal of 80 columns.
#include "app/command/help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace robochart::app {
namespace {

constexpr std::size_t page_width = 80;
constexpr std::size_t text_column = 26;

constexpr const char* about_models =
    "MODEL is a folder (a project: every .rct and .assertions file below it) or a file (together with the .rct files "
    "of its folder that it needs; for assertions in a folder without models, those of the parent folder). Independent "
    "projects are processed separately.";

/// Breaks the text into lines that begin at this column. Writes `lead` before the first line.
std::string wrap_paragraph(const std::string& lead, std::string_view text, std::size_t column) {
    std::string out = lead;
    std::size_t used = lead.size();
    const auto new_line = [&] {
        out.append("\n").append(column, ' ');
        used = column;
    };
    if (used + 2 > column && !lead.empty()) new_line();
    out.append(column - used, ' ');
    used = column;
    std::istringstream words{std::string(text)};
    for (std::string word; words >> word;) {
        if (used > column && used + 1 + word.size() > page_width) new_line();
        if (used > column) out += ' ', ++used;
        out += word;
        used += word.size();
    }
    return out + "\n";
}

/// Returns the option as in "-o, --out DIR".
std::string spelling_text(const OptionRow& row) {
    const std::string_view brief = short_name(row);
    const std::string_view name = row.argument.name;
    return fmt::format("{}{}{}{}", brief.empty() ? "    " : fmt::format("{}, ", brief), long_name(row),
                       name.empty() ? "" : " ", name);
}

/// Returns the help text of an option with its choices and its default.
std::string option_help(const OptionRow& row) {
    std::string text = row.help;
    if (row.argument.choices[0] != '\0') text += fmt::format(" {{{}}}", row.argument.choices);
    if (row.argument.usual[0] != '\0') text += fmt::format(" [{}]", row.argument.usual);
    if (row.argument.repeated) text += " (may be repeated)";
    return text;
}

std::string options_text(Verbs verbs) {
    std::string out;
    for (const Group group : option_groups()) {
        std::string lines;
        for (const OptionRow* row : options_of(verbs))
            if (row->group == group)
                lines += wrap_paragraph("  " + spelling_text(*row), option_help(*row), text_column);
        if (!lines.empty()) out += fmt::format("\n{}:\n{}", group_heading(group), lines);
    }
    return out;
}

std::string verbs_text(bool emitted) {
    std::string out = "\nVerbs:\n";
    for (const VerbRow& row : verb_table())
        if (!emitted || row.parent[0] != '\0') out += wrap_paragraph("  " + full_name(row), row.summary, 16);
    return out;
}

std::string exit_text() {
    std::string out = "\nExit status:\n";
    for (const ExitRow& row : exit_table())
        out += wrap_paragraph(fmt::format("  {:>2}", static_cast<int>(row.exit)), row.meaning, 6);
    return out;
}

}  // namespace

std::string usage_line(const VerbRow& row) {
    return fmt::format("usage: robochart-verify {} [OPTIONS]{}{}\n", full_name(row), row.input[0] == '\0' ? "" : " ",
                       row.input);
}

std::string verb_help(const VerbRow& row) {
    std::string out = usage_line(row) + "\n" + wrap_paragraph("", row.summary, 0);
    out += options_text(verb_bit(row.verb));
    if (std::string_view(row.input) == "MODEL...") out += "\n" + wrap_paragraph("", about_models, 0);
    return out + exit_text();
}

std::string emit_help() {
    return "usage: robochart-verify emit WHAT [OPTIONS] MODEL...\n\n" + wrap_paragraph("", emit_summary, 0) +
           verbs_text(true) + "\nrobochart-verify help emit WHAT lists the options of each.\n" + exit_text();
}

std::string program_help() {
    return "usage: robochart-verify [OPTIONS] MODEL...\n       robochart-verify VERB [OPTIONS] ...\n\n" +
           wrap_paragraph("", "Verifies RoboChart models: semantics, assertions, C++ controllers, conformance.", 0) +
           verbs_text(false) + options_text(no_verb) +
           "\nrobochart-verify help VERB lists the options of a verb; without a verb,\nthe options of `verify` "
           "apply.\n\n" +
           wrap_paragraph("", about_models, 0) + exit_text();
}

}  // namespace robochart::app
