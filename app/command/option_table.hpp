// SPDX-License-Identifier: Apache-2.0
// The verbs, options and exit codes of the command as data. The parser, the help, the man page and the shell
// completions use only these tables.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/options.hpp"

namespace robochart::app {

/// A verb of the command.
struct VerbRow {
    Verb verb;
    const char* name;
    const char* parent;   ///< "emit", or "" for top-level verbs
    const char* summary;  ///< a sentence without a full stop
    const char* input;    ///< as in usage lines: "MODEL...", "[CODE...]"; "": no input
};

/// The verbs in the order of the help.
[[nodiscard]] const std::vector<VerbRow>& verb_table();
/// "check", "emit csp".
[[nodiscard]] std::string full_name(const VerbRow&);
/// The row with this full name; null if there is none.
[[nodiscard]] const VerbRow* find_verb(std::string_view name);
/// The summary of `emit`, which is not a verb without a second word.
extern const char* const emit_summary;
/// The verbs that may be the first word of the command line, including `emit`.
[[nodiscard]] std::vector<std::string> first_words();
/// The words that may follow `emit`.
[[nodiscard]] std::vector<std::string> emit_targets();

/// The heading under which the help lists an option.
enum class Group : unsigned char { checking, model, code, simulation, files, output, limits, general };
[[nodiscard]] const std::vector<Group>& option_groups();
[[nodiscard]] std::string_view group_heading(Group);

/// The argument of an option.
struct Argument {
    enum class Kind : unsigned char {
        none,
        text,
        name,  ///< not empty, because an empty name would select everything
        choice,
        file,
        folder,
        whole,     ///< a number from `least` to `most`
        seconds,   ///< a number of seconds, possibly with decimals
        size,      ///< a size of memory, such as 300M or 4GiB
        fraction,  ///< a number between 0 and 1
        warning,   ///< the code of a warning
    };
    Kind kind = Kind::none;
    const char* name = "";     ///< as in the help: "DIR"; two words if the option has two arguments
    const char* usual = "";    ///< the default, as in the help; "" if none is shown
    const char* choices = "";  ///< the allowed words, separated by commas: "auto,always,never"
    bool repeated = false;     ///< the option may be given several times
    std::uint64_t least = 0, most = 0;
};

/// A set of verbs, one bit for each.
using Verbs = std::uint32_t;
[[nodiscard]] constexpr Verbs verb_bit(Verb verb) {
    return Verbs{1} << static_cast<unsigned>(verb);
}
/// The command without a verb.
inline constexpr Verbs no_verb = Verbs{1} << 31U;

/// An option of some verbs. An option whose meaning differs between verbs has one row per meaning.
struct OptionRow {
    const char* names;  ///< "--out", "-q,--quiet"
    Group group;
    Verbs verbs;
    Argument argument;
    const char* help;  ///< a sentence without a full stop
    /// Sets the option. It is called once per argument, or once with "" if the option has no argument; `wrong_word` has
    /// accepted `word` before. Null for the options help and version, which end parsing.
    void (*take)(Options&, const std::string& word);
    const char* excludes = "";  ///< name of an option that cannot be combined with this option
};

[[nodiscard]] const std::vector<OptionRow>& option_table();
/// The rows of a verb (or `no_verb`), in the order of the table.
[[nodiscard]] std::vector<const OptionRow*> options_of(Verbs);
/// "--out".
[[nodiscard]] std::string_view long_name(const OptionRow&);
/// "-o"; "" if there is none.
[[nodiscard]] std::string_view short_name(const OptionRow&);
/// The choices of an argument as a list.
[[nodiscard]] std::vector<std::string> choices_of(const Argument&);
/// The number of words that follow the option.
[[nodiscard]] std::size_t words_after(const Argument&);
/// The reason why an argument is wrong; "" if it is accepted. An accepted word is converted to its normal form: a size
/// to bytes, a code to the spelling of the tables.
[[nodiscard]] std::string wrong_word(const Argument&, std::size_t at, std::string& word);
/// "; did you mean 'check'?", or "" if no candidate is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// An exit code with its meaning.
struct ExitRow {
    Exit exit;
    const char* meaning;
};
[[nodiscard]] const std::vector<ExitRow>& exit_table();

}  // namespace robochart::app
