// SPDX-License-Identifier: Apache-2.0
// Draws diagnostics for people: header, place, excerpt with caret, notes and certain fixes.
#include "base/diagnostics/render.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/excerpt.hpp"
#include "base/diagnostics/paint.hpp"

namespace robochart::diagnostics {

namespace {

struct Look {
    std::string_view word;
    Paint paint;
};

Look look_of_severity(Severity severity) {
    switch (severity) {
        case Severity::note:
            return {"note", Paint::note};
        case Severity::warning:
            return {"warning", Paint::warning};
        case Severity::error:
            return {"error", Paint::error};
    }
    return {"error", Paint::error};
}

/// Draws `  --> path:line:column` and the marked line.
std::string draw_place(const SourceManager& sources, Span span, const TextStyle& style, Paint paint) {
    const Position begin = sources.position(span.source, span.begin);
    const Position end = sources.position(span.source, span.end);
    const std::string_view line = sources.line_text(span.source, begin.line);
    // The line is a view into the text of the file, so the difference of the pointers is the offset of the line.
    const auto line_start = static_cast<std::size_t>(line.data() - sources.source_text(span.source).data());
    const std::size_t from = span.begin - std::min<std::size_t>(span.begin, line_start);
    const std::size_t to = end.line == begin.line ? span.end - line_start : line.size();
    const Excerpt excerpt = make_excerpt(line, from, to, style.max_width);

    const std::string number = std::to_string(begin.line);
    const std::string margin(number.size(), ' ');
    const std::string mark = std::string(excerpt.mark_begin, ' ') +
                             paint_text("^" + std::string(excerpt.mark_width - 1, '~'), paint, style.color);
    return fmt::format("{0} --> {1}:{2}:{3}\n{0}  |\n {4} | {5}\n{0}  | {6}\n", margin,
                       escape_for_display(sources.path(span.source)), begin.line, begin.column, number, excerpt.text,
                       mark);
}

std::string draw_note(const SourceManager& sources, const Note& note, const TextStyle& style) {
    if (!note.span.is_known()) return fmt::format("   = note: {}\n", shown_lines(note.message));
    const Look as_note = look_of_severity(Severity::note);
    return fmt::format("{}: {}\n{}", paint_text(as_note.word, as_note.paint, style.color), shown_lines(note.message),
                       draw_place(sources, note.span, style, as_note.paint));
}

/// Draws a fix: an instruction, and the line as it is after the fix.
std::string draw_fix(const SourceManager& sources, const FixIt& fix, const TextStyle& style) {
    const bool removes = fix.replacement.empty();
    std::string out = fmt::format("   = help: {}{}\n", shown_lines(fix.title),
                                  removes ? "" : ": `" + shown_lines(fix.replacement) + "`");
    if (!fix.span.is_known() || fix.replacement.find_first_of("\r\n") != std::string::npos) return out;
    const Position begin = sources.position(fix.span.source, fix.span.begin);
    if (sources.position(fix.span.source, fix.span.end).line != begin.line) return out;
    const std::string_view line = sources.line_text(fix.span.source, begin.line);
    const auto start = static_cast<std::size_t>(line.data() - sources.source_text(fix.span.source).data());
    // Only the text near the fix is copied, because a line may have many megabytes.
    const std::size_t from = std::min<std::size_t>(fix.span.begin - start, line.size());
    const std::size_t to = std::min<std::size_t>(fix.span.end - start, line.size());
    constexpr std::size_t reach = 1000;
    const std::size_t cut = from > reach ? from - reach : 0;
    const std::string fixed =
        fmt::format("{}{}{}", line.substr(cut, from - cut), fix.replacement, line.substr(to, reach));
    const Excerpt excerpt = make_excerpt(fixed, from - cut, from - cut + fix.replacement.size(), style.max_width);
    const std::string number = std::to_string(begin.line);
    const std::string margin(number.size(), ' ');
    const std::string mark = removes
                                 ? ""
                                 : std::string(excerpt.mark_begin + 1, ' ') +
                                       paint_text(std::string(excerpt.mark_width, '+'), Paint::addition, style.color);
    return out + fmt::format("{0}  |\n {1} | {2}\n{0}  |{3}\n", margin, number, excerpt.text, mark);
}

/// Groups digits, as in 1,324.
std::string group_digits(std::size_t n) {
    std::string digits = std::to_string(n);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
    return digits;
}

std::string count(std::size_t n, std::string_view noun) {
    return fmt::format("{} {}{}", group_digits(n), noun, n == 1 ? "" : "s");
}

}  // namespace

std::string render_text(const SourceManager& sources, const Diagnostic& diagnostic, const TextStyle& style) {
    const Look severity = look_of_severity(diagnostic.rule->severity);
    std::string out = fmt::format(
        "{}: {}\n",
        paint_text(fmt::format("{}[{}]", severity.word, diagnostic.rule->code), severity.paint, style.color),
        shown_lines(diagnostic.message()));
    if (diagnostic.span.is_known()) out += draw_place(sources, diagnostic.span, style, severity.paint);
    for (const Note& note : diagnostic.notes)
        if (!note.span.is_known()) out += draw_note(sources, note, style);
    for (const FixIt& fix : diagnostic.fixes) out += draw_fix(sources, fix, style);
    for (const Note& note : diagnostic.notes)
        if (note.span.is_known()) out += draw_note(sources, note, style);
    return out;
}

std::string render_text(const SourceManager& sources, const Diagnostics& diagnostics, const TextStyle& style) {
    if (diagnostics.empty()) return {};
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics.sorted_findings())
        out += render_text(sources, diagnostic, style) + "\n";
    if (diagnostics.dropped_count() > 0) {
        const std::size_t counted = diagnostics.error_count() + diagnostics.warning_count();
        out +=
            fmt::format("{} shown of {}\n", group_digits(counted - diagnostics.dropped_count()), group_digits(counted));
    }
    return out + fmt::format("{}, {}\n", count(diagnostics.error_count(), "error"),
                             count(diagnostics.warning_count(), "warning"));
}

}  // namespace robochart::diagnostics
