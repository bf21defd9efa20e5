// Ctrl-C asks long work to end at the next frame; what is done so far is kept. A second one ends the program at once.
#pragma once

namespace manylight {

class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// SIGINT or SIGTERM came while a guard existed.
bool isInterrupted();

}  // namespace manylight
