// Writes states of the exploration as text: values with parts, as in logs (trace.hpp). Included before the trace header
// of the controller, whose functions call those declared here. Delivered with the generated code. Copyright: see
// LICENSE (Apache-2.0).
#ifndef ROBOCHART_EXPLORE_VALUES_HPP
#define ROBOCHART_EXPLORE_VALUES_HPP

#include "robochart/explore.hpp"
#include "robochart/finite.hpp"
#include "robochart/trace.hpp"

namespace robochart {

/// Writes a number over a finite carrier, which is an integer that counts units.
inline void log_units(Tracer& tracer, std::int64_t units, std::int64_t scale) noexcept {
    char digits[64];
    Text text(digits, sizeof digits);
    text.add(units, scale);
    tracer.text(digits);
}
template <class Carrier>
void log_value(Tracer& tracer, Finite<Carrier> value) noexcept {
    log_units(tracer, value.raw(), Carrier::scale);
}

#ifdef ROBOCHART_TRACKED_HPP
template <class Carrier>
void log_value(Tracer& tracer, Tracked<Carrier> value) noexcept {
    log_units(tracer, value.raw(), Carrier::scale);
}
#endif
#ifdef ROBOCHART_TRACKED_SEQUENCES_HPP
template <class Carrier, std::size_t capacity>
void log_value(Tracer& tracer, const Sequence<Tracked<Carrier>, capacity>& value) noexcept {
    const std::int64_t length = value.known() ? 0 : tracking.size_of(value.type(), value.index());
    tracer.text("<");
    for (std::int64_t i = 0; i < length; ++i) {
        if (i > 0) tracer.text(",");
        log_units(tracer, tracking.items_of(value.type(), value.index())[i], Carrier::scale);
    }
    tracer.text(">");
}
#endif

/// Writes log text to a Text.
class TextTracer final : public Tracer {
public:
    explicit TextTracer(Text& text) noexcept : text_(text) {}
    void text(const char* piece) noexcept override { text_.add(piece); }

private:
    Text& text_;
};

template <class T>
void add_value(Text& text, const T& value) noexcept {
    TextTracer words(text);
    Tracer& tracer = words;
    log_value(tracer, value);
}

}  // namespace robochart

#endif
