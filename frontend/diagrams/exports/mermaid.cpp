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
std::string escaped(const std::string& text) {
    constexpr std::string_view plain = " _.,=()[]/!?*+";
    std::string result;
    for (const char c : diagnostics::shown(text)) {
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
        out_ += fmt::format("  %% {}\n", escaped(picture_.title));
        losses();
        for (const std::size_t frame : outline_.inside(none)) write_level(frame, "  ");
        return out_;
    }

private:
    [[nodiscard]] bool has(Look look) const {
        return std::ranges::any_of(picture_.boxes, [&](const PictureBox& box) { return box.look == look; });
    }

    void loss(bool present, std::string_view what) {
        if (present) out_ += fmt::format("  %% not shown: {}\n", what);
    }

    void losses() {
        const std::size_t frame = outline_.inside(none).front();
        loss(!outline_.rows(frame).empty(), "interfaces, variables, constants and clocks of the component");
        loss(!outline_.events(frame).empty(), "its events");
        loss(has(Look::probabilistic), "that a choice is probabilistic; probabilities are text of its transitions");
        loss(has(Look::missing), "that a name means nothing");
    }

    void component_losses() {
        loss(has(Look::event) || has(Look::broadcast),
             "that events are on the borders of components: they are in them");
        loss(has(Look::broadcast), "that an event is broadcast");
        loss(has(Look::missing), "that a name means nothing");
    }

    [[nodiscard]] Look look(std::size_t box) const { return picture_.boxes[box].look; }

    void write_level(std::size_t parent, const std::string& indent) {
        for (const std::size_t box : outline_.inside(parent)) write_node(box, indent);
        for (const std::size_t l : outline_.lines(parent)) {
            const PictureLine& line = picture_.lines[l];
            const std::string label = escaped(outline_.label(line));
            out_ += fmt::format("{}{} --> {}{}{}\n", indent, end_of(line.from), end_of(line.to),
                                label.empty() ? "" : " : ", label);
        }
    }

    [[nodiscard]] std::string end_of(std::size_t box) const {
        return look(box) == Look::initial || look(box) == Look::final ? "[*]" : outline_.id(box);
    }

    void write_node(std::size_t box, const std::string& indent) {
        const std::string id = outline_.id(box);
        if (look(box) == Look::initial || look(box) == Look::final) return;
        if (is_round(look(box))) {
            out_ += fmt::format("{}state {} <<choice>>\n", indent, id);
            return;
        }
        std::string title = escaped(outline_.title(box));
        if (outline_.inside(box).empty()) {
            out_ += fmt::format("{}state \"{}\" as {}\n", indent, title, id);
            for (const std::string& row : outline_.rows(box))
                out_ += fmt::format("{}{} : {}\n", indent, id, escaped(row));
            return;
        }
        // The rows become part of the title. A description of a composite state would replace its title, and Mermaid 12
        // draws a note outside of the enclosing state.
        for (const std::string& row : outline_.rows(box)) title += "<br/>" + escaped(row);
        out_ += fmt::format("{}state \"{}\" as {} {{\n", indent, title, id);
        write_level(box, indent + "  ");
        out_ += indent + "}\n";
    }

    std::string write_components() {
        out_ = fmt::format("flowchart LR\n  %% {}\n", escaped(picture_.title));
        component_losses();
        for (const std::size_t box : outline_.inside(none)) write_part(box, "  ");
        for (const PictureLine& line : picture_.lines) {
            const std::string label = escaped(outline_.label(line));
            out_ += fmt::format("  {} {}-->{} {}\n", outline_.id(line.from), line.both_ways ? "<" : "",
                                label.empty() ? "" : "|\"" + label + "\"|", outline_.id(line.to));
        }
        return out_;
    }

    void write_part(std::size_t box, const std::string& indent) {
        std::string text = escaped(outline_.title(box));
        for (const std::string& row : outline_.rows(box)) text += "<br/>" + escaped(row);
        const bool group = !outline_.inside(box).empty() || !outline_.events(box).empty();
        out_ += fmt::format("{}{}{}[\"{}\"]\n", indent, group ? "subgraph " : "", outline_.id(box), text);
        if (!group) return;
        for (const std::size_t event : outline_.events(box))
            out_ += fmt::format("{}  {}[\"{}\"]\n", indent, outline_.id(event), escaped(outline_.title(event)));
        for (const std::size_t inner : outline_.inside(box)) write_part(inner, indent + "  ");
        out_ += indent + "end\n";
    }

    const Picture& picture_;
    Outline outline_;
    std::string out_;
};

}  // namespace

std::string mermaid(const Picture& picture) {
    return MermaidWriter(picture).write();
}

}  // namespace robochart::diagrams
