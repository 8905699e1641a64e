// SPDX-License-Identifier: Apache-2.0
// Finds components in which a rule can be violated.
#include "tests/random_models/changes/violations.hpp"

#include <algorithm>
#include <map>

#include "frontend/syntax/print.hpp"

namespace robochart::random_models {

using namespace frontend;

namespace {

/// A component in which a violation can be inserted.
struct Place {
    const Declaration* component = nullptr;
    const File* file = nullptr;
    const NodeContainer* nodes = nullptr;  ///< of machines, operations and states
};

/// Collects all components of a project by kind, including nested ones.
class Places {
public:
    explicit Places(const Model& model) {
        for (const auto& file : model.files) {
            if (file->is_assertions || file->is_library) continue;
            files_.push_back({nullptr, file.get(), nullptr});
            for (const auto& declared : file->declarations) add(*declared, *file);
        }
    }

    [[nodiscard]] const std::vector<Place>& places_for(Site site) const {
        switch (site) {
            case Site::file:
                return files_;
            case Site::machine:
                return kind(DeclKind::state_machine);
            case Site::operation:
                return kind(DeclKind::operation);
            case Site::platform:
                return kind(DeclKind::platform);
            case Site::controller:
                return kind(DeclKind::controller);
            case Site::module:
                return kind(DeclKind::module);
            case Site::state:
                break;
        }
        return kind(DeclKind::state);
    }
    /// Returns the place of a component.
    [[nodiscard]] const Place* find(const Declaration* component) const {
        for (const auto& [kind, places] : places_)
            for (const Place& place : places)
                if (place.component == component) return &place;
        return nullptr;
    }

private:
    [[nodiscard]] const std::vector<Place>& kind(DeclKind kind) const {
        static const std::vector<Place> none;
        const auto found = places_.find(kind);
        return found != places_.end() ? found->second : none;
    }

    void add(const Declaration& declared, const File& file) {
        const auto* machine = dynamic_cast<const Machine*>(&declared);
        places_[declared.kind].push_back({&declared, &file, machine});
        if (machine != nullptr) add_states(*machine, file);
        if (const auto* component = dynamic_cast<const Component*>(&declared))
            for (const Declaration* part : component->order) add(*part, file);
    }

    void add_states(const NodeContainer& container, const File& file) {
        for (const auto& node : container.nodes)
            if (node->kind == DeclKind::state) {
                places_[DeclKind::state].push_back({node.get(), &file, node.get()});
                add_states(*node, file);
            }
    }

    std::map<DeclKind, std::vector<Place>> places_;
    std::vector<Place> files_;
};

std::vector<std::string> names_of(const NodeContainer* container, DeclKind kind) {
    std::vector<std::string> names;
    if (container != nullptr)
        for (const auto& node : container->nodes)
            if (node->kind == kind) names.push_back(written_name(node->name));
    return names;
}

std::vector<std::string> inner_states(const NodeContainer* container) {
    std::vector<std::string> names;
    if (container == nullptr) return names;
    for (const auto& node : container->nodes)
        for (std::string& name : names_of(node.get(), DeclKind::state)) names.push_back(std::move(name));
    return names;
}

/// Returns the parts of a controller that are machines, with the definitions of the machines.
std::vector<std::pair<std::string, const Machine*>> machine_parts(const Declaration* component) {
    std::vector<std::pair<std::string, const Machine*>> parts;
    const auto* controller = dynamic_cast<const Component*>(component);
    if (controller == nullptr) return parts;
    for (const Declaration* part : controller->order) {
        const auto* reference = dynamic_cast<const Reference*>(part);
        const auto* machine = dynamic_cast<const Machine*>(reference != nullptr ? reference->target : part);
        if (machine != nullptr && machine->kind == DeclKind::state_machine)
            parts.emplace_back(written_name(part->name), machine);
    }
    return parts;
}

/// Replaces words such as `$state` by names of elements.
class Filler {
public:
    Filler(const Place& place, Random& random) : place_(place), random_(random) {}

    /// Returns the text with names, or nullopt if the component has no such element.
    std::optional<std::string> fill(std::string_view text) {
        std::string out;
        while (!text.empty()) {
            const std::size_t mark = std::min(text.find('$'), text.size());
            out += text.substr(0, mark);
            text.remove_prefix(mark);
            if (text.empty()) break;
            const std::size_t end = std::min(text.find_first_of(" ),;}.", 1), text.size());
            const auto name = value(text.substr(1, end - 1));
            if (!name) return std::nullopt;
            out += *name;
            text.remove_prefix(end);
        }
        return out;
    }
    [[nodiscard]] const Machine* part() const { return part_; }

private:
    std::optional<std::string> value(std::string_view word) {
        const auto known = chosen_.find(word);
        if (known != chosen_.end()) return known->second;
        const std::vector<std::string> names = candidates(word);
        if (names.empty()) return std::nullopt;
        const std::size_t index = random_.below(names.size());
        if (word == "part") part_ = machine_parts(place_.component)[index].second;
        chosen_.emplace(word, names[index]);
        return names[index];
    }

    [[nodiscard]] std::vector<std::string> candidates(std::string_view word) const {
        if (word == "state") return names_of(place_.nodes, DeclKind::state);
        if (word == "initial") return names_of(place_.nodes, DeclKind::initial);
        if (word == "final") return names_of(place_.nodes, DeclKind::final);
        if (word == "junction") return names_of(place_.nodes, DeclKind::junction);
        if (word == "inner") return inner_states(place_.nodes);
        if (word == "self") return {written_name(place_.component->name)};
        std::vector<std::string> names;
        if (word == "part")
            for (const auto& [name, machine] : machine_parts(place_.component)) names.push_back(name);
        if (word == "parameter")
            for (const VariablePtr& parameter : static_cast<const Machine&>(*place_.component).parameters)
                names.push_back(written_name(parameter->name));
        return names;
    }

    const Place& place_;
    Random& random_;
    std::map<std::string_view, std::string> chosen_;
    const Machine* part_ = nullptr;
};

/// Collects texts to insert, in descending order of position.
class Insertions {
public:
    explicit Insertions(const Model& model) : model_(model) {}

    /// Inserts before the closing brace of a component, or at the end of the file if there is none.
    void add(const Place& place, const std::string& text) {
        const std::size_t file = static_cast<std::size_t>(
            std::ranges::find_if(model_.files, [&](const auto& candidate) { return candidate.get() == place.file; }) -
            model_.files.begin());
        const bool inside = place.component != nullptr;
        insertions_.push_back({file, inside ? place.component->span.end - 1 : std::string::npos, "\n" + text + "\n"});
    }

    Project apply(Project project) {
        std::ranges::stable_sort(insertions_, [](const Insertion& a, const Insertion& b) { return a.at > b.at; });
        for (const Insertion& insertion : insertions_) {
            std::string& text = project[insertion.file].text;
            text.insert(std::min(insertion.at, text.size()), insertion.text);
        }
        return project;
    }

private:
    struct Insertion {
        std::size_t file;
        std::size_t at;
        std::string text;
    };
    const Model& model_;
    std::vector<Insertion> insertions_;
};

}  // namespace

std::optional<Project> violate(const Project& project, const Violation& violation, Random& random) {
    const auto loaded = load(project);
    const Places places(loaded->model);
    const std::vector<Place>& candidates = places.places_for(violation.site);
    if (candidates.empty()) return std::nullopt;
    const Place place = random.pick(candidates);
    Filler filler(place, random);
    const auto member = filler.fill(violation.member);
    if (!member) return std::nullopt;
    Insertions insertions(loaded->model);
    insertions.add(place, *member);
    if (!violation.top.empty()) insertions.add({nullptr, place.file, nullptr}, std::string(violation.top));
    if (!violation.part.empty()) insertions.add(*places.find(filler.part()), std::string(violation.part));
    return insertions.apply(project);
}

}  // namespace robochart::random_models
