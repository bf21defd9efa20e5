// What main() needs to know of a subcommand: one file pair each, one line in main().
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace manylight {

struct BenchCommand {
    CLI::App* parser = nullptr;
    std::function<void()> run;  // owns the options that `parser` fills
};

}  // namespace manylight
