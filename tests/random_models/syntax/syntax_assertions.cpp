// SPDX-License-Identifier: Apache-2.0
// Builds assertion files, and defines the public functions of the syntax generator (any_syntax.hpp).
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/random_models/syntax/syntax_builder.hpp"

namespace robochart::random_models {

using namespace frontend;

AssertionTime SyntaxBuilder::time() {
    return static_cast<AssertionTime>(random_.below(3));
}

AssertionParameter SyntaxBuilder::assertion_parameter() {
    AssertionParameter parameter;
    parameter.kind = random_.chance(60) ? ParameterKind::constant : ParameterKind::parameter;
    parameter.name = simple();
    parameter.context = qualified();
    parameter.value = expression(2);
    return parameter;
}

Assertion SyntaxBuilder::assertion() {
    constexpr std::size_t kinds = 11;
    Assertion result;
    result.name = name();
    result.time = time();
    result.kind = static_cast<AssertionKind>(random_.below(kinds));
    result.negated = random_.chance(40);
    const bool binary = result.kind == AssertionKind::refines || result.kind == AssertionKind::equals ||
                        result.kind == AssertionKind::reachable;
    const bool of_machine =
        result.kind == AssertionKind::clock_initialised || result.kind == AssertionKind::event_missed;
    if (result.kind == AssertionKind::clock_initialised) result.time = AssertionTime::both;
    if (!of_machine) result.subject = qualified();
    if (binary || of_machine) result.other = qualified();
    if (result.kind == AssertionKind::conforms) {
        result.time = AssertionTime::timed;
        result.other = simple();
        return result;
    }
    if (result.kind == AssertionKind::event_missed) {
        result.event = simple();
        if (random_.chance(50)) result.time_units = static_cast<std::int64_t>(random_.between(1, 50));
    }
    const std::size_t model = random_.below(6);
    if (model < 4) result.model = static_cast<AssertionModel>(model);
    if (random_.chance(30))
        for (std::size_t i = random_.between(1, 3); i > 0; --i) result.parameters.push_back(assertion_parameter());
    return result;
}

CspBlock SyntaxBuilder::csp_block() {
    static const std::vector<std::string> texts = {" Spec = STOP ", "\nP = a -> P -- a comment\n{- and\n another -}\n",
                                                   "", "\n  \"csp-\" [[ a <- b ]]\n"};
    CspBlock block;
    block.name = name();
    block.time = time();
    for (std::size_t i = random_.below(3); i > 0; --i) block.associated.push_back(qualified());
    block.text = random_.pick(texts);
    return block;
}

/// Returns a part of the file that belongs to another tool.
KeptPart SyntaxBuilder::kept() {
    static const std::vector<std::string> parts = {
        "label \"ready\" = (x = 1);",
        "formula \"f\" = x + 1;",
        "rewards \"steps\" true : 1; endrewards",
        "instantiate T as int(0..3)",
    };
    KeptPart part;
    part.text = random_.pick(parts);
    return part;
}

std::unique_ptr<File> any_syntax(std::uint64_t seed, std::size_t size) {
    Random random(seed);
    SyntaxBuilder builder(random);
    auto file = std::make_unique<File>();
    if (random.chance(60)) file->package = builder.qualified();
    for (std::size_t i = random.below(3); i > 0; --i) file->imports.push_back(builder.import());
    if (random.chance(20)) file->diagrams.push_back(builder.name());
    for (std::size_t i = random.between(1, size); i > 0; --i) file->declarations.push_back(builder.declaration());
    return file;
}

std::unique_ptr<File> any_assertions(std::uint64_t seed, std::size_t size) {
    Random random(seed);
    SyntaxBuilder builder(random);
    auto file = std::make_unique<File>();
    file->is_assertions = true;
    if (random.chance(30)) file->package = builder.qualified();
    for (std::size_t i = random.below(3); i > 0; --i) file->imports.push_back(builder.import());
    for (std::size_t i = random.between(1, size + size / 2); i > 0; --i) {
        const std::size_t way = random.below(9);
        if (way < 4) file->assertions.push_back(builder.assertion());
        if (way == 4) file->csp_blocks.push_back(builder.csp_block());
        if (way == 5) file->kept.push_back(builder.kept());
        if (way == 6) file->probabilistic_assertions.push_back(builder.probabilistic_assertion());
        if (way > 6) file->probabilistic_definitions.push_back(builder.probabilistic_definition());
    }
    return file;
}

ExprPtr any_expression(std::uint64_t seed, std::size_t depth) {
    Random random(seed);
    return SyntaxBuilder(random).expression(depth);
}

}  // namespace robochart::random_models
