// SPDX-License-Identifier: Apache-2.0
// See elements.hpp.
#include "frontend/diagrams/notation/elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "frontend/diagrams/notation/labels.hpp"
#include "frontend/diagrams/notation/picture.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::diagrams {
namespace {

using namespace frontend;

/// An element before it is numbered.
struct Found {
    const void* node = nullptr;
    Element element;
};

/// Visits everything that is drawn.
class Collector {
public:
    std::vector<Found> found;

    void add(const Declaration& it) {
        found.push_back({&it,
                         {"", std::string(to_text(it.kind)), shown_name(it.name),
                          diagnostics::join_spans(it.span, it.name_span), it.name_span}});
        if (const auto* type = dynamic_cast<const TypeDeclaration*>(&it)) add_type(*type);
        if (const auto* function = dynamic_cast<const Function*>(&it)) {
            collect_conditions("precondition", function->preconditions);
            collect_conditions("postcondition", function->postconditions);
        }
        if (const auto* context = dynamic_cast<const Context*>(&it)) add_context(*context);
        if (const auto* machine = dynamic_cast<const Machine*>(&it)) {
            collect_conditions("precondition", machine->preconditions);
            collect_conditions("postcondition", machine->postconditions);
            add_nodes(*machine);
        }
        if (const auto* component = dynamic_cast<const Component*>(&it)) add_component(*component);
        if (const auto* state = dynamic_cast<const State*>(&it)) {
            for (const Action& action : state->actions)
                add(&action, std::string(to_text(action.kind)) + " action", "", action.span);
            add_nodes(*state);
        }
    }

private:
    void add(const void* node, std::string kind, std::string name, diagnostics::Span span) {
        found.push_back({node, {"", std::move(kind), std::move(name), span, span}});
    }

    template <class Items>
    void add_all(const Items& items) {
        for (const auto& item : items) add(*item);
    }

    void add_type(const TypeDeclaration& type) {
        add_all(type.fields);
        add_all(type.literals);
    }

    void add_context(const Context& context) {
        for (const InterfaceClause& clause : context.interfaces)
            add(&clause, std::string(to_text(clause.use)), shown_name(clause.name.text()), clause.name.span);
        add_all(context.variables);
        add_all(context.events);
        add_all(context.clocks);
        add_all(context.signatures);
        for (const Context* registers : {context.input.get(), context.output.get()})
            if (registers != nullptr) this->add(*registers);
    }

    void collect_conditions(std::string_view word, const std::vector<ExprPtr>& list) {
        for (const ExprPtr& condition : list)
            if (condition) add(condition.get(), std::string(word), "", condition->span);
    }

    void add_nodes(const NodeContainer& container) {
        add_all(container.nodes);
        add_all(container.transitions);
    }

    void add_component(const Component& component) {
        add_all(component.platforms);
        add_all(component.controllers);
        add_all(component.machines);
        add_all(component.operations);
        add_all(component.references);
        add_all(component.connections);
    }
};

}  // namespace

Elements::Elements(const Model& model, std::size_t first) {
    for (const auto& file : model.files) {
        if (file->is_library || file->is_assertions) continue;
        Collector collector;
        for (const auto& declaration : file->declarations) collector.add(*declaration);
        std::ranges::stable_sort(collector.found, [](const Found& a, const Found& b) {
            return std::pair(a.element.span.begin, b.element.span.end) <
                   std::pair(b.element.span.begin, a.element.span.end);
        });
        for (Found& found : collector.found) {
            places_.emplace(found.node, elements_.size());
            found.element.id = fmt::format("e{}", first + elements_.size());
            elements_.push_back(std::move(found.element));
        }
    }
}

std::size_t Elements::find(const void* node) const {
    const auto at = places_.find(node);
    return at == places_.end() ? none : at->second;
}

}  // namespace robochart::diagrams
