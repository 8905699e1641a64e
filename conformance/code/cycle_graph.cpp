// SPDX-License-Identifier: Apache-2.0
// See cycle_graph.hpp. A run repeats the cycle from its beginning with given answers to its reads. Further reads are
// first answered with "absent". All runs of an image are made in the order of their answers. What the code does later
// in a cycle depends on the bytes at the beginning of a round and on the registers. They are the key of a point. At a
// point that was already explored, the run of a path is not continued.
#include "conformance/code/cycle_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "conformance/code/watchdog.hpp"

namespace robochart::conformance {

namespace {

/// The maximal number of outputs of a cycle that are compared. A cycle with more outputs is explored with all inputs.
constexpr std::uint32_t most_outputs = 4096;

struct ProbedCall {
    const rc_interface* code;
    void* state;
    const rc_probe* probe;
    rc_log* log;
};

rc_result probed_step(void* arguments) {
    const auto* const call = static_cast<const ProbedCall*>(arguments);
    return call->code->probe(call->state, call->probe, call->log);
}

template <class Item>
std::string bytes_of(const std::vector<Item>& items) {
    return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)};
}

}  // namespace

CycleGraph::CycleGraph(const rc_interface& code, const Alphabet& alphabet, std::uint32_t cycle_length)
    : code_(&code),
      alphabet_(&alphabet),
      cycle_length_(std::max(1U, cycle_length)),
      inputs_(alphabet.interface().inputs.size()),
      images_(code) {
    if (code.probe == nullptr) throw NotProbed("the code does not report which registers it reads");
    if (!images_.reset_writes_all()) unsound_ = "`initial` does not write the whole state";
    (void)intern_sequence({});
    log_.reserve(most_outputs);
    again_.reserve(most_outputs);
}

std::uint32_t CycleGraph::root(std::uint32_t image) {
    const auto found = roots_.find(image);
    if (found != roots_.end()) return found->second;
    const std::uint32_t root = add_segments(1);
    answers_.clear();
    do {
        run(image, root);
        if (!unsound_.empty()) throw NotProbed(unsound_);
    } while (next_answers());
    roots_.emplace(image, root);
    begun_.push_back(image);
    return root;
}

/// Advances to the next answers in their order. Returns false after the last ones.
bool CycleGraph::next_answers() {
    while (!answers_.empty()) {
        Answer& last = answers_.back();
        if (++last.reading < alphabet_->interface().inputs[last.input].reading_count()) return true;
        answers_.pop_back();
    }
    return false;
}

void CycleGraph::begin_run(std::uint32_t root) {
    answered_ = 0;
    current_ = root;
    first_write_ = 0;
    shared_ = false;
    known_.assign(inputs_, -1);
    spent_.assign(inputs_, false);
    sealed_.assign(inputs_, false);
    rounds_.clear();
    steps_at_start_ = 0;
    steps_ = 0;
    log_.clear();
    log_.given = 0;
}

void CycleGraph::run(std::uint32_t image, std::uint32_t root) {
    ++cycles_;
    budget_->poll();
    begin_run(root);
    const Bytes from = images_.bytes(image);
    Bytes after = from;
    const rc_probe probe{this, on_read, on_value, on_assigned, on_round};
    ProbedCall call{code_, after.data(), &probe, &log_};
    const Stepped stepped = call_watched(probed_step, &call, endless_ ? Patience::short_ : Patience::seconds);
    if (log_.asked > 0) refused_ = "the cycle asks its platform for choices";
    if (!refused_.empty()) throw NotProbed(refused_);
    if (stepped.endless) return close_endless();
    // docs/conformance.md, "Reading on demand", explains why this bound suffices.
    if (stepped.result != RC_STEP_BOUND) most_steps_ = std::max(most_steps_, steps_);
    if (steps_at_start_ > 0 && (inputs_ + 1) * std::uint64_t{most_steps_} >= steps_at_start_)
        throw NotProbed("a cycle takes too many steps");
    if (!log_.is_cut()) most_writes_ = std::max(most_writes_, log_.count);
    const bool shared = shared_;
    end_run(stepped.result, after);
    run_again(from, stepped.result, after, false);
    if (!shared) run_again(from, stepped.result, after, true);
}

void CycleGraph::close_endless() {
    endless_ = true;
    if (shared_ || segments_[current_].end != End::open) return;
    const std::uint32_t image = reset_image();  // the state that the code left has no meaning
    close(End::leaf, 0, intern_leaf(RC_STEP_BOUND, image));
}

void CycleGraph::end_run(rc_result outcome, const Bytes& after) {
    if (shared_) return check_shared_path(outcome, after);
    if (log_.is_cut()) throw NotProbed("a cycle makes too many outputs");
    if (segments_[current_].end != End::open) return fault("the code reads other registers in the same cycle");
    close(End::leaf, 0, intern_leaf(outcome, images_.intern(after)));
}

/// Checks the outputs and the end of a run that continued, after a shared point, with empty registers. They must be
/// those of this path in the graph.
void CycleGraph::check_shared_path(rc_result outcome, const Bytes& after) {
    if (log_.is_cut() && outcome != RC_STEP_BOUND) throw NotProbed("a cycle makes too many outputs");
    std::uint32_t at = shared_point_;
    std::uint32_t write = shared_write_;
    bool same = true;
    for (; segments_[at].end != End::open; at = segments_[at].next) {
        for (const process::Event event : outputs(segments_[at]))
            same = same && write < log_.count && event_of(log_.record[write++]) == event;
        if (segments_[at].end == End::leaf) break;
    }
    if (segments_[at].end == End::open) return fault("a cycle continues in two ways from one point");
    const Leaf& end = leaf(segments_[at]);
    if (outcome == RC_STEP_BOUND && end.outcome != outcome) throw NotProbed("a cycle takes too many steps");
    if (outcome == RC_STEP_BOUND) return;
    if (!same || write != log_.count || end.outcome != outcome || !images_.has_bytes(end.next, after))
        fault("a cycle continues in two ways from one point");
}

/// Repeats the cycle with given contents of all registers; those that were not read are all empty, or all present. The
/// code must not depend on these registers, nor on memory outside its state.
void CycleGraph::run_again(const Bytes& from, rc_result outcome, const Bytes& after, bool unread_present) {
    std::vector<rc_register> registers(inputs_);
    for (std::size_t i = 0; i < inputs_; ++i) {
        const std::uint32_t last = alphabet_->interface().inputs[i].reading_count() - 1;
        const std::int64_t unread = unread_present ? last : 0;
        const std::int64_t reading = known_[i] < 0 ? unread : known_[i];
        registers[i] = {reading == 0 ? 0U : 1U, reading == 0 ? 0U : static_cast<std::uint32_t>(reading - 1)};
    }
    Bytes again = from;
    again_.clear();
    const Stepped stepped = step_watched(*code_, again.data(), registers.data(), &again_);
    if (stepped.result != outcome) return fault("`step` gives two results for one state and one set of inputs");
    if (outcome == RC_STEP_BOUND) return;
    if (again != after || !same_writes(again_, log_))
        fault("`step` gives two results for one state and one set of inputs");
}

void CycleGraph::fault(const char* reason) {
    unsound_ = reason;
    shared_ = true;
}

// ------------------------------------------------------------ calls from the code

std::uint32_t CycleGraph::on_read(void* graph, std::uint32_t input) {
    return static_cast<CycleGraph*>(graph)->read(input);
}

std::uint32_t CycleGraph::on_value(void* graph, std::uint32_t input) {
    auto* const self = static_cast<CycleGraph*>(graph);
    if (self->sealed_[input]) self->refused_ = "the code reads the value of an input that is absent";
    const std::uint32_t reading = self->read(input);
    return reading == 0 ? 0 : reading - 1;
}

void CycleGraph::on_assigned(void* graph, std::uint32_t input) {
    static_cast<CycleGraph*>(graph)->spent_[input] = true;
}

void CycleGraph::on_round(void* graph, const void* step, std::uint32_t size, const void* state, std::uint32_t left) {
    static_cast<CycleGraph*>(graph)->round(static_cast<const unsigned char*>(step), size,
                                           static_cast<const unsigned char*>(state), left);
}

std::uint32_t CycleGraph::read(std::uint32_t input) {
    if (known_[input] < 0) {
        known_[input] = take(input);
        if (known_[input] == 0) spent_[input] = true;
    }
    return static_cast<std::uint32_t>(known_[input]);
}

/// Returns the answer to the next read on the path.
std::uint32_t CycleGraph::take(std::uint32_t input) {
    if (shared_) return 0;
    if (segments_[current_].end == End::open) {
        close(End::reading, input, add_segments(alphabet_->interface().inputs[input].reading_count()));
        answers_.push_back({input, 0});
    } else if (segments_[current_].end != End::reading || segments_[current_].input != input ||
               answered_ == answers_.size() || !same_outputs(segments_[current_])) {
        fault("the code reads other registers in the same cycle");
        return 0;
    }
    const std::uint32_t reading = answers_[answered_++].reading;
    current_ = segments_[current_].next + reading;
    first_write_ = log_.count;
    return reading;
}

void CycleGraph::round(const unsigned char* step, std::uint32_t size, const unsigned char* state, std::uint32_t left) {
    if (steps_at_start_ == 0) steps_at_start_ = left;
    steps_ = steps_at_start_ - left;
    for (std::size_t i = 0; i < inputs_; ++i)
        if (spent_[i]) sealed_[i] = true;
    if (shared_) return;
    if (segments_[current_].end == End::open) {
        make_key(step, size, state);
        const auto [place, fresh] = points_.emplace(key_, 0);
        if (fresh) place->second = add_segments(1);
        const std::uint32_t point = place->second;
        if (!fresh) {
            shared_ = true;
            shared_point_ = point;
            shared_write_ = log_.count;
        }
        const bool loop = !fresh && std::ranges::find(rounds_, point) != rounds_.end();
        if (loop)
            close(End::leaf, 0, intern_leaf(RC_STEP_BOUND, reset_image()));
        else
            close(End::round, 0, point);
        if (!fresh) return;
        current_ = point;
    } else {
        if (segments_[current_].end != End::round || !same_outputs(segments_[current_]))
            return fault("the code reads other registers in the same cycle");
        current_ = segments_[current_].next;
    }
    rounds_.push_back(current_);
    first_write_ = log_.count;
}

/// Stores the key: the bytes of the step and of the state, and the contents of the registers that the code has read and
/// not consumed.
void CycleGraph::make_key(const unsigned char* step, std::uint32_t size, const unsigned char* state) {
    key_.assign(reinterpret_cast<const char*>(step), size);
    key_.append(reinterpret_cast<const char*>(state), code_->state_size);
    for (std::size_t i = 0; i < inputs_; ++i) {
        std::uint32_t content = 0;
        if (known_[i] >= 0) content = spent_[i] ? 1U : 1U + static_cast<std::uint32_t>(known_[i]);
        const std::size_t width = alphabet_->interface().inputs[i].reading_count() < 255 ? 1 : sizeof content;
        for (std::size_t byte = 0; byte < width; ++byte) key_ += static_cast<char>(content >> (8U * byte));
    }
}

void CycleGraph::close(End end, std::uint32_t input, std::uint32_t next) {
    std::vector<process::Event> writes;
    for (std::uint32_t r = first_write_; r < log_.count; ++r) writes.push_back(event_of(log_.record[r]));
    Segment& segment = segments_[current_];
    segment.end = end;
    segment.input = input;
    segment.next = next;
    segment.writes = intern_sequence(std::move(writes));
}

bool CycleGraph::same_outputs(const Segment& segment) const {
    return outputs(segment).size() == log_.count - first_write_;
}

process::Event CycleGraph::event_of(const rc_record& record) {
    if (record.output >= code_->outputs || record.count > ROBOCHART_MAX_ARGUMENTS) {
        refused_ = "the code logs an output that its interface does not have";
        return process::tau;
    }
    std::string key(reinterpret_cast<const char*>(&record.output), sizeof record.output);
    key.append(reinterpret_cast<const char*>(record.argument), record.count * sizeof(std::int64_t));
    const auto found = events_.find(key);
    if (found != events_.end()) return found->second;
    const process::Event event =
        alphabet_->write_event(record.output, {record.argument, record.argument + record.count});
    events_.emplace(std::move(key), event);
    return event;
}

std::uint32_t CycleGraph::add_segments(std::size_t count) {
    const auto first = static_cast<std::uint32_t>(segments_.size());
    segments_.resize(segments_.size() + count);
    return first;
}

std::uint32_t CycleGraph::intern_sequence(std::vector<process::Event> events) {
    const auto [place, fresh] = sequence_ids_.emplace(bytes_of(events), static_cast<std::uint32_t>(sequences_.size()));
    if (fresh) sequences_.push_back(std::move(events));
    return place->second;
}

std::uint32_t CycleGraph::intern_leaf(rc_result outcome, std::uint32_t next) {
    Leaf leaf{outcome, next, std::vector<bool>(inputs_)};
    std::string key = fmt::format("{} {} ", static_cast<int>(outcome), next);
    for (std::size_t i = 0; i < inputs_; ++i) {
        leaf.unread[i] = known_[i] < 0;
        key += leaf.unread[i] ? '?' : '.';
    }
    const auto [place, fresh] = leaf_ids_.emplace(std::move(key), static_cast<std::uint32_t>(leaves_.size()));
    if (fresh) leaves_.push_back(std::move(leaf));
    return place->second;
}

// ------------------------------------------------------------ what the reports ask

namespace {

/// A path through a cycle, up to its next read or its end.
class Path {
public:
    Path(const CycleGraph& graph, std::uint32_t segment) : graph_(&graph), segment_(segment) { advance(); }

    [[nodiscard]] const CycleGraph::Segment& at() const { return graph_->segment(segment_); }
    [[nodiscard]] std::uint32_t number() const { return segment_; }
    [[nodiscard]] bool ended() const { return at().end == CycleGraph::End::leaf; }
    void answer(std::uint32_t reading) {
        segment_ = at().next + reading;
        advance();
    }
    /// The outputs so far, without those that were removed.
    std::vector<process::Event> writes;

private:
    void advance() {
        for (;;) {
            const std::vector<process::Event>& more = graph_->outputs(at());
            writes.insert(writes.end(), more.begin(), more.end());
            if (at().end != CycleGraph::End::round) return;
            segment_ = at().next;
        }
    }

    const CycleGraph* graph_;
    std::uint32_t segment_;
};

/// Decides whether two paths that differ in the reading of one register have the same continuations, for all readings
/// of the other registers.
class PathEquality {
public:
    PathEquality(const CycleGraph& graph, const Alphabet& alphabet) : graph_(graph), alphabet_(alphabet) {}

    [[nodiscard]] bool equal(std::uint32_t one, std::uint32_t other) {
        return equal(Path(graph_, one), Path(graph_, other), {});
    }

private:
    using Ahead = std::map<std::uint32_t, std::uint32_t>;  ///< readings that only one of the paths has read

    /// Returns whether both paths continue in the same way. Recursion depth: the number of reads of both.
    [[nodiscard]] bool equal(Path one, Path other, const Ahead& ahead) {
        const std::size_t common = std::min(one.writes.size(), other.writes.size());
        if (!std::equal(one.writes.begin(), one.writes.begin() + static_cast<std::ptrdiff_t>(common),
                        other.writes.begin()))
            return false;
        for (Path* const path : {&one, &other})
            path->writes.erase(path->writes.begin(), path->writes.begin() + static_cast<std::ptrdiff_t>(common));
        if (one.number() == other.number() && ahead.empty()) return one.writes == other.writes;
        if (one.ended() && other.ended()) {
            const CycleGraph::Leaf& a = graph_.leaf(one.at());
            const CycleGraph::Leaf& b = graph_.leaf(other.at());
            return one.writes == other.writes && a.outcome == b.outcome && a.next == b.next;
        }
        const bool level = ahead.empty() && one.writes.empty() && other.writes.empty();
        if (level && !compared_.emplace(one.number(), other.number()).second) return true;
        if (++steps_ > most_steps) return false;
        return one.ended() ? equal_after_read(other, one, ahead) : equal_after_read(one, other, ahead);
    }

    bool equal_after_read(const Path& reader, const Path& rest, const Ahead& ahead) {
        const std::uint32_t input = reader.at().input;
        const auto known = ahead.find(input);
        const std::uint32_t all = alphabet_.interface().inputs[input].reading_count();
        for (std::uint32_t reading = 0; reading < all; ++reading) {
            if (known != ahead.end() && known->second != reading) continue;
            Path next = reader;
            next.answer(reading);
            Ahead left = ahead;
            if (known != ahead.end())
                left.erase(input);
            else
                left[input] = reading;
            if (!equal(rest, next, left)) return false;
        }
        return true;
    }

    static constexpr std::size_t most_steps = 100'000;
    const CycleGraph& graph_;
    const Alphabet& alphabet_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> compared_;
    std::size_t steps_ = 0;
};

/// Visits all segments that are reachable from one segment.
template <class Visit>
void visit_below(const CycleGraph& graph, const Alphabet& alphabet, std::uint32_t root, Visit visit) {
    std::set<std::uint32_t> seen{root};
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
        const CycleGraph::Segment& segment = graph.segment(open.back());
        open.pop_back();
        visit(segment);
        std::uint32_t count = 0;
        if (segment.end == CycleGraph::End::round) count = 1;
        if (segment.end == CycleGraph::End::reading) count = alphabet.interface().inputs[segment.input].reading_count();
        for (std::uint32_t child = segment.next; child < segment.next + count; ++child)
            if (seen.insert(child).second) open.push_back(child);
    }
}

}  // namespace

std::vector<bool> CycleGraph::without_effect(std::uint32_t image) const {
    std::vector<bool> lost(inputs_, true);
    visit_below(*this, *alphabet_, roots_.at(image), [&](const Segment& segment) {
        if (segment.end != End::reading || !lost[segment.input]) return;
        for (std::uint32_t r = 1; r < alphabet_->interface().inputs[segment.input].reading_count(); ++r)
            if (!PathEquality(*this, *alphabet_).equal(segment.next, segment.next + r)) lost[segment.input] = false;
    });
    return lost;
}

std::vector<std::uint32_t> CycleGraph::next_images(std::uint32_t image) const {
    std::set<std::uint32_t> images;
    visit_below(*this, *alphabet_, roots_.at(image), [&](const Segment& segment) {
        if (segment.end == End::leaf && leaf(segment).outcome == RC_QUIESCENT) images.insert(leaf(segment).next);
    });
    return {images.begin(), images.end()};
}

std::vector<process::Event> CycleGraph::writes(std::uint32_t image, const std::vector<Raised>& raised) const {
    Path path(*this, roots_.at(image));
    while (!path.ended()) {
        const auto found = std::ranges::find(raised, path.at().input, &Raised::first);
        path.answer(found == raised.end() ? 0 : found->second);
    }
    return path.writes;
}

std::vector<PassedCycle> CycleGraph::path_to_image(std::uint32_t image) const {
    struct From {
        std::uint32_t image = 0;
        PassedCycle cycle;
    };
    std::map<std::uint32_t, From> from;
    std::vector<std::uint32_t> open{reset_image()};
    std::deque<CycleResult>& results = shown_;
    for (std::size_t i = 0; i < open.size() && from.count(image) == 0 && image != reset_image(); ++i) {
        const std::uint32_t here = open[i];
        std::vector<std::pair<Path, std::vector<std::uint32_t>>> paths;
        paths.emplace_back(Path(*this, roots_.at(here)), std::vector<std::uint32_t>(inputs_, 0));
        std::set<std::uint32_t> seen;
        while (!paths.empty()) {
            const auto [path, readings] = std::move(paths.back());
            paths.pop_back();
            if (!seen.insert(path.number()).second) continue;
            if (!path.ended()) {
                const std::uint32_t input = path.at().input;
                for (std::uint32_t r = alphabet_->interface().inputs[input].reading_count(); r-- > 0;) {
                    paths.emplace_back(path, readings);
                    paths.back().first.answer(r);
                    paths.back().second[input] = r;
                }
                continue;
            }
            const Leaf& end = leaf(path.at());
            if (end.outcome != RC_QUIESCENT || end.next == reset_image() || roots_.count(end.next) == 0) continue;
            if (from.count(end.next) != 0) continue;
            results.push_back({end.outcome, path.writes, end.next, {}});
            from.emplace(end.next, From{here, {readings, &results.back()}});
            open.push_back(end.next);
        }
    }
    std::vector<PassedCycle> way;
    while (image != reset_image() && from.count(image) != 0) {
        const From& last = from.at(image);
        way.insert(way.begin(), last.cycle);
        image = last.image;
    }
    return way;
}

}  // namespace robochart::conformance
