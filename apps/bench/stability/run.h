// Runs cases of the stability suite, one after the other.
#pragma once

#include "apps/bench/stability/case.h"
#include "engine/core/report.h"

#include <string>
#include <vector>

namespace manylight {

struct CaseOutcome {
    const StabilityCase* stabilityCase = nullptr;
    Findings findings;  // at least one
    double seconds = 0.0;
};

struct StabilityRun {
    std::vector<CaseOutcome> outcomes;  // of the cases that ran to their end
    Json machine;
    bool isInterrupted = false;
};

/// A case that throws has failed; the others run all the same. So has one with a validation message.
StabilityRun runStability(const std::vector<const StabilityCase*>& cases, const std::string& device);

/// The crack test on a scene, as the one case of a run.
StabilityRun runCrackTest(const std::string& scene, const std::string& device);

/// Those named, or all (the quick ones). Throws Error (usage) on a name that is none.
std::vector<const StabilityCase*> chooseCases(const std::vector<std::string>& names, bool onlyQuick);

size_t failureCount(const StabilityRun& run);

std::string stabilityTable(const StabilityRun& run);
std::string stabilityCsv(const StabilityRun& run);
Json stabilityJson(const StabilityRun& run);
/// The names, for --list.
std::string stabilityList();

}  // namespace manylight
