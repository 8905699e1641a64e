// What a console program picks where the model leaves a choice: the words of the cycle say it, a person is asked, or a
// record of an earlier run is repeated. A record is text: the words of each cycle in a line, with what was picked of
// how many. Ships with generated code that asks (`emit cpp --choices`, probabilistic junctions). Copyright: see LICENSE
// (Apache-2.0).
#ifndef ROBOCHART_CONSOLE_CHOICES_HPP
#define ROBOCHART_CONSOLE_CHOICES_HPP

#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace robochart {

class ConsoleChoices {
public:
    /// `word` is what answers begin with: "pick" for `pick=2`, which is counted from 0.
    ConsoleChoices(std::string controller, const std::string& word)
        : controller_(std::move(controller)), prefix_(word + "=") {}

    /// From now on somebody is asked where the words do not answer; else it is the first.
    void ask() { asks_ = true; }

    /// Begins a record; false if the file cannot be written.
    [[nodiscard]] bool record(const std::string& path) {
        record_.open(path);
        record_ << "robochart-record 1\ncontroller " << controller_ << std::endl;
        recording_ = true;
        return record_.good();
    }
    [[nodiscard]] bool recorded() const { return !recording_ || record_.good(); }

    /// Begins to repeat a record. What is wrong with it: fault().
    void replay(const std::string& path) {
        path_ = path;
        replayed_.open(path);
        replaying_ = true;
        std::string line;
        if (!replayed_) return fail("cannot be read", false);
        if (!read(line) || line != "robochart-record 1")
            return fail("expected `robochart-record 1`, found `" + line + "`");
        if (!read(line) || line != "controller " + controller_)
            fail("expected `controller " + controller_ + "`, found `" + line + "`");
    }
    /// The words of the next cycle; false at the end of the record and after a fault.
    [[nodiscard]] bool next(std::string& line) {
        if (!fault_.empty()) return false;
        do
            if (!read(line)) return false;
        while (line.rfind("//", 0) == 0);
        return true;
    }
    /// The run is over: so must be the record.
    void finish() {
        std::string line;
        if (replaying_ && next(line)) fail("the controller has ended, the record goes on");
    }
    /// "FILE:LINE: what is wrong"; empty where all is well.
    [[nodiscard]] const std::string& fault() const { return fault_; }

    /// Takes an answer for this cycle, `pick=2` or `pick=2/3`; false if the word is none.
    [[nodiscard]] bool take(const std::string& word) {
        if (word.rfind(prefix_, 0) != 0) return false;
        Answer answer;
        const std::size_t slash = word.find('/');
        const bool good = number(word.substr(prefix_.size(), slash - prefix_.size()), answer.picked) &&
                          (slash == std::string::npos || number(word.substr(slash + 1), answer.count));
        if (good)
            answers_.push_back(answer);
        else
            refuse("not a choice: " + word);
        return true;
    }
    /// A word raised an input.
    void raised(const std::string& word) { words_ += (words_.empty() ? "" : " ") + word; }
    /// A word is invalid: reported, or the end of the repeated run.
    void refuse(const std::string& told) {
        if (replaying_) return fail(told);
        std::cerr << told << '\n';
    }

    /// The answer where `count` are possible.
    std::size_t pick(std::size_t count) {
        const std::size_t picked = next_ < answers_.size() ? answered(answers_[next_++], count) : unanswered(count);
        std::cout << "  picks " << picked << " of " << range(count) << '\n';
        raised(prefix_ + std::to_string(picked) + "/" + std::to_string(count));
        return picked;
    }
    /// The same where alternatives are drawn by their chances: those without one are not offered.
    std::size_t choose(const double* chances, std::size_t count) {
        std::vector<std::size_t> ways;
        for (std::size_t way = 0; way < count; ++way)
            if (chances[way] > 0.0) ways.push_back(way);
        return ways.empty() ? 0 : ways.size() == 1 ? ways[0] : ways[pick(ways.size())];
    }
    /// The cycle is over.
    void end() {
        for (; next_ < answers_.size() && fault_.empty(); ++next_)
            refuse("nothing to choose: " + prefix_ + std::to_string(answers_[next_].picked));
        if (recording_) record_ << words_ << std::endl;
        answers_.clear();
        words_.clear();
        next_ = 0;
    }

private:
    struct Answer {
        std::size_t picked = 0;
        std::size_t count = 0;  ///< of how many; 0: not said
    };

    std::size_t answered(const Answer& answer, std::size_t count) {
        if (answer.count != 0 && answer.count != count)
            refuse("a choice of " + std::to_string(answer.count) + ", here it is one of " + std::to_string(count));
        if (answer.picked < count) return answer.picked;
        refuse("not a choice: " + std::to_string(answer.picked) + " of " + range(count));
        return 0;
    }
    std::size_t unanswered(std::size_t count) {
        if (replaying_) fail("no answer where there is a choice of " + std::to_string(count));
        std::string line;
        while (asks_ && !replaying_) {
            std::cout << "  which of " << range(count) << "? " << std::flush;
            asks_ = static_cast<bool>(std::getline(std::cin, line));
            std::size_t picked = 0;
            if (!asks_ || line.empty()) break;
            if (number(line, picked) && picked < count) return picked;
            std::cerr << "not a choice: " << line << " of " << range(count) << '\n';
        }
        return 0;
    }

    static bool number(const std::string& text, std::size_t& value) {
        if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) return false;
        value = std::stoul(text);
        return true;
    }
    static std::string range(std::size_t count) { return "0.." + std::to_string(count - 1); }

    [[nodiscard]] bool read(std::string& line) {
        line.clear();
        ++line_;
        return static_cast<bool>(std::getline(replayed_, line));
    }
    /// The first fault is reported.
    void fail(const std::string& what, bool with_line = true) {
        if (!fault_.empty()) return;
        fault_ = path_ + (with_line ? ":" + std::to_string(line_) : "") + ": " + what;
    }

    std::string controller_, prefix_;
    bool asks_ = false;
    std::vector<Answer> answers_;  ///< of this cycle
    std::size_t next_ = 0;
    std::string words_;  ///< of this cycle, for the record
    bool recording_ = false;
    std::ofstream record_;
    bool replaying_ = false;
    std::ifstream replayed_;
    std::string path_, fault_;
    std::size_t line_ = 0;
};

}  // namespace robochart

#endif
