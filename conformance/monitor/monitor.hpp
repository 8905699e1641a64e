// SPDX-License-Identifier: Apache-2.0
// Builds the normal form of a component as dense tables for a monitor (cpp_emit/runtime/monitor.hpp): NF_c(M),
// determinised and minimised, with equal columns shared. The tables represent only traces, because a monitor sees only
// the events that happen.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "conformance/model/cyclic_model.hpp"
#include "cpp_emit/emit.hpp"
#include "cpp_emit/runtime/monitor.hpp"

namespace robochart::conformance {

/// The tables and all data to which they point.
class MonitorBuild {
public:
    /// Builds the tables. Throws std::length_error if they would be too large, and process::Interrupted at a limit.
    [[nodiscard]] static std::unique_ptr<MonitorBuild> make(CyclicModel&, const refine::Limits&,
                                                            const diagnostics::SourceManager&);
    [[nodiscard]] const MonitorTables& tables() const { return tables_; }
    [[nodiscard]] std::size_t table_bytes() const { return next_.size() * sizeof next_[0]; }
    /// Returns the number of nodes of the normal form before minimisation.
    [[nodiscard]] std::uint32_t node_count() const { return nodes_; }

private:
    friend class MonitorBuilder;
    MonitorBuild() = default;

    struct Channel {
        std::string name, element;
        std::deque<std::vector<std::int64_t>> numbers;
        std::vector<MonitorValues> values;
        std::vector<std::uint16_t> columns;
    };
    std::string component_;
    std::vector<std::uint16_t> next_;
    std::deque<Channel> channels_;
    std::vector<MonitorChannel> inputs_, outputs_;
    std::deque<std::string> texts_;
    std::vector<const char*> where_;
    std::uint32_t nodes_ = 0;
    MonitorTables tables_{};
};

/// Returns a header with the tables, and robochart/monitor.hpp, which is the only file that the header includes.
/// `subject` describes the content of the tables.
[[nodiscard]] std::vector<cpp_emit::OutputFile> monitor_files(const MonitorTables&, const std::string& name,
                                                              const std::string& subject = "what its model allows");

}  // namespace robochart::conformance
