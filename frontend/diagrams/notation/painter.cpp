// SPDX-License-Identifier: Apache-2.0
// See painter.hpp.
#include "frontend/diagrams/notation/painter.hpp"

#include <algorithm>
#include <limits>

#include "frontend/diagrams/notation/labels.hpp"

namespace robochart::diagrams {

using namespace frontend;
using layout::Point;
using layout::Rectangle;
using layout::text_width;

namespace {

constexpr double icon_width = 18;
constexpr double base_below_middle = 4.5;  ///< distance of a title's base line from its middle

std::string short_title(const std::string& text) {
    return layout::elide_text(text, measure::longest_title);
}

/// Returns the bounding box of a text.
Rectangle extent_of(const Text& text) {
    const double width = text_width(text.text, text.size, text.bold);
    double shift = 0;
    if (text.anchor == Anchor::middle) shift = width / 2;
    if (text.anchor == Anchor::end) shift = width;
    return {text.at.x - shift, text.at.y - text.size, width, text.size * 1.3};
}

/// A bounding box that grows.
class Extent {
public:
    void include_rectangle(const Rectangle& it) {
        low_ = {std::min(low_.x, it.x), std::min(low_.y, it.y)};
        high_ = {std::max(high_.x, it.right()), std::max(high_.y, it.bottom())};
    }
    [[nodiscard]] Rectangle bounding_box() const { return {low_.x, low_.y, high_.x - low_.x, high_.y - low_.y}; }

private:
    static constexpr double far = std::numeric_limits<double>::infinity();
    Point low_{far, far}, high_{-far, -far};
};

Rectangle extent_of(const Picture& picture) {
    Extent extent;
    for (const PictureBox& box : picture.boxes) {
        extent.include_rectangle(box.place);
        for (const Text& text : box.texts) extent.include_rectangle(extent_of(text));
    }
    for (const PictureLine& line : picture.lines) {
        for (const Point& point : line.points) extent.include_rectangle({point.x, point.y, 0, 0});
        if (!line.label.empty()) extent.include_rectangle(line.label);
    }
    return picture.boxes.empty() ? Rectangle() : extent.bounding_box();
}

void move_by(Text& text, const Point& by) {
    text.at = {text.at.x + by.x, text.at.y + by.y};
}

void move_by(PictureBox& box, const Point& by) {
    box.place.x += by.x;
    box.place.y += by.y;
    for (double& rule : box.rules) rule += by.y;
    for (Sign& sign : box.signs) sign.centre = {sign.centre.x + by.x, sign.centre.y + by.y};
    for (Text& text : box.texts) move_by(text, by);
}

void move_by(PictureLine& line, const Point& by) {
    for (Point& point : line.points) point = {point.x + by.x, point.y + by.y};
    line.label.x += by.x;
    line.label.y += by.y;
    for (Text& text : line.texts) move_by(text, by);
}

}  // namespace

double Title::width() const {
    return text_width(short_title(text), measure::title_font, bold) + (icon == Icon::no_icon ? 0 : icon_width) +
           2 * measure::padding;
}

layout::Rectangle Title::text_place(double height) const {
    const double width = text_width(short_title(text), measure::title_font, bold);
    const double shift = icon == Icon::no_icon ? 0 : icon_width / 2;
    const double base = height / 2 + base_below_middle;
    return {shift - width / 2, base - 0.8 * measure::title_font, width, 1.05 * measure::title_font};
}

void Title::write(PictureBox& box, double height) const {
    const std::string shown = short_title(text);
    if (shown != text) box.whole += text + "\n";
    const double half = text_width(shown, measure::title_font, bold) / 2;
    double middle = box.place.centre().x;
    if (icon != Icon::no_icon) {
        middle += icon_width / 2;
        box.signs.push_back({icon, {middle - half - icon_width / 2, box.place.y + height / 2}, reference});
    }
    Text written{{middle, box.place.y + height / 2 + base_below_middle}, shown};
    written.size = measure::title_font;
    written.anchor = Anchor::middle;
    written.italic = italic;
    written.bold = bold;
    written.underlined = underlined;
    box.texts.push_back(std::move(written));
}

layout::Size size_of(const layout::Lines& lines) {
    double width = 0;
    for (const std::string& line : lines.lines) width = std::max(width, text_width(line, measure::row_font));
    return {width, measure::line * static_cast<double>(lines.lines.size())};
}

void write_lines(const layout::Lines& lines, const Point& corner, std::vector<Text>& texts) {
    double y = corner.y;
    for (const std::string& line : lines.lines) {
        Text written{{corner.x, y + 11}, line};
        written.size = measure::row_font;
        texts.push_back(std::move(written));
        y += measure::line;
    }
}

std::vector<const Event*> events_of(const Context& context) {
    std::vector<const Event*> events;
    const auto add = [&](const Context& declaring) {
        for (const auto& event : declaring.events)
            if (std::ranges::find(events, event.get()) == events.end()) events.push_back(event.get());
    };
    add(context);
    for (const InterfaceClause& clause : context.interfaces)
        if (const auto* interface = dynamic_cast<const Context*>(clause.target);
            interface != nullptr && clause.use == InterfaceUse::uses)
            add(*interface);
    return events;
}

EventSquare square_of(const Event& event, const Elements& elements) {
    return square_of(text_of(event), elements.find(&event), event.broadcast);
}

EventSquare square_of(const std::string& label, std::size_t element, bool broadcast) {
    constexpr std::size_t longest = 40;
    const std::string shown = layout::elide_text(label, longest);
    return {shown, element, broadcast, shown == label ? "" : label};
}

double label_width(const EventSquare& square) {
    return text_width(square.label, measure::row_font) + measure::padding;
}

PictureBox draw_square(const EventSquare& square, const Point& centre, std::size_t owner, bool label_left) {
    constexpr double half = layout::port_size / 2;
    PictureBox box;
    box.look = square.broadcast ? Look::broadcast : Look::event;
    box.element = square.element;
    box.event_of = owner;
    box.whole = square.whole;
    box.place = {centre.x - half, centre.y - half, layout::port_size, layout::port_size};
    Text label{{label_left ? centre.x - half - 5 : centre.x + half + 5, centre.y + 4}, square.label};
    label.size = measure::row_font;
    label.anchor = label_left ? Anchor::end : Anchor::start;
    box.texts.push_back(std::move(label));
    return box;
}

layout::Size label_size(const EventSquare& square) {
    return {text_width(square.label, measure::row_font), square.label.empty() ? 0 : measure::line};
}

PictureBox draw_square(const EventSquare& square, const layout::PlacedPort& port, const Point& corner,
                       std::size_t owner, bool label_left) {
    const Point centre{port.centre.x + corner.x, port.centre.y + corner.y};
    PictureBox box = draw_square(square, centre, owner, label_left);
    if (port.label) {
        Text& label = box.texts.back();
        label.at = {port.label->x + corner.x, port.label->y + corner.y + 11};
        label.anchor = Anchor::start;
    }
    return box;
}

void crop_picture(Picture& picture) {
    constexpr double margin = 14;
    const Rectangle extent = extent_of(picture);
    const Point by{margin - extent.x, margin - extent.y};
    for (PictureBox& box : picture.boxes) move_by(box, by);
    for (PictureLine& line : picture.lines) move_by(line, by);
    picture.size = {extent.width + 2 * margin, extent.height + 2 * margin};
}

}  // namespace robochart::diagrams
