// SPDX-License-Identifier: Apache-2.0
// Defines the verbs, options and exit codes of the command as data. The parser, the help, the man page and the shell
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
    const char* input;    ///< as in usage lines: "MODEL...", "[CODE...]"; "" if there is no input
};

/// Returns the verbs in the order of the help.
[[nodiscard]] const std::vector<VerbRow>& verb_table();
/// Returns the name with its parent: "check", "emit csp".
[[nodiscard]] std::string full_name(const VerbRow&);
/// Returns the row with this full name; null if there is none.
[[nodiscard]] const VerbRow* find_verb(std::string_view name);
/// The summary of `emit`, which is a verb only together with a second word.
extern const char* const emit_summary;
/// Returns the words with which the command line may begin: the verbs and `emit`.
[[nodiscard]] std::vector<std::string> first_words();
/// Returns the words that may follow `emit`.
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
        name,  ///< a name; it must not be empty, because "" would select everything
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
    const char* name = "";     ///< the name in the help: "DIR"; two words if the option has two arguments
    const char* usual = "";    ///< the default in the help; "" if none is shown
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

/// An option of some verbs. If the meaning of an option differs between verbs, it has one row for each meaning.
struct OptionRow {
    const char* names;  ///< "--out", "-q,--quiet"
    Group group;
    Verbs verbs;
    Argument argument;
    const char* help;  ///< a sentence without a full stop
    /// Sets the option. The function is called once per argument, or once with "" if the option has no argument.
    /// `wrong_word` has already accepted `word`. Null for the options help and version, which end parsing.
    void (*take)(Options&, const std::string& word);
    const char* excludes = "";  ///< name of an option that cannot be combined with this option
};

[[nodiscard]] const std::vector<OptionRow>& option_table();
/// Returns the rows of a verb (or `no_verb`), in the order of the table.
[[nodiscard]] std::vector<const OptionRow*> options_of(Verbs);
/// Returns the long name: "--out".
[[nodiscard]] std::string_view long_name(const OptionRow&);
/// Returns the short name: "-o"; "" if there is none.
[[nodiscard]] std::string_view short_name(const OptionRow&);
/// Returns the choices of an argument as a list.
[[nodiscard]] std::vector<std::string> choices_of(const Argument&);
/// Returns the number of words that follow the option.
[[nodiscard]] std::size_t words_after(const Argument&);
/// Returns the reason why an argument is wrong; "" if it is accepted. Converts an accepted word to its normal form: a
/// size to bytes, a code to the spelling of the tables.
[[nodiscard]] std::string wrong_word(const Argument&, std::size_t at, std::string& word);
/// Returns "; did you mean 'check'?" with the nearest candidate, or "" if no candidate is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// An exit code with its meaning.
struct ExitRow {
    Exit exit;
    const char* meaning;
};
[[nodiscard]] const std::vector<ExitRow>& exit_table();

}  // namespace robochart::app
