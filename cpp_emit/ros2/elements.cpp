// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/elements.hpp"

#include <fmt/format.h>

namespace robochart::cpp_emit::ros2 {

std::vector<Element> elements_of(const Generation& generation, const ClassApi& api) {
    std::vector<Element> result;
    const diagnostics::Span whole = generation.component.origin.span;
    each_class(api, [&](const ApiClass& part) {
        for (const ApiEvent& event : part.events)
            result.push_back({ElementKind::event, event.sent, event.port->model_name, nullptr, &event, nullptr, whole});
        for (const ApiOperation& operation : part.operations)
            if (!operation.modelled)
                result.push_back({ElementKind::operation, true, operation.signature->name, &operation, nullptr, nullptr,
                                  operation.signature->origin.span});
        for (const ApiVariable& variable : part.variables) {
            const ir::Variable& declared = *variable.stored->variable;
            for (const bool published : {true, false})
                if (published ? variable.stored->visible : variable.stored->external && variable.stored->has_member())
                    result.push_back({ElementKind::variable, published, declared.name, nullptr, nullptr, &variable,
                                      declared.origin.span});
        }
    });
    return result;
}

std::optional<ir::TypeId> type_of(const Element& element) {
    if (element.event != nullptr) return element.event->port->type;
    if (element.variable != nullptr) return element.variable->stored->variable->type;
    return std::nullopt;
}

std::vector<ModelValue> values_of(const Element& element) {
    std::vector<ModelValue> values;
    if (element.operation != nullptr) {
        const ir::OperationSignature& signature = *element.operation->signature;
        for (std::size_t i = 0; i < signature.parameters.size(); ++i)
            values.push_back({signature.parameter_names[i], fmt::format("a{}", i), signature.parameters[i]});
    } else if (const auto type = type_of(element)) {
        const bool sent = element.published && element.event != nullptr;
        values.push_back({"value", sent ? "a0" : "value", *type});
    }
    return values;
}

}  // namespace robochart::cpp_emit::ros2
