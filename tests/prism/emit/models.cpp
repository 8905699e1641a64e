// SPDX-License-Identifier: Apache-2.0
#include "tests/prism/emit/models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "prism/checks/check.hpp"
#include "prism/explore/state_space.hpp"
#include "prism/session/experiment.hpp"
#include "prism/session/session.hpp"
#include "prism/syntax/printer.hpp"
#include "prism/syntax/reader.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::prism_emit::testing {

std::string Encoded::codes() const {
    std::set<std::string> codes;
    for (const diagnostics::Diagnostic& finding : diagnostics.sorted_findings())
        if (finding.rule->severity == diagnostics::Severity::error) codes.emplace(finding.rule->code);
    std::string result;
    for (const std::string& code : codes) result += (result.empty() ? "" : " ") + code;
    return result;
}

std::string Encoded::report() const {
    return diagnostics::render_text(sources, diagnostics);
}

std::set<std::string> Encoded::lines(const std::string& prefix) const {
    std::set<std::string> result;
    if (!emission) return result;
    std::istringstream text(prism::print(emission->model));
    for (std::string line; std::getline(text, line);) {
        for (auto at = line.find(prefix); !prefix.empty() && at != std::string::npos; at = line.find(prefix, at))
            line.erase(at, prefix.size());
        line.erase(0, line.find_first_not_of(' '));
        if (!line.empty()) result.insert(line);
    }
    return result;
}

Preferences small_ranges() {
    return {{0, 2}, {0, 2}, {0, 2}, prism::ModelKind::dtmc};
}

std::unique_ptr<Encoded> encode_model(const std::string& text, const Preferences& ranges) {
    return encode_model({{"model.rct", text}}, ranges);
}

std::unique_ptr<Encoded> encode_model(const std::map<std::string, std::string>& files, const Preferences& ranges) {
    auto result = std::make_unique<Encoded>();
    frontend::Model parsed;
    for (const auto& [path, text] : files)
        parsed.files.push_back(frontend::parse(result->sources, result->sources.add(path, text),
                                               path.ends_with(".assertions"), result->diagnostics));
    frontend::add_toolkits(result->sources, parsed, result->diagnostics);
    frontend::resolve(parsed, result->diagnostics);
    if (!result->diagnostics.ok()) return result;
    const ir::System system = ir::lower(parsed, result->sources, result->diagnostics);
    if (!result->diagnostics.ok() || system.modules.empty()) return result;
    result->emission = emit(system, system.modules.front(), ranges, result->diagnostics);
    return result;
}

namespace {

/// Explores the generated text after parsing it, because the users' tools read the text.
class Explored {
public:
    Explored(const Encoded& encoded, const std::map<std::string, std::string>& constants) {
        const auto source = sources_.add("model.prism", file_text(*encoded.emission));
        model_ = prism::check_model(prism::read_model(sources_, source, diagnostics_), diagnostics_);
        if (!model_) throw std::runtime_error(report());
        std::vector<prism::Series> series;
        for (const auto& [name, value] : constants)
            for (prism::Series& constant :
                 prism::read_series(name + "=" + value, prism::open_constants(model_->constants)))
                series.push_back(std::move(constant));
        space_.emplace(*model_, prism::combinations(series).front(), prism::ExploreOptions{}, diagnostics_);
        EXPECT_TRUE(diagnostics_.ok()) << report();
    }

    [[nodiscard]] const prism::StateSpace& space() const { return *space_; }

    double evaluate_property(const std::string& property) {
        const auto source = sources_.add("properties", property);
        const auto properties =
            prism::check_properties(*model_, prism::read_properties(sources_, source, diagnostics_), diagnostics_);
        EXPECT_TRUE(diagnostics_.ok()) << report();
        const prism::Result result = prism::Session(*space_, properties, {1e-11, false, nullptr}).check(0, {});
        return (result.low.bounds().low + result.low.bounds().high) / 2;  // for a number, low is its enclosure
    }

private:
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources_, diagnostics_); }

    diagnostics::SourceManager sources_;
    diagnostics::Diagnostics diagnostics_;
    std::optional<prism::CheckedModel> model_;
    std::optional<prism::StateSpace> space_;
};

}  // namespace

Size size_of(const Encoded& encoded, const std::map<std::string, std::string>& constants) {
    const Explored explored(encoded, constants);
    return {explored.space().chain().states(), static_cast<std::size_t>(explored.space().transitions())};
}

double value_of(const Encoded& encoded, const std::map<std::string, std::string>& constants,
                const std::string& property) {
    return Explored(encoded, constants).evaluate_property(property);
}

}  // namespace robochart::prism_emit::testing
