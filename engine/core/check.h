// MANYLIGHT_CHECK(a == b, "pass {}", name): on in release builds; the message prints both sides and the context.
#pragma once

#include "engine/core/error.h"

#include <fmt/format.h>

#include <type_traits>

namespace manylight::detail {

template <typename T>
std::string describeOperand(const T& value) {
    if constexpr (std::is_enum_v<T>) {
        return fmt::format("{}", static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (fmt::is_formattable<T>::value && !std::is_pointer_v<T>) {
        return fmt::format("{}", value);
    } else {
        return "?";
    }
}

/// Holds the outcome of `Decomposer() << a == b` and the text of both operands.
struct CheckOutcome {
    bool holds;
    std::string operands;
};

template <typename L>
struct LeftOperand {
    const L& left;

    template <typename R>
    CheckOutcome compare(bool holds, const char* op, const R& right) const {
        return {holds, holds ? "" : fmt::format("{} {} {}", describeOperand(left), op, describeOperand(right))};
    }
    template <typename R>
    CheckOutcome operator==(const R& r) const {
        return compare(left == r, "==", r);
    }
    template <typename R>
    CheckOutcome operator!=(const R& r) const {
        return compare(left != r, "!=", r);
    }
    template <typename R>
    CheckOutcome operator<(const R& r) const {
        return compare(left < r, "<", r);
    }
    template <typename R>
    CheckOutcome operator<=(const R& r) const {
        return compare(left <= r, "<=", r);
    }
    template <typename R>
    CheckOutcome operator>(const R& r) const {
        return compare(left > r, ">", r);
    }
    template <typename R>
    CheckOutcome operator>=(const R& r) const {
        return compare(left >= r, ">=", r);
    }
    operator CheckOutcome() const { return {static_cast<bool>(left), describeOperand(left)}; }
};

struct Decomposer {
    template <typename L>
    LeftOperand<L> operator<<(const L& left) const {
        return {left};
    }
};

[[noreturn]] void failCheck(const char* expression, const CheckOutcome& outcome, const char* file, int line,
                            const std::string& context);

inline std::string checkContext() { return {}; }
template <typename... Args>
std::string checkContext(fmt::format_string<Args...> format, Args&&... args) {
    return fmt::format(format, std::forward<Args>(args)...);
}

}  // namespace manylight::detail

#define MANYLIGHT_CHECK(expression, ...)                                                                    \
    do {                                                                                                    \
        const ::manylight::detail::CheckOutcome outcome_ = ::manylight::detail::Decomposer() << expression; \
        if (!outcome_.holds)                                                                                \
            ::manylight::detail::failCheck(#expression, outcome_, __FILE__, __LINE__,                       \
                                           ::manylight::detail::checkContext(__VA_ARGS__));                 \
    } while (false)
