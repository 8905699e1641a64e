// SPDX-License-Identifier: Apache-2.0
// Writes a random project into a folder (random_models_tool), for benchmarks, demonstrations and use by hand.
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tests/random_models/models/well_formed.hpp"

namespace {

using namespace robochart::random_models;

constexpr const char* usage =
    "usage: random_models_tool --out DIR [--seed N] [--lines N] [--files N] [--shape untimed|timed|whole|hostile]\n"
    "Without --lines: one module. With --lines: modules until there are about so many lines, in --files files.\n";

int fail(const std::string& message) {
    std::fprintf(stderr, "random_models_tool: %s\n%s", message.c_str(), usage);
    return 4;
}

bool read(std::string_view digits, std::uint64_t& value) {
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return result.ec == std::errc() && result.ptr == digits.data() + digits.size();
}

std::optional<Shape> shape_of(const std::string& name) {
    if (name == "whole") return Shape::whole_language();
    if (name == "timed") return Shape::timed_core();
    if (name == "untimed") return Shape::untimed_core();
    if (name == "hostile") return Shape::with_hostile_words();
    return std::nullopt;
}

}  // namespace

int main(int count, char** words) {
    std::map<std::string, std::string> options = {{"--shape", "whole"}};
    for (int i = 1; i + 1 < count; i += 2) options[words[i]] = words[i + 1];
    std::map<std::string, std::uint64_t> numbers = {{"--seed", 1}, {"--lines", 0}, {"--files", 1}};
    for (const auto& [name, value] : options) {
        if (numbers.contains(name) && !read(value, numbers[name])) return fail(name + " takes a number");
        if (!numbers.contains(name) && name != "--out" && name != "--shape") return fail("unknown option " + name);
    }
    if (count % 2 == 0 || options["--out"].empty()) return fail("an option lacks its value, or --out is missing");
    const std::optional<Shape> shape = shape_of(options["--shape"]);
    if (!shape) return fail("unknown shape " + options["--shape"]);
    const Project project = numbers["--lines"] == 0
                                ? well_formed(numbers["--seed"], *shape)
                                : sized(numbers["--seed"], numbers["--lines"], numbers["--files"], *shape);
    const std::string failure = write(project, options["--out"]);
    if (!failure.empty()) return fail(failure);
    std::printf("%zu files, %zu lines\n", project.size(), lines(project));
    return 0;
}
