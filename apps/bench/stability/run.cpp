#include "apps/bench/stability/run.h"

#include "apps/bench/stability/crack.h"
#include "apps/bench/stability/lab.h"
#include "apps/common/command_line.h"
#include "apps/common/interrupt.h"
#include "engine/core/error.h"
#include "engine/core/progress.h"

#include <algorithm>
#include <chrono>
#include <string_view>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

Findings findingsOf(const StabilityCase& stabilityCase, StabilityLab& lab) {
    try {
        Findings findings = stabilityCase.run(lab);
        if (findings.empty()) findings.push_back({"findings", "some", "none", Verdict::Fails});
        return findings;
    } catch (const std::exception& error) {  // a case that fails must not end the others
        return {{"runs to its end", "no error", error.what(), Verdict::Fails}};
    }
}

CaseOutcome runCase(const StabilityCase& stabilityCase, StabilityLab& lab) {
    const uint64_t messagesBefore = lab.device().instance().validationMessages();
    const auto start = Clock::now();
    CaseOutcome outcome{&stabilityCase, findingsOf(stabilityCase, lab), 0.0};
    outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const uint64_t messages = lab.device().instance().validationMessages() - messagesBefore;
    if (messages > 0)
        outcome.findings.push_back({"validation messages", "0", fmt::format("{}", messages), Verdict::Fails});
    return outcome;
}

}  // namespace

StabilityRun runStability(const std::vector<const StabilityCase*>& cases, const std::string& device) {
    const InterruptGuard guard;
    gpu::Device chosen({.select = device, .validation = gpu::validationFromEnvironment()});
    StabilityLab lab(chosen);
    StabilityRun run;
    run.machine = describeMachine(chosen);
    Progress progress("cases", cases.size());
    for (const StabilityCase* stabilityCase : cases) {
        CaseOutcome outcome = runCase(*stabilityCase, lab);
        run.isInterrupted = isInterrupted();
        if (run.isInterrupted) break;
        run.outcomes.push_back(std::move(outcome));
        progress.advance();
    }
    return run;
}

StabilityRun runCrackTest(const std::string& scene, const std::string& device) {
    static constexpr StabilityCase kCase{19, "crack", "edges and corners of a scene that was not made for it", false,
                                         nullptr};
    gpu::Device chosen({.select = device, .validation = gpu::validationFromEnvironment()});
    StabilityLab lab(chosen);
    const auto start = Clock::now();
    CaseOutcome outcome{&kCase, crackTest(lab, scene), 0.0};
    outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return {{std::move(outcome)}, describeMachine(chosen), false};
}

std::vector<const StabilityCase*> chooseCases(const std::vector<std::string>& names, bool onlyQuick) {
    std::vector<const StabilityCase*> chosen;
    for (const std::string& name : names) {
        const auto& cases = stabilityCases();
        const auto found = std::find_if(cases.begin(), cases.end(),
                                        [&](const StabilityCase& c) { return name == std::string_view(c.name); });
        if (found == cases.end()) failUsage("--case {}: expected one of those that --list prints", name);
        chosen.push_back(&*found);
    }
    if (names.empty())
        for (const StabilityCase& stabilityCase : stabilityCases())
            if (stabilityCase.isQuick || !onlyQuick) chosen.push_back(&stabilityCase);
    return chosen;
}

size_t failureCount(const StabilityRun& run) {
    size_t count = 0;
    for (const CaseOutcome& outcome : run.outcomes)
        count += std::any_of(outcome.findings.begin(), outcome.findings.end(),
                             [](const Finding& finding) { return finding.verdict == Verdict::Fails; })
                     ? 1
                     : 0;
    return count;
}

}  // namespace manylight
