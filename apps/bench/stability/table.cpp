#include "apps/bench/stability/run.h"

#include <fmt/format.h>

namespace manylight {
namespace {

const char* name(Verdict verdict) {
    switch (verdict) {
        case Verdict::Holds:
            return "ok";
        case Verdict::Shown:
            return "shown";
        case Verdict::Fails:
            break;
    }
    return "FAILED";
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string caseText(const CaseOutcome& outcome) {
    std::string text = fmt::format("\n{:>2} {}: {}  ({:.1f} s)\n", outcome.stabilityCase->row,
                                   outcome.stabilityCase->name, outcome.stabilityCase->difficulty, outcome.seconds);
    for (const Finding& finding : outcome.findings)
        text += fmt::format("   {:<40} {:<26} {:<36} {}\n", finding.what, finding.expected, finding.measured,
                            name(finding.verdict));
    return text;
}

}  // namespace

std::string stabilityTable(const StabilityRun& run) {
    std::string text = fmt::format(
        "Stability on {}, Manylight {}\n   {:<40} {:<26} {:<36} {}\n", run.machine["device"].get<std::string>(),
        run.machine["manylight"].get<std::string>(), "case and what is compared", "expected", "measured", "verdict");
    double seconds = 0.0;
    for (const CaseOutcome& outcome : run.outcomes) {
        text += caseText(outcome);
        seconds += outcome.seconds;
    }
    return text + fmt::format("\n{} cases, {} failed, {:.1f} s{}\n", run.outcomes.size(), failureCount(run), seconds,
                              run.isInterrupted ? "; interrupted: the others did not run" : "");
}

std::string stabilityCsv(const StabilityRun& run) {
    std::string text = "row,case,difficulty,what,expected,measured,verdict,case_seconds\n";
    for (const CaseOutcome& outcome : run.outcomes)
        for (const Finding& finding : outcome.findings)
            text += fmt::format("{},{},{},{},{},{},{},{:.3f}\n", outcome.stabilityCase->row,
                                quoted(outcome.stabilityCase->name), quoted(outcome.stabilityCase->difficulty),
                                quoted(finding.what), quoted(finding.expected), quoted(finding.measured),
                                name(finding.verdict), outcome.seconds);
    return text;
}

Json stabilityJson(const StabilityRun& run) {
    Json cases = Json::array();
    for (const CaseOutcome& outcome : run.outcomes) {
        Json findings = Json::array();
        for (const Finding& finding : outcome.findings)
            findings.push_back({{"what", finding.what},
                                {"expected", finding.expected},
                                {"measured", finding.measured},
                                {"verdict", name(finding.verdict)}});
        cases.push_back({{"row", outcome.stabilityCase->row},
                         {"case", outcome.stabilityCase->name},
                         {"difficulty", outcome.stabilityCase->difficulty},
                         {"seconds", outcome.seconds},
                         {"findings", findings}});
    }
    return {
        {"machine", run.machine}, {"interrupted", run.isInterrupted}, {"failed", failureCount(run)}, {"cases", cases}};
}

std::string stabilityList() {
    std::string text;
    for (const StabilityCase& stabilityCase : stabilityCases())
        text += fmt::format("{:>2} {:<26} {:<6} {}\n", stabilityCase.row, stabilityCase.name,
                            stabilityCase.isQuick ? "quick" : "", stabilityCase.difficulty);
    return text;
}

}  // namespace manylight
