// SPDX-License-Identifier: Apache-2.0
// Reads drawings; see drawn_obstacles.hpp. Expat reports elements one after another, so only the corners are stored.
#include "simulation/scenario/drawn_obstacles.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace robochart::simulation {

namespace {

constexpr std::size_t most_drawn_corners = 10'000;
constexpr double largest_number = 1e6;

/// Thrown if a drawing is rejected.
class BadDrawing : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Reads numbers and, in paths, commands, one after another.
class Coordinates {
public:
    explicit Coordinates(std::string_view text) : rest_(text) { skip_separators(); }

    [[nodiscard]] bool is_at_end() const { return rest_.empty(); }
    [[nodiscard]] bool at_letter() const {
        return !rest_.empty() && ((rest_[0] >= 'a' && rest_[0] <= 'z') || (rest_[0] >= 'A' && rest_[0] <= 'Z'));
    }
    char read_letter() {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        skip_separators();
        return c;
    }
    double read_number() {
        if (rest_.starts_with('+')) rest_.remove_prefix(1);
        double value = 0;
        const auto [end, wrong] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (wrong != std::errc() || !(std::abs(value) <= largest_number))
            throw BadDrawing(fmt::format("a number up to a million is expected at '{}'", rest_.substr(0, 20)));
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        skip_separators();
        return value;
    }
    Vector read_point() {
        const double x = read_number();
        return {x, read_number()};
    }

private:
    void skip_separators() {
        while (!rest_.empty() && (is_blank(rest_[0]) || rest_[0] == ',')) rest_.remove_prefix(1);
    }
    std::string_view rest_;
};

/// Returns a single number. `px` after the number is the unit of the drawing.
double length_of(std::string_view text) {
    if (text.ends_with("px")) text.remove_suffix(2);
    Coordinates numbers(text);
    const double value = numbers.read_number();
    if (!numbers.is_at_end())
        throw BadDrawing(fmt::format("'{}' is not a length in units of the drawing", text.substr(0, 20)));
    return value;
}

using Polygon = std::vector<Vector>;

/// Reads the polygons of a path with M, L, H, V and Z, absolute or relative.
class Path {
public:
    std::vector<Polygon> read(std::string_view text) {
        Coordinates in(text);
        char command = 0;
        while (!in.is_at_end()) {
            if (in.at_letter())
                command = in.read_letter();
            else if (command == 0)
                throw BadDrawing("a path begins with a command");
            if (command == 'z' || command == 'Z') {
                close_polygon();
                command = 0;
                continue;
            }
            apply_command(command, in);
            // Further points after a move are lines.
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        if (!corners_.empty()) throw BadDrawing("a path is not closed");
        return std::move(polygons_);
    }

private:
    void apply_command(char command, Coordinates& in) {
        const bool relative = command >= 'a';
        const Vector from = relative ? at_ : Vector{};
        switch (command) {
            case 'M':
            case 'm':
                if (!corners_.empty()) throw BadDrawing("a path is not closed");
                at_ = from + in.read_point();
                break;
            case 'L':
            case 'l':
                at_ = from + in.read_point();
                break;
            case 'H':
            case 'h':
                at_.x = from.x + in.read_number();
                break;
            case 'V':
            case 'v':
                at_.y = from.y + in.read_number();
                break;
            default:
                throw BadDrawing(
                    fmt::format("a path has the command {}: only straight lines are read (M L H V Z)", command));
        }
        if (corners_.size() >= most_drawn_corners)
            throw BadDrawing(fmt::format("it has more than {} corners", most_drawn_corners));
        corners_.push_back(at_);
    }

    void close_polygon() {
        if (corners_.empty()) throw BadDrawing("a path is closed twice");
        at_ = corners_.front();
        polygons_.push_back(std::move(corners_));
        corners_.clear();
    }

    Vector at_;
    Polygon corners_;
    std::vector<Polygon> polygons_;
};

/// The polygons and the scale that have been read from a drawing.
class Drawing {
public:
    void begin(std::string_view name, const XML_Char** attributes) {
        constexpr std::string_view space = "http://www.w3.org/2000/svg|";
        // Elements of other namespaces are editors' metadata.
        if (!name.starts_with(space) && name.find('|') != std::string_view::npos) return;
        const std::string_view element = name.starts_with(space) ? name.substr(space.size()) : name;
        if (in_definitions_) throw BadDrawing("the contents of `defs` are not read");
        const auto attribute = [&](std::string_view attribute_name) -> std::optional<std::string_view> {
            for (const XML_Char** at = attributes; *at != nullptr; at += 2)
                if (attribute_name == at[0]) return at[1];
            return std::nullopt;
        };
        const auto needed = [&](std::string_view attribute_name) {
            if (const auto value = attribute(attribute_name)) return *value;
            throw BadDrawing(fmt::format("`{}` has no {}", element, attribute_name));
        };
        if (!root_seen_ && element != "svg") throw BadDrawing("it is not an SVG drawing");
        if (attribute("transform") || attribute("style").value_or("").find("transform") != std::string_view::npos)
            throw BadDrawing("`transform` is not read: write coordinates as they are");
        if (element == "svg") {
            if (root_seen_) throw BadDrawing("a drawing inside the drawing is not read");
            root_seen_ = true;
            set_view(needed("viewBox"));
        } else if (element == "polygon") {
            Coordinates in(needed("points"));
            Polygon corners;
            while (!in.is_at_end()) {
                corners.push_back(in.read_point());
                if (corners.size() > most_drawn_corners) break;
            }
            add(std::move(corners));
        } else if (element == "rect") {
            if (attribute("rx") || attribute("ry")) throw BadDrawing("rounded corners of `rect` are not read");
            const double x = length_of(attribute("x").value_or("0"));
            const double y = length_of(attribute("y").value_or("0"));
            const double width = length_of(needed("width"));
            const double height = length_of(needed("height"));
            if (width <= 0 || height <= 0) throw BadDrawing("a `rect` has no size");
            add({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
        } else if (element == "path") {
            for (Polygon& polygon : Path().read(needed("d"))) add(std::move(polygon));
        } else if (element == "defs") {
            in_definitions_ = true;
        } else if (!draws_nothing(element)) {
            throw BadDrawing(fmt::format("`{}` is not read: obstacles are `polygon`, `rect` and `path`", element));
        }
    }

    void end(std::string_view name) {
        if (name.ends_with("defs")) in_definitions_ = false;
    }

    [[nodiscard]] std::vector<Polygon> obstacles() const {
        if (!root_seen_) throw BadDrawing("it is not an SVG drawing");
        std::vector<Polygon> result = polygons_;
        for (Polygon& polygon : result)
            for (Vector& at : polygon) at = {at.x - middle_.x, middle_.y - at.y};
        return result;
    }

private:
    static bool draws_nothing(std::string_view element) {
        return element == "g" || element == "title" || element == "desc" || element == "metadata";
    }

    void set_view(std::string_view box) {
        Coordinates in(box);
        const Vector corner = in.read_point();
        const Vector size = in.read_point();
        if (!in.is_at_end() || size.x <= 0 || size.y <= 0)
            throw BadDrawing("its viewBox is not four numbers with a size");
        middle_ = corner + 0.5 * size;
    }

    void add(Polygon polygon) {
        if (polygon.size() < 3) throw BadDrawing("an obstacle has at least three corners");
        corners_ += polygon.size();
        if (corners_ > most_drawn_corners)
            throw BadDrawing(fmt::format("it has more than {} corners", most_drawn_corners));
        polygons_.push_back(std::move(polygon));
    }

    bool in_definitions_ = false;
    bool root_seen_ = false;
    Vector middle_;
    std::size_t corners_ = 0;
    std::vector<Polygon> polygons_;
};

/// Wraps the builder, because Expat's callbacks must not throw.
struct DrawingReader {
    XML_Parser parser = nullptr;
    Drawing drawing;
    std::exception_ptr thrown;
    std::uint64_t line = 0;

    template <typename Do>
    void run_guarded(Do what) {
        if (thrown) return;
        try {
            what();
        } catch (...) {
            thrown = std::current_exception();
            line = XML_GetCurrentLineNumber(parser);
            XML_StopParser(parser, XML_FALSE);
        }
    }
};

void element_begins(void* reading, const XML_Char* name, const XML_Char** attributes) {
    auto& to = *static_cast<DrawingReader*>(reading);
    to.run_guarded([&] { to.drawing.begin(name, attributes); });
}

void element_ends(void* reading, const XML_Char* name) {
    auto& to = *static_cast<DrawingReader*>(reading);
    to.run_guarded([&] { to.drawing.end(name); });
}

void doctype_begins(void* reading, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    auto& to = *static_cast<DrawingReader*>(reading);
    to.run_guarded([] { throw BadDrawing("document types are not read: remove the DOCTYPE"); });
}

}  // namespace

std::vector<std::vector<Vector>> drawn_obstacles(std::string_view svg, std::string& error) {
    if (svg.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        error = "it is too large";
        return {};
    }
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
        XML_ParserCreateNS(nullptr, '|'), &XML_ParserFree);
    if (!parser) throw std::bad_alloc();
    DrawingReader reading;
    reading.parser = parser.get();
    XML_SetUserData(parser.get(), &reading);
    XML_SetElementHandler(parser.get(), element_begins, element_ends);
    XML_SetStartDoctypeDeclHandler(parser.get(), doctype_begins);
    const bool read = XML_Parse(parser.get(), svg.data(), static_cast<int>(svg.size()), 1) == XML_STATUS_OK;
    try {
        if (reading.thrown) std::rethrow_exception(reading.thrown);
        if (read) return reading.drawing.obstacles();
        error = fmt::format("line {}: {}", XML_GetCurrentLineNumber(parser.get()),
                            XML_ErrorString(XML_GetErrorCode(parser.get())));
    } catch (const BadDrawing& wrong) {
        error = reading.line > 0 ? fmt::format("line {}: {}", reading.line, wrong.what()) : wrong.what();
    }
    return {};
}

}  // namespace robochart::simulation
