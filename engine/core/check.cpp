#include "engine/core/check.h"

namespace manylight::detail {

void failCheck(const char* expression, const CheckOutcome& outcome, const char* file, int line,
               const std::string& context) {
    throw BugError(fmt::format("{}:{}: check failed: {}   [{}]{}{}", file, line, expression, outcome.operands,
                               context.empty() ? "" : "   in ", context));
}

}  // namespace manylight::detail
