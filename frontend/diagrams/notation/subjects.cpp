// SPDX-License-Identifier: Apache-2.0
// See subjects.hpp.
#include "frontend/diagrams/notation/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "frontend/diagrams/layout/drawn_ports.hpp"
#include "frontend/diagrams/notation/labels.hpp"
#include "frontend/diagrams/notation/node_level.hpp"
#include "frontend/diagrams/notation/part_level.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::diagrams {

using namespace frontend;
using layout::Point;
using layout::Rectangle;
using layout::Size;

namespace {

/// Returns a name as part of a file name: all characters except ASCII letters and digits become "_".
std::string safe_file_name(const std::string& name) {
    constexpr std::size_t longest = 100;
    std::string result;
    for (const char c : name.substr(0, longest))
        result += std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80 ? c : '_';
    return result.empty() ? "_" : result;
}

std::string to_lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string stem_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    return name.substr(0, name.rfind('.'));
}

class Finder {
public:
    explicit Finder(const diagnostics::SourceManager& sources) : sources_(sources) {}

    std::vector<Subject> find(const Model& model) {
        for (const auto& file : model.files) {
            if (file->is_library || file->is_assertions) continue;
            for (const auto& declaration : file->declarations) add(*declaration, file->package.text());
            add_package(*file);
        }
        for (Subject& package : found_) subjects_.push_back(std::move(package));
        name_files();
        return std::move(subjects_);
    }

private:
    void add(const Declaration& declaration, const std::string& prefix) {
        const std::string name = (prefix.empty() ? "" : prefix + "::") + declaration.name;
        if (!has_diagram(declaration)) return;
        subjects_.push_back({name, "", &declaration, {}});
        const auto* component = dynamic_cast<const Component*>(&declaration);
        if (component == nullptr) return;
        for (const Declaration* part : component->order)
            if (part->kind != DeclKind::reference) add(*part, name);
    }

    void add_package(const File& file) {
        const bool drawn = std::ranges::any_of(file.declarations, [](const auto& declaration) {
            return declaration->kind == DeclKind::interface || declaration->kind == DeclKind::function ||
                   dynamic_cast<const TypeDeclaration*>(declaration.get()) != nullptr;
        });
        if (!drawn) return;
        const std::string name = file.package.empty() ? stem_of(sources_.path(file.source)) : file.package.text();
        const auto [at, fresh] = packages_.emplace(name, found_.size());
        if (fresh) found_.push_back({name, "", nullptr, {}});
        found_[at->second].files.push_back(&file);
    }

    /// Names the file of each diagram after the last part of the subject's name. If two names would be equal on some
    /// file system, the full names are used. If these are also equal, numbers are added.
    void name_files() {
        std::map<std::string, std::size_t> uses;
        const auto last_name = [](const Subject& subject) {
            return subject.component == nullptr ? safe_file_name(subject.name) + "_types"
                                                : safe_file_name(subject.component->name);
        };
        for (const Subject& subject : subjects_) ++uses[to_lower_case(last_name(subject))];
        std::set<std::string> taken;
        for (Subject& subject : subjects_) {
            std::string name = last_name(subject);
            if (uses[to_lower_case(name)] > 1)
                name = safe_file_name(subject.name) + (subject.component == nullptr ? "_types" : "");
            subject.file = name;
            for (int i = 2; !taken.insert(to_lower_case(subject.file)).second; ++i)
                subject.file = fmt::format("{}_{}", name, i);
        }
    }

    const diagnostics::SourceManager& sources_;
    std::vector<Subject> subjects_;
    std::vector<Subject> found_;  ///< packages
    std::map<std::string, std::size_t> packages_;
};

/// The title and the rows of a component. If `events` is true, also the squares of its events at the right.
class Frame {
public:
    Frame(const Context& context, const Drawing& drawing, bool events) : context_(context), stored_(drawing.stored) {
        box_.look = Look::frame;
        box_.element = drawing.elements.find(&context);
        rows_ = rows_of(context, drawing.elements, false);
        if (const auto* machine = dynamic_cast<const Machine*>(&context)) {
            add_conditions(rows_, Icon::precondition, machine->preconditions, drawing.elements);
            add_conditions(rows_, Icon::postcondition, machine->postconditions, drawing.elements);
        }
        if (events)
            for (const Event* event : events_of(context)) {
                squares_.push_back(square_of(*event, drawing.elements));
                if (stored_ == nullptr) continue;
                drawn_.ports.push_back(stored_->port_of(&context, event));
                drawn_.labels.push_back(label_size(squares_.back()));
            }
        set_title();
    }

    /// Returns the size of the title, the rows and the squares.
    [[nodiscard]] Size header_size() const {
        const Size rows = rows_.size();
        if (stored_ != nullptr)
            return {std::max(title_.width(), rows.width + row_indent), measure::title + rows.height};
        double labels = 0;
        for (const EventSquare& square : squares_) labels = std::max(labels, label_width(square));
        if (labels > 0) labels += pitch;
        const double squares = squares_.empty() ? 0 : pitch * static_cast<double>(squares_.size()) + 4;
        return {std::max(title_.width(), rows.width + labels), measure::title + std::max(rows.height, squares)};
    }

    /// Returns the text of the title, relative to the middle of the upper side.
    [[nodiscard]] Rectangle title() const { return title_.text_place(measure::title); }

    /// Returns the frame without its position.
    [[nodiscard]] PictureBox frame_box() const { return box_; }

    /// Writes the contents into the first box of a picture, whose position is set.
    void write(Picture& picture, bool more_below) const {
        PictureBox& box = picture.boxes.front();
        title_.write(box, measure::title);
        const double header = this->header_size().height;
        if (header > measure::title || more_below) box.rules.push_back(box.place.y + measure::title);
        if (header > measure::title && more_below) box.rules.push_back(box.place.y + header);
        rows_.write({box.place.x + (stored_ == nullptr ? 0 : row_indent), box.place.y + measure::title}, box);
        if (stored_ != nullptr) {
            write_squares(picture, header);
            return;
        }
        const Point first{box.place.right(), box.place.y + measure::title + 2 + pitch / 2};
        for (std::size_t i = 0; i < squares_.size(); ++i)
            picture.boxes.push_back(
                draw_square(squares_[i], {first.x, first.y + pitch * static_cast<double>(i)}, 0, true));
    }

private:
    static constexpr double pitch = 26;
    static constexpr double row_indent = layout::port_size / 2;  ///< space for squares on the left border

    /// Writes the squares where a person drew them.
    void write_squares(Picture& picture, double header) const {
        layout::DrawnPorts drawn = drawn_;
        drawn.title = title();
        drawn.owner = stored_->size(&context_);
        drawn.header = stored_->area_of(&context_).above.value_or(header);
        const std::vector<layout::PlacedPort> ports =
            layout::ports_as_drawn(picture.boxes.front().place, header, drawn);
        for (std::size_t i = 0; i < squares_.size(); ++i)
            picture.boxes.push_back(draw_square(squares_[i], ports[i], {0, 0}, 0, true));
    }

    void set_title() {
        title_.text = shown_name(context_.name);
        title_.icon = Icon::machine;
        if (context_.kind == DeclKind::module) title_.icon = Icon::module;
        if (context_.kind == DeclKind::controller) title_.icon = Icon::controller;
        if (context_.kind == DeclKind::platform) title_.icon = Icon::platform;
        if (context_.kind == DeclKind::operation) {
            title_.icon = Icon::operation;
            title_.text = title_of(dynamic_cast<const Machine&>(context_));
        }
    }

    const Context& context_;
    PictureBox box_;
    Title title_;
    Rows rows_;
    std::vector<EventSquare> squares_;
    const StoredLayout* stored_;
    layout::DrawnPorts drawn_;
};

Picture draw_machine(const Machine& machine, const std::string& path, const Drawing& drawing) {
    constexpr double inset = 16;
    const Frame frame(machine, drawing, true);
    const NodeLevel level(machine, path, drawing);
    const Size header = frame.header_size();
    Picture picture;
    picture.boxes.push_back(frame.frame_box());
    const double around = 2 * level.margin(inset);
    const double width = std::max({header.width, level.size().width + around, 120.0});
    const Rectangle inside{0, header.height, width, level.empty() ? 0 : level.size().height + around};
    picture.boxes[0].place = {0, 0, width, inside.bottom()};
    frame.write(picture, !level.empty());
    level.paint(picture, level.corner_in(inside), 0);
    return picture;
}

Picture draw_component(const Component& component, const Drawing& drawing) {
    const Frame frame(component, drawing, false);
    PartLevel level(component, frame.header_size(), frame.title(), drawing);
    Picture picture;
    picture.boxes.push_back(frame.frame_box());
    level.paint(picture);
    frame.write(picture, true);
    return picture;
}

Picture draw_platform(const Context& platform, const Drawing& drawing) {
    const Frame frame(platform, drawing, true);
    const Size header = frame.header_size();
    Picture picture;
    picture.boxes.push_back(frame.frame_box());
    const Size drawn = drawing.stored == nullptr ? Size() : drawing.stored->size(&platform);
    picture.boxes[0].place = {0, 0, std::max({header.width, drawn.width, 120.0}),
                              std::max(header.height, drawn.height)};
    frame.write(picture, false);
    return picture;
}

/// A declaration of a package with its title and rows.
struct Card {
    const void* node = nullptr;
    Title title;
    Rows rows;
};

std::optional<Card> card_of(const Declaration& declaration, const Elements& elements) {
    Card card{&declaration, {Icon::no_icon, shown_name(declaration.name)}, {}};
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declaration)) {
        if (type->kind == DeclKind::enumeration) card.title.icon = Icon::enumeration;
        if (type->kind == DeclKind::record_type) card.title.icon = Icon::record;
        for (const auto& literal : type->literals)
            card.rows.add(Icon::no_icon, {{text_of(*literal), elements.find(literal.get())}});
        for (const auto& field : type->fields)
            card.rows.add(Icon::no_icon, {{text_of(*field), elements.find(field.get())}});
        return card;
    }
    if (const auto* function = dynamic_cast<const Function*>(&declaration)) {
        card.title = {Icon::function, text_of(*function)};
        add_conditions(card.rows, Icon::precondition, function->preconditions, elements);
        add_conditions(card.rows, Icon::postcondition, function->postconditions, elements);
        return card;
    }
    if (declaration.kind != DeclKind::interface) return std::nullopt;
    card.rows = rows_of(dynamic_cast<const Context&>(declaration), elements, true);
    return card;
}

std::vector<Card> cards_of(const Subject& subject, const Elements& elements) {
    std::vector<Card> cards;
    Card package;
    package.title = {Icon::no_icon, "package " + shown_name(subject.name), false, true, true, false};
    Card imports;
    imports.title = {Icon::no_icon, "imports", false, true, false, false};
    for (const File* file : subject.files) {
        if (!file->package.empty()) package.node = file;
        for (const Import& import : file->imports)
            imports.rows.add(Icon::no_icon, {{shown_name(import.name.text() + (import.wildcard ? "::*" : ""))}});
    }
    if (package.node != nullptr) cards.push_back(std::move(package));
    if (!imports.rows.empty()) cards.push_back(std::move(imports));
    for (const File* file : subject.files)
        for (const auto& declaration : file->declarations)
            if (auto card = card_of(*declaration, elements)) cards.push_back(std::move(*card));
    return cards;
}

Picture draw_package(const Subject& subject, const Drawing& drawing) {
    const std::vector<Card> cards = cards_of(subject, drawing.elements);
    layout::Level level;
    LevelNames names;
    names.path = "package " + subject.name;
    for (const Card& card : cards) {
        const Size rows = card.rows.size();
        level.boxes.emplace_back().size = {std::max({card.title.width(), rows.width, 80.0}),
                                           measure::title + rows.height};
        names.boxes.push_back(card.title.text);
    }
    level.direction = layout::Direction::down;
    const layout::Placement placement = arrange_again(level, std::move(names), drawing.memory, drawing.budget);
    Picture picture;
    for (std::size_t c = 0; c < cards.size(); ++c) {
        PictureBox box;
        box.element = drawing.elements.find(cards[c].node);
        box.place = placement.boxes[c].place;
        cards[c].title.write(box, measure::title);
        if (!cards[c].rows.empty()) box.rules.push_back(box.place.y + measure::title);
        cards[c].rows.write({box.place.x, box.place.y + measure::title}, box);
        picture.boxes.push_back(std::move(box));
    }
    return picture;
}

std::string count_text(std::size_t count, const std::string& one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// Describes a picture by the numbers of its boxes and lines, without the squares of events and the frame.
std::string description_of(const Picture& picture) {
    const auto boxes = static_cast<std::size_t>(std::ranges::count_if(
        picture.boxes, [](const PictureBox& box) { return box.event_of == none && box.look != Look::frame; }));
    const std::size_t events = static_cast<std::size_t>(
        std::ranges::count_if(picture.boxes, [](const PictureBox& box) { return box.event_of != none; }));
    return fmt::format("{}, {}, {}", boxes == 1 ? "1 box" : fmt::format("{} boxes", boxes),
                       count_text(picture.lines.size(), "line"), count_text(events, "event"));
}

Picture draw_any(const Subject& subject, const Drawing& drawing) {
    if (subject.component == nullptr) return draw_package(subject, drawing);
    if (const auto* machine = dynamic_cast<const Machine*>(subject.component))
        return draw_machine(*machine, subject.name, drawing);
    if (const auto* component = dynamic_cast<const Component*>(subject.component))
        return draw_component(*component, drawing);
    return draw_platform(dynamic_cast<const Context&>(*subject.component), drawing);
}

}  // namespace

bool has_diagram(const frontend::Declaration& declaration) {
    const DeclKind kind = declaration.kind;
    return kind == DeclKind::module || kind == DeclKind::controller || kind == DeclKind::state_machine ||
           kind == DeclKind::operation || kind == DeclKind::platform;
}

std::vector<Subject> find_subjects(const Model& model, const diagnostics::SourceManager& sources) {
    return Finder(sources).find(model);
}

Picture draw_subject(const Subject& subject, const Drawing& drawing) {
    Picture picture = draw_any(subject, drawing);
    crop_picture(picture);
    const std::string kind = subject.component == nullptr ? "package" : std::string(to_text(subject.component->kind));
    picture.title = kind + " " + shown_name(subject.name);
    picture.description = description_of(picture);
    return picture;
}

}  // namespace robochart::diagrams
