// A progress line on standard error, only when it is a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace manylight {

/// Shows "label [#####.....] 42 %  0:12 left". Redraws at most ten times a second; silent when stderr is no terminal.
class Progress {
  public:
    Progress(std::string label, uint64_t total, bool enabled = true);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void advance(uint64_t steps = 1);

  private:
    void draw();

    std::string label_;
    uint64_t total_;
    uint64_t done_ = 0;
    bool enabled_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point lastDraw_;
};

}  // namespace manylight
