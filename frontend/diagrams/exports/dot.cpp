// SPDX-License-Identifier: Apache-2.0
// See dot.hpp.
#include "frontend/diagrams/exports/dot.hpp"

#include <fmt/format.h>

#include <string_view>

#include "base/diagnostics/escape.hpp"
#include "frontend/diagrams/exports/outline.hpp"

namespace robochart::diagrams {
namespace {

class DotWriter {
public:
    explicit DotWriter(const Picture& picture) : picture_(picture), outline_(picture) {}

    std::string write() {
        out_ = fmt::format(
            "digraph \"{}\" {{\n  compound=true;\n  rankdir={};\n  fontname=\"DejaVu Sans\";\n"
            "  node [shape=box, fontname=\"DejaVu Sans\", fontsize=11];\n"
            "  edge [fontname=\"DejaVu Sans\", fontsize=10, arrowhead=vee];\n",
            diagnostics::label_text(picture_.title), outline_.is_machine() ? "TB" : "LR");
        for (const std::size_t box : outline_.boxes_inside(none)) write_box(box, "  ");
        for (const PictureLine& line : picture_.lines) write_line(line);
        return out_ + "}\n";
    }

private:
    [[nodiscard]] bool is_cluster(std::size_t box) const {
        return !outline_.boxes_inside(box).empty() || !outline_.events_of(box).empty();
    }

    /// Returns the lines of a label: the title and the rows.
    [[nodiscard]] std::string text_of(std::size_t box, const char* line_end) const {
        std::string text = diagnostics::label_text(outline_.title_of_box(box));
        for (const std::string& row : outline_.rows_of(box)) text += line_end + diagnostics::label_text(row);
        return text;
    }

    void write_box(std::size_t box, const std::string& indent) {
        const Look look = picture_.boxes[box].look;
        if (is_round(look)) {
            out_ += fmt::format("{}{} [shape=circle, width=0.3, fixedsize=true, label=\"{}\"];\n", indent,
                                outline_.id(box), letter_of(look));
            return;
        }
        if (!is_cluster(box)) {
            const bool dashed = look == Look::machine_reference || look == Look::missing;
            out_ += fmt::format("{}{} [label=\"{}\"{}];\n", indent, outline_.id(box), text_of(box, "\\n"),
                                dashed ? ", style=dashed" : "");
            return;
        }
        out_ += fmt::format("{}subgraph cluster_{} {{\n{}  label=\"{}\";\n", indent, outline_.id(box), indent,
                            text_of(box, "\\n"));
        // An edge to a cluster ends at an invisible point inside it and is clipped at its border.
        out_ += fmt::format("{}  {} [shape=point, style=invis];\n", indent, outline_.id(box));
        for (const std::size_t event : outline_.events_of(box))
            out_ += fmt::format("{}  {} [shape=square, label=\"{}\"];\n", indent, outline_.id(event),
                                diagnostics::label_text(outline_.title_of_box(event)));
        for (const std::size_t inner : outline_.boxes_inside(box)) write_box(inner, indent + "  ");
        out_ += indent + "}\n";
    }

    void write_line(const PictureLine& line) {
        std::string more;
        if (is_cluster(line.from) && line.to != line.from)
            more += fmt::format(", ltail=cluster_{}", outline_.id(line.from));
        if (is_cluster(line.to) && line.to != line.from)
            more += fmt::format(", lhead=cluster_{}", outline_.id(line.to));
        if (line.both_ways) more += ", dir=both";
        out_ += fmt::format("  {} -> {} [label=\"{}\"{}];\n", outline_.id(line.from), outline_.id(line.to),
                            diagnostics::label_text(outline_.label_of(line)), more);
    }

    const Picture& picture_;
    Outline outline_;
    std::string out_;
};

}  // namespace

std::string render_dot(const Picture& picture) {
    return DotWriter(picture).write();
}

}  // namespace robochart::diagrams
