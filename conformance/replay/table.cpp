// SPDX-License-Identifier: Apache-2.0
// Reads the files of a certificate strictly. A file with a part that is not understood is rejected.
#include "conformance/replay/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>

#include "base/cache/sha256.hpp"

namespace robochart::replay {

namespace {

std::string read_file(const std::filesystem::path& path) {
    std::error_code code;
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    if (!std::filesystem::is_regular_file(path, code) || !(text << in.rdbuf()))
        throw Unusable(fmt::format("{} cannot be read", path.string()));
    return text.str();
}

/// The lines of a file, which are read one after the other.
class Lines {
public:
    Lines(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {}

    [[noreturn]] void fail(const std::string& why) const {
        throw Unusable(fmt::format("{}, line {}: {}", file_, number_, why));
    }
    std::string next() {
        ++number_;
        const std::size_t end = text_.find('\n', at_);
        if (end == std::string::npos) fail("the file ends too early");
        std::string line = text_.substr(at_, end - at_);
        at_ = end + 1;
        return line;
    }
    /// Reads a line that begins with this word, and returns the rest.
    std::string after(const std::string& word) {
        std::string line = next();
        if (!line.starts_with(word + " ")) fail(fmt::format("`{}` was expected", word));
        return line.substr(word.size() + 1);
    }
    void expect(const std::string& line) {
        if (next() != line) fail(fmt::format("`{}` was expected", line));
    }
    [[nodiscard]] std::uint32_t number(std::string_view word) const {
        std::uint32_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size()) fail("a number was expected");
        return value;
    }
    /// Reads how many lines or more follow.
    std::uint32_t count(const std::string& word) {
        const std::uint32_t value = number(after(word));
        if (value > text_.size()) fail("there are fewer lines than this");
        return value;
    }
    /// Splits a number and the rest of the line after a blank.
    std::pair<std::uint32_t, std::string> numbered(const std::string& line) const {
        const std::size_t blank = line.find(' ');
        if (blank == std::string::npos) fail("a number and a text were expected");
        return {number(std::string_view(line).substr(0, blank)), line.substr(blank + 1)};
    }
    std::vector<std::string> texts(std::uint32_t count) {
        if (count > text_.size()) fail("there are fewer lines than this");
        std::vector<std::string> result;
        for (std::uint32_t i = 0; i < count; ++i) result.push_back(next());
        return result;
    }
    /// Reads the last line: the digest of all lines above it.
    void end_with_digest() {
        const std::string digest = diagnostics::sha256(std::string_view(text_).substr(0, at_));
        if (after("end-sha256:") != digest) fail("the digest of the lines above is another one");
        end();
    }
    void end() const {
        if (at_ != text_.size()) fail("the file goes on after its end");
    }

private:
    std::string file_, text_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
};

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

void read_sources(const std::filesystem::path& folder, Lines& lines, Table& table) {
    for (std::uint32_t left = lines.count("sources"); left > 0; --left) {
        const std::string line = lines.next();
        const std::size_t blank = line.find(' ');
        if (blank == std::string::npos) lines.fail("a digest and a path were expected");
        Source source{line.substr(blank + 1), ""};
        source.text = read_file(folder / "code" / source.path);
        if (diagnostics::sha256(source.text) != line.substr(0, blank))
            throw Unusable(fmt::format("code/{}: its digest is not that in code.txt", source.path));
        table.sources.push_back(std::move(source));
    }
}

void read_interface(Lines& lines, Table& table) {
    for (std::uint32_t left = lines.count("inputs"); left > 0; --left) {
        const auto [values, name] = lines.numbered(lines.after("input"));
        table.inputs.push_back({name, lines.texts(values)});
    }
    for (std::uint32_t left = lines.count("outputs"); left > 0; --left) {
        const auto [arguments, name] = lines.numbered(lines.after("output"));
        Output& output = table.outputs.emplace_back(Output{name, {}});
        for (std::uint32_t i = 0; i < arguments; ++i) output.arguments.push_back(lines.texts(lines.count("argument")));
    }
}

/// Reads the transitions of one state: pairs of an event and a target.
std::vector<Edge> read_edges(Lines& lines, std::size_t events, std::uint32_t states) {
    const std::vector<std::string> words = words_of(lines.next());
    std::vector<Edge> edges;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2)
        edges.push_back({lines.number(words[i]), lines.number(words[i + 1])});
    if (words.size() % 2 != 0) lines.fail("a transition has an event and a target");
    for (const Edge& edge : edges)
        if (edge.event >= events || edge.target >= states) lines.fail("there is no such event or state");
    if (!std::ranges::is_sorted(edges)) lines.fail("the transitions are not ascending");
    return edges;
}

/// Reads a process that is one component with one rule for each event. The process then behaves as its component.
void read_process(Lines lines, Table& table) {
    lines.expect("robochart-verify process 1");
    table.events = {"", ""};
    const std::vector<std::string> names = lines.texts(lines.count("events"));
    if (std::set(names.begin(), names.end()).size() != names.size()) lines.fail("two events have the same name");
    table.events.insert(table.events.end(), names.begin(), names.end());
    lines.expect("components 1");
    const auto [states, rest] = lines.numbered(lines.after("component"));
    table.initial = lines.numbered(rest).first;
    if (table.initial >= states) lines.fail("there is no such state");
    std::set<std::uint32_t> used;
    for (std::uint32_t state = 0; state < states; ++state) {
        table.edges.push_back(read_edges(lines, table.events.size(), states));
        for (const Edge& edge : table.edges.back()) used.insert(edge.event);
    }
    const auto [participants, rules] = lines.numbered(lines.after("region"));
    if (participants != 1) lines.fail("the process has several participants");
    lines.expect("slot 0");
    for (std::uint32_t left = lines.number(rules); left > 0; --left) {
        const std::string rule = lines.after("rule");
        const std::uint32_t event = lines.numbered(rule).first;
        if (rule != fmt::format("{0} - 1 0 {0}", event)) lines.fail("a rule changes an event of the component");
        used.erase(event);
    }
    if (!used.empty()) lines.fail("an event has no rule");
    lines.expect("end");
    lines.end();
}

}  // namespace

Table read_table(const std::string& folder) {
    Table table;
    // claim.txt is written last, so it is missing if the certificate is not complete.
    const std::string claim = read_file(std::filesystem::path(folder) / "claim.txt");
    Lines lines("code.txt", read_file(std::filesystem::path(folder) / "code.txt"));
    lines.expect("robochart-verify code 1");
    table.component = lines.after("component:");
    table.cycle = lines.number(lines.after("cycle:"));
    if (table.cycle == 0) lines.fail("a cycle takes time");
    table.build = words_of(lines.after("build:"));
    const std::string digest = lines.after("implementation-sha256:");
    read_sources(folder, lines, table);
    read_interface(lines, table);
    for (std::uint32_t left = lines.count("states"); left > 0; --left) {
        const auto [state, text] = lines.numbered(lines.after("state"));
        table.states.push_back({state, text});
    }
    lines.end_with_digest();
    std::string process = read_file(std::filesystem::path(folder) / "implementation.txt");
    if (diagnostics::sha256(process) != digest)
        throw Unusable("implementation.txt: its digest is not that in code.txt, so it is the table of other code");
    if (claim.find("\nimplementation-sha256: " + digest + "\n") == std::string::npos)
        throw Unusable("claim.txt: it is about another process than implementation.txt");
    read_process(Lines("implementation.txt", std::move(process)), table);
    return table;
}

}  // namespace robochart::replay
