// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"

namespace robochart::storage {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view title = "robochart-verify checkpoint 1";
constexpr std::uintmax_t largest = std::uintmax_t{1} << 30U;

template <class Bytes>
std::string hex_text(const Bytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
}

std::string check_line(std::string_view text) {
    diagnostics::Hasher hasher;
    hasher.add(text);
    return "check " + hex_text(hasher.finish()) + "\n";
}

std::string file_line(const char* what, const SavedFile& file) {
    return fmt::format("{} {} {} {}\n", what, file.name.empty() ? "-" : file.name, file.blocks, hex_text(file.check));
}

std::string text_of(const RowKind& kind, const Checkpoint& checkpoint) {
    std::string text =
        fmt::format("{}\nsearch {} {}\nnumber {}\nrank {} {}\nlevels {}\n", title, hex_text(kind.search), kind.width,
                    checkpoint.number, checkpoint.place.rank, checkpoint.place.ranks, checkpoint.levels);
    text += fmt::format("files {}\n", checkpoint.files.size());
    for (const SavedFile& file : checkpoint.files) text += file_line("rows", file);
    text += file_line("marks", checkpoint.marks) + file_line("unsure", checkpoint.unsure);
    text += fmt::format("expanded {}\n", checkpoint.expanded.size());
    for (const SavedFigures& figures : checkpoint.expanded)
        text += fmt::format("{} {}\n", figures.transitions, figures.chased);
    return text + check_line(text);
}

/// Splits the text of a checkpoint into words.
class Parser {
public:
    Parser(std::string path, std::string_view text) : path_(std::move(path)), whole_(text), rest_(text) {}

    [[noreturn]] void throw_bad_file(const std::string& cause) const {
        const auto done = whole_.substr(0, whole_.size() - rest_.size());
        throw BadFile(fmt::format("{}: line {}: {}", diagnostics::escape_for_display(path_),
                                  1 + std::ranges::count(done, '\n'), cause));
    }
    std::string_view read_word() {
        const std::size_t end = std::min(rest_.find_first_of(" \n"), rest_.size());
        const std::string_view found = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return found;
    }
    void expect_word(std::string_view expected) {
        if (read_word() != expected) throw_bad_file(fmt::format("'{}' is missing", expected));
    }
    template <class Number>
    Number read_number() {
        const std::string_view text = read_word();
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) throw_bad_file("a number is missing");
        return value;
    }
    SavedFile file(std::string_view what) {
        expect_word(what);
        SavedFile file;
        const std::string_view name = read_word();
        const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
        if (name != "-") {
            if (name.empty() || !std::ranges::all_of(name, plain)) throw_bad_file("a name is missing");
            file.name = name;
        }
        file.blocks = read_number<std::uint64_t>();
        const std::string_view check = read_word();
        for (std::size_t i = 0; i < file.check.size(); ++i) {
            const std::string_view digits = check.substr(std::min(2 * i, check.size()), 2);
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), file.check[i], 16);
            if (error != std::errc() || digits.size() != 2 || end != digits.data() + 2)
                throw_bad_file("a check is missing");
        }
        return file;
    }

private:
    std::string path_;
    std::string_view whole_, rest_;
};

Checkpoint parse_checkpoint(const std::string& path, std::string_view text, const RowKind& kind) {
    Parser parser(path, text);
    for (std::string_view rest = title; !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (parser.read_word() != rest.substr(0, end))
            parser.throw_bad_file("this is no checkpoint that this program reads");
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    Checkpoint result;
    parser.expect_word("search");
    if (parser.read_word() != hex_text(kind.search) || parser.read_number<std::size_t>() != kind.width)
        parser.throw_bad_file("it belongs to another search");
    parser.expect_word("number");
    result.number = parser.read_number<std::uint64_t>();
    parser.expect_word("rank");
    result.place.rank = parser.read_number<std::uint32_t>();
    result.place.ranks = parser.read_number<std::uint32_t>();
    parser.expect_word("levels");
    result.levels = parser.read_number<std::uint32_t>();
    parser.expect_word("files");
    const auto files = parser.read_number<std::size_t>();
    for (std::size_t i = 0; i < files; ++i) result.files.push_back(parser.file("rows"));
    result.marks = parser.file("marks");
    result.unsure = parser.file("unsure");
    parser.expect_word("expanded");
    const auto levels = parser.read_number<std::size_t>();
    for (std::size_t i = 0; i < levels; ++i) {
        const auto transitions = parser.read_number<std::uint64_t>();
        result.expanded.push_back({transitions, parser.read_number<std::uint64_t>()});
    }
    if (result.levels == 0 || levels >= result.levels) parser.throw_bad_file("its levels do not fit");
    return result;
}

/// The rank and the number in the name of a checkpoint. parse_name returns no value for other names.
struct Named {
    std::uint64_t number = 0;
    Place place;
};
std::optional<Named> parse_name(const std::string& name) {
    Named result;
    unsigned long long number = 0;
    int used = 0;
    if (std::sscanf(name.c_str(), "checkpoint-%llu-%u-of-%u%n", &number, &result.place.rank, &result.place.ranks,
                    &used) != 3 ||
        name_of(number, result.place) != name)
        return std::nullopt;
    result.number = number;
    return result;
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code code;
    for (fs::directory_iterator at(folder, code); !code && at != fs::directory_iterator(); at.increment(code))
        names.push_back(at->path().filename().string());
    std::ranges::sort(names);
    return names;
}

[[noreturn]] void cannot_write(const std::string& path) {
    throw CannotWrite(fmt::format("cannot write {}: {}", diagnostics::escape_for_display(path), std::strerror(errno)));
}

void write_and_sync(const std::string& path, std::string_view text) {
    diagnostics::Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (!file.is_open()) cannot_write(path);
    while (!text.empty()) {
        const ssize_t written = ::write(file.get(), text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) cannot_write(path);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(file.get()) != 0 || !file.close()) cannot_write(path);
}

void sync_folder(const std::string& folder) {
    const diagnostics::Descriptor open(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!open.is_open() || ::fsync(open.get()) != 0) cannot_write(folder);
}

}  // namespace

std::string name_of(std::uint64_t number, const Place& place) {
    return fmt::format("checkpoint-{}-{}-of-{}", number, place.rank, place.ranks);
}

void write(const std::string& folder, const RowKind& kind, const Checkpoint& checkpoint) {
    // No run could read any other checkpoint (see parsed).
    assert(checkpoint.levels > 0 && checkpoint.expanded.size() < checkpoint.levels);
    assert(checkpoint.place.rank < checkpoint.place.ranks);
    const std::string path = folder + "/" + name_of(checkpoint.number, checkpoint.place);
    const std::string unfinished = path + ".unfinished";
    sync_folder(folder);  // makes the names of the files durable
    try {
        write_and_sync(unfinished, text_of(kind, checkpoint));
        if (std::rename(unfinished.c_str(), path.c_str()) != 0) cannot_write(path);
    } catch (const CannotWrite&) {
        ::unlink(unfinished.c_str());
        throw;
    }
    sync_folder(folder);
}

Checkpoint read(const std::string& folder, const RowKind& kind, const std::string& name) {
    const std::string path = folder + "/" + name;
    const diagnostics::Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
    const auto bad = [&path](const std::string& cause) {
        throw BadFile(fmt::format("{}: {}", diagnostics::escape_for_display(path), cause));
    };
    if (!file.is_open()) cannot_open(path, errno);
    std::string text;
    std::array<char, 1U << 16U> piece{};
    for (;;) {
        const ssize_t got = ::read(file.get(), piece.data(), piece.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) bad(std::strerror(errno));
        if (got == 0) break;
        text.append(piece.data(), static_cast<std::size_t>(got));
        if (text.size() > largest) bad("it is too large for a checkpoint");
    }
    const std::size_t sealed = check_line("").size();
    if (text.size() < sealed || text.substr(text.size() - sealed) != check_line(text.substr(0, text.size() - sealed)))
        bad(fmt::format("the check at its end, after {} bytes, is not that of the text: it is damaged or cut off",
                        text.size()));
    return parse_checkpoint(path, std::string_view(text).substr(0, text.size() - sealed), kind);
}

namespace {

/// Reads the checkpoints of all ranks with this number. Throws BadFile.
std::vector<Checkpoint> read_all_ranks(const std::string& folder, const RowKind& kind, std::uint64_t number,
                                       std::uint32_t ranks) {
    std::vector<Checkpoint> all;
    for (std::uint32_t rank = 0; rank < ranks; ++rank) {
        const std::string name = name_of(number, {rank, ranks});
        all.push_back(read(folder, kind, name));
        const Checkpoint& one = all.back();
        if (one.number != number || one.place != Place{rank, ranks})
            throw BadFile(
                fmt::format("{}/{}: it does not belong to the others", diagnostics::escape_for_display(folder), name));
    }
    return all;
}

/// Counts checkpoint files by checkpoint number and number of ranks.
std::map<std::pair<std::uint64_t, std::uint32_t>, std::uint32_t> count_checkpoints(const std::string& folder) {
    std::map<std::pair<std::uint64_t, std::uint32_t>, std::uint32_t> found;
    for (const std::string& name : names_in(folder))
        if (const auto parts = parse_name(name)) ++found[{parts->number, parts->place.ranks}];
    return found;
}

/// Returns the number of the newest complete checkpoint with this number of ranks, or 0 if there is none. Other ranks
/// may write and remove checkpoints at the same time, so a checkpoint that cannot be read is ignored.
std::uint64_t complete_number(const std::string& folder, const RowKind& kind, std::uint32_t rank_count) {
    const auto found = count_checkpoints(folder);
    for (auto at = found.rbegin(); at != found.rend(); ++at) {
        const auto [number, ranks] = at->first;
        if (ranks != rank_count || at->second != ranks) continue;
        try {
            (void)read_all_ranks(folder, kind, number, ranks);
            return number;
        } catch (const BadFile&) {
        }
    }
    return 0;
}

}  // namespace

Newest newest_in(const std::string& folder) {
    const auto found = count_checkpoints(folder);
    Newest newest;
    if (!found.empty()) newest.greatest = found.rbegin()->first.first;
    for (auto at = found.rbegin(); at != found.rend() && newest.ranks == 0; ++at) {
        const auto [number, ranks] = at->first;
        if (at->second != ranks) continue;
        newest.number = number;
        newest.ranks = ranks;
    }
    return newest;
}

std::vector<Checkpoint> read(const std::string& folder, const RowKind& kind, const Newest& newest) {
    return read_all_ranks(folder, kind, newest.number, newest.ranks);
}

void remove_old(const std::string& folder, const RowKind& kind, const Place& place) {
    const std::uint64_t number = complete_number(folder, kind, place.ranks);
    const std::vector<std::string> names = names_in(folder);
    const auto mine = [&](const Place& other) {
        return other == place || (place.rank == 0 && other.ranks != place.ranks);
    };
    std::set<std::string> needed;
    for (const std::string& name : names) {
        const auto parts = parse_name(name);
        if (!parts || !mine(parts->place)) continue;
        if (parts->number < number) {
            ::unlink((folder + "/" + name).c_str());
            continue;
        }
        const Checkpoint checkpoint = read(folder, kind, name);
        for (const SavedFile& file : checkpoint.files) needed.insert(file.name);
        needed.insert(checkpoint.marks.name);
        needed.insert(checkpoint.unsure.name);
    }
    for (const std::string& name : names) {
        Place other;
        unsigned long long file = 0;
        const bool rows = std::sscanf(name.c_str(), "rows-%u-of-%u-%llu", &other.rank, &other.ranks, &file) == 3;
        if (rows && mine(other) && !needed.contains(name)) ::unlink((folder + "/" + name).c_str());
    }
}

}  // namespace robochart::storage
