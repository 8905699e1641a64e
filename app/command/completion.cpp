// SPDX-License-Identifier: Apache-2.0
// Generates the completions for bash, zsh and fish: verbs, their options, choices, rule codes, files and folders.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/command/help.hpp"
#include "app/command/rules.hpp"

namespace robochart::app {
namespace {

using Kind = Argument::Kind;

constexpr std::string_view made_by =
    "# Completion of robochart-verify for {0}, made by `robochart-verify help --generate {0}`.\n";

std::string made_for(std::string_view shell) {
    return fmt::format(fmt::runtime(made_by), shell);
}

/// Inserts `with` before each of these characters.
std::string escape_characters(std::string_view text, std::string_view characters, std::string_view with) {
    std::string out;
    for (const char c : text) {
        if (characters.find(c) != std::string_view::npos) out += with;
        out += c;
    }
    return out;
}

/// Returns the word in single quotes for bash and zsh.
std::string quote_word(std::string_view text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

/// Returns the codes that `explain` accepts, or only those that `--allow` accepts.
std::string rule_codes(bool warnings) {
    std::set<std::string_view> found;
    for (const diagnostics::Rule* rule : all_rules())
        if (!warnings || rule->severity == diagnostics::Severity::warning) found.insert(rule->code);
    return fmt::format("{}", fmt::join(found, " "));
}

std::vector<std::string> option_spellings(const OptionRow& row) {
    std::vector<std::string> names;
    if (!short_name(row).empty()) names.emplace_back(short_name(row));
    names.emplace_back(long_name(row));
    return names;
}

// ---------------------------------------------------------------- bash

std::string bash_options() {
    std::string out = "_robochart_verify_options() {\n  case \"$1\" in\n";
    for (const VerbRow& verb : verb_table()) {
        std::vector<std::string> names;
        for (const OptionRow* row : options_of(verb_bit(verb.verb)))
            for (std::string& name : option_spellings(*row)) names.push_back(std::move(name));
        out += fmt::format("    '{}') echo {} ;;\n", full_name(verb),
                           quote_word(fmt::format("{}", fmt::join(names, " "))));
    }
    std::vector<std::string> names;
    for (const OptionRow* row : options_of(no_verb))
        for (std::string& name : option_spellings(*row)) names.push_back(std::move(name));
    return out + fmt::format("    *) echo {} ;;\n  esac\n}}\n", quote_word(fmt::format("{}", fmt::join(names, " "))));
}

/// Returns the completions of an argument: its choices, or the kind of names that it accepts (files, folders, rule
/// codes).
std::string bash_argument(const Argument& argument) {
    switch (argument.kind) {
        case Kind::choice:
            return fmt::format("{}", fmt::join(choices_of(argument), " "));
        case Kind::file:
            return "<file>";
        case Kind::folder:
            return "<folder>";
        case Kind::warning:
            return "<warning>";
        case Kind::none:
        case Kind::text:
        case Kind::name:
        case Kind::whole:
        case Kind::seconds:
        case Kind::size:
        case Kind::fraction:
            break;
    }
    return "<value>";
}

std::string bash_arguments() {
    std::string out = "_robochart_verify_argument() {\n  case \"$1 $2\" in\n";
    for (const OptionRow& row : option_table()) {
        if (row.argument.kind == Kind::none) continue;
        std::vector<std::string> patterns;
        for (const VerbRow& verb : verb_table())
            if ((row.verbs & verb_bit(verb.verb)) != 0)
                for (const std::string& name : option_spellings(row))
                    patterns.push_back(quote_word(full_name(verb) + " " + name));
        out += fmt::format("    {}) echo {} ;;\n", fmt::join(patterns, " | "), quote_word(bash_argument(row.argument)));
    }
    return out + "  esac\n}\n";
}

constexpr std::string_view bash_function = R"text(
# Codes by their beginning, in small letters too.
_robochart_verify_code() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
  [ "${#COMPREPLY[@]}" -gt 0 ] || mapfile -t COMPREPLY < <(compgen -W "$1" -- "${2^^}")
}

_robochart_verify() {
  local current="${COMP_WORDS[COMP_CWORD]}" before="" verb="" first=1 choices
  COMPREPLY=()
  [ "$COMP_CWORD" -gt 1 ] && before="${COMP_WORDS[COMP_CWORD - 1]}"
  # bash takes `--format=json` apart.
  if [ "$current" = = ]; then
    current=""
  elif [ "$before" = = ]; then
    before="${COMP_WORDS[COMP_CWORD - 2]}"
  fi
  if [ "$COMP_CWORD" -gt 1 ]; then
    verb="${COMP_WORDS[1]}"
    if [ "$verb" = emit ]; then
      [ "$COMP_CWORD" -gt 2 ] && verb="emit ${COMP_WORDS[2]}" && first=2
    elif [[ " $_robochart_verify_verbs " != *" $verb "* ]]; then
      verb=verify first=0  # the first word of all may be a model
    fi
  fi
  choices="$(_robochart_verify_argument "$verb" "$before")"
  case "$choices" in
    '') ;;
    '<file>') mapfile -t COMPREPLY < <(compgen -f -- "$current"); return 0 ;;
    '<folder>') mapfile -t COMPREPLY < <(compgen -d -- "$current"); return 0 ;;
    '<warning>') _robochart_verify_code "$_robochart_verify_warnings" "$current"; return 0 ;;
    '<value>') return 0 ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current"); return 0 ;;
  esac
  if [ "$verb" = explain ] && [[ "$current" != -* ]]; then
    _robochart_verify_code "$_robochart_verify_codes" "$current"
    return 0
  fi
  case "$current" in
    -*) mapfile -t COMPREPLY < <(compgen -W "$(_robochart_verify_options "$verb")" -- "$current") ;;
    *)
      local words=""
      [ -z "$verb" ] && words="$_robochart_verify_verbs"
      [ "$verb" = emit ] && words="$_robochart_verify_emitted"
      [ "$verb" = help ] && words="$_robochart_verify_verbs"
      if [ "$first" -lt "$COMP_CWORD" ] || [ -z "$verb" ]; then
        mapfile -t COMPREPLY < <(
          [ -n "$words" ] && compgen -W "$words" -- "$current"
          [ "$verb" = emit ] || [ "$verb" = help ] || compgen -f -- "$current"
        )
      fi
      ;;
  esac
}

complete -o filenames -F _robochart_verify robochart-verify
)text";

}  // namespace

std::string bash_completion() {
    return made_for("bash") +
           fmt::format("_robochart_verify_verbs={}\n_robochart_verify_emitted={}\n",
                       quote_word(fmt::format("{}", fmt::join(first_words(), " "))),
                       quote_word(fmt::format("{}", fmt::join(emit_targets(), " ")))) +
           fmt::format("_robochart_verify_codes={}\n_robochart_verify_warnings={}\n\n", quote_word(rule_codes(false)),
                       quote_word(rule_codes(true))) +
           "# The options of a verb.\n" + bash_options() +
           "\n# What a verb's option takes: its choices, or of which kind it is; nothing if it takes no word.\n" +
           bash_arguments() + std::string(bash_function);
}

// ---------------------------------------------------------------- zsh

namespace {

/// Returns `:MESSAGE:ACTION` for each word of an argument.
std::string zsh_argument(const Argument& argument) {
    const std::string name = argument.name;
    const std::size_t blank = name.find(' ');
    const std::string message = escape_characters(name.substr(0, blank), ":", "\\");
    std::string out;
    if (argument.kind == Kind::choice)
        out = fmt::format(":{}:({})", message, fmt::join(choices_of(argument), " "));
    else if (argument.kind == Kind::file)
        out = fmt::format(":{}:_files", message);
    else if (argument.kind == Kind::folder)
        out = fmt::format(":{}:_files -/", message);
    else if (argument.kind == Kind::warning)
        out = fmt::format(":{}:_robochart-verify_warnings", message);
    else
        out = fmt::format(":{}: ", message);
    return blank == std::string::npos ? out : out + fmt::format(":{}: ", name.substr(blank + 1));
}

std::string zsh_option(const OptionRow& row) {
    const std::string help = fmt::format("[{}]", escape_characters(row.help, "[]:\\", "\\"));
    const bool takes = row.argument.kind != Kind::none;
    const std::string rest = help + (takes ? zsh_argument(row.argument) : "");
    const std::string repeated = row.argument.repeated ? "*" : "";
    std::string out;
    for (const std::string& name : option_spellings(row)) {
        const std::string others =
            row.argument.repeated ? "" : fmt::format("({})", fmt::join(option_spellings(row), " "));
        const bool with_equals = takes && name.starts_with("--") && words_after(row.argument) == 1;
        out += fmt::format(" \\\n        {}", quote_word(others + repeated + name + (with_equals ? "=" : "") + rest));
    }
    return out;
}

std::string zsh_input(const VerbRow& verb) {
    const std::string_view input = verb.input;
    if (input.empty()) return "";
    if (verb.verb == Verb::help) return " \\\n        '1:verb:_robochart-verify_verbs'";
    if (verb.verb == Verb::explain) return " \\\n        '*:code:_robochart-verify_codes'";
    const std::string name(input.substr(0, input.find('.')));
    return fmt::format(" \\\n        {}",
                       quote_word(fmt::format("{}:{}:_files", input.ends_with("...") ? "*" : "1", name)));
}

std::string zsh_verbs(std::string_view parent) {
    std::string out;
    for (const VerbRow& row : verb_table())
        if (row.parent == parent)
            out += fmt::format("    {}\n",
                               quote_word(fmt::format("{}:{}", row.name, escape_characters(row.summary, ":\\", "\\"))));
    if (parent.empty()) out += fmt::format("    {}\n", quote_word(fmt::format("emit:{}", emit_summary)));
    return out;
}

}  // namespace

std::string zsh_completion() {
    std::string out = "#compdef robochart-verify\n" + made_for("zsh");
    out += "\n_robochart-verify_verbs() {\n  local -a verbs\n  verbs=(\n" + zsh_verbs("") +
           "  )\n  _describe -t verbs verb verbs\n}\n";
    out += "\n_robochart-verify_emitted() {\n  local -a verbs\n  verbs=(\n" + zsh_verbs("emit") +
           "  )\n  _describe -t verbs 'what is written' verbs\n}\n";
    for (const bool warnings : {false, true})
        out += fmt::format("\n_robochart-verify_{}() {{\n  compadd -M 'm:{{a-z}}={{A-Z}}' -- {}\n}}\n",
                           warnings ? "warnings" : "codes", rule_codes(warnings));
    out += R"text(
_robochart-verify() {
  local verb="$words[2]"
  if (( CURRENT == 2 )); then
    if [[ $PREFIX == -* ]]; then
      _arguments)text";
    for (const OptionRow* row : options_of(no_verb)) out += zsh_option(*row);
    out += R"text(
      return
    fi
    _alternative 'verbs:verb:_robochart-verify_verbs' 'models:model:_files'
    return
  fi
  if [[ $verb == emit ]]; then
    if (( CURRENT == 3 )); then
      _robochart-verify_emitted
      return
    fi
    verb="emit $words[3]"
    shift 2 words
    (( CURRENT -= 2 ))
)text";
    out += fmt::format("  elif [[ ' {} ' == *\" $verb \"* ]]; then\n", fmt::join(first_words(), " "));
    out += "    shift words\n    (( CURRENT -= 1 ))\n  else\n    verb=verify\n  fi\n  case \"$verb\" in\n";
    for (const VerbRow& verb : verb_table()) {
        out += fmt::format("    {})\n      _arguments -s", quote_word(full_name(verb)));
        for (const OptionRow* row : options_of(verb_bit(verb.verb))) out += zsh_option(*row);
        out += zsh_input(verb) + "\n      ;;\n";
    }
    return out + "  esac\n}\n\n_robochart-verify \"$@\"\n";
}

// ---------------------------------------------------------------- fish

namespace {

std::string fish_quoted(std::string_view text) {
    return "'" + escape_characters(text, "'\\", "\\") + "'";
}

/// Returns the condition that the verb has the option, as a call of `__robochart_verify_is`.
std::string fish_condition(const OptionRow& row) {
    std::vector<std::string> names;
    for (const VerbRow& verb : verb_table())
        if ((row.verbs & verb_bit(verb.verb)) != 0) names.push_back("\"" + full_name(verb) + "\"");
    if ((row.verbs & no_verb) != 0) names.emplace_back("none");
    return fish_quoted(fmt::format("__robochart_verify_is {}", fmt::join(names, " ")));
}

std::string fish_option(const OptionRow& row) {
    std::string out = fmt::format("complete -c robochart-verify -n {}", fish_condition(row));
    if (!short_name(row).empty()) out += fmt::format(" -s {}", short_name(row).substr(1));
    out += fmt::format(" -l {}", long_name(row).substr(2));
    if (row.argument.kind == Kind::choice)
        out += fmt::format(" -x -a {}", fish_quoted(fmt::format("{}", fmt::join(choices_of(row.argument), " "))));
    else if (row.argument.kind == Kind::file)
        out += " -r -F";
    else if (row.argument.kind == Kind::folder)
        out += " -x -a '(__fish_complete_directories)'";
    else if (row.argument.kind == Kind::warning)
        out += fmt::format(" -x -a {}", fish_quoted(rule_codes(true)));
    else if (row.argument.kind != Kind::none)
        out += " -x";
    return out + fmt::format(" -d {}\n", fish_quoted(row.help));
}

constexpr std::string_view fish_functions = R"text(
# The verb of the command line, `emit` with what it writes; `none` before there is one.
function __robochart_verify_verb
    set -l words (commandline -opc)
    if test (count $words) -lt 2
        echo none
    else if test $words[2] = emit
        if test (count $words) -lt 3
            echo emit
        else
            echo "emit $words[3]"
        end
    else if contains -- $words[2] $__robochart_verify_verbs
        echo $words[2]
    else
        echo verify # the first word of all may be a model
    end
end

function __robochart_verify_is
    contains -- (__robochart_verify_verb) $argv
end

)text";

}  // namespace

std::string fish_completion() {
    std::string out =
        made_for("fish") + fmt::format("set -g __robochart_verify_verbs {}\n", fmt::join(first_words(), " "));
    out += fish_functions;
    for (const VerbRow& row : verb_table())
        out += fmt::format("complete -c robochart-verify {}-n '__robochart_verify_is {}' -a {} -d {}\n",
                           row.parent[0] == '\0' ? "" : "-f ", row.parent[0] == '\0' ? "none help" : row.parent,
                           row.name, fish_quoted(row.summary));
    out += fmt::format("complete -c robochart-verify -n '__robochart_verify_is none help' -a emit -d {}\n",
                       fish_quoted(emit_summary));
    out += fmt::format("complete -c robochart-verify -f -n '__robochart_verify_is explain' -a {}\n",
                       fish_quoted(rule_codes(false)));
    for (const OptionRow& row : option_table()) out += fish_option(row);
    return out;
}

}  // namespace robochart::app
