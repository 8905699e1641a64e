// SPDX-License-Identifier: Apache-2.0
#include "tests/claims/sleec/syntax/same_file.hpp"

#include <algorithm>

namespace robochart::sleec::testing {
namespace {

bool same_expr(const ExprPtr& a, const ExprPtr& b) {
    if (!a || !b) return a == b;
    return a->op == b->op && a->text == b->text && a->braced == b->braced &&
           std::ranges::equal(a->parts, b->parts, same_expr);
}

bool same_element(const Name& a, const Name& b) {
    return a.text == b.text;
}

bool same_event(const EventName& a, const EventName& b) {
    if (a.text != b.text || a.arguments.has_value() != b.arguments.has_value()) return false;
    return !a.arguments || std::ranges::equal(*a.arguments, *b.arguments, same_expr);
}

bool same_element(const Trigger& a, const Trigger& b) {
    return same_event(a.event, b.event) && same_expr(a.condition, b.condition);
}

bool same_limit(const Limit* a, const Limit* b) {
    if (a == nullptr || b == nullptr) return a == b;
    return a->unit == b->unit && a->from_unit == b->from_unit && same_expr(a->from, b->from) && same_expr(a->to, b->to);
}

bool same_response(const ResponsePtr& a, const ResponsePtr& b);

bool same_element(const Defeater& a, const Defeater& b) {
    if (a.event.has_value() != b.event.has_value() || (a.event && !same_event(*a.event, *b.event))) return false;
    return same_expr(a.condition, b.condition) && same_response(a.response, b.response);
}

template <class Item, class Same>
bool same_list(const std::vector<Item>& a, const std::vector<Item>& b, const Same& same_item) {
    return std::ranges::equal(a, b, same_item);
}

bool same_response(const ResponsePtr& a, const ResponsePtr& b) {
    if (!a || !b) return a == b;
    return a->negated == b->negated && a->eventually == b->eventually && same_event(a->event, b->event) &&
           same_limit(a->limit.get(), b->limit.get()) && same_response(a->otherwise, b->otherwise) &&
           same_list(a->defeaters, b->defeaters,
                     [](const Defeater& x, const Defeater& y) { return same_element(x, y); });
}

bool same_element(const Measure& a, const Measure& b) {
    return same_element(a.name, b.name) && a.type == b.type &&
           same_list(a.literals, b.literals, [](const Name& x, const Name& y) { return same_element(x, y); });
}

bool same_element(const Rule& a, const Rule& b) {
    return same_element(a.name, b.name) && a.form == b.form && a.assumed == b.assumed &&
           same_element(a.trigger, b.trigger) && same_response(a.response, b.response);
}

bool same_element(const Property& a, const Property& b) {
    if (!a.during != !b.during || (a.during && !same_element(*a.during, *b.during))) return false;
    return same_element(a.name, b.name) && a.exists == b.exists && same_element(a.trigger, b.trigger) &&
           same_response(a.response, b.response);
}

}  // namespace

bool same_file(const RuleFile& a, const RuleFile& b) {
    return a.dialect == b.dialect &&
           same_list(a.events, b.events, [](const Event& x, const Event& y) { return same_element(x.name, y.name); }) &&
           same_list(a.measures, b.measures, [](const Measure& x, const Measure& y) { return same_element(x, y); }) &&
           same_list(a.constants, b.constants,
                     [](const Constant& x, const Constant& y) {
                         return same_element(x.name, y.name) && same_expr(x.value, y.value);
                     }) &&
           same_list(a.mappings, b.mappings,
                     [](const Mapping& x, const Mapping& y) {
                         return same_element(x.name, y.name) && same_element(x.element, y.element);
                     }) &&
           same_list(a.rules, b.rules, [](const Rule& x, const Rule& y) { return same_element(x, y); }) &&
           same_list(a.concerns, b.concerns, [](const Property& x, const Property& y) { return same_element(x, y); }) &&
           same_list(a.purposes, b.purposes, [](const Property& x, const Property& y) { return same_element(x, y); });
}

}  // namespace robochart::sleec::testing
