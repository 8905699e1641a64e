// SPDX-License-Identifier: Apache-2.0
#include "classics.hpp"

#include <map>

namespace robochart::refine {
namespace {

using process::Op;
using process::SetId;

std::string at(const std::string& channel, int i) {
    return channel + "." + std::to_string(i);
}
std::string at(const std::string& channel, int i, int j) {
    return at(channel, i) + "." + std::to_string(j);
}

/// Returns a process that repeatedly performs these events in turn.
TermId cycle(Scripted& s, const std::string& name, const std::vector<std::string>& events) {
    const TermId self = s.name(name);
    TermId body = self;
    for (std::size_t i = events.size(); i-- > 0;) body = s.prefix(events[i], body);
    s.bind(self, body);
    return self;
}

TermId philosopher(Scripted& s, int i, int count, bool left_first) {
    const int right = (i + 1) % count;
    const std::string first = at("picks", i, left_first ? i : right);
    const std::string second = at("picks", i, left_first ? right : i);
    return cycle(s, at("PHIL", i),
                 {at("thinks", i), at("sits", i), first, second, at("eats", i), at("putsdown", i, right),
                  at("putsdown", i, i), at("getsup", i)});
}

TermId fork_process(Scripted& s, int i, int count) {
    const int left = (i + count - 1) % count;
    const TermId self = s.name(at("FORK", i));
    s.bind(self, s.menu({{at("picks", i, i), s.prefix(at("putsdown", i, i), self)},
                         {at("picks", left, i), s.prefix(at("putsdown", left, i), self)}}));
    return self;
}

/// Returns D(i) = b.i -> c.(i+1) -> Q(i) [] c.(i+1) -> b.i -> Q(i) with Q(i) = c.i -> a.i -> D(i).
TermId cycler(Scripted& s, int i, int count) {
    const int next = (i + 1) % count;
    const TermId d = s.name(at("D", i));
    const TermId q = s.name(at("Q", i));
    s.bind(d, s.menu({{at("b", i), s.prefix(at("c", next), q)}, {at("c", next), s.prefix(at("b", i), q)}}));
    const TermId go = s.prefix(at("a", i), d);
    s.bind(q, s.prefix(at("c", i), go));
    return i == 0 ? go : q;
}

TermId copier(Scripted& s, int i) {
    const TermId self = s.name(at("COPY", i));
    s.bind(self, s.menu({{at("ch", i, 0), s.prefix(at("ch", i + 1, 0), self)},
                         {at("ch", i, 1), s.prefix(at("ch", i + 1, 1), self)}}));
    return self;
}

class BufferMaker {
public:
    BufferMaker(Scripted& s, std::size_t places) : s_(s), places_(places) {}
    TermId buffer_holding(const std::string& content) {
        if (const auto known = made_.find(content); known != made_.end()) return known->second;
        const TermId self = made_[content] = s_.name("BUFF(" + content + ")");
        std::vector<std::pair<std::string, TermId>> branches;
        for (const char* bit : {"0", "1"})
            if (content.size() < places_)
                branches.emplace_back(std::string("ch.0.") + bit, buffer_holding(content + bit));
        if (!content.empty())
            branches.emplace_back("ch." + std::to_string(places_) + "." + content[0],
                                  buffer_holding(content.substr(1)));
        s_.bind(self, s_.menu(branches));
        return self;
    }

private:
    Scripted& s_;
    std::size_t places_;
    std::map<std::string, TermId> made_;
};

}  // namespace

TermId dining_philosophers(Scripted& s, int count, bool symmetric) {
    std::vector<TermId> philosophers;
    std::vector<TermId> forks;
    std::vector<std::string> shared;
    for (int i = 0; i < count; ++i) {
        philosophers.push_back(philosopher(s, i, count, symmetric || i + 1 < count));
        forks.push_back(fork_process(s, i, count));
        for (int fork : {i, (i + 1) % count})
            for (const char* channel : {"picks", "putsdown"}) shared.push_back(at(channel, i, fork));
    }
    return s.over(Op::parallel, {s.over(Op::parallel, philosophers, {}), s.over(Op::parallel, forks, {})}, shared);
}

TermId milner_scheduler(Scripted& s, int count) {
    std::vector<TermId> cyclers;
    std::vector<SetId> alphabets;
    for (int i = 0; i < count; ++i) {
        cyclers.push_back(cycler(s, i, count));
        alphabets.push_back(s.set({at("a", i), at("b", i), at("c", i), at("c", (i + 1) % count)}));
    }
    return s.op(Op::alphabetised, cyclers, 0, alphabets);
}

TermId round_robin(Scripted& s, int count) {
    std::vector<std::string> events;
    for (int i = 0; i < count; ++i) events.push_back(at("a", i));
    return cycle(s, "SPEC", events);
}

TermId buffer_chain(Scripted& s, int count) {
    std::vector<TermId> copiers;
    std::vector<SetId> alphabets;
    std::vector<std::string> middle;
    for (int i = 0; i < count; ++i) {
        copiers.push_back(copier(s, i));
        alphabets.push_back(s.set({at("ch", i, 0), at("ch", i, 1), at("ch", i + 1, 0), at("ch", i + 1, 1)}));
        if (i > 0) middle.insert(middle.end(), {at("ch", i, 0), at("ch", i, 1)});
    }
    return s.over(Op::hide, {s.op(Op::alphabetised, copiers, 0, alphabets)}, middle);
}

TermId buffer(Scripted& s, int places) {
    return BufferMaker(s, static_cast<std::size_t>(places)).buffer_holding("");
}

TermId independent_cycles(Scripted& s, int count) {
    std::vector<TermId> cycles;
    for (int i = 0; i < count; ++i)
        cycles.push_back(cycle(s, at("CYCLE", i), {at("p", i), at("q", i), at("r", i), at("t", i)}));
    return s.over(Op::parallel, cycles, {});
}

TermId hide_channels(Scripted& s, TermId process, const std::vector<std::string>& channels, int count) {
    std::vector<std::string> hidden;
    for (const std::string& channel : channels)
        for (int i = 0; i < count; ++i) {
            hidden.push_back(at(channel, i));
            for (int j = 0; j < count; ++j) hidden.push_back(at(channel, i, j));
        }
    return s.over(Op::hide, {process}, hidden);
}

}  // namespace robochart::refine
