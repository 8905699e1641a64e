// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/kept_search.hpp"

#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "checker/storage/file_lock.hpp"

namespace robochart::refine {
namespace {

namespace fs = std::filesystem;

constexpr const char* const questions_name = "questions";
constexpr const char* const lock_name = "lock";
constexpr const char* const finished_prefix = "finished-";
constexpr std::size_t search_digits = 16;
constexpr std::size_t longest_line = 4096;
constexpr std::string_view title = "robochart-verify questions 1";

std::string hex_text(const diagnostics::Digest& digest) {
    std::string text;
    for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
    return text;
}

diagnostics::Digest digest_of(const std::string& text) {
    diagnostics::Hasher hasher;
    hasher.add(std::string_view("a question by its text alone"));
    hasher.add(std::string_view(text));
    return hasher.finish();
}

std::string hex_text(const std::string& text) {
    std::string result;
    for (const char byte : text) result += fmt::format("{:02x}", static_cast<unsigned char>(byte));
    return result.empty() ? "-" : result;
}

[[noreturn]] void throw_bad_file(const std::string& path, const std::string& why) {
    throw storage::BadFile(fmt::format("{}: {}", diagnostics::escape_for_display(path), why));
}

/// Converts a text to one line and truncates it if it is long.
std::string one_line(std::string text) {
    constexpr std::size_t longest = 2000;
    if (text.size() > longest) text.resize(longest);
    for (char& byte : text)
        if (byte == '\n' || byte == '\0') byte = ' ';
    return text;
}

/// Returns true if a search with this name is being removed (see remove_searches).
bool is_finished(const std::string& name) {
    constexpr std::string_view prefix = "finished-search-";
    return name.size() == prefix.size() + search_digits && name.starts_with(prefix) &&
           name.find_first_not_of("0123456789abcdef", prefix.size()) == std::string::npos;
}

/// Returns a different text each time: 128 random bits. It does not use std::random_device, because this calls a
/// function that the C library has only since 2.36.
std::string random_text() {
    std::array<std::uint64_t, 2> bits{};
    if (getrandom(bits.data(), sizeof bits, 0) != static_cast<ssize_t>(sizeof bits))
        throw std::system_error(errno, std::generic_category(), "cannot read random bits");
    return fmt::format("{:016x}{:016x}", bits[0], bits[1]);
}

/// Returns true if this entry was left by a run that was killed while it was writing.
bool is_unfinished(const fs::directory_entry& entry) {
    std::error_code ignored;
    return diagnostics::is_unfinished(entry.path().filename().string()) &&
           entry.symlink_status(ignored).type() == fs::file_type::regular;
}

}  // namespace

KeptSearch::KeptSearch(KeptSettings settings, LevelStrategy& ranks) : settings_(std::move(settings)), ranks_(ranks) {
    if (settings_.program.empty())
        throw_bad_file(settings_.folder,
                       "this program was built without a build ID, by which it knows what it has written itself");
    lock_folder();
    look_at_folder();
    if (settings_.resume) read_questions();
    remove_left_over();
    if (!settings_.resume) write_questions();  // shows that the folder belongs to this program
    answers_.emplace(path("answers"), settings_.program, std::uint64_t{512} << 20U);
}

/// Locks the folder. If this run must not use the folder, creates no file in it.
void KeptSearch::lock_folder() {
    std::error_code made, ignored;
    if (!settings_.resume) fs::create_directories(settings_.folder, made);
    if (!made && !fs::exists(path(lock_name), ignored)) look_at_folder();
    lock_ = storage::open_to_lock(path(lock_name), true);
    if (!lock_.is_open()) {
        if (settings_.resume) storage::cannot_open(path(lock_name), errno);
        const std::string why = made ? made.message() : std::strerror(errno);
        throw storage::CannotWrite(
            fmt::format("cannot write into {}: {}", diagnostics::escape_for_display(settings_.folder), why));
    }
    if (const std::string why =
            storage::lock(lock_, path(lock_name), storage::Lock::exclusive, "another run is using this folder");
        !why.empty())
        throw_bad_file(settings_.folder, why);
}

/// Rejects the folder if this run must not use it.
void KeptSearch::look_at_folder() const {
    std::error_code code;
    const bool there = fs::exists(path(questions_name), code);
    if (settings_.resume && !there)
        throw_bad_file(settings_.folder, code ? code.message() : "there is no checkpoint in this folder");
    if (settings_.resume) return;
    if (there)
        throw_bad_file(settings_.folder,
                       "it has what an earlier run has found: --resume goes on from there; else name another folder");
    for (fs::directory_iterator at(settings_.folder, code); !code && at != fs::directory_iterator(); at.increment(code))
        if (!is_unfinished(*at) && at->path().filename() != lock_name)
            throw_bad_file(settings_.folder,
                           "there are other files in this folder: name one that is empty or not there");
    if (code) throw_bad_file(settings_.folder, code.message());
}

/// Removes the folder. The lock file is removed first: if another machine has a removed file open, a file with another
/// name appears in the folder.
void KeptSearch::remove_folder() {
    std::error_code ignored;
    fs::remove_all(path("answers"), ignored);
    fs::remove(path(questions_name), ignored);
    fs::remove(path(lock_name), ignored);
    lock_ = diagnostics::Descriptor();
    fs::remove(settings_.folder, ignored);  // removes the folder if it is empty
}

/// Keeps the files if a later run needs them to continue. Removes the folder if no assertion was ever begun.
KeptSearch::~KeptSearch() {
    if (!asked_.empty() || !earlier_.empty() || !answers_) return;
    remove_folder();
}

void KeptSearch::all_asked() {
    if (decided_ < asked_.size() || asked_.size() < earlier_.size() || asked_.empty()) return;
    folders_ = std::move(answered_);
    remove_searches();
    remove_folder();
}

void KeptSearch::read_questions() {
    const std::string file = path(questions_name);
    std::error_code code;
    if (fs::symlink_status(file, code).type() != fs::file_type::regular) throw_bad_file(file, "this is no file");
    if (constexpr std::uintmax_t largest = std::uintmax_t{1} << 28U; fs::file_size(file, code) > largest || code)
        throw_bad_file(file, "it is too large for a list of questions");
    std::ifstream in(file, std::ios::binary);
    std::array<char, longest_line> buffer{};
    std::string line;
    const auto next_line = [&] {
        if (!in.getline(buffer.data(), buffer.size())) return false;
        line = buffer.data();
        return true;
    };
    if (!next_line() || line != title) throw_bad_file(file, "line 1: this is no list of questions of this program");
    if (!next_line()) throw_bad_file(file, "line 2: it was cut off");
    if (line != hex_text(settings_.program))
        throw_bad_file(file, "line 2: another version of the program has written it, whose states may be others");
    constexpr std::size_t digits = 64;
    std::size_t number = 3;
    for (; next_line(); ++number) {
        const bool good =
            line.size() > digits && line[digits] == ' ' && line.find_first_not_of("0123456789abcdef") == digits;
        if (!good) throw_bad_file(file, fmt::format("line {}: there is no question", number));
        earlier_.push_back({line.substr(0, digits), line.substr(digits + 1)});
    }
    if (!in.eof()) throw_bad_file(file, fmt::format("line {}: it cannot be read, or is too long", number));
}

void KeptSearch::write_questions() const {
    std::string text = fmt::format("{}\n{}\n", title, hex_text(settings_.program));
    // The assertions of this run come first; then those of an earlier run that this run has not reached yet.
    std::vector<Asked> all = asked_;
    if (earlier_.size() > all.size())
        all.insert(all.end(), earlier_.begin() + static_cast<std::ptrdiff_t>(all.size()), earlier_.end());
    for (const Asked& question : all) text += fmt::format("{} {}\n", question.digest, question.text);
    if (const std::string error = diagnostics::replace_file(path(questions_name), text); !error.empty())
        throw storage::CannotWrite(error);
}

void KeptSearch::refuse_question(std::size_t place, const std::string& instead) const {
    throw_bad_file(settings_.folder, fmt::format("it was written for question {}, `{}`, {}", place + 1,
                                                 diagnostics::escape_for_display(earlier_[place].text), instead));
}

/// Begins an assertion. Until it is identified, the digest of its text is used.
void KeptSearch::begin_question(const std::string& text) {
    Asked question{hex_text(digest_of(text)), one_line(text)};
    const std::size_t place = asked_.size();
    if (place < earlier_.size() && earlier_[place].text != question.text)
        refuse_question(place, fmt::format("where this run asks `{}`", diagnostics::escape_for_display(question.text)));
    asked_.push_back(std::move(question));
    question_.reset();
    searches_ = 0;
    folders_.clear();
    if (asked_.size() > earlier_.size()) write_questions();
}

/// Identifies the current assertion. An earlier run may have ended before it had identified the assertion. If a check
/// begins again with wider rows, it identifies its assertion again.
void KeptSearch::identify_question(const std::optional<diagnostics::Digest>& digest) {
    assert(!asked_.empty());
    Asked& question = asked_.back();
    const std::string unidentified = question.digest;
    if (digest) question.digest = hex_text(*digest);
    question_ = digest;
    const bool again = asked_.size() <= earlier_.size();
    const std::string& before = again ? earlier_[asked_.size() - 1].digest : unidentified;
    if (before != unidentified && before != question.digest)
        refuse_question(asked_.size() - 1, "about other processes or with other options");
    if (before != question.digest) write_questions();
    if (again) earlier_[asked_.size() - 1].digest = question.digest;
    if (!digest && settings_.say)
        settings_.say(
            fmt::format("nothing is kept of the search for `{}`: its states have other numbers in each run, "
                        "or what it depends on is too large to be looked at as a whole",
                        diagnostics::escape_for_display(question.text)));
}

/// Ends an assertion. If it is decided but its answer could not be stored, its search is not removed, because the
/// search is the only record of the answer.
void KeptSearch::end_question(bool decided) {
    assert(!asked_.empty() && decided_ < asked_.size());
    if (decided) ++decided_;
    const bool stored = question_ && answers_->find(*question_);
    question_.reset();
    if (decided && stored) return remove_searches();
    if (decided) answered_.insert(answered_.end(), folders_.begin(), folders_.end());
    folders_.clear();
}

/// Removes the searches. Each of them is renamed before its files are removed: if the run is killed in between, the
/// next run recognises what is left.
void KeptSearch::remove_searches() {
    std::error_code ignored;
    for (const std::string& folder : folders_) {
        const std::string finished = path(finished_prefix + fs::path(folder).filename().string());
        fs::rename(folder, finished, ignored);
        fs::remove_all(finished, ignored);
    }
    folders_.clear();
}

void KeptSearch::remove_left_over() const {
    std::error_code ignored;
    std::vector<fs::path> found;
    for (fs::directory_iterator at(settings_.folder, ignored); !ignored && at != fs::directory_iterator();
         at.increment(ignored))
        if (is_finished(at->path().filename().string()) || is_unfinished(*at)) found.push_back(at->path());
    for (const fs::path& path : found) fs::remove_all(path, ignored);
}

/// Describes the stores for a search and prepares its folder. Each search of an assertion has a number and its own
/// folder. An assertion has the same searches in every run.
RowKeeping KeptSearch::rows_of(const LevelQuestion& question, std::size_t width, const Budget& budget) {
    diagnostics::Hasher hasher;
    hasher.add(std::string_view("a search by levels"));
    hasher.add(std::string_view(settings_.program));
    hasher.add(*question_);
    for (const std::uint64_t part :
         {searches_++, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(question.kind),
          static_cast<std::uint64_t>(question.model), std::uint64_t{question.divergence ? 1U : 0U},
          question.events_until})
        hasher.add(part);
    RowKeeping rows;
    rows.search = hasher.finish();
    // The path becomes absolute; nevertheless another rank may see another folder there.
    std::error_code ignored;
    rows.folder = fs::absolute(path("search-" + hex_text(rows.search).substr(0, search_digits)), ignored).string();
    if (::mkdir(rows.folder.c_str(), 0700) != 0 && errno != EEXIST)
        throw storage::CannotWrite(fmt::format("cannot make the folder {}: {}",
                                               diagnostics::escape_for_display(rows.folder), std::strerror(errno)));
    folders_.push_back(rows.folder);
    const std::string run = rows.folder + "/" + run_name;
    // The lock is held until the file is replaced, so that no rank of an earlier run begins in between.
    const diagnostics::Descriptor earlier = storage::open_to_lock(run, false);
    if (!earlier.is_open() && errno != ENOENT) storage::cannot_open(run, errno);
    if (earlier.is_open())
        if (const std::string why = storage::lock(earlier, run, storage::Lock::exclusive,
                                                  "ranks of an earlier run are still using this folder");
            !why.empty())
            throw_bad_file(settings_.folder, why);
    rows.run = random_text();
    if (const std::string error = diagnostics::replace_file(run, rows.run); !error.empty())
        throw storage::CannotWrite(error);
    rows.from = storage::newest_in(rows.folder);
    if (rows.from.ranks == 0 && rows.from.greatest > 0 && settings_.say)
        settings_.say(fmt::format("{}: not all ranks have written their part of a checkpoint; the search begins anew",
                                  diagnostics::escape_for_display(rows.folder)));
    rows.every = settings_.every;
    rows.disk = settings_.disk;
    // Uses only a part of the remaining memory, because the program needs memory for other purposes, too.
    const std::uint64_t resident = diagnostics::resident_bytes();
    const std::uint64_t most = budget.limits().memory_bytes;
    rows.most_bytes = settings_.most_bytes.value_or((most - std::min(most, resident)) / 8 * 7);
    rows.filter_bits = settings_.filter_bits;
    rows.reads_a_step = settings_.reads_a_step;
    return rows;
}

std::optional<Violation> KeptSearch::search(lts::TransitionSystem& system, const LevelQuestion& question,
                                            Budget& budget, Statistics& statistics) {
    const std::size_t width = question.row_width(system.width());
    if (!question_ || system.states_are_terms() || width == 0)
        return ranks_.search(system, question, budget, statistics);
    LevelQuestion with_rows = question;
    with_rows.rows = rows_of(question, width, budget);
    const std::uint64_t settled = statistics.settled, rolled_back = statistics.rolled_back;
    std::optional<Violation> found = ranks_.search(system, with_rows, budget, statistics);
    if (statistics.settled > settled && settings_.say)
        settings_.say(
            fmt::format("the states of `{}` on disk were read through {} times, and the search went back {} times",
                        diagnostics::escape_for_display(asked_.back().text), statistics.settled - settled,
                        statistics.rolled_back - rolled_back));
    return found;
}

}  // namespace robochart::refine
