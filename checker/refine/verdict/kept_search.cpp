#include "checker/refine/verdict/kept_search.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "checker/refine/levels/disk_row_store.hpp"
#include "checker/refine/levels/saved_row_store.hpp"
#include "diagnostics/escape.hpp"
#include "diagnostics/files.hpp"

namespace robochart::refine {
namespace {

namespace fs = std::filesystem;

constexpr const char* const questions_name = "questions";
constexpr const char* const finished_prefix = "finished-";
constexpr std::string_view title = "robochart-verify questions 1";

std::string hex(const diagnostics::Digest& digest) {
    std::string text;
    for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
    return text;
}

diagnostics::Digest digest_of(const std::string& text) {
    diagnostics::Hasher hasher;
    hasher.add(std::string_view(text));
    return hasher.finish();
}

std::string hex(const std::string& text) {
    std::string result;
    for (const char byte : text) result += fmt::format("{:02x}", static_cast<unsigned char>(byte));
    return result.empty() ? "-" : result;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw storage::BadFile(fmt::format("{}: {}", diagnostics::shown(path), why));
}

/// A text in one line.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

KeptSearch::KeptSearch(KeptSettings settings) : settings_(std::move(settings)) {
    std::error_code code;
    if (!settings_.resume) fs::create_directories(settings_.folder, code);
    const std::string shown = diagnostics::shown(settings_.folder);
    folder_ = diagnostics::Descriptor(::open(settings_.folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder_.open()) {
        const std::string why = code ? code.message() : std::strerror(errno);
        if (settings_.resume) refuse(settings_.folder, why);
        throw storage::CannotWrite(fmt::format("cannot write into {}: {}", shown, why));
    }
    if (::flock(folder_.get(), LOCK_EX | LOCK_NB) != 0) refuse(settings_.folder, "another run is using this folder");
    const bool used = fs::exists(path(questions_name), code);
    if (used && !settings_.resume)
        refuse(settings_.folder,
               "it has what an earlier run has found: --resume goes on from there; else name another folder");
    if (!used && settings_.resume) refuse(settings_.folder, "there is no checkpoint in this folder");
    if (settings_.resume) {
        read_questions();
        remove_finished();
    }
    answers_.emplace(path("answers"), settings_.program, std::uint64_t{512} << 20U);
}

/// What is left is needed to go on, unless everything has been decided.
KeptSearch::~KeptSearch() {
    if (!all_decided_ || asked_.size() < earlier_.size() || asked_.empty()) return;
    std::error_code ignored;
    fs::remove_all(path("answers"), ignored);
    fs::remove(path(questions_name), ignored);
    fs::remove(settings_.folder, ignored);  // if nothing else is in it
}

void KeptSearch::read_questions() {
    const std::string file = path(questions_name);
    std::ifstream in(file, std::ios::binary);
    std::string line;
    std::string program;
    if (!std::getline(in, line) || line != title) refuse(file, "line 1: this is no list of questions of this program");
    if (!std::getline(in, program)) refuse(file, "line 2: it was cut off");
    if (program != hex(settings_.program))
        refuse(file, "line 2: another version of the program has written it, whose states may be others");
    constexpr std::size_t digits = 64;
    for (std::size_t number = 3; std::getline(in, line); ++number) {
        const bool good =
            line.size() > digits && line[digits] == ' ' && line.find_first_not_of("0123456789abcdef") == digits;
        if (!good) refuse(file, fmt::format("line {}: there is no question", number));
        earlier_.push_back({line.substr(0, digits), line.substr(digits + 1)});
    }
    if (!in.eof()) refuse(file, "it cannot be read");
}

void KeptSearch::write_questions() const {
    std::string text = fmt::format("{}\n{}\n", title, hex(settings_.program));
    const std::vector<Asked>& all = asked_.size() > earlier_.size() ? asked_ : earlier_;
    for (const Asked& each : all) text += fmt::format("{} {}\n", each.digest, each.text);
    if (const std::string error = diagnostics::replace_file(path(questions_name), text); !error.empty())
        throw storage::CannotWrite(error);
}

void KeptSearch::begin_question(const std::string& text, const std::optional<diagnostics::Digest>& digest) {
    Asked asked{hex(digest ? *digest : digest_of(text)), one_line(text)};
    const std::size_t place = asked_.size();
    if (place < earlier_.size() && earlier_[place].digest != asked.digest) {
        const bool same_text = earlier_[place].text == asked.text;
        refuse(
            settings_.folder,
            fmt::format("it was written for question {}, `{}`, {}", place + 1, diagnostics::shown(earlier_[place].text),
                        same_text ? "about other processes or with other options"
                                  : fmt::format("where this run asks `{}`", diagnostics::shown(asked.text))));
    }
    asked_.push_back(std::move(asked));
    question_ = digest;
    searches_ = 0;
    folders_.clear();
    if (asked_.size() > earlier_.size()) write_questions();
}

void KeptSearch::end_question(bool decided) {
    question_.reset();
    all_decided_ = all_decided_ && decided;
    if (decided) remove_searches();
}

/// First all at once, by its name: a run that is killed must not leave half of it.
void KeptSearch::remove_searches() {
    std::error_code ignored;
    for (const std::string& folder : folders_) {
        const std::string finished = path(finished_prefix + fs::path(folder).filename().string());
        fs::rename(folder, finished, ignored);
        fs::remove_all(finished, ignored);
    }
    folders_.clear();
}

void KeptSearch::remove_finished() const {
    std::error_code ignored;
    std::vector<fs::path> found;
    for (fs::directory_iterator at(settings_.folder, ignored); !ignored && at != fs::directory_iterator();
         at.increment(ignored))
        if (at->path().filename().string().starts_with(finished_prefix)) found.push_back(at->path());
    for (const fs::path& each : found) fs::remove_all(each, ignored);
}

/// Each search of a question has a folder, by its number: the searches of a question are the same each time.
std::optional<Violation> KeptSearch::search(lts::TransitionSystem& system, const LevelQuestion& question,
                                            Budget& budget, Statistics& statistics) {
    const std::size_t width = question.row_width(system.width());
    const bool keeps = question_ && !system.states_are_terms() && width > 0;
    MakeRowStore make = memory_row_store;
    if (keeps) {
        diagnostics::Hasher hasher;
        hasher.add(std::string_view("a search by levels"));
        hasher.add(std::string_view(settings_.program));
        hasher.add(*question_);
        for (const std::uint64_t part :
             {searches_++, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(question.kind),
              static_cast<std::uint64_t>(question.model), std::uint64_t{question.divergence ? 1U : 0U},
              question.events_until})
            hasher.add(part);
        const storage::RowKind kind{width, hasher.finish()};
        constexpr std::size_t digits = 16;
        const std::string folder = path("search-" + hex(kind.search).substr(0, digits));
        if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
            throw storage::CannotWrite(
                fmt::format("cannot make the folder {}: {}", diagnostics::shown(folder), std::strerror(errno)));
        folders_.push_back(folder);
        // A part of what is left, since the program needs some for other things.
        const std::uint64_t resident = diagnostics::resident_bytes();
        const std::uint64_t most = budget.limits().memory_bytes;
        DiskRowStore::Bounds bounds;
        bounds.most_bytes = settings_.most_bytes.value_or((most - std::min(most, resident)) / 4 * 3);
        bounds.filter_bits = settings_.filter_bits;
        bounds.fewest_unsure = settings_.fewest_unsure.value_or(bounds.fewest_unsure);
        bounds.report = on_end;
        make = [this, kind, folder, bounds, &budget](const LevelQuestion&, const lts::TransitionSystem&,
                                                     Exchange& exchange) -> std::unique_ptr<RowStore> {
            KeptWhere where{folder, kind, {exchange.rank(), exchange.ranks()}, settings_.every, {}, {}, {}};
            if (exchange.ranks() > 1)
                where.mine = [rank = exchange.rank(), ranks = exchange.ranks()](lts::StateView row) {
                    return owner_of(lts::StateStore::hash(row), ranks) == rank;
                };
            where.undisturbed = settings_.undisturbed;
            // The budget is the first rank's; others find out at the end of a round.
            if (exchange.rank() == 0) where.poll = [&budget] { budget.charge(256); };
            if (!settings_.disk) return std::make_unique<SavedRowStore>(std::move(where));
            DiskRowStore::Bounds own = bounds;
            own.most_bytes /= exchange.ranks();
            return std::make_unique<DiskRowStore>(std::move(where), own);
        };
    }
    if (settings_.ranks > 1) return ThreadRanks(settings_.ranks, make).search(system, question, budget, statistics);
    return OneRank(make).search(system, question, budget, statistics);
}

}  // namespace robochart::refine
