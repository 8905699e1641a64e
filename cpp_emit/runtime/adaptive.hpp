// Tests implementations of a model that leaves choices; the tests adapt to the implementation (docs/conformance.md,
// "Test suites"). The model is a graph over control cycles: for each reading of the inputs, the allowed outputs and
// their successors. The implementation is explored as in black box checking (Peled, Vardi, Yannakakis 1999): its states
// are distinguished by their answers, and every step is compared with the model. A step that the model does not have is
// a forbidden continuation (Cavalcanti, Gaudel 2007). Delivered with generated tests. Copyright: see LICENSE
// (Apache-2.0).
#ifndef ROBOCHART_ADAPTIVE_HPP
#define ROBOCHART_ADAPTIVE_HPP

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <istream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace robochart {

/// The behaviour that a model allows, cycle by cycle.
class AllowedCycles {
public:
    using Words = std::vector<std::string>;
    struct Branch {
        Words writes;
        long target = -1;  ///< -1: terminated
    };

    /// Reads `C.graph`. Returns false if the text is not a valid graph.
    [[nodiscard]] bool read(std::istream& in) {
        std::string line;
        for (std::size_t state = 0; std::getline(in, line);) {
            std::istringstream words(line.substr(0, line.find("//")));
            std::string word;
            if (!(words >> word)) continue;
            if (word == "robochart-graph" || word == "component") continue;
            if (word == "extra") {
                if (!(words >> extra)) return false;
            } else if (word == "input") {
                std::size_t number = 0;
                if (!(words >> number) || number != inputs.size()) return false;
                inputs.emplace_back(rest(words));
            } else if (word == "state") {
                state = states.size();
                states.emplace_back(inputs.size());
            } else {
                std::size_t symbol = 0;
                Branch branch;
                std::string target;
                if (!(std::istringstream(word) >> symbol) || !(words >> target)) return false;
                if (target != "over" && !(std::istringstream(target) >> branch.target)) return false;
                branch.writes = rest(words);
                if (states.empty() || symbol >= inputs.size()) return false;
                states[state][symbol].push_back(branch);
            }
        }
        return !states.empty();
    }

    std::vector<Words> inputs;                             ///< by symbol
    std::vector<std::vector<std::vector<Branch>>> states;  ///< [state][symbol]; state 0 is the initial state
    std::size_t extra = 0;                                 ///< number of further states that the implementation may
                                                           ///< have

private:
    static Words rest(std::istream& words) {
        Words all;
        for (std::string word; words >> word;) all.push_back(word);
        return all;
    }
};

/// Compares words. Numbers are compared by value, so 0.50 equals 0.5.
inline bool same_word(const std::string& a, const std::string& b) {
    if (a == b) return true;
    std::istringstream x(a), y(b);
    for (std::string p, q; std::getline(x, p, '!') && std::getline(y, q, '!');) {
        char *end_p = nullptr, *end_q = nullptr;
        const double n = std::strtod(p.c_str(), &end_p);
        const double m = std::strtod(q.c_str(), &end_q);
        const bool numbers = !p.empty() && !q.empty() && *end_p == '\0' && *end_q == '\0';
        if (numbers ? n < m - 1e-9 || n > m + 1e-9 : p != q) return false;
        if (x.eof() != y.eof()) return false;
    }
    return x.eof() && y.eof();
}

inline bool same_words(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same_word(a[i], b[i])) return false;
    return true;
}

struct AdaptiveVerdict {
    enum class Kind { passed, failed, inconclusive };
    Kind kind = Kind::passed;
    std::string reason;      ///< failed: the run and the allowed continuations; inconclusive: the cause
    std::size_t states = 0;  ///< number of distinguished states of the implementation
    std::size_t cycles = 0;  ///< number of executed cycles of the implementation
};

/// Explores an implementation. It must have `reset()`, and `cycle(inputs)`, which returns the outputs, with "terminate"
/// at its end.
template <class Implementation>
class AdaptiveTest {
public:
    AdaptiveTest(const AllowedCycles& model, Implementation& implementation, std::size_t most_cycles)
        : model_(model), implementation_(implementation), most_(most_cycles) {
        nodes_.emplace_back();
        // The suffixes distinguish states, and more are added when they are needed. If there are many symbols, only a
        // selection is used at first.
        const std::size_t step = 1 + (model.inputs.size() - 1) / 32;
        for (std::size_t symbol = 0; symbol < model.inputs.size(); symbol += step) suffixes_.push_back({symbol});
    }

    AdaptiveVerdict run() {
        states_.push_back({});
        while (verdict_.kind == AdaptiveVerdict::Kind::passed) {
            if (close() && agree(model_.extra + 1) && within()) break;
        }
        verdict_.states = states_.size();
        return verdict_;
    }

private:
    using Word = std::vector<std::size_t>;
    static constexpr std::size_t over = static_cast<std::size_t>(-1);

    /// The node after a word, with the outputs of the last cycle and the possible states of the model.
    struct Node {
        std::size_t answer = 0;
        std::size_t model = 0;
        bool ended = false;
        std::map<std::size_t, std::size_t> next;  ///< by symbol
    };
    /// A step of the hypothesis.
    struct Step {
        std::size_t answer;
        std::size_t target;
    };

    [[nodiscard]] bool going() const { return verdict_.kind == AdaptiveVerdict::Kind::passed; }
    void stop(AdaptiveVerdict::Kind kind, const std::string& reason) {
        if (going()) verdict_.kind = kind, verdict_.reason = reason;
    }

    static std::string shown(const AllowedCycles::Words& words) {
        std::string text;
        for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
        return text.empty() ? "nothing" : text;
    }

    std::size_t answer_of(const AllowedCycles::Words& words) {
        std::string key;
        for (const std::string& word : words) key += word + ' ';
        return answers_.emplace(key, answers_.size() + 1).first->second;
    }

    std::string told(const Word& word, std::size_t length) const {
        std::string text;
        for (std::size_t i = 0; i < length; ++i)
            text += "\n  cycle " + std::to_string(i + 1) + ": " + shown(model_.inputs[word[i]]);
        return text;
    }

    /// Returns the node after one more symbol. The implementation must be in the state before the symbol.
    std::size_t make(std::size_t from, const Word& word, std::size_t at, const AllowedCycles::Words& done) {
        Node node;
        node.answer = answer_of(done);
        node.ended = !done.empty() && done.back() == "terminate";
        std::string allowed;
        const AllowedCycles::Branch* found = nullptr;
        for (const AllowedCycles::Branch& branch : model_.states[nodes_[from].model][word[at]]) {
            AllowedCycles::Words writes = branch.writes;
            if (branch.target < 0) writes.push_back("terminate");
            if (same_words(writes, done)) found = &branch;
            allowed += "\n    " + shown(writes);
        }
        if (found == nullptr)
            stop(AdaptiveVerdict::Kind::failed,
                 "after" + told(word, at + 1) + "\nit did " + shown(done) + "; the model allows one of" + allowed);
        if (found != nullptr && found->target >= 0) node.model = static_cast<std::size_t>(found->target);
        nodes_.push_back(node);
        nodes_[from].next[word[at]] = nodes_.size() - 1;
        return nodes_.size() - 1;
    }

    /// Returns the word's answers. Queries the implementation if some of them are not known.
    std::vector<std::size_t> ask(const Word& word) {
        std::vector<std::size_t> result;
        if (!known(word, result) && going()) drive(word);
        if (going()) known(word, result);
        result.resize(word.size(), over);
        return result;
    }

    bool known(const Word& word, std::vector<std::size_t>& result) const {
        result.clear();
        std::size_t at = 0;
        for (const std::size_t symbol : word) {
            if (nodes_[at].ended) {
                result.push_back(over);
                continue;
            }
            const auto next = nodes_[at].next.find(symbol);
            if (next == nodes_[at].next.end()) return false;
            at = next->second;
            result.push_back(nodes_[at].answer);
        }
        return true;
    }

    void drive(const Word& word) {
        implementation_.reset();
        std::size_t at = 0;
        for (std::size_t i = 0; i < word.size() && going() && !nodes_[at].ended; ++i) {
            if (++verdict_.cycles > most_)
                return stop(AdaptiveVerdict::Kind::inconclusive,
                            "more than " + std::to_string(most_) + " cycles are needed (ROBOCHART_MOST_CYCLES)");
            const AllowedCycles::Words done = implementation_.cycle(model_.inputs[word[i]]);
            const auto next = nodes_[at].next.find(word[i]);
            if (next == nodes_[at].next.end()) {
                at = make(at, word, i, done);
            } else {
                at = next->second;
                if (nodes_[at].answer != answer_of(done))
                    return stop(AdaptiveVerdict::Kind::inconclusive,
                                "the implementation is not deterministic: it does not always do the same after" +
                                    told(word, i + 1));
            }
        }
    }

    static Word joined(Word word, const Word& more) {
        word.insert(word.end(), more.begin(), more.end());
        return word;
    }

    /// Returns the answers of the state after a word to all suffixes.
    std::vector<std::size_t> row(const Word& word) {
        std::vector<std::size_t> all;
        for (const Word& suffix : suffixes_) {
            const std::vector<std::size_t> answers = ask(joined(word, suffix));
            all.insert(all.end(), answers.begin() + static_cast<std::ptrdiff_t>(word.size()), answers.end());
            if (!going()) break;
        }
        return all;
    }

    /// Finds an access word for every state that can be distinguished, and builds the hypothesis from these words.
    /// Returns false if the test was stopped.
    bool close() {
        std::map<std::vector<std::size_t>, std::size_t> rows;
        states_.assign(1, Word{});
        hypothesis_.clear();
        rows.emplace(row({}), 0);
        for (std::size_t state = 0; state < states_.size() && going(); ++state) {
            hypothesis_.emplace_back();
            for (std::size_t symbol = 0; symbol < model_.inputs.size() && going(); ++symbol) {
                const Word longer = joined(states_[state], {symbol});
                const std::size_t answer = ask(longer).back();
                const auto place = rows.emplace(row(longer), states_.size());
                if (place.second) states_.push_back(longer);
                hypothesis_[state].push_back({answer, place.first->second});
            }
        }
        return going();
    }

    /// Compares the hypothesis with the implementation as in Chow 1978: all states, all words of at most `depth`
    /// symbols, all suffixes. A difference gives a suffix that distinguishes two states of the hypothesis (Rivest,
    /// Schapire 1993). Returns false if the loop must start again, or if the test was stopped.
    bool agree(std::size_t depth) {
        std::deque<Word> words{{}};
        for (; !words.empty() && going(); words.pop_front()) {
            for (const Word& access : states_)
                for (std::size_t s = 0; s < suffixes_.size(); ++s)
                    if (!agree_on(joined(joined(access, words.front()), suffixes_[s]))) return false;
            if (words.front().size() == depth) continue;
            for (std::size_t symbol = 0; symbol < model_.inputs.size(); ++symbol)
                words.push_back(joined(words.front(), {symbol}));
        }
        return going();
    }

    bool agree_on(const Word& word) {
        const std::vector<std::size_t> answers = ask(word);
        std::size_t state = 0;
        for (std::size_t i = 0; i < word.size() && going(); ++i) {
            const Step& step = hypothesis_[state][word[i]];
            if (step.answer != answers[i]) {
                learn(Word(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(i + 1)));
                return false;
            }
            state = step.target;
        }
        return going();
    }

    /// Searches the product of hypothesis and model. Every step of the hypothesis must be allowed in all reachable
    /// pairs. Returns false if the loop must start again, or if the test was stopped.
    bool within() {
        std::map<std::pair<std::size_t, std::size_t>, Word> seen{{{0, 0}, {}}};
        std::deque<std::pair<std::size_t, std::size_t>> open{{0, 0}};
        for (; !open.empty(); open.pop_front()) {
            const std::pair<std::size_t, std::size_t> here = open.front();
            for (std::size_t symbol = 0; symbol < model_.inputs.size(); ++symbol) {
                const Word word = joined(seen.at(here), {symbol});
                if (!agree_on(word)) return false;
                const Node& node = nodes_[behind(word)];
                const std::pair<std::size_t, std::size_t> next{hypothesis_[here.first][symbol].target, node.model};
                if (!node.ended && seen.emplace(next, word).second) open.push_back(next);
            }
        }
        return true;
    }

    [[nodiscard]] std::size_t behind(const Word& word) const {
        std::size_t at = 0;
        for (const std::size_t symbol : word) at = nodes_[at].next.at(symbol);
        return at;
    }

    /// Finds the position in the word from which the answers of the hypothesis differ from those of the implementation.
    void learn(const Word& word) {
        const std::size_t last = ask(word).back();
        std::size_t state = 0;
        for (std::size_t i = 0; i < word.size() && going(); ++i) {
            state = hypothesis_[state][word[i]].target;
            const Word suffix(word.begin() + static_cast<std::ptrdiff_t>(i + 1), word.end());
            if (suffix.empty()) break;
            if (ask(joined(states_[state], suffix)).back() == last) continue;
            suffixes_.push_back(suffix);
            return;
        }
    }

    const AllowedCycles& model_;
    Implementation& implementation_;
    std::size_t most_;
    AdaptiveVerdict verdict_;
    std::vector<Node> nodes_;
    std::map<std::string, std::size_t> answers_;
    std::vector<Word> suffixes_;
    std::vector<Word> states_;
    std::vector<std::vector<Step>> hypothesis_;
};

}  // namespace robochart

#endif
