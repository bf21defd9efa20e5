// A case of the stability suite: plain data and one function. Adding one is that function and a line in
// stability_cases.cpp.
#pragma once

#include <string>
#include <vector>

namespace manylight {

class StabilityLab;

enum class Verdict {
    Holds,
    Fails,
    Shown,  // measured for the reader; nothing is claimed
};

/// One line of the table: what was compared with what.
struct Finding {
    std::string what;
    std::string expected;
    std::string measured;
    Verdict verdict = Verdict::Fails;
};

using Findings = std::vector<Finding>;

struct StabilityCase {
    int row = 0;  // of the table of cases in docs/numerics.md
    const char* name = "";
    const char* difficulty = "";  // what makes it hard
    bool isQuick = true;
    Findings (*run)(StabilityLab&) = nullptr;
};

/// Every case, in the order of the table.
const std::vector<StabilityCase>& stabilityCases();

}  // namespace manylight
