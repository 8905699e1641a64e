// SPDX-License-Identifier: Apache-2.0
// Process terms as bytes, by content: equal terms have equal bytes and different ones different bytes, in whatever
// order terms and values were made. A term's bytes say where it ends, so rows may be filled up with zeros.
//
// A call is its definition with its arguments, a prefix its place in the script with the values that it uses; other
// operators are written before their operands. Definitions and places have the numbers of the resolver, which are the
// same whenever the same script is read. Sets of events and renamings are written by number (packed_parts.hpp).
#pragma once

#include <vector>

#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/process_terms.hpp"
#include "checker/cspm/packed/bytes.hpp"
#include "checker/cspm/packed/packed_parts.hpp"
#include "checker/process/term.hpp"

namespace robochart::cspm {

/// Writes and reads terms and values of one store. What has no packed form is refused with NotPacked: compressions and
/// what they make; sequences without end; sets of processes, whose order is that in which the processes were made.
class TermCodec {
public:
    /// All expressions are resolved already.
    TermCodec(const Program& program, ValueStore& store, process::TermStore& terms, ProcessTerms& processes,
              PackedParts& parts);

    void write(process::TermId term, Bytes& out);
    [[nodiscard]] process::TermId read(ByteReader& in);
    /// `value` is shared.
    void write(Value value, Bytes& out);
    [[nodiscard]] Value read_value(ByteReader& in);
    /// Passes over a term.
    void skip(ByteReader& in);

    // The parts of calls and prefixes, for whoever reads or writes them without making terms.
    /// How many values the function has already, and how many its last group of arguments.
    struct CallShape {
        std::size_t given;
        std::size_t arguments;
    };
    [[nodiscard]] static CallShape shape(const Function& function);
    /// The head of a call in that shape; the values follow, those given first.
    static void begin_call(const Function& function, Bytes& out);
    /// After the operator: the function; null: a call in another form, which `read` knows.
    [[nodiscard]] const Function* call_head(ByteReader& in) const;
    static void begin_operator(process::Op op, Bytes& out) { out.push_back(static_cast<std::uint8_t>(op)); }

private:
    void write_call(const process::Term& term, Bytes& out);
    void write_prefix(const process::Term& term, Bytes& out);
    void write_children(const process::Term& term, Bytes& out);
    void write_values(const Values& values, std::size_t from, Bytes& out);
    [[nodiscard]] process::TermId read_call(ByteReader& in);
    [[nodiscard]] process::TermId read_prefix(ByteReader& in);
    [[nodiscard]] process::TermId read_operator(process::Op op, ByteReader& in);
    [[nodiscard]] std::uint32_t read_part(process::Op op, ByteReader& in);
    [[nodiscard]] Values read_values(std::size_t count, ByteReader& in);
    void skip_value(ByteReader& in);
    void skip_values(std::size_t count, ByteReader& in);
    void skip_prefix(ByteReader& in);
    [[nodiscard]] std::size_t values_of_prefix(PrefixKind kind, std::uint64_t place) const;

    const Program& program_;
    ValueStore& store_;
    process::TermStore& terms_;
    ProcessTerms& processes_;
    PackedParts& parts_;
    std::vector<const Function*> functions_;  // by number
    std::vector<const Group*> groups_;        // by number
    unsigned depth_ = 0;
    unsigned inside_sets_ = 0;
};

}  // namespace robochart::cspm
