// Declares a tracer that writes a log for `robochart-verify conform --traces` and counts transitions. It is for hosts
// with files. Delivered with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TRACE_FILE_HPP
#define ROBOCHART_TRACE_FILE_HPP

#include <cstdio>
#include <string>
#include <vector>

#include "robochart/trace.hpp"

namespace robochart {

class TraceFile final : public Tracer {
public:
    explicit TraceFile(const RunHeader& header) : header_(header), counts_(header.transition_count) {}
    TraceFile(const TraceFile&) = delete;
    TraceFile& operator=(const TraceFile&) = delete;
    ~TraceFile() override {
        if (file_ != nullptr) std::fclose(file_);
    }

    /// Begins the log. Returns false if the file cannot be written. Without a log, only transitions are counted.
    [[nodiscard]] bool open(const std::string& path, const std::string& robot = "") {
        file_ = std::fopen(path.c_str(), "w");
        if (file_ == nullptr) return false;
        std::fprintf(file_, "robochart-trace 1\n");
        if (*header_.model != 0) std::fprintf(file_, "model %s\n", header_.model);
        std::fprintf(file_, "component %s\ncycle %u\n", header_.component, static_cast<unsigned>(header_.cycle_length));
        std::fputs(header_.constants, file_);
        if (!robot.empty()) std::fprintf(file_, "robot %s\n", robot.c_str());
        std::fflush(file_);
        return std::ferror(file_) == 0;
    }
    /// Returns whether all writes so far have succeeded.
    [[nodiscard]] bool good() const { return file_ == nullptr || std::ferror(file_) == 0; }

    /// Begins a run. The run appears in the log together with its first cycle.
    void begin() noexcept override { begun_ = false; }
    void text(const char* piece) noexcept override {
        if (file_ == nullptr) return;
        if (!begun_) std::fprintf(file_, "run %d\n", ++runs_);
        begun_ = in_cycle_ = true;
        std::fputs(piece, file_);
    }
    /// Writes a comment on a separate line, for incidents of the robot that are not events of the model. In a cycle,
    /// the comment follows the cycle's line.
    void note(const std::string& comment) {
        if (file_ == nullptr) return;
        if (in_cycle_) {
            notes_ += "// " + comment + '\n';
        } else {
            std::fprintf(file_, "// %s\n", comment.c_str());
        }
    }
    void taken(std::uint32_t transition) noexcept override {
        if (transition < counts_.size()) ++counts_[transition];
    }
    /// Ends a cycle. The log is complete up to the last cycle even if the program ends abnormally.
    void end() noexcept override {
        in_cycle_ = false;
        if (file_ == nullptr) return;
        std::fputs(notes_.c_str(), file_);
        notes_.clear();
        std::fflush(file_);
    }

    /// Returns the number of times that each transition was taken.
    [[nodiscard]] const std::vector<unsigned long>& counts() const { return counts_; }
    /// Returns "3 of 4 transitions taken", then a line for each transition: count, name, place in the model.
    [[nodiscard]] std::string coverage() const {
        std::size_t taken = 0;
        for (const unsigned long count : counts_) taken += count > 0 ? 1 : 0;
        std::string text = std::to_string(taken) + " of " + std::to_string(counts_.size()) + " transitions taken\n";
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            const TransitionName& name = header_.transitions[i];
            text += "  " + std::to_string(counts_[i]) + "  " + name.element;
            if (*name.place != 0) text += std::string(" (") + name.place + ")";
            text += '\n';
        }
        return text;
    }

private:
    RunHeader header_;
    std::FILE* file_ = nullptr;
    std::vector<unsigned long> counts_;
    std::string notes_;
    int runs_ = 0;
    bool begun_ = false;     ///< true if the line `run N` of the current run is written
    bool in_cycle_ = false;  ///< true if the line of a cycle has begun and has not ended
};

}  // namespace robochart

#endif
