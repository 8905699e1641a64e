// SPDX-License-Identifier: Apache-2.0
// See fragments.hpp.
#include "frontend/diagrams/stored/fragments.hpp"

#include <charconv>
#include <optional>
#include <utility>
#include <vector>

namespace robochart::diagrams {

using namespace frontend;

namespace {

int digit_of(char c) {
    if ('0' <= c && c <= '9') return c - '0';
    if ('a' <= c && c <= 'f') return c - 'a' + 10;
    if ('A' <= c && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// Replaces escapes such as "%40" by their characters ("@"). All other text is unchanged.
std::string unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size() && digit_of(text[i + 1]) >= 0 && digit_of(text[i + 2]) >= 0) {
            result += static_cast<char>(digit_of(text[i + 1]) * 16 + digit_of(text[i + 2]));
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

std::string last_part(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

/// A step of a path, such as "@nodes.3".
struct Step {
    std::string feature;
    std::size_t number = 0;
};

/// Returns no value if a step has another form.
std::optional<std::vector<Step>> steps_of(std::string_view path) {
    std::vector<Step> steps;
    while (!path.empty()) {
        const std::string_view part = path.substr(0, path.find('/'));
        path.remove_prefix(part.size() < path.size() ? part.size() + 1 : part.size());
        if (!part.starts_with('@')) return std::nullopt;
        const std::size_t dot = part.rfind('.');
        if (dot == std::string_view::npos) return std::nullopt;
        Step step{std::string(part.substr(1, dot - 1)), 0};
        const char* end = part.data() + part.size();
        if (const auto read = std::from_chars(part.data() + dot + 1, end, step.number);
            read.ec != std::errc() || read.ptr != end)
            return std::nullopt;
        steps.push_back(std::move(step));
    }
    return steps;
}

DeclKind kind_of(const Declaration& declaration) {
    const auto* reference = dynamic_cast<const Reference*>(&declaration);
    return reference != nullptr ? reference->refers_to : declaration.kind;
}

/// Returns the item with this number among those that satisfy `fits`.
template <class Items, class Fits>
const Declaration* nth_item(const Items& items, std::size_t number, Fits fits) {
    for (const auto& item : items)
        if (fits(*item) && number-- == 0) return &*item;
    return nullptr;
}

template <class Items>
const Declaration* nth_item(const Items& items, std::size_t number) {
    return number < items.size() ? &*items[number] : nullptr;
}

const Declaration* in_file(const File& file, const Step& step) {
    const auto kinds = [](const std::string& feature) -> std::vector<DeclKind> {
        if (feature == "modules") return {DeclKind::module};
        if (feature == "controllers") return {DeclKind::controller};
        if (feature == "machines") return {DeclKind::state_machine};
        if (feature == "operations") return {DeclKind::operation};
        if (feature == "robots") return {DeclKind::platform};
        if (feature == "interfaces") return {DeclKind::interface};
        return {};
    }(step.feature);
    if (kinds.empty()) return nullptr;
    return nth_item(file.declarations, step.number,
                    [&](const Declaration& declaration) { return declaration.kind == kinds.front(); });
}

const Declaration* in_nodes(const NodeContainer& container, const Step& step) {
    if (step.feature == "nodes") return nth_item(container.nodes, step.number);
    if (step.feature == "transitions") return nth_item(container.transitions, step.number);
    return nullptr;
}

const Declaration* in_component(const Component& component, const Step& step) {
    if (step.feature == "connections") return nth_item(component.connections, step.number);
    if (component.kind == DeclKind::module)
        return step.feature == "nodes" ? nth_item(component.order, step.number) : nullptr;
    const auto of_kind = [&](DeclKind kind) {
        return nth_item(component.order, step.number,
                        [&](const Declaration& declaration) { return kind_of(declaration) == kind; });
    };
    if (step.feature == "machines") return of_kind(DeclKind::state_machine);
    if (step.feature == "lOperations") return of_kind(DeclKind::operation);
    return nullptr;
}

const Declaration* in_declaration(const Declaration& declaration, const Step& step) {
    if (const auto* context = dynamic_cast<const Context*>(&declaration);
        context != nullptr && step.feature == "events")
        return nth_item(context->events, step.number);
    if (const auto* component = dynamic_cast<const Component*>(&declaration)) return in_component(*component, step);
    if (const auto* container = dynamic_cast<const NodeContainer*>(&declaration)) return in_nodes(*container, step);
    return nullptr;
}

}  // namespace

Fragments::Fragments(const Model& model, const diagnostics::SourceManager& sources, const std::string& folder) {
    for (const auto& file : model.files) {
        if (file->is_library || file->is_assertions) continue;
        const std::string& path = sources.path(file->source);
        const std::string name = last_part(path);
        const File*& known = files_[name];
        if (known == nullptr || path == folder + name) known = file.get();
    }
}

/// A file and the steps in it. If the reference does not lead into the model, `file` is null and `steps` is empty.
struct Fragments::Reference {
    const File* file = nullptr;
    std::vector<Step> steps;

    [[nodiscard]] const Declaration* find_target() const {
        if (steps.empty()) return nullptr;
        const Declaration* at = in_file(*file, steps.front());
        for (std::size_t i = 1; i < steps.size() && at != nullptr; ++i) at = in_declaration(*at, steps[i]);
        return at;
    }
};

Fragments::Reference Fragments::read(std::string_view href) const {
    const std::size_t hash = href.find('#');
    if (hash == std::string_view::npos) return {};
    const auto file = files_.find(last_part(unescaped(href.substr(0, hash))));
    const std::string path = unescaped(href.substr(hash + 1));
    if (file == files_.end() || !path.starts_with("//")) return {};
    return {file->second, steps_of(std::string_view(path).substr(2)).value_or(std::vector<Step>())};
}

const Declaration* Fragments::find(std::string_view href) const {
    return read(href).find_target();
}

std::vector<const Declaration*> Fragments::siblings(std::string_view href) const {
    std::vector<const Declaration*> result;
    Reference reference = read(href);
    if (reference.steps.empty()) return result;
    std::size_t& number = reference.steps.back().number;
    number = 0;
    for (const Declaration* at = reference.find_target(); at != nullptr; at = reference.find_target()) {
        result.push_back(at);
        ++number;
    }
    return result;
}

}  // namespace robochart::diagrams
