// SPDX-License-Identifier: Apache-2.0
#include "tests/semantics/lower/lowering_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/diagnostics/render.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "semantics/ir/dump.hpp"
#include "tests/codes.hpp"

namespace robochart::ir::samples {
namespace {

template <class T, class Match>
const T& find(const std::vector<T>& items, const std::string& what, const Match& match) {
    const auto it = std::ranges::find_if(items, match);
    if (it == items.end()) throw std::out_of_range("no " + what);
    return *it;
}

}  // namespace

std::vector<std::string> Lowered::codes() const {
    return robochart::tests::codes_but_advice(diagnostics);
}

std::string Lowered::messages() const {
    return diagnostics::render_text(sources, diagnostics);
}

const Machine& Lowered::machine(const std::string& path) const {
    return find(system.machines, path, [&](const Machine& m) { return m.path == path; });
}

const Controller& Lowered::controller(const std::string& path) const {
    return find(system.controllers, path, [&](const Controller& c) { return c.path == path; });
}

const Node& Lowered::node(const std::string& machine_path, const std::string& path) const {
    return find(machine(machine_path).nodes, path, [&](const Node& n) { return n.path == path; });
}

const Transition& Lowered::transition(const std::string& machine_path, const std::string& name) const {
    return find(machine(machine_path).transitions, name, [&](const Transition& t) { return t.name == name; });
}

std::string Lowered::guard(const std::string& machine_path, const std::string& name) const {
    return text(machine_path, transition(machine_path, name).guard);
}

std::string Lowered::text(const std::string& machine_path, const ExprPtr& expr) const {
    return expr ? dump_text(system, &machine(machine_path), *expr) : "none";
}

std::unique_ptr<Lowered> lower_files(const std::vector<SourceText>& files) {
    auto result = std::make_unique<Lowered>();
    for (const auto& file : files) {
        const auto id = result->sources.add(file.path, file.text);
        const bool assertions = file.path.size() > 4 && file.path.substr(file.path.size() - 4) != ".rct";
        result->model.files.push_back(frontend::parse(result->sources, id, assertions, result->diagnostics));
    }
    frontend::add_toolkits(result->sources, result->model, result->diagnostics);
    frontend::resolve(result->model, result->diagnostics);
    if (result->diagnostics.ok()) result->system = lower(result->model, result->sources, result->diagnostics);
    return result;
}

std::unique_ptr<Lowered> lower_text(const std::string& rct, const std::string& assertions) {
    std::vector<SourceText> files{{"t.rct", rct}};
    if (!assertions.empty()) files.push_back({"t.assertions", assertions});
    auto result = lower_files(files);
    EXPECT_EQ(result->diagnostics.error_count(), 0U) << result->messages();
    return result;
}

std::unique_ptr<Lowered> lower_path(const std::string& path) {
    auto result = std::make_unique<Lowered>();
    const auto model = frontend::load_project(result->sources, path, result->diagnostics);
    EXPECT_TRUE(result->diagnostics.ok()) << result->messages();
    if (result->diagnostics.ok()) result->system = lower(*model, result->sources, result->diagnostics);
    EXPECT_TRUE(result->diagnostics.ok()) << result->messages();
    return result;
}

std::string machine_text(const std::string& body) {
    return "stm S {\n initial i\n state A { }\n transition start { from i to A }\n" + body + "\n}\n";
}

}  // namespace robochart::ir::samples
