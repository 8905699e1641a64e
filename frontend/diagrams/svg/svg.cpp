// SPDX-License-Identifier: Apache-2.0
// See svg.hpp. Colours are CSS class rules, because librsvg does not support custom properties. Arrowheads are paths,
// because markers would need unique ids.
#include "frontend/diagrams/svg/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "base/diagnostics/escape.hpp"
#include "frontend/diagrams/svg/icons.hpp"

namespace robochart::diagrams {
namespace {

using layout::Point;
using layout::Rectangle;

/// The two colours of an item, for the light and the dark theme.
struct Colours {
    std::string_view page, fill, reference_fill, ink, line, label, accent, warning;
};
constexpr Colours light{"#ffffff", "#ffffff", "#d9d9d9", "#000000", "#666666", "#0b3d80", "#0b4fb3", "#b00020"};
constexpr Colours dark{"#1e1e1e", "#262626", "#3d4048", "#e8e8e8", "#a8a8a8", "#9cc4ff", "#8ab4ff", "#ff8a8a"};

std::string rules_of(const Colours& c) {
    return fmt::format(
        "text{{fill:{0}}}.page{{fill:{1}}}.box{{fill:{2};stroke:{0};stroke-width:1}}"
        ".reference>.box,.machine-reference>.box{{fill:{3}}}.machine-reference>.box{{stroke-dasharray:6.6,3.3}}"
        ".missing>.box{{stroke:{4};stroke-dasharray:3,3}}.missing>text{{fill:{4}}}.rule{{stroke:{0};stroke-width:1}}"
        ".square{{fill:{2};stroke:{0};stroke-width:3}}.inner{{fill:none;stroke:{0};stroke-width:1.5}}"
        ".full{{fill:{0};stroke:{0};stroke-width:1.5}}.open{{fill:{2};stroke:{0};stroke-width:1.5}}"
        ".thick{{fill:{2};stroke:{0};stroke-width:3.5}}.in-full{{fill:{2}}}"
        ".line,.head{{fill:none;stroke:{5};stroke-width:1.6}}.line-label text{{fill:{6}}}"
        ".thin{{fill:none;stroke:{0}}}.dot{{fill:{0}}}"
        ".blue .thin{{stroke:{7}}}.blue .dot,.blue .sign{{fill:{7}}}",
        c.ink, c.page, c.fill, c.reference_fill, c.warning, c.line, c.label, c.accent);
}

std::string style_of(Theme theme) {
    if (theme == Theme::light) return rules_of(light);
    if (theme == Theme::dark) return rules_of(dark);
    return rules_of(light) + "@media screen and (prefers-color-scheme:dark){" + rules_of(dark) + "}";
}

std::string format_number(double value) {
    const double rounded = std::round(value * 10) / 10;
    return rounded == std::floor(rounded) ? fmt::format("{:.0f}", rounded + 0.0) : fmt::format("{:.1f}", rounded);
}

std::string_view class_of(Look look) {
    switch (look) {
        case Look::plain:
            return "node";
        case Look::frame:
            return "frame";
        case Look::reference:
            return "reference";
        case Look::machine_reference:
            return "machine-reference";
        case Look::missing:
            return "missing";
        case Look::event:
        case Look::broadcast:
            return "event";
        case Look::initial:
        case Look::junction:
        case Look::probabilistic:
        case Look::final:
            return "pseudo-node";
    }
    return "";
}

/// Returns the path of a line with rounded corners.
std::string path_of(const std::vector<Point>& points) {
    constexpr double radius = 5;
    std::string path = fmt::format("M{} {}", format_number(points[0].x), format_number(points[0].y));
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const auto towards = [&](const Point& other) {
            const Point& corner = points[i];
            const double length = std::hypot(other.x - corner.x, other.y - corner.y);
            const double part = length > 0 ? std::min(radius, length / 2) / length : 0;
            return Point{corner.x + (other.x - corner.x) * part, corner.y + (other.y - corner.y) * part};
        };
        const Point before = towards(points[i - 1]);
        const Point after = towards(points[i + 1]);
        path += fmt::format("L{} {}Q{} {} {} {}", format_number(before.x), format_number(before.y),
                            format_number(points[i].x), format_number(points[i].y), format_number(after.x),
                            format_number(after.y));
    }
    return path + fmt::format("L{} {}", format_number(points.back().x), format_number(points.back().y));
}

/// Returns an open arrowhead at `tip`, for a line that comes from `before`.
std::string head_of(const Point& before, const Point& tip) {
    constexpr double length = 7;
    constexpr double half = 4;
    const double distance = std::hypot(tip.x - before.x, tip.y - before.y);
    if (distance == 0) return "";
    const Point along{(tip.x - before.x) / distance, (tip.y - before.y) / distance};
    const auto corner = [&](double side) {
        return format_number(tip.x - along.x * length - along.y * side) + " " +
               format_number(tip.y - along.y * length + along.x * side);
    };
    return fmt::format("<path class=\"head\" d=\"M{}L{} {}L{}\"/>", corner(half), format_number(tip.x),
                       format_number(tip.y), corner(-half));
}

class Writer {
public:
    Writer(const Picture& picture, const Elements& elements, const SvgOptions& options)
        : picture_(picture), elements_(elements), options_(options) {}

    std::string write() {
        const std::string width = format_number(std::ceil(picture_.size.width));
        const std::string height = format_number(std::ceil(picture_.size.height));
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
            "role=\"img\" "
            "font-family=\"'DejaVu Sans',Verdana,sans-serif\" font-size=\"11\">\n<title>{2}</title>\n<desc>{3}</desc>\n"
            "<style>{4}</style>\n<rect class=\"page\" width=\"{0}\" height=\"{1}\"/>\n",
            width, height, diagnostics::xml_lines(picture_.title), diagnostics::xml_lines(picture_.description),
            style_of(options_.theme));
        for (const PictureBox& box : picture_.boxes)
            if (box.event_of == none) write_box(box);
        for (const PictureLine& line : picture_.lines) write_line(line);
        for (const PictureBox& box : picture_.boxes)
            if (box.event_of != none) write_box(box);
        return out_ + "</svg>\n";
    }

private:
    /// Returns the class attribute of a group, including the classes from the options.
    [[nodiscard]] std::string class_attribute(std::string_view own, std::size_t element) const {
        const auto found =
            element == none ? options_.classes.end() : options_.classes.find(elements_.all_elements()[element].id);
        return found == options_.classes.end() ? std::string(own) : fmt::format("{} {}", own, found->second);
    }

    /// Returns the attributes `id="…" data-element="…"`. A counter replaces the id of a group that shows no element of
    /// the model.
    std::string id_attributes(std::size_t element) {
        if (element == none) return fmt::format("id=\"{}x{}\"", options_.id_prefix, ++others_);
        const std::string& id = elements_.all_elements()[element].id;
        const std::size_t time = ++times_[element];
        const std::string again = time > 1 ? fmt::format("-{}", time) : "";
        return fmt::format("id=\"{}{}{}\" data-element=\"{}\"", options_.id_prefix, id, again, id);
    }

    /// Returns the tooltip: kind and name, and the complete text if it is elided.
    [[nodiscard]] std::string tooltip_text(std::size_t element, const std::string& whole) const {
        std::string text;
        if (element != none) {
            const Element& it = elements_.all_elements()[element];
            text = it.kind + (it.name.empty() ? "" : " " + it.name) + "\n";
        }
        text += whole;
        return text.empty() ? "" : "<title>" + diagnostics::xml_lines(text) + "</title>";
    }

    void write_box(const PictureBox& box) {
        out_ += fmt::format("<g class=\"{}\" {}>{}", class_attribute(class_of(box.look), box.element),
                            id_attributes(box.element), tooltip_text(box.element, box.whole));
        write_shape(box);
        for (const double rule : box.rules)
            out_ += fmt::format("<path class=\"rule\" d=\"M{} {}H{}\"/>", format_number(box.place.x),
                                format_number(rule), format_number(box.place.right()));
        for (const Sign& sign : box.signs)
            out_ += fmt::format("<g{} transform=\"translate({} {})\">{}</g>", sign.reference ? " class=\"blue\"" : "",
                                format_number(sign.centre.x), format_number(sign.centre.y), icon_svg(sign.icon));
        write_texts(box.texts);
        out_ += "</g>\n";
    }

    void write_shape(const PictureBox& box) {
        const Rectangle& at = box.place;
        if (!is_round(box.look)) {
            const bool event = box.event_of != none;
            write_rectangle(at, event ? "square" : "box");
            if (box.look == Look::broadcast)
                write_rectangle({at.x + 5, at.y + 5, at.width - 10, at.height - 10}, "inner");
            return;
        }
        const bool thick = box.look == Look::probabilistic;
        const bool full = box.look == Look::initial || box.look == Look::junction;
        const double line = thick ? 3.5 : 1.5;
        std::string_view kind = "open";
        if (thick) kind = "thick";
        if (full) kind = "full";
        out_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", kind, format_number(at.centre().x),
                            format_number(at.centre().y), format_number((at.width - line) / 2));
        const std::string_view letter = letter_of(box.look);
        if (!letter.empty())
            out_ += fmt::format(
                "<text{} x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"13\" font-weight=\"bold\">{}</text>",
                full ? " class=\"in-full\"" : "", format_number(at.centre().x), format_number(at.centre().y + 4.7),
                letter);
    }

    void write_rectangle(const Rectangle& at, std::string_view kind) {
        out_ +=
            fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", kind, format_number(at.x),
                        format_number(at.y), format_number(at.width), format_number(at.height));
    }

    void write_texts(const std::vector<Text>& texts) {
        for (std::size_t t = 0; t < texts.size(); ++t) {
            const bool more = t + 1 < texts.size() && texts[t + 1].flows;
            if (!texts[t].flows) begin_text(texts[t], more);
            const bool alone = !texts[t].flows && !more;
            if (!alone)
                out_ += texts[t].element == none ? "<tspan>" : "<tspan " + id_attributes(texts[t].element) + ">";
            if (alone && texts[t].element != none) {
                out_.pop_back();
                out_ += " " + id_attributes(texts[t].element) + ">";
            }
            out_ += diagnostics::xml_lines(texts[t].text);
            if (!alone) out_ += "</tspan>";
            if (!more) out_ += "</text>";
        }
    }

    void begin_text(const Text& text, bool more) {
        out_ += fmt::format("<text x=\"{}\" y=\"{}\"", format_number(text.at.x), format_number(text.at.y));
        if (text.anchor != Anchor::start)
            out_ += text.anchor == Anchor::middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
        if (text.size != 11) out_ += fmt::format(" font-size=\"{}\"", format_number(text.size));
        if (text.bold) out_ += " font-weight=\"bold\"";
        if (text.italic) out_ += " font-style=\"italic\"";
        if (more) out_ += " xml:space=\"preserve\"";
        if (text.underlined) out_ += " text-decoration=\"underline\"";
        out_ += ">";
    }

    void write_line(const PictureLine& line) {
        if (line.points.size() < 2) return;
        out_ +=
            fmt::format("<g class=\"{}\" {}>{}<path class=\"line\" d=\"{}\"/>", class_attribute("edge", line.element),
                        id_attributes(line.element), tooltip_text(line.element, line.whole), path_of(line.points));
        out_ += head_of(line.points[line.points.size() - 2], line.points.back());
        if (line.both_ways) out_ += head_of(line.points[1], line.points[0]);
        if (!line.texts.empty()) {
            out_ += "<g class=\"line-label\">";
            write_texts(line.texts);
            out_ += "</g>";
        }
        out_ += "</g>\n";
    }

    const Picture& picture_;
    const Elements& elements_;
    const SvgOptions& options_;
    std::string out_;
    std::map<std::size_t, std::size_t> times_;  ///< number of groups of each element so far
    std::size_t others_ = 0;
};

}  // namespace

std::string render_svg(const Picture& picture, const Elements& elements, const SvgOptions& options) {
    return Writer(picture, elements, options).write();
}

}  // namespace robochart::diagrams
