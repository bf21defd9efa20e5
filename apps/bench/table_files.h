// Where a subcommand's results go, besides standard output.
#pragma once

#include "engine/core/report.h"

#include <CLI/CLI.hpp>

#include <string>

namespace manylight {

struct TableFiles {
    std::string text;  // file names; "-" for standard output (not text), empty for none
    std::string csv;
    std::string json;
};

void addTableOptions(CLI::App& parser, TableFiles& files);

/// Throws Error if a file could not be written: to be called before anything is measured.
void checkTableFiles(const TableFiles& files);

/// Prints the text (on standard error where a program reads standard output) and writes the files.
void writeTables(const TableFiles& files, const std::string& text, const std::string& csv, const Json& json);

}  // namespace manylight
