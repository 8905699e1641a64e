// SPDX-License-Identifier: Apache-2.0
// See aird.hpp. Expat reports the elements one after the other, and the relevant ones are stored at once.
#include "frontend/diagrams/stored/aird.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace robochart::diagrams {
namespace {

/// The reason why the text is rejected.
class Refused : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Attributes of an element, by name.
class Attributes {
public:
    explicit Attributes(const XML_Char** list) : list_(list) {}

    /// Returns the value of an attribute, or "" if it does not exist.
    [[nodiscard]] std::string_view operator[](std::string_view name) const {
        for (const XML_Char** at = list_; *at != nullptr; at += 2)
            if (name == at[0]) return at[1];
        return {};
    }
    /// Returns the value of an attribute that has one of two names, depending on the version of RoboTool.
    [[nodiscard]] std::string_view first_value_of(std::string_view name, std::string_view other) const {
        const std::string_view found = (*this)[name];
        return found.empty() ? (*this)[other] : found;
    }
    [[nodiscard]] std::string id() const { return std::string(first_value_of("uid", "xmi:id")); }

private:
    const XML_Char** list_;
};

/// Reads numbers from the beginning of a text. They are pixels or fractions of a side.
class Numbers {
public:
    explicit Numbers(std::string_view text) : text_(text), rest_(text) {}

    double next_number() {
        constexpr double largest = 100'000;
        double value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        const bool read = error == std::errc() || error == std::errc::result_out_of_range;
        if (!read) throw Refused(fmt::format("expected a number at the end of '{}'", text_around()));
        if (error != std::errc() || !(std::abs(value) <= largest))
            throw Refused(fmt::format("the number in '{}' is out of range", text_around()));
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    void expect(char c) {
        if (!rest_.starts_with(c)) throw Refused(fmt::format("expected '{}' in '{}'", c, text_around()));
        rest_.remove_prefix(1);
    }
    [[nodiscard]] bool begins_with(char c) const { return rest_.starts_with(c); }
    [[nodiscard]] bool is_done() const { return rest_.empty(); }

private:
    /// Returns the text around the current position, for messages.
    [[nodiscard]] std::string_view text_around() const {
        constexpr std::size_t around = 24;
        const std::size_t read = text_.size() - rest_.size();
        const std::size_t from = read > around ? read - around : 0;
        return text_.substr(from, 2 * around);
    }

    std::string_view text_, rest_;
};

std::optional<double> number_of(std::string_view text) {
    if (text.empty()) return std::nullopt;
    Numbers numbers(text);
    const double value = numbers.next_number();
    if (!numbers.is_done()) throw Refused(fmt::format("'{}' is not a number", text.substr(0, 40)));
    return value;
}

/// Reads an anchor such as "(0.5,1.0)".
layout::Point anchor_of(std::string_view text) {
    if (!text.starts_with('(')) return {0.5, 0.5};  // a named anchor: the middle
    Numbers numbers(text);
    numbers.expect('(');
    const double x = numbers.next_number();
    numbers.expect(',');
    const double y = numbers.next_number();
    numbers.expect(')');
    return {x, y};
}

/// Reads bends such as "[sx, sy, tx, ty]$[...]".
std::vector<layout::DrawnEdge::Bend> bends_of(std::string_view text) {
    std::vector<layout::DrawnEdge::Bend> bends;
    Numbers numbers(text);
    constexpr std::size_t most = 1000;
    while (!numbers.is_done()) {
        if (bends.size() == most) throw Refused(fmt::format("a line has more than {} bends", most));
        if (!bends.empty()) numbers.expect('$');
        numbers.expect('[');
        double values[4] = {};
        for (double& value : values) {
            if (&value != values) {
                numbers.expect(',');
                while (numbers.begins_with(' ')) numbers.expect(' ');
            }
            value = numbers.next_number();
        }
        numbers.expect(']');
        bends.push_back({{values[0], values[1]}, {values[2], values[3]}});
    }
    return bends;
}

/// Returns the last name in "...[name='StateID']/...".
std::string mapping_of(std::string_view href) {
    constexpr std::string_view before = "[name='";
    const std::size_t begin = href.rfind(before);
    if (begin == std::string_view::npos) return "";
    href.remove_prefix(begin + before.size());
    return std::string(href.substr(0, href.find('\'')));
}

/// The data read so far, and the open elements.
class AirdBuilder {
public:
    explicit AirdBuilder(std::vector<AirdDiagram>& diagrams) : diagrams_(diagrams) {}

    void begin(std::string_view tag, const Attributes& attributes) {
        constexpr std::size_t deepest = 400;
        if (open_.size() >= deepest) throw Refused(fmt::format("elements are nested more than {} deep", deepest));
        Open now = open_.empty() ? Open() : open_.back();
        if (!diagrams_.empty() && now.kind != Kind::outside)
            open_inside(now, tag, attributes);
        else if (tag.ends_with("DSemanticDiagram"))
            now = {Kind::diagram, "", diagrams_.emplace_back().shapes.size(), 0};
        open_.push_back(std::move(now));
    }

    void end() { open_.pop_back(); }

private:
    /// The role of an open element.
    enum class Kind { outside, diagram, element, layout, shape, line, other };
    struct Open {
        Kind kind = Kind::outside;
        std::string element;  ///< id of the drawn element
        std::size_t shape = no_shape;
        std::size_t line = 0;
    };

    void open_inside(Open& now, std::string_view tag, const Attributes& attributes) {
        switch (now.kind) {
            case Kind::diagram:
            case Kind::element:
                in_element(now, tag, attributes);
                return;
            case Kind::layout:
            case Kind::shape:
                in_shape(now, tag, attributes);
                return;
            case Kind::line:
                in_line(now, tag, attributes);
                return;
            case Kind::outside:
            case Kind::other:
                now.kind = Kind::other;
                return;
        }
    }

    void in_element(Open& now, std::string_view tag, const Attributes& attributes) {
        AirdDiagram& diagram = diagrams_.back();
        const bool in_diagram = now.kind == Kind::diagram;
        if (tag == "ownedDiagramElements" || tag == "ownedElements" || tag == "ownedBorderedNodes") {
            now = {Kind::element, attributes.id(), no_shape, 0};
            diagram.elements.try_emplace(
                now.element, AirdElement{std::string(attributes["name"]), "", "", std::string(attributes["sourceNode"]),
                                         std::string(attributes["targetNode"])});
            return;
        }
        if (in_diagram && tag == "ownedAnnotationEntries") return;
        const std::string_view type = attributes.first_value_of("xmi:type", "xsi:type");
        if (in_diagram && tag == "data" && type == "notation:Diagram") {
            now = {Kind::layout, "", no_shape, 0};
            return;
        }
        if (!in_diagram) {
            AirdElement& element = diagram.elements[now.element];
            if (tag == "target" && element.href.empty()) element.href = attributes["href"];
            if (tag == "actualMapping" && element.mapping.empty()) element.mapping = mapping_of(attributes["href"]);
        }
        now.kind = Kind::other;
    }

    void in_shape(Open& now, std::string_view tag, const Attributes& attributes) {
        AirdDiagram& diagram = diagrams_.back();
        if (tag == "children") {
            AirdShape shape;
            shape.type = type_of(attributes["type"]);
            shape.element = attributes["element"];
            shape.parent = now.shape;
            shape.visible = attributes["visible"] != "false";
            now = {Kind::shape, "", diagram.shapes.size(), 0};
            diagram.shapes.push_back(std::move(shape));
        } else if (tag == "edges" && now.kind == Kind::layout) {
            AirdLine line;
            line.element = attributes["element"];
            line.visible = attributes["visible"] != "false";
            line.route.right_angled = false;
            now = {Kind::line, "", no_shape, diagram.lines.size()};
            diagram.lines.push_back(std::move(line));
        } else {
            if (tag == "layoutConstraint" && now.kind == Kind::shape) {
                AirdShape& shape = diagram.shapes[now.shape];
                shape.x = number_of(attributes["x"]);
                shape.y = number_of(attributes["y"]);
                shape.width = number_of(attributes["width"]);
                shape.height = number_of(attributes["height"]);
            }
            now.kind = Kind::other;
        }
    }

    /// Handles a child of a line or of one of its labels. The type of a label is in `shape`.
    void in_line(Open& now, std::string_view tag, const Attributes& attributes) {
        layout::DrawnEdge& route = diagrams_.back().lines[now.line].route;
        constexpr int label_in_the_middle = 6001;
        if (tag == "children") {
            now.shape = static_cast<std::size_t>(std::max(0, type_of(attributes["type"])));
            return;
        }
        const bool in_label = now.shape != no_shape;
        if (in_label && tag == "layoutConstraint" && now.shape == label_in_the_middle)
            route.label = layout::Point{number_of(attributes["x"]).value_or(0), number_of(attributes["y"]).value_or(0)};
        if (!in_label && tag == "styles" && attributes["routing"] == "Rectilinear") route.right_angled = true;
        if (!in_label && tag == "bendpoints") route.bends = bends_of(attributes["points"]);
        if (!in_label && tag == "sourceAnchor") route.source_anchor = anchor_of(attributes["id"]);
        if (!in_label && tag == "targetAnchor") route.target_anchor = anchor_of(attributes["id"]);
        now.kind = Kind::other;
    }

    static int type_of(std::string_view text) {
        int type = 0;
        std::from_chars(text.data(), text.data() + text.size(), type);
        return type;
    }

    std::vector<AirdDiagram>& diagrams_;
    std::vector<Open> open_;
};

/// Runs Expat with the builder. An exception is stored until Expat has returned.
class AirdReader {
public:
    AirdReader(std::string_view text, diagnostics::Budget* budget) : text_(text), budget_(budget) {}

    Aird read() {
        if (text_.size() > longest_aird)
            return make_refusal(fmt::format("it is longer than {} MiB", longest_aird >> 20U));
        parser_.reset(XML_ParserCreate("UTF-8"));
        if (parser_ == nullptr) throw std::bad_alloc();
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), on_begin, on_end);
        XML_SetXmlDeclHandler(parser_.get(), on_declaration);
        XML_SetStartDoctypeDeclHandler(parser_.get(), on_document_type);
        parse();
        if (!error_.empty()) return make_refusal(error_);
        return std::move(aird_);
    }

private:
    void parse() {
        constexpr std::size_t piece = 1U << 16U;
        for (std::size_t at = 0; error_.empty(); at += piece) {
            if (budget_ != nullptr) budget_->check();
            const std::string_view part = text_.substr(at, piece);
            const bool last = at + part.size() == text_.size();
            const auto result =
                XML_Parse(parser_.get(), part.data(), static_cast<int>(part.size()), last ? XML_TRUE : XML_FALSE);
            if (failure_) std::rethrow_exception(failure_);
            if (result == XML_STATUS_ERROR && error_.empty()) {
                error_ = error_cause();
                at_ = XML_GetCurrentByteIndex(parser_.get());
            }
            if (last) break;
        }
    }

    [[nodiscard]] std::string error_cause() const {
        const XML_Error error = XML_GetErrorCode(parser_.get());
        const bool short_text =
            error == XML_ERROR_NO_ELEMENTS || error == XML_ERROR_UNCLOSED_TOKEN || error == XML_ERROR_PARTIAL_CHAR;
        if (text_.empty()) return "it is empty";
        const bool at_end = XML_GetCurrentByteIndex(parser_.get()) >= static_cast<XML_Index>(text_.size());
        if (short_text || at_end) return "the text ends before the end of its last element";
        return fmt::format("it is not XML in UTF-8: {}", XML_ErrorString(error));
    }

    Aird make_refusal(std::string why) const {
        Aird result;
        result.error = std::move(why);
        if (at_ > 0) result.offset = static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(at_), text_.size()));
        return result;
    }

    /// Calls `work`. An exception is stored and ends the parsing, because exceptions must not pass through Expat, which
    /// is C code.
    template <class Work>
    void run_guarded(Work work) {
        if (!error_.empty() || failure_) return;
        try {
            work();
        } catch (const Refused& wrong) {
            error_ = wrong.what();
            at_ = XML_GetCurrentByteIndex(parser_.get());
        } catch (...) {
            failure_ = std::current_exception();
        }
        if (!error_.empty() || failure_) XML_StopParser(parser_.get(), XML_FALSE);
    }

    static AirdReader& reader_of(void* data) { return *static_cast<AirdReader*>(data); }
    static void XMLCALL on_begin(void* data, const XML_Char* tag, const XML_Char** attributes) {
        AirdReader& reader = reader_of(data);
        reader.run_guarded([&] {
            if (reader.budget_ != nullptr) reader.budget_->poll();
            reader.builder_.begin(tag, Attributes(attributes));
        });
    }
    static void XMLCALL on_end(void* data, const XML_Char*) {
        reader_of(data).run_guarded([&] { reader_of(data).builder_.end(); });
    }
    static void XMLCALL on_declaration(void* data, const XML_Char* version, const XML_Char* encoding, int) {
        if (version == nullptr || encoding == nullptr) return;
        reader_of(data).run_guarded([&] {
            std::string name(encoding);
            std::ranges::transform(name, name.begin(),
                                   [](char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
            if (name != "UTF-8" && name != "ASCII" && name != "US-ASCII")
                throw Refused(fmt::format("its encoding is {}, not UTF-8", name.substr(0, 40)));
        });
    }
    static void XMLCALL on_document_type(void* data, const XML_Char*, const XML_Char*, const XML_Char*, int) {
        reader_of(data).run_guarded(
            [] { throw Refused("it has a document type (DOCTYPE), but diagram files have none"); });
    }

    struct Free {
        void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
    };

    std::string_view text_;
    diagnostics::Budget* budget_;
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
    Aird aird_;
    AirdBuilder builder_{aird_.diagrams};
    std::string error_;
    XML_Index at_ = 0;  ///< the place of the error, in bytes
    std::exception_ptr failure_;
};

}  // namespace

Aird read_aird(std::string_view text, diagnostics::Budget* budget) {
    return AirdReader(text, budget).read();
}

}  // namespace robochart::diagrams
