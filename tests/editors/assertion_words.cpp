// SPDX-License-Identifier: Apache-2.0
#include "assertion_words.hpp"
#include "tests/source_folder.hpp"

#include <fstream>
#include <iterator>
#include <regex>

namespace robochart::editors {

std::set<std::string> assertion_words() {
    std::string source;
    for (const char* file : {"parser_assertions.cpp", "parser_probability.cpp"}) {
        std::ifstream in(tests::source_folder().string() + "/frontend/syntax/" + file, std::ios::binary);
        source.append(std::istreambuf_iterator<char>(in), {});
    }
    const std::regex literal("\"([A-Za-z]+(-[a-z]+)*)\"");
    std::set<std::string> words;
    for (std::sregex_iterator it(source.begin(), source.end(), literal); it != std::sregex_iterator(); ++it)
        words.insert((*it)[1]);
    return words;
}

}  // namespace robochart::editors
