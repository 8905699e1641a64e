// SPDX-License-Identifier: Apache-2.0
// See mermaid.hpp.
#include "frontend/diagrams/exports/mermaid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/diagnostics/escape.hpp"
#include "frontend/diagrams/exports/outline.hpp"

namespace robochart::diagrams {
namespace {

/// Writes all characters as entity codes, except letters, digits and a few signs. Mermaid ends statements at `;`,
/// interprets `::` and `%%` anywhere, and reads `\n` as a line end.
std::string escape_label(const std::string& text) {
    constexpr std::string_view plain = " _.,=()[]/!?*+";
    std::string result;
    for (const char c : diagnostics::escape_for_display(text)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) != 0 || plain.find(c) != std::string_view::npos)
            result += c;
        else
            result += fmt::format("#{};", static_cast<unsigned>(byte));
    }
    return result;
}

class MermaidWriter {
public:
    explicit MermaidWriter(const Picture& picture) : picture_(picture), outline_(picture) {}

    std::string write() {
        if (!outline_.is_machine()) return write_components();
        out_ = "stateDiagram-v2\n";
        out_ += fmt::format("  %% {}\n", escape_label(picture_.title));
        write_losses();
        for (const std::size_t frame : outline_.boxes_inside(none)) write_level(frame, "  ");
        return out_;
    }

private:
    [[nodiscard]] bool has_box_of(Look look) const {
        return std::ranges::any_of(picture_.boxes, [&](const PictureBox& box) { return box.look == look; });
    }

    void write_loss(bool present, std::string_view what) {
        if (present) out_ += fmt::format("  %% not shown: {}\n", what);
    }

    void write_losses() {
        const std::size_t frame = outline_.boxes_inside(none).front();
        write_loss(!outline_.rows_of(frame).empty(), "interfaces, variables, constants and clocks of the component");
        write_loss(!outline_.events_of(frame).empty(), "its events");
        write_loss(has_box_of(Look::probabilistic),
                   "that a choice is probabilistic; probabilities are text of its transitions");
        write_loss(has_box_of(Look::missing), "that a name means nothing");
    }

    void component_losses() {
        write_loss(has_box_of(Look::event) || has_box_of(Look::broadcast),
                   "that events are on the borders of components: they are in them");
        write_loss(has_box_of(Look::broadcast), "that an event is broadcast");
        write_loss(has_box_of(Look::missing), "that a name means nothing");
    }

    [[nodiscard]] Look look_of_box(std::size_t box) const { return picture_.boxes[box].look; }

    void write_level(std::size_t parent, const std::string& indent) {
        for (const std::size_t box : outline_.boxes_inside(parent)) write_node(box, indent);
        for (const std::size_t l : outline_.lines_inside(parent)) {
            const PictureLine& line = picture_.lines[l];
            const std::string label = escape_label(outline_.label_of(line));
            out_ += fmt::format("{}{} --> {}{}{}\n", indent, end_of(line.from), end_of(line.to),
                                label.empty() ? "" : " : ", label);
        }
    }

    [[nodiscard]] std::string end_of(std::size_t box) const {
        return look_of_box(box) == Look::initial || look_of_box(box) == Look::final ? "[*]" : outline_.id(box);
    }

    void write_node(std::size_t box, const std::string& indent) {
        const std::string id = outline_.id(box);
        if (look_of_box(box) == Look::initial || look_of_box(box) == Look::final) return;
        if (is_round(look_of_box(box))) {
            out_ += fmt::format("{}state {} <<choice>>\n", indent, id);
            return;
        }
        std::string title = escape_label(outline_.title_of_box(box));
        if (outline_.boxes_inside(box).empty()) {
            out_ += fmt::format("{}state \"{}\" as {}\n", indent, title, id);
            for (const std::string& row : outline_.rows_of(box))
                out_ += fmt::format("{}{} : {}\n", indent, id, escape_label(row));
            return;
        }
        // The rows become part of the title. A description of a composite state would replace its title, and Mermaid 12
        // draws a note outside of the enclosing state.
        for (const std::string& row : outline_.rows_of(box)) title += "<br/>" + escape_label(row);
        out_ += fmt::format("{}state \"{}\" as {} {{\n", indent, title, id);
        write_level(box, indent + "  ");
        out_ += indent + "}\n";
    }

    std::string write_components() {
        out_ = fmt::format("flowchart LR\n  %% {}\n", escape_label(picture_.title));
        component_losses();
        for (const std::size_t box : outline_.boxes_inside(none)) write_part(box, "  ");
        for (const PictureLine& line : picture_.lines) {
            const std::string label = escape_label(outline_.label_of(line));
            out_ += fmt::format("  {} {}-->{} {}\n", outline_.id(line.from), line.both_ways ? "<" : "",
                                label.empty() ? "" : "|\"" + label + "\"|", outline_.id(line.to));
        }
        return out_;
    }

    void write_part(std::size_t box, const std::string& indent) {
        std::string text = escape_label(outline_.title_of_box(box));
        for (const std::string& row : outline_.rows_of(box)) text += "<br/>" + escape_label(row);
        const bool group = !outline_.boxes_inside(box).empty() || !outline_.events_of(box).empty();
        out_ += fmt::format("{}{}{}[\"{}\"]\n", indent, group ? "subgraph " : "", outline_.id(box), text);
        if (!group) return;
        for (const std::size_t event : outline_.events_of(box))
            out_ +=
                fmt::format("{}  {}[\"{}\"]\n", indent, outline_.id(event), escape_label(outline_.title_of_box(event)));
        for (const std::size_t inner : outline_.boxes_inside(box)) write_part(inner, indent + "  ");
        out_ += indent + "end\n";
    }

    const Picture& picture_;
    Outline outline_;
    std::string out_;
};

}  // namespace

std::string render_mermaid(const Picture& picture) {
    return MermaidWriter(picture).write();
}

}  // namespace robochart::diagrams
