#include "engine/core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace manylight {

Progress::Progress(std::string label, uint64_t total, bool enabled)
    : label_(std::move(label)),
      total_(std::max<uint64_t>(total, 1)),
      enabled_(enabled && ::isatty(STDERR_FILENO)),
      start_(std::chrono::steady_clock::now()) {
    if (enabled_) draw();
}

Progress::~Progress() {
    if (enabled_) fmt::print(stderr, "\r\033[K");
}

void Progress::advance(uint64_t steps) {
    done_ = std::min(done_ + steps, total_);
    const auto now = std::chrono::steady_clock::now();
    if (enabled_ && (now - lastDraw_ > std::chrono::milliseconds(100) || done_ == total_)) draw();
}

void Progress::draw() {
    constexpr uint64_t kWidth = 30;
    lastDraw_ = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double>(lastDraw_ - start_).count();
    const uint64_t filled = done_ * kWidth / total_;
    std::string left;
    if (done_ > 0) {
        const auto seconds =
            static_cast<uint64_t>(elapsed / static_cast<double>(done_) * static_cast<double>(total_ - done_));
        left = fmt::format("  {}:{:02} left", seconds / 60, seconds % 60);
    }
    fmt::print(stderr, "\r\033[K{} [{}{}] {:3} %{}", label_, std::string(filled, '#'),
               std::string(kWidth - filled, '.'), done_ * 100 / total_, left);
    std::fflush(stderr);
}

}  // namespace manylight
