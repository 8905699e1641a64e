// SPDX-License-Identifier: Apache-2.0
#include "app/command/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/base/built_commit.hpp"
#include "app/command/help.hpp"
#include "app/command/option_table.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json.hpp"

namespace robochart::app {
namespace {

Parsed wrong_usage(const std::string& what, const std::string& help = "") {
    return {
        std::nullopt, Exit::usage,
        fmt::format("robochart-verify: {}\ntry: robochart-verify {}--help\n", what, help.empty() ? "" : help + " ")};
}

Parsed answer_with_text(std::string text) {
    return {std::nullopt, Exit::success, std::move(text)};
}

/// Stores the words after an option in the options.
void store_option(const OptionRow& row, const std::vector<std::string>& words, Options& options) {
    const std::size_t behind = words_after(row.argument);
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::string word = words[i];
        if (const std::string wrong = wrong_word(row.argument, i % behind, word); !wrong.empty())
            throw CLI::ValidationError(std::string(long_name(row)), wrong);
        row.take(options, word);
    }
}

void add_option(CLI::App& app, const OptionRow& row, Options& options) {
    const auto callback = [&row, &options](const CLI::results_t& words) {
        store_option(row, words, options);
        return true;
    };
    CLI::Option* option = app.add_option(row.names, callback)->allow_extra_args(false);
    const auto words = static_cast<int>(words_after(row.argument));
    if (row.argument.repeated)
        option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->expected(1, -1)->allow_extra_args(false);
    else
        option->expected(words);
}

void add_options(CLI::App& app, Verbs verbs, Options& options) {
    const std::vector<const OptionRow*> rows = options_of(verbs);
    for (const OptionRow* row : rows) {
        if (std::string_view(row->names) == "-h,--help")
            app.set_help_flag(row->names);
        else if (std::string_view(row->names) == "--version")
            app.set_version_flag(row->names, "");
        else if (row->argument.kind == Argument::Kind::none)
            app.add_flag_callback(row->names, [row, &options] { row->take(options, ""); });
        else
            add_option(app, *row, options);
    }
    for (const OptionRow* row : rows)
        if (row->excludes[0] != '\0') app.get_option(row->names)->excludes(app.get_option(row->excludes));
}

void add_verb(CLI::App& app, const VerbRow& row, Options& options) {
    CLI::App* sub = app.add_subcommand(row.name);
    add_options(*sub, verb_bit(row.verb), options);
    if (const std::string input = row.input; !input.empty()) {
        const std::size_t begin = input.front() == '[' ? 1 : 0;
        const std::string name = input.substr(begin, input.find_first_of(".] ") - begin);
        sub->add_option(name, options.load.inputs)->required(begin == 0);
    }
    sub->callback([&options, &row] { set_verb(options, row.verb); });
}

bool names_a_verb(const std::string& word) {
    const std::vector<std::string> known = first_words();
    return std::ranges::find(known, word) != known.end();
}

/// Returns the words that the user may have meant as the first word: the verbs, and the files in the current folder.
std::vector<std::string> verbs_and_files() {
    constexpr std::size_t most = 1000;
    std::vector<std::string> names = first_words();
    std::error_code code;
    std::filesystem::directory_iterator at(".", code);
    for (const std::filesystem::directory_iterator end; !code && at != end && names.size() < most; at.increment(code))
        names.push_back(at->path().filename().string());
    std::ranges::sort(names);  // so that the nearest name does not depend on the order in the folder
    return names;
}

/// Returns a usage error if the first word is not a verb but looks like one, and no file has this name (as in git and
/// cargo). Otherwise, the word names a model. A word with a dot, a separator or a capital letter is treated as a path,
/// and a later error says that the path cannot be read.
std::optional<Parsed> unknown_verb(const std::vector<std::string>& words) {
    const std::string& first = words.front();
    std::error_code ignored;
    if (first == "emit" && words.size() > 1 && !words[1].starts_with("-")) {
        const std::vector<std::string> known = emit_targets();
        if (std::ranges::find(known, words[1]) != known.end()) return std::nullopt;
        const bool plus = words[1] == "c++" || words[1] == "cxx" || words[1] == "C++";
        return wrong_usage(fmt::format("emit cannot write '{}'{}", words[1],
                                       plus ? "; did you mean 'cpp'?" : did_you_mean(words[1], known)),
                           "emit");
    }
    const bool like_a_verb =
        !first.starts_with("-") && first.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
    if (!like_a_verb || names_a_verb(first) || std::filesystem::exists(first, ignored)) return std::nullopt;
    return wrong_usage(
        fmt::format("there is no verb, file or folder '{}'{}", first, did_you_mean(first, verbs_and_files())));
}

/// Returns the verb that the parser has reached: "" if there is none, "emit" if the word after `emit` is missing.
std::string verb_reached(const CLI::App& app) {
    std::string name;
    for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
        at = at->get_subcommands().front();
        name += (name.empty() ? "" : " ") + at->get_name();
    }
    return name;
}

Parsed help_of(const std::string& name) {
    if (name.empty()) return answer_with_text(program_help());
    if (name == "emit") return answer_with_text(emit_help());
    if (const VerbRow* row = find_verb(name)) return answer_with_text(verb_help(*row));
    std::vector<std::string> known = first_words();
    for (const VerbRow& row : verb_table()) known.push_back(full_name(row));
    return wrong_usage(fmt::format("there is no verb '{}'{}", name, did_you_mean(name, known)));
}

/// Returns the result of the verb `help`.
Parsed answer_help(const Options& options) {
    switch (options.generate) {
        case Generated::none:
            break;
        case Generated::man:
            return answer_with_text(manual_page());
        case Generated::bash:
            return answer_with_text(bash_completion());
        case Generated::zsh:
            return answer_with_text(zsh_completion());
        case Generated::fish:
            return answer_with_text(fish_completion());
    }
    return help_of(fmt::format("{}", fmt::join(options.load.inputs, " ")));
}

std::string version_text(Format format = Format::text) {
    if (format == Format::text)
        return fmt::format("robochart-verify {} ({})\n", program_version, commit_text(built_commit()));
    diagnostics::Json json;
    json["schema"] = "robochart-verify/version/1";
    json.update(program_json(program_version, built_commit()));
    return diagnostics::json_text(json, 2) + "\n";
}

/// True if the verb uses the cache, that is, if it has the option --no-cache.
bool has_cache(Verb verb) {
    const std::vector<const OptionRow*> rows = options_of(verb_bit(verb));
    return std::ranges::any_of(rows, [](const OptionRow* row) { return long_name(*row) == "--no-cache"; });
}

/// Returns the message about an option that the verb does not have. The message suggests the nearest option of the
/// verb, or lists the verbs that have the option.
std::string unknown_option(const std::string& given, const std::string& verb) {
    const std::string name = given.substr(0, given.find('='));
    std::vector<std::string> known, owners;
    const VerbRow* row = find_verb(verb);
    for (const OptionRow* option : options_of(row == nullptr ? no_verb : verb_bit(row->verb)))
        known.emplace_back(long_name(*option));
    for (const VerbRow& verb_row : verb_table())
        for (const OptionRow* option : options_of(verb_bit(verb_row.verb)))
            if (long_name(*option) == name) owners.push_back(full_name(verb_row));
    const std::string who = verb.empty() ? "the program" : fmt::format("`{}`", verb);
    std::string text = fmt::format("{} has no option {}", who, name);
    if (!owners.empty()) return text + fmt::format("; `{}` has", fmt::join(owners, "`, `"));
    return text + did_you_mean(name, known);
}

/// Returns the argument of the verb's option, such as "FILE"; "" if there is no such option.
std::string argument_of(const std::string& option, const std::string& verb) {
    const VerbRow* row = find_verb(verb);
    for (const OptionRow* option_row : options_of(row == nullptr ? no_verb : verb_bit(row->verb)))
        if (long_name(*option_row) == option || short_name(*option_row) == option) return option_row->argument.name;
    return "";
}

/// Returns the message about an option that lacks its argument or is given twice. The parser's own message states only
/// numbers of words.
std::string wrong_count(const CLI::ArgumentMismatch& error, const std::string& verb) {
    const std::string message = error.what();
    const std::string option = message.substr(0, message.find(':'));
    if (message.find("At Most") != std::string::npos) return option + " is given twice";
    const std::string argument = argument_of(option, verb);
    return argument.empty() ? message : fmt::format("{} needs {}", option, argument);
}

Parsed parse_failed(const CLI::App& app, const CLI::Error& error) {
    const std::string verb = verb_reached(app);
    if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) return answer_with_text(version_text());
    if (error.get_exit_code() == 0) return help_of(verb);
    // An unknown option is reported first: other errors may follow from it, such as a model that was read as its
    // argument.
    for (const std::string& word : app.remaining(true))
        if (word.starts_with("-") && word != "--" && word != "-") return wrong_usage(unknown_option(word, verb), verb);
    if (const auto* count = dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        return wrong_usage(wrong_count(*count, verb), verb);
    if (verb.empty()) return wrong_usage("expected a model or a verb");
    if (verb == "emit") return wrong_usage(fmt::format("emit needs one of {}", fmt::join(emit_targets(), ", ")), verb);
    return wrong_usage(error.what(), verb);
}

/// Returns the option that names the output file of this format.
const char* file_option(Format format) {
    if (format == Format::json) return "--json";
    return format == Format::sarif ? "--sarif" : "--junit";
}

/// Returns the output files that options name, as pairs of option and file.
std::vector<std::pair<std::string, std::string>> written_files(const Options& options) {
    std::vector<std::pair<std::string, std::string>> files;
    const auto add = [&](const std::string& option, const std::string& path) {
        if (!path.empty()) files.emplace_back(option, path);
    };
    for (const auto& [format, path] : options.output.files) add(file_option(format), path);
    add("--html", options.output.html);
    add("--plot", options.prism.plot);
    add("--export", options.conform.exported_code);
    if (options.verb == Verb::draw) add("--out", options.output.folder);
    return files;
}

/// True if people write files of this type. Such a file may be an input even if the command line does not name it,
/// because files in the same folder are read too.
bool is_written_by_hand(const std::filesystem::path& path) {
    constexpr std::array endings{".rct",    ".assertions", ".rst",   ".rsa",  ".prism", ".props", ".sleec",
                                 ".claims", ".scenario",   ".swarm", ".ros2", ".trace", ".mcap",  ".prefs"};
    return std::ranges::find(endings, path.extension().string()) != endings.end();
}

/// Returns an error if an output file would overwrite an input, otherwise "".
std::string overwritten_input(const Options& options) {
    std::vector<std::string> read = options.load.inputs;
    read.insert(read.end(), options.conform.traces.begin(), options.conform.traces.end());
    for (const std::string* file : {&options.swarm.file, &options.code.mapping, &options.probability.preferences,
                                    &options.tune.certificate, &options.simulate.compare})
        if (!file->empty()) read.push_back(*file);
    std::error_code ignored;
    for (const auto& [option, path] : written_files(options)) {
        if (!std::filesystem::is_regular_file(path, ignored)) continue;
        const bool named = std::ranges::any_of(read, [&, &written = path](const std::string& file) {
            return std::filesystem::equivalent(file, written, ignored);
        });
        if (named || is_written_by_hand(path))
            return fmt::format("{} would overwrite {}, which is no answer of an earlier run", option,
                               diagnostics::escape_for_display(path));
    }
    return "";
}

}  // namespace

Parsed parse_command_line(int argc, const char* const* argv) {
    Options options;
    CLI::App app;
    add_options(app, no_verb, options);
    app.require_subcommand(1);
    CLI::App* emit = app.add_subcommand("emit");
    emit->set_help_flag("-h,--help");
    emit->require_subcommand(1);
    for (const VerbRow& row : verb_table()) add_verb(row.parent[0] == '\0' ? app : *emit, row, options);
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const bool of_the_program = words.empty() || words[0] == "-h" || words[0] == "--help" || words[0] == "--version";
    if (!of_the_program) {
        if (std::optional<Parsed> wrong = unknown_verb(words)) return *wrong;
        // If the first word is not a verb, `robochart-verify MODEL` means `robochart-verify verify MODEL`.
        if (!names_a_verb(words.front())) words.insert(words.begin(), "verify");
    }
    std::ranges::reverse(words);
    try {
        app.parse(words);
    } catch (const CLI::Error& error) {
        return parse_failed(app, error);
    }
    if (options.verb == Verb::help) return answer_help(options);
    if (options.verb == Verb::version) return answer_with_text(version_text(options.output.format));
    if (const std::string wrong = overwritten_input(options); !wrong.empty()) return wrong_usage(wrong);
    options.cache = options.cache && has_cache(options.verb);
    return Parsed{options, Exit::success, ""};
}

}  // namespace robochart::app
