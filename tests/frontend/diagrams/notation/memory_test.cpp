// SPDX-License-Identifier: Apache-2.0
// Tests that the diagram of a machine changes little after an edit if the previous layout is used. The test edits real
// machines and measures the share of pairs of nodes whose order changes.
#include "frontend/diagrams/notation/memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "frontend/syntax/ast.hpp"
#include "tests/contents.hpp"
#include "tests/frontend/diagrams/models.hpp"
#include "tests/frontend/diagrams/scene.hpp"
#include "tests/shared_folder.hpp"
#include "tests/source_folder.hpp"

namespace robochart::diagrams {
namespace {

namespace fs = std::filesystem;
using frontend::Machine;

using Edit = void (*)(Machine&);

/// Adds two resets to the label of a transition in the middle of the machine.
void lengthen_a_label(Machine& machine) {
    frontend::Transition& transition = *machine.transitions[machine.transitions.size() / 2];
    frontend::QualifiedName name;
    name.parts = {"AnotherClock"};
    transition.resets.push_back({name, nullptr});
}

void add_a_state(Machine& machine) {
    auto state = std::make_unique<frontend::State>(frontend::DeclKind::state);
    state->name = "Added";
    auto transition = std::make_unique<frontend::Transition>();
    transition->source = machine.nodes[machine.nodes.size() / 2].get();
    transition->from.parts = {transition->source->name};
    transition->target = state.get();
    transition->to.parts = {"Added"};
    machine.nodes.push_back(std::move(state));
    machine.transitions.push_back(std::move(transition));
}

void delete_a_transition(Machine& machine) {
    machine.transitions.erase(machine.transitions.begin() +
                              static_cast<std::ptrdiff_t>(machine.transitions.size() / 2));
}

Scene drawn(const frontend::Model& model, const Subject& subject, Memory& memory) {
    const Elements elements(model);
    const Picture picture = draw_subject(subject, {elements, &memory, nullptr});
    Scene scene = scene_of(picture);
    // These names stay the same if boxes are added. They are the names of the elements, qualified by their parents.
    for (std::size_t b = 0; b < scene.boxes.size(); ++b) {
        const std::size_t element = picture.boxes[b].element;
        const std::size_t parent = scene.boxes[b].parent;
        scene.boxes[b].name = (parent == no_box ? "" : scene.boxes[parent].name + "/") +
                              (element == none ? "" : elements.all_elements()[element].name);
    }
    return scene;
}

void edit_machines_of(const fs::path& file, Edit edit, Flips& all) {
    const auto loaded = random_models::load({{file.string(), tests::read_contents(file)}});
    for (const Subject& subject : find_subjects(loaded->model, loaded->sources)) {
        auto* machine = const_cast<Machine*>(dynamic_cast<const Machine*>(subject.component));
        if (machine == nullptr || machine->nodes.size() < 4 || machine->transitions.empty()) continue;
        Memory memory;
        const Scene before = drawn(loaded->model, subject, memory);
        edit(*machine);
        const Flips flips = flips_between(before, drawn(loaded->model, subject, memory));
        if (flips.flipped > 0) std::cout << subject.name << " of " << file << ": " << flips.flipped << "\n";
        all.pairs += flips.pairs;
        all.flipped += flips.flipped;
    }
}

double percent_after(Edit edit, const fs::path& folder) {
    Flips all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".rct") edit_machines_of(entry.path(), edit, all);
    EXPECT_GT(all.pairs, 0U);
    const double percent =
        100.0 * static_cast<double>(all.flipped) / static_cast<double>(std::max<std::size_t>(all.pairs, 1));
    std::cout << all.flipped << " of " << all.pairs << " pairs change sides\n";
    return percent;
}

TEST(Memory, EditsOfOurMachinesMoveLittle) {
    const fs::path folder = tests::source_folder() / "tests";
    EXPECT_EQ(percent_after(lengthen_a_label, folder), 0);
    EXPECT_LE(percent_after(add_a_state, folder), 0.5);
    EXPECT_LE(percent_after(delete_a_transition, folder), 10);
}

TEST(Memory, EditsOfPublicMachinesMoveLittle) {
    const fs::path folder = tests::shared_folder() / "suite";
    if (tests::shared_folder().empty()) GTEST_SKIP() << "there is no folder `shared` beside the repository";
    EXPECT_EQ(percent_after(lengthen_a_label, folder), 0);
    EXPECT_LE(percent_after(add_a_state, folder), 0.5);
    EXPECT_LE(percent_after(delete_a_transition, folder), 10);
}

}  // namespace
}  // namespace robochart::diagrams
