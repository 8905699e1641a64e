// SPDX-License-Identifier: Apache-2.0
// Distributes systems over files and packages.
#include "tests/random_models/models/well_formed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/random_models/models/system.hpp"

namespace robochart::random_models {

namespace {

/// A file to which systems are being added.
struct Draft {
    std::string body;
    std::set<std::size_t> imports;
};

std::size_t line_count(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

bool is_part_of_name(char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns whether the text calls a function with this name. Names of models end in digits, but names of toolkits do
/// not.
bool calls(const std::string& text, const std::string& function) {
    const std::string call = function + "(";
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1))
        if (at > 0 && !is_part_of_name(text[at - 1])) return true;
    return false;
}

/// Returns imports of the called functions, or of their whole toolkits.
std::string toolkit_imports(const std::string& text, Random& random) {
    std::string out;
    std::map<std::string, bool> whole;
    for (const Generic& function : toolkit_functions()) {
        if (!calls(text, function.name)) continue;
        const auto [toolkit, first] = whole.emplace(function.package, false);
        if (first) toolkit->second = random.chance(70);
        if (first || !toolkit->second)
            out += fmt::format("import {}::{}\n", function.package, toolkit->second ? "*" : function.name);
    }
    return out;
}

/// Returns the name that starts at a position, or "" if there is none.
std::string word_at(const std::string& text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_part_of_name(text[end])) ++end;
    return text.substr(at, end - at);
}

/// Returns the name that a definition introduces, or "" for modules and functions, which are never referenced in this
/// way.
std::string defined_name(const std::string& text) {
    static const std::vector<std::string> heads = {"type ",        "datatype ",  "record ",
                                                   "enumeration ", "interface ", "robotic platform ",
                                                   "controller ",  "stm ",       "operation "};
    for (const std::string& head : heads)
        if (text.starts_with(head)) return word_at(text, head.size());
    return {};
}

/// Returns whether a reference to a type, an interface or a component starts at this position.
bool refers(const std::string& text, std::size_t at) {
    const auto behind = [&](std::string_view lead) {
        return at >= lead.size() && std::string_view(text).substr(at - lead.size(), lead.size()) == lead;
    };
    for (const std::string_view lead : {" : ", "uses ", "requires ", "provides "})
        if (behind(lead)) return true;
    const std::size_t line = text.find_last_of('\n', at) + 1;
    const std::size_t first = text.find_first_not_of(' ', line);
    return behind(" = ") && text.substr(first + 1, 4) == "ref ";
}

class ProjectBuilder {
public:
    ProjectBuilder(std::uint64_t seed, const Shape& shape, std::size_t files)
        : random_(seed), shape_(shape), names_(random_, shape), drafts_(files) {
        for (std::size_t file = 0; file < files; ++file) packages_.push_back(names_.package_for_file(file));
    }

    void add_system();
    [[nodiscard]] std::size_t lines() const { return lines_; }
    Project finish();

private:
    [[nodiscard]] const std::string& package_of(std::size_t file) const { return packages_[file]; }
    std::vector<std::size_t> choose_files();
    void add_claims(const System& system, const std::vector<std::size_t>& files);
    std::string comment();
    std::string qualify_names(const std::string& text, const std::map<std::string, std::string>& packages);

    Random random_;
    const Shape& shape_;
    Names names_;
    std::vector<Draft> drafts_;
    std::vector<std::string> packages_;
    std::string claims_;
    std::set<std::size_t> claimed_;  ///< files that contain modules with assertions
    std::size_t claim_count_ = 0;
    std::size_t lines_ = 0;
};

std::vector<std::size_t> ProjectBuilder::choose_files() {
    const std::size_t count = random_.between(std::max<std::size_t>(1, shape_.files.low), shape_.files.high);
    const std::size_t first = random_.below(drafts_.size());
    std::vector<std::size_t> files;
    for (std::size_t i = 0; i < std::min(count, drafts_.size()); ++i) files.push_back((first + i) % drafts_.size());
    return files;
}

std::string ProjectBuilder::comment() {
    if (!shape_.comments || !random_.chance(30)) return {};
    return random_.chance(50) ? "// What follows was made at random.\n" : "/* Made at random:\n * see below. */\n";
}

/// Qualifies some names with their package.
std::string ProjectBuilder::qualify_names(const std::string& text, const std::map<std::string, std::string>& packages) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::string word = word_at(text, at);
        const auto found = packages.find(word);
        if (found != packages.end() && refers(text, at) && random_.chance(10)) out += found->second + "::";
        out += word.empty() ? text.substr(at, 1) : word;
        at += std::max<std::size_t>(1, word.size());
    }
    return out;
}

void ProjectBuilder::add_system() {
    const std::vector<std::size_t> files = choose_files();
    const System system = SystemBuilder(random_, shape_, names_, files.size()).build();
    std::map<std::string, std::string> packages;
    if (shape_.packages && shape_.qualified_names)
        for (const Definition& definition : system.definitions)
            if (const std::string name = defined_name(definition.text); !name.empty())
                packages[name] = package_of(files[definition.file]);
    for (const Definition& definition : system.definitions) {
        Draft& draft = drafts_[files[definition.file]];
        const std::string text = "\n" + comment() + qualify_names(definition.text, packages);
        draft.body += text;
        lines_ += line_count(text);
    }
    for (const std::size_t file : files)
        for (const std::size_t other : files)
            if (other != file) drafts_[file].imports.insert(other);
    if (shape_.assertions) add_claims(system, files);
}

void ProjectBuilder::add_claims(const System& system, const std::vector<std::size_t>& files) {
    const std::vector<std::string> properties = {"deadlock-free", "divergence-free", "deterministic"};
    const std::vector<std::string> times = {"", "", "untimed ", "timed "};
    claimed_.insert(files.begin(), files.end());
    for (std::size_t i = random_.between(1, 3); i > 0; --i) {
        const std::string part =
            random_.chance(50) ? system.module : system.module + "::" + random_.pick(system.components);
        const std::string time = random_.pick(times);
        const std::string negation = random_.chance(30) ? "not " : "";
        claims_ += fmt::format("\n{}assertion A{} : {} is {}{}\n", time, claim_count_++, part, negation,
                               random_.pick(properties));
    }
}

Project ProjectBuilder::finish() {
    Project project;
    const auto imports = [&](const std::set<std::size_t>& files) {
        std::string out;
        if (shape_.packages)
            for (const std::size_t file : files) out += "import " + package_of(file) + "::*\n";
        return out;
    };
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
        const std::string package = shape_.packages ? "package " + package_of(i) + "\n" : "";
        const std::string toolkits = shape_.data.toolkits ? toolkit_imports(drafts_[i].body, random_) : "";
        const bool drawn = shape_.comments && random_.chance(20);
        const std::string diagram = drawn ? "diagram " + names_.unused_name("Diagram") + "\n" : "";
        project.push_back({fmt::format("part{}.rct", i),
                           package + imports(drafts_[i].imports) + toolkits + diagram + drafts_[i].body});
    }
    if (!claims_.empty()) project.push_back({"properties.assertions", imports(claimed_) + claims_});
    std::ranges::sort(project, [](const Text& a, const Text& b) { return a.path < b.path; });
    return project;
}

}  // namespace

Project well_formed(std::uint64_t seed, const Shape& shape) {
    Random sizes(seed ^ 0xF11E5U);
    ProjectBuilder builder(seed, shape, sizes.between(std::max<std::size_t>(1, shape.files.low), shape.files.high));
    builder.add_system();
    return builder.finish();
}

Project sized(std::uint64_t seed, std::size_t lines, std::size_t files, const Shape& shape) {
    ProjectBuilder builder(seed, shape, std::max<std::size_t>(1, files));
    do builder.add_system();
    while (builder.lines() < lines);
    return builder.finish();
}

}  // namespace robochart::random_models
