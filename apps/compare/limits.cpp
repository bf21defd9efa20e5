#include "apps/compare/limits.h"

#include "engine/core/error.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace manylight {
namespace {

struct LimitedNumber {
    const char* name;
    std::optional<double> (*value)(const CompareNumbers& numbers);
};

/// The largest relative deviation of a channel's mean.
std::optional<double> largestBias(const CompareNumbers& numbers) {
    double largest = 0.0;
    for (size_t c = 0; c < 3; ++c) {
        const double test = numbers.error.meanTest[c];
        const double reference = numbers.error.meanReference[c];
        if (test == reference) continue;
        if (reference == 0.0) return std::nullopt;
        largest = std::max(largest, std::abs(test / reference - 1.0));
    }
    return largest;
}

constexpr LimitedNumber kNumbers[] = {
    {"rmse", [](const CompareNumbers& n) { return std::optional(n.error.rmse); }},
    {"relmse", [](const CompareNumbers& n) { return n.error.relativeMse; }},
    {"smape", [](const CompareNumbers& n) { return n.error.smape; }},
    {"flip", [](const CompareNumbers& n) { return n.flip ? std::optional(n.flip->mean) : std::nullopt; }},
    {"worst", [](const CompareNumbers& n) { return std::optional(n.error.worstShare); }},
    {"bias", largestBias},
};

const LimitedNumber* find(const std::string& name) {
    const auto* const found = std::find_if(std::begin(kNumbers), std::end(kNumbers),
                                           [&](const LimitedNumber& number) { return number.name == name; });
    return found == std::end(kNumbers) ? nullptr : found;
}

}  // namespace

std::vector<std::string> limitNames() {
    std::vector<std::string> names;
    for (const LimitedNumber& number : kNumbers) names.emplace_back(number.name);
    return names;
}

std::vector<Limit> limitsFrom(const std::vector<std::string>& texts) {
    std::vector<Limit> limits;
    for (const std::string& text : texts) {
        const size_t equals = std::min(text.find('='), text.size());
        Limit limit{text.substr(0, equals), 0.0};
        const char* const end = text.data() + text.size();
        const char* const begin = std::min(text.data() + equals + 1, end);
        const std::from_chars_result read = std::from_chars(begin, end, limit.largest);
        if (read.ec != std::errc() || read.ptr != end || !std::isfinite(limit.largest))
            failUsage("--fail-above {}: expected a name, \"=\" and a number, as in rmse=0.01", text);
        if (!find(limit.name))
            failUsage("--fail-above {}: no number \"{}\"; expected one of {}", text, limit.name,
                      fmt::join(limitNames(), ", "));
        limits.push_back(limit);
    }
    return limits;
}

std::vector<std::string> exceeded(const std::vector<Limit>& limits, const CompareNumbers& numbers) {
    std::vector<std::string> phrases;
    for (const Limit& limit : limits) {
        const std::optional<double> value = find(limit.name)->value(numbers);
        if (!value)
            phrases.push_back(fmt::format("{} is undefined, limit {}", limit.name, limit.largest));
        else if (!(*value <= limit.largest))
            phrases.push_back(fmt::format("{} {:.6g} is above {}", limit.name, *value, limit.largest));
    }
    return phrases;
}

}  // namespace manylight
