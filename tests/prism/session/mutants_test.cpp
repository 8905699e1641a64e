// SPDX-License-Identifier: Apache-2.0
// Tests mutated models: every prefix of a text, and texts with pieces cut, doubled and exchanged. Each must be rejected
// with a finding, stopped by a limit, or answered.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/diagnostics/splitmix64.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;
using testing::failure_text;

constexpr std::string_view model_text =
    "mdp\nconst int n = 3; const double p = 0.25; formula f = x<n & (b | !b);\nglobal g : bool init false;\n"
    "module M\n  x : [0..n] init 0;\n  b : bool;\n  [a] f -> p:(x'=x+1) + 1-p:(b'=!b);\n  [] x=n -> (x'=max(0,x-2));\n"
    "  [] g=b -> (g'=!g);\nendmodule\nmodule N = M [ x=y, b=c, a=a ] endmodule\nmodule O z:[-1..1]; [d] z<1 -> "
    "(z'=z+1); "
    "endmodule\nrewards \"r\" [a] true : 1/3; x=1 : mod(x,2)^2; endrewards\nlabel \"l\" = x=n ? b : c;\n"
    "system (M |[a]| N) ||| O/{d} endsystem\n";
constexpr std::string_view property_text =
    "const int k = 2;\n\"one\": Pmax=? [ !\"l\" U<=k x=n ];\nR{\"r\"}min=? [ F x=1 ];\nfilter(max, Pmin=? [ G F b ], "
    "x=1) + "
    "floor(log(8,2));\nA [ G \"one\" >= 0 ] => P>=1 [ X b ];\nRmax=? [ C<=3 ];\n";

/// Processes the texts in the same way as the verb.
void process(const std::string& model, const std::string& properties) {
    diagnostics::Limits limits;
    limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    diagnostics::Budget budget(limits);
    ExploreOptions options;
    options.max_states = 500;
    options.budget = &budget;
    testing::Read read;
    const ModelFile file = read_model(read.sources, read.add(model), read.diagnostics);
    const PropertyFile questions = read_properties(read.sources, read.add(properties, "p.props"), read.diagnostics);
    if (!read.diagnostics.ok()) return;
    const auto checked = check_model(file, read.diagnostics);
    if (!checked) {
        EXPECT_FALSE(read.diagnostics.ok()) << model;
        return;
    }
    const CheckedProperties checked_properties = check_properties(*checked, questions, read.diagnostics);
    if (!read.diagnostics.ok()) return;
    try {
        const StateSpace space(*checked, {}, options, read.diagnostics);
        Session session(space, checked_properties, {1e-6, false, &budget});
        for (std::size_t i = 0; i < checked_properties.properties.size(); ++i) {
            try {
                (void)session.check(i, {});
            } catch (const EvaluationError& error) {
                error.report(read.diagnostics);
            }
        }
    } catch (const EvaluationError& error) {
        error.report(read.diagnostics);
    } catch (const diagnostics::LimitReached&) {
        return;
    }
}

TEST(PrismMutants, TheTextItselfIsInOrder) {
    Explored model{std::string(model_text)};
    EXPECT_GT(model.space->chain().states(), 10U);
    const Result result = model.ask(std::string(property_text));
    EXPECT_EQ(result.kind, Result::Kind::number);
}

TEST(PrismMutants, Prefixes) {
    for (std::size_t length = 0; length < model_text.size(); ++length)
        process(std::string(model_text.substr(0, length)), std::string(property_text));
    for (std::size_t length = 0; length < property_text.size(); ++length)
        process(std::string(model_text), std::string(property_text.substr(0, length)));
}

/// Cuts, doubles or exchanges words and symbols of one or both texts.
std::string mutant(std::string text, std::uint64_t& seed) {
    const auto place = [&] { return diagnostics::splitmix64(seed) % (text.size() + 1); };
    const int changes = 1 + static_cast<int>(diagnostics::splitmix64(seed) % 3);
    for (int i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t at = place();
        const std::size_t length = 1 + diagnostics::splitmix64(seed) % 8;
        const std::string piece = text.substr(at, length);
        switch (diagnostics::splitmix64(seed) % 4) {
            case 0:
                text.erase(std::min(at, text.size()), length);
                break;
            case 1:
                text.insert(place(), piece);
                break;
            case 2: {
                const char* pieces[] = {"0", "99999", "-", "!", "(", ")",     "true", "x", "b",  "1.5",
                                        "<", "=",     "[", "]", "F", "P>0 [", "&",    "^", "/0", "'"};
                text.insert(at, pieces[diagnostics::splitmix64(seed) % 20]);
                break;
            }
            default: {
                text.erase(std::min(at, text.size()), length);
                text.insert(place(), piece);
            }
        }
    }
    return text;
}

TEST(PrismMutants, Random) {
    std::uint64_t seed = 11;
    for (int i = 0; i < 1500; ++i) {
        process(mutant(std::string(model_text), seed), std::string(property_text));
        process(std::string(model_text), mutant(std::string(property_text), seed));
    }
}

}  // namespace
}  // namespace robochart::prism
