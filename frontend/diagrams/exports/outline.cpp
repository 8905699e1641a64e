// SPDX-License-Identifier: Apache-2.0
// See outline.hpp.
#include "frontend/diagrams/exports/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace robochart::diagrams {

Outline::Outline(const Picture& picture)
    : picture_(picture),
      inside_(picture.boxes.size() + 1),
      events_(picture.boxes.size() + 1),
      lines_(picture.boxes.size() + 1) {
    const auto at = [&](std::size_t box) { return box == none ? picture.boxes.size() : box; };
    for (std::size_t b = 0; b < picture.boxes.size(); ++b) {
        const PictureBox& box = picture.boxes[b];
        if (box.event_of != none)
            events_[box.event_of].push_back(b);
        else
            inside_[at(box.parent)].push_back(b);
    }
    for (std::size_t l = 0; l < picture.lines.size(); ++l) {
        const PictureBox& from = picture.boxes[picture.lines[l].from];
        lines_[at(from.event_of == none ? from.parent : none)].push_back(l);
    }
    machine_ = std::ranges::any_of(picture.boxes, [](const PictureBox& box) { return is_round(box.look); });
}

std::string Outline::id(std::size_t box) const {
    return fmt::format("n{}", box);
}

std::string Outline::title_of_box(std::size_t box) const {
    const PictureBox& it = picture_.boxes[box];
    return it.texts.empty() ? "" : it.texts.front().text;
}

std::vector<std::string> Outline::rows_of(std::size_t box) const {
    const PictureBox& it = picture_.boxes[box];
    std::vector<std::string> rows;
    double y = 0;
    for (std::size_t t = 1; t < it.texts.size(); ++t) {
        const Text& text = it.texts[t];
        const bool same =
            !rows.empty() &&
            (y == text.at.y || (text.element != none && is_machine() && text.element == it.texts[t - 1].element));
        if (same)
            rows.back() += (rows.back().ends_with(' ') ? "" : " ") + text.text;
        else
            rows.push_back(text.text);
        y = text.at.y;
    }
    std::istringstream whole(it.whole);
    for (std::string line; std::getline(whole, line);) {
        const auto front = line.substr(0, std::min<std::size_t>(line.size(), 20));
        const auto shortened = std::ranges::find_if(
            rows, [&](const std::string& row) { return row.starts_with(front) && row.ends_with("\xE2\x80\xA6"); });
        if (shortened != rows.end()) *shortened = line;
    }
    return rows;
}

std::string Outline::label_of(const PictureLine& line) const {
    if (!line.whole.empty()) return line.whole;
    std::string result;
    for (const Text& text : line.texts) result += (result.empty() ? "" : " ") + text.text;
    return result;
}

const std::vector<std::size_t>& Outline::boxes_inside(std::size_t box) const {
    return inside_[box == none ? inside_.size() - 1 : box];
}

const std::vector<std::size_t>& Outline::events_of(std::size_t box) const {
    return events_[box];
}

const std::vector<std::size_t>& Outline::lines_inside(std::size_t box) const {
    return lines_[box == none ? lines_.size() - 1 : box];
}

}  // namespace robochart::diagrams
