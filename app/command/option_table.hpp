// The verbs, options and exit codes of the command as data. Parsing, help, the man page and the completions of shells
// are made from these tables alone.
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
    const char* summary;  ///< in a sentence without its full stop
    const char* input;    ///< as usage lines show it: "MODEL...", "[CODE...]"; "": it takes none
};

/// In the order in which help lists them.
[[nodiscard]] const std::vector<VerbRow>& verb_table();
/// "check", "emit csp".
[[nodiscard]] std::string full_name(const VerbRow&);
/// The row of a full name; null if there is none.
[[nodiscard]] const VerbRow* find_verb(std::string_view name);
/// What is said of `emit`, which is no verb of its own.
extern const char* const emit_summary;
/// First words of the command line that are verbs, `emit` among them.
[[nodiscard]] std::vector<std::string> first_words();
/// The words that may follow `emit`.
[[nodiscard]] std::vector<std::string> emitted_things();

/// Under which heading help lists an option.
enum class Group : unsigned char { checking, model, code, simulation, files, output, limits, general };
[[nodiscard]] const std::vector<Group>& groups();
[[nodiscard]] std::string_view heading(Group);

/// The word behind an option.
struct Argument {
    enum class Kind : unsigned char {
        none,
        text,
        name,  ///< not empty: an empty one would stand for all
        choice,
        file,
        folder,
        whole,     ///< a number from `least` to `most`
        seconds,   ///< the same with decimals
        size,      ///< of memory, as 300M or 4GiB
        fraction,  ///< a number between 0 and 1
        warning,   ///< the code of a warning
    };
    Kind kind = Kind::none;
    const char* name = "";     ///< as help shows it: "DIR"; two words where the option takes two
    const char* usual = "";    ///< the default, as help shows it; "" where there is none to show
    const char* choices = "";  ///< words of which one is taken, the first of several: "auto,always,never"
    bool repeated = false;     ///< the option may be given several times
    std::uint64_t least = 0, most = 0;
};

/// A set of verbs, a bit for each.
using Verbs = std::uint32_t;
[[nodiscard]] constexpr Verbs of(Verb verb) {
    return Verbs{1} << static_cast<unsigned>(verb);
}
/// The command without a verb.
inline constexpr Verbs no_verb = Verbs{1} << 31U;

/// An option of some verbs. Where one means different things for different verbs, it has a row for each meaning.
struct OptionRow {
    const char* names;  ///< "--out", "-q,--quiet"
    Group group;
    Verbs verbs;
    Argument argument;
    const char* help;  ///< a sentence without its full stop
    /// Sets it; `word` has passed `wrong_word`. Called for each word behind the option, once with "" where there is
    /// none. Null for what ends the reading of the command line: help and version.
    void (*take)(Options&, const std::string& word);
    const char* excludes = "";  ///< an option that may not be given with it
};

[[nodiscard]] const std::vector<OptionRow>& option_table();
/// The rows of a verb (or `no_verb`), in the order of the table.
[[nodiscard]] std::vector<const OptionRow*> options_of(Verbs);
/// "--out".
[[nodiscard]] std::string_view long_name(const OptionRow&);
/// "-o"; "" if there is none.
[[nodiscard]] std::string_view short_name(const OptionRow&);
/// The choices of an argument, one by one.
[[nodiscard]] std::vector<std::string> choices_of(const Argument&);
/// How many words follow the option.
[[nodiscard]] std::size_t words_behind(const Argument&);
/// Why the word at this place behind the option does not fit, "" if it does; what fits is written in its plain form (a
/// size in bytes, a code as the tables have it).
[[nodiscard]] std::string wrong_word(const Argument&, std::size_t at, std::string& word);
/// "; did you mean 'check'?", or "" if nothing is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// An exit code with its meaning.
struct ExitRow {
    Exit exit;
    const char* meaning;
};
[[nodiscard]] const std::vector<ExitRow>& exit_table();

}  // namespace robochart::app
