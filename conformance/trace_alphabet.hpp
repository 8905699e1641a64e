// Words of a log as events of NF_c(M): `e?v` is a reading, `o!a!b` a write (docs/traces.md). Values that the finite
// reading does not have are told apart from those it has.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "conformance/cyclic_model.hpp"
#include "conformance/trace_text.hpp"

namespace robochart::conformance {

/// A value in a log.
struct LoggedValue {
    std::optional<std::int64_t> number;  ///< as in the carrier; none: outside of it
    std::string text;                    ///< outside: as logged, in one spelling for one value
    bool passed_on = false;              ///< outside: the component only passes such values on
};

struct LoggedEvent {
    enum class Kind { read, write };
    Kind kind = Kind::read;
    std::uint32_t index = 0;              ///< of the register or output
    std::vector<LoggedValue> values;      ///< none for events without
    process::Event event = process::tau;  ///< where all values are in their carriers

    [[nodiscard]] bool inside() const;
};

class TraceAlphabet {
public:
    explicit TraceAlphabet(const CyclicModel&);

    /// Throws TraceFault. The reference is good until the next call.
    [[nodiscard]] const LoggedEvent& read(const TraceToken&);
    /// A kind of event by its name with `?` or `!`. Throws TraceFault.
    [[nodiscard]] LoggedEvent kind(const TraceToken&) const;
    /// The event with values outside of their carriers replaced by `stand_in`'s choice inside.
    [[nodiscard]] process::Event stand_in(const LoggedEvent&, std::uint64_t salt) const;
    [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
    [[nodiscard]] const std::vector<std::string>& outputs() const { return outputs_; }

private:
    struct Domain {
        Carrier carrier;
        ir::TypeKind kind = ir::TypeKind::unit;
        std::vector<std::int64_t> values;  ///< ascending
        std::map<std::string, std::int64_t, std::less<>> texts;
    };
    [[nodiscard]] Domain domain(ir::TypeId, const Carrier&) const;
    [[nodiscard]] LoggedEvent parse(const TraceToken&) const;
    [[nodiscard]] LoggedValue value(const Domain&, std::string_view text, const TraceToken& token,
                                    std::string_view name) const;
    [[nodiscard]] std::int64_t replace(const Domain&, const LoggedValue&, std::uint64_t salt) const;

    const CyclicModel* model_;
    std::vector<std::string> inputs_, outputs_;
    std::unordered_map<std::string, std::uint32_t> input_ids_, output_ids_;  ///< never iterated
    std::vector<std::optional<Domain>> input_domains_;
    std::vector<std::vector<Domain>> output_domains_;
    std::unordered_map<std::string, LoggedEvent> known_;  ///< by token; never iterated
    LoggedEvent last_;
};

}  // namespace robochart::conformance
