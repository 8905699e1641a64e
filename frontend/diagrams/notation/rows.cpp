// SPDX-License-Identifier: Apache-2.0
// See rows.hpp.
#include "frontend/diagrams/notation/rows.hpp"

#include <algorithm>

#include "frontend/diagrams/layout/text_width.hpp"
#include "frontend/diagrams/notation/labels.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::diagrams {

using namespace frontend;

namespace {

double width_of(const std::string& text) {
    return layout::text_width(text, measure::row_font);
}

double width_of(const Row& row) {
    double width = 0;
    for (const RowText& text : row.texts) width += width_of(text.text);
    return width;
}

std::vector<RowText> variables_of(const Context& context, DeclKind kind, const Elements& elements) {
    std::vector<RowText> texts;
    for (const VariablePtr& variable : context.variables)
        if (variable->kind == kind) texts.push_back({text_of(*variable), elements.find(variable.get())});
    return texts;
}

void add_clauses(Rows& rows, const Context& context, InterfaceUse use, Icon icon, const Elements& elements) {
    for (const InterfaceClause& clause : context.interfaces)
        if (clause.use == use) rows.add(icon, {{shown_name(clause.name.text()), elements.find(&clause)}});
}

}  // namespace

void Rows::add(Icon icon, const std::vector<RowText>& texts) {
    constexpr std::size_t longest = 90;
    Row row{icon, {}};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        RowText text = texts[i];
        const std::string short_text = layout::elide_text(text.text, longest);
        if (short_text != text.text) whole += text.text + "\n";
        text.text = short_text + (i + 1 < texts.size() ? ", " : "");
        if (!row.texts.empty() && width_of(row) + width_of(text.text) > measure::widest_row) {
            rows.push_back(std::move(row));
            row = {Icon::no_icon, {}};
        }
        row.texts.push_back(std::move(text));
    }
    if (!row.texts.empty()) rows.push_back(std::move(row));
}

layout::Size Rows::size() const {
    if (rows.empty()) return {0, 0};
    double width = 0;
    for (const Row& row : rows) width = std::max(width, width_of(row));
    return {measure::sign + width + measure::padding,
            measure::row * static_cast<double>(rows.size()) + measure::padding};
}

void Rows::write(const layout::Point& corner, PictureBox& box) const {
    double y = corner.y + measure::padding / 2;
    for (const Row& row : rows) {
        if (row.icon != Icon::no_icon)
            box.signs.push_back({row.icon, {corner.x + measure::sign / 2, y + measure::row / 2}});
        double x = corner.x + measure::sign;
        for (const RowText& text : row.texts) {
            Text written{{x, y + 12}, text.text};
            written.size = measure::row_font;
            written.element = text.element;
            written.italic = text.italic;
            written.flows = &text != &row.texts.front();
            box.texts.push_back(std::move(written));
            x += width_of(text.text);
        }
        y += measure::row;
    }
    if (!whole.empty()) box.whole += whole;
}

namespace {

/// Adds a context of RoboSim, as in `input: uses Button, event pressed`.
void add_registers(Rows& rows, const Context& registers, const Elements& elements) {
    const std::string head = registers.kind == DeclKind::input_context ? "input: " : "output: ";
    std::vector<RowText> texts;
    const auto add = [&](const std::string& text, std::size_t element) {
        texts.push_back({(texts.empty() ? head : "") + text, element});
    };
    for (const InterfaceClause& clause : registers.interfaces)
        add(std::string(to_text(clause.use)) + " " + shown_name(clause.name.text()), elements.find(&clause));
    for (const auto& event : registers.events) add("event " + text_of(*event), elements.find(event.get()));
    rows.add(Icon::no_icon, texts);
}

}  // namespace

Rows rows_of(const Context& context, const Elements& elements, bool with_events) {
    Rows rows;
    for (const Context* registers : {context.input.get(), context.output.get()})
        if (registers != nullptr) add_registers(rows, *registers, elements);
    if (context.cycle) rows.add(Icon::no_icon, {{"cycleDef " + text_of(*context.cycle), elements.find(&context)}});
    add_clauses(rows, context, InterfaceUse::provides, Icon::provides, elements);
    add_clauses(rows, context, InterfaceUse::requires_, Icon::requires_, elements);
    add_clauses(rows, context, InterfaceUse::uses, Icon::uses, elements);
    for (const auto& signature : context.signatures)
        rows.add(Icon::operation, {{text_of(*signature), elements.find(signature.get())}});
    if (with_events)
        for (const auto& event : context.events) rows.add(Icon::event, {{text_of(*event), elements.find(event.get())}});
    rows.add(Icon::constant, variables_of(context, DeclKind::constant, elements));
    rows.add(Icon::variable, variables_of(context, DeclKind::variable, elements));
    std::vector<RowText> clocks;
    for (const auto& clock : context.clocks) clocks.push_back({shown_name(clock->name), elements.find(clock.get())});
    rows.add(Icon::clock, clocks);
    return rows;
}

void add_conditions(Rows& rows, Icon icon, const std::vector<ExprPtr>& conditions, const Elements& elements) {
    for (const ExprPtr& condition : conditions)
        if (condition) rows.add(icon, {{text_of(*condition), elements.find(condition.get())}});
}

}  // namespace robochart::diagrams
