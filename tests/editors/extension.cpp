// SPDX-License-Identifier: Apache-2.0
#include "extension.hpp"
#include "tests/source_folder.hpp"

#include <iterator>
#include <regex>

namespace robochart::editors {

using nlohmann::json;

std::filesystem::path extension_folder() {
    return tests::source_folder() / "editors/vscode";
}

json load_json(const std::string& name) {
    return json::parse(read_contents(extension_folder() / name));
}

namespace {

/// Returns the position after the parenthesis that closes the group opened at `at`.
std::size_t group_end(const std::string& pattern, std::size_t at) {
    int open = 0;
    for (; at < pattern.size(); ++at) {
        if (pattern[at] == '\\') {
            ++at;
        } else if (pattern[at] == '(') {
            ++open;
        } else if (pattern[at] == ')' && --open == 0) {
            return at + 1;
        }
    }
    return at;
}

/// Returns the pattern without the parts that match no word: lookarounds, character classes, escapes.
std::string plain_text(const std::string& pattern) {
    std::string out;
    for (std::size_t at = 0; at < pattern.size();) {
        if (pattern[at] == '\\') {
            out += ' ';
            at += 2;
        } else if (pattern[at] == '[') {
            out += ' ';
            while (pattern[at] != ']') at += pattern[at] == '\\' ? 2U : 1U;
            ++at;
        } else if (std::regex_search(pattern.substr(at, 4), std::regex("^\\(\\?(<?[=!])"))) {
            out += ' ';
            at = group_end(pattern, at);
        } else {
            out += pattern[at++];
        }
    }
    return out;
}

void add_words(const std::string& pattern, std::set<std::string>& words) {
    static const std::regex word("[A-Za-z_][A-Za-z0-9_]*(-[a-z]+)*");
    const std::string text = plain_text(pattern);
    for (std::sregex_iterator it(text.begin(), text.end(), word); it != std::sregex_iterator(); ++it)
        words.insert(it->str());
}

/// Returns true if the rule, or one of its groups, has a scope that satisfies the predicate.
bool gives_scope(const json& rule, const std::function<bool(const std::string&)>& scope) {
    if (rule.contains("name") && scope(rule["name"])) return true;
    for (const char* key : {"captures", "beginCaptures", "endCaptures"})
        for (const json& capture : rule.value(key, json::object()))
            if (scope(capture["name"])) return true;
    return false;
}

void collect(const json& node, const std::function<bool(const std::string&)>& scope, std::set<std::string>& words) {
    if (node.is_object() && gives_scope(node, scope))
        for (const char* key : {"match", "begin", "end"})
            if (node.contains(key)) add_words(node[key], words);
    if (node.is_structured())
        for (const json& child : node) collect(child, scope, words);
}

}  // namespace

std::set<std::string> grammar_words(const json& grammar, const std::function<bool(const std::string&)>& scope) {
    std::set<std::string> words;
    collect(grammar, scope, words);
    return words;
}

}  // namespace robochart::editors
