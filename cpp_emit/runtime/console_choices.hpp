// Decides choices of the model in a console program: by the words of the cycle, by asking the user, or by repeating a
// record of an earlier run. A record is a text with one line for each cycle. The line contains the words of the cycle,
// and its choices with the number of alternatives. Delivered with generated code that asks (`emit cpp --choices`,
// probabilistic junctions). Copyright: see LICENSE (Apache-2.0).
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
    /// `word` is the word before "=" in answers: "pick" for `pick=2`. Alternatives are counted from 0.
    ConsoleChoices(std::string controller, const std::string& word)
        : controller_(std::move(controller)), prefix_(word + "=") {}

    /// After this call, the program asks the user if the words contain no answer. Without this call, it takes the first
    /// alternative.
    void ask() { asks_ = true; }

    /// Begins a record. Returns false if the file cannot be written.
    [[nodiscard]] bool record(const std::string& path) {
        record_.open(path);
        record_ << "robochart-record 1\ncontroller " << controller_ << std::endl;
        recording_ = true;
        return record_.good();
    }
    [[nodiscard]] bool recorded() const { return !recording_ || record_.good(); }

    /// Starts to repeat a record. fault() reports errors in the record.
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
    /// Returns the words of the next cycle in `line`. Returns false at the end of the record and after a fault.
    [[nodiscard]] bool next(std::string& line) {
        if (!fault_.empty()) return false;
        do
            if (!read(line)) return false;
        while (line.rfind("//", 0) == 0);
        return true;
    }
    /// Called at the end of the run. The record must end here, too.
    void finish() {
        std::string line;
        if (replaying_ && next(line)) fail("the controller has ended, the record goes on");
    }
    /// Returns "FILE:LINE: error", or an empty text if there is no error.
    [[nodiscard]] const std::string& fault() const { return fault_; }

    /// Takes an answer for this cycle, `pick=2` or `pick=2/3`. Returns false if the word is not an answer.
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
    /// Called for a word that raised an input.
    void raised(const std::string& word) { words_ += (words_.empty() ? "" : " ") + word; }
    /// Called for an invalid word. Prints the error, or ends the repeated run.
    void refuse(const std::string& told) {
        if (replaying_) return fail(told);
        std::cerr << told << '\n';
    }

    /// Returns the answer to a choice between `count` alternatives.
    std::size_t pick(std::size_t count) {
        const std::size_t picked = next_ < answers_.size() ? answered(answers_[next_++], count) : unanswered(count);
        std::cout << "  picks " << picked << " of " << range(count) << '\n';
        raised(prefix_ + std::to_string(picked) + "/" + std::to_string(count));
        return picked;
    }
    /// Decides a probabilistic choice. Alternatives with probability zero are not offered.
    std::size_t choose(const double* chances, std::size_t count) {
        std::vector<std::size_t> ways;
        for (std::size_t way = 0; way < count; ++way)
            if (chances[way] > 0.0) ways.push_back(way);
        return ways.empty() ? 0 : ways.size() == 1 ? ways[0] : ways[pick(ways.size())];
    }
    /// Called at the end of a cycle.
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
        std::size_t count = 0;  ///< number of alternatives; 0: not given
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
    /// Stores the first error.
    void fail(const std::string& what, bool with_line = true) {
        if (!fault_.empty()) return;
        fault_ = path_ + (with_line ? ":" + std::to_string(line_) : "") + ": " + what;
    }

    std::string controller_, prefix_;
    bool asks_ = false;
    std::vector<Answer> answers_;  ///< answers in this cycle
    std::size_t next_ = 0;
    std::string words_;  ///< words of this cycle, for the record
    bool recording_ = false;
    std::ofstream record_;
    bool replaying_ = false;
    std::ifstream replayed_;
    std::string path_, fault_;
    std::size_t line_ = 0;
};

}  // namespace robochart

#endif
