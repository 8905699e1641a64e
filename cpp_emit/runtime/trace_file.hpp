// A tracer that writes a log for `robochart-verify conform --traces` and counts transitions; for hosts with files. The
// log is a text, or an MCAP file if its name ends in `.mcap`.
// Delivered with the generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TRACE_FILE_HPP
#define ROBOCHART_TRACE_FILE_HPP

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "robochart/mcap_writer.hpp"
#include "robochart/trace.hpp"

namespace robochart {

class TraceFile final : public Tracer {
public:
    explicit TraceFile(const RunHeader& header) : header_(header), counts_(header.transition_count) {}
    TraceFile(const TraceFile&) = delete;
    TraceFile& operator=(const TraceFile&) = delete;
    ~TraceFile() override {
        if (file_ == nullptr) return;
        if (!pending_.empty()) write_pending();
        std::fclose(file_);
    }

    /// Begins the log. Returns false if the file cannot be written. Without a log, only transitions are counted.
    [[nodiscard]] bool open(const std::string& path, const std::string& robot = "") {
        const std::string extension = ".mcap";
        const bool mcap = path.size() >= extension.size() &&
                          path.compare(path.size() - extension.size(), extension.size(), extension) == 0;
        file_ = std::fopen(path.c_str(), mcap ? "wb" : "w");
        if (file_ == nullptr) return false;
        if (mcap) begin_mcap();
        pending_ = "robochart-trace 1\n";
        if (*header_.model != 0) pending_ += std::string("model ") + header_.model + '\n';
        pending_ += std::string("component ") + header_.component + "\ncycle " + std::to_string(header_.cycle_length) +
                    '\n' + header_.constants;
        if (!robot.empty()) pending_ += "robot " + robot + '\n';
        write_pending();
        return std::ferror(file_) == 0;
    }
    /// Returns whether all writes so far have succeeded.
    [[nodiscard]] bool good() const { return file_ == nullptr || std::ferror(file_) == 0; }

    /// Begins a run. The run appears in the log together with its first cycle.
    void begin() noexcept override { begun_ = false; }
    void text(const char* piece) noexcept override {
        if (file_ == nullptr) return;
        if (!begun_) pending_ += "run " + std::to_string(++runs_) + '\n';
        begun_ = in_cycle_ = true;
        pending_ += piece;
    }
    /// Writes a comment on a separate line, for incidents of the robot that are not events of the model. In a cycle,
    /// the comment follows the cycle's line.
    void note(const std::string& comment) {
        if (file_ == nullptr) return;
        (in_cycle_ ? notes_ : pending_) += "// " + comment + '\n';
    }
    void taken(std::uint32_t transition) noexcept override {
        if (transition < counts_.size()) ++counts_[transition];
    }
    /// Ends a cycle. The log is complete up to the last cycle even if the program ends abnormally.
    void end() noexcept override {
        in_cycle_ = false;
        if (file_ == nullptr) return;
        pending_ += notes_;
        notes_.clear();
        write_pending();
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
    void begin_mcap() {
        mcap_ = std::make_unique<McapWriter>("/trace");
        const std::string bytes = mcap_->begin();
        std::fwrite(bytes.data(), 1, bytes.size(), file_);
        chunk_at_ = std::ftell(file_);
    }
    /// Writes the text since the last call. An MCAP file is complete afterwards: its end follows the new chunk, which
    /// overwrites the last end.
    void write_pending() noexcept {
        std::string bytes;
        if (mcap_) {
            const auto now = std::chrono::system_clock::now().time_since_epoch();
            const auto time = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
            bytes = mcap_->chunk(pending_, static_cast<std::uint64_t>(time));
            std::fseek(file_, chunk_at_, SEEK_SET);
            chunk_at_ += static_cast<long>(bytes.size());
            bytes += mcap_->end();
        } else {
            bytes = pending_;
        }
        std::fwrite(bytes.data(), 1, bytes.size(), file_);
        std::fflush(file_);
        pending_.clear();
    }

    RunHeader header_;
    std::FILE* file_ = nullptr;
    std::vector<unsigned long> counts_;
    std::unique_ptr<McapWriter> mcap_;  ///< null for a text
    long chunk_at_ = 0;                 ///< the place of the next chunk
    std::string pending_;               ///< text that is not in the file yet
    std::string notes_;
    int runs_ = 0;
    bool begun_ = false;     ///< true if the line `run N` of the current run is written
    bool in_cycle_ = false;  ///< true if the line of a cycle has begun and has not ended
};

}  // namespace robochart

#endif
