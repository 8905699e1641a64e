// SPDX-License-Identifier: Apache-2.0
#include "random_cases.hpp"

#include <cstdlib>
#include <string>

#include "random_process.hpp"

namespace robochart::refine {
namespace {

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* const text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): before any thread starts
    return text == nullptr ? otherwise : std::stoull(text);
}

}  // namespace

RandomCases::RandomCases(std::uint64_t purpose)
    : numbers_(number_from("ROBOCHART_RANDOM_SEED", 20) * 1'000'003 + purpose) {}

Case RandomCases::random_case() {
    const std::size_t length = 10 + numbers_() % 110;
    std::vector<unsigned> list;
    while (list.size() < length) list.push_back(static_cast<unsigned>(numbers_() % 1'000'000));
    Case made{naive::Decoder(list).script(2), {static_cast<int>(numbers_() % 3), static_cast<int>(numbers_() % 3)}};
    // A quarter of the pairs are related, so that enough refinements hold.
    if (numbers_() % 4 == 0)
        made.script.mains[0] = std::make_shared<const naive::Tree>(
            naive::Tree{naive::Kind::internal, {made.script.mains[0], made.script.mains[1]}, {}, {}, {}, {}, 0});
    return made;
}

RandomCases::Explored RandomCases::next() {
    for (;;) {
        Case test_case = random_case();
        if (auto graphs = explore(test_case, largest_graph)) return {std::move(test_case), std::move(*graphs)};
    }
}

int wanted_checks(int otherwise) {
    return static_cast<int>(number_from("ROBOCHART_RANDOM_CHECKS", static_cast<std::uint64_t>(otherwise)));
}

int wanted_scripts(int otherwise) {
    return static_cast<int>(number_from("ROBOCHART_RANDOM_SCRIPTS", static_cast<std::uint64_t>(otherwise)));
}

}  // namespace robochart::refine
